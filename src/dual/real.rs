//! [`Real`] and [`Elementary`]. Each value is computed by T's own operation and has its bits; the derivative
//! follows from the value.

use super::Dual;
use crate::elementary::Elementary;
use crate::real::Real;
use crate::vector::Vec3;

type Triple<T> = [Dual<T>; 3];

#[inline]
fn values<T: Real>([x, y, z]: Triple<T>) -> [T; 3] {
    [x.value, y.value, z.value]
}

#[inline]
fn gradients<T: Real>([x, y, z]: Triple<T>) -> [Vec3<T>; 3] {
    [x.gradient, y.gradient, z.gradient]
}

#[inline]
fn with_values<T: Real>([x, y, z]: [T; 3], [dx, dy, dz]: [Vec3<T>; 3]) -> Triple<T> {
    let dual = |value, gradient| Dual { value, gradient };
    [dual(x, dx), dual(y, dy), dual(z, dz)]
}

/// ∇(a·v) for a constant a.
#[inline]
fn gradient_along<T: Real>(a: [T; 3], v: Triple<T>) -> Vec3<T> {
    let [x, y, z] = gradients(v);
    Vec3::new(
        T::dot(a, [x.x, y.x, z.x]),
        T::dot(a, [x.y, y.y, z.y]),
        T::dot(a, [x.z, y.z, z.z]),
    )
}

/// ∇(a·b) = a·∇b + b·∇a
#[inline]
fn gradient_of_dot<T: Real>(a: Triple<T>, b: Triple<T>) -> Vec3<T> {
    gradient_along(values(a), b) + gradient_along(values(b), a)
}

/// ∇(v/|v|) = (∇v − u ∇|v|)/|v| with u = v/|v|, and ∇|v| = u·∇v.
#[inline]
fn gradients_of_unit<T: Real>(
    v: Triple<T>,
    unit @ [ux, uy, uz]: [T; 3],
    length: T,
) -> ([Vec3<T>; 3], Vec3<T>) {
    let [x, y, z] = gradients(v);
    let along = gradient_along(unit, v);
    let part = |gradient: Vec3<T>, u| (gradient - along * u) / length;
    ([part(x, ux), part(y, uy), part(z, uz)], along)
}

#[diagnostic::do_not_recommend] // the trait's own message names the types
impl<T: Real> Real for Dual<T> {
    const ZERO: Self = Self::constant(T::ZERO);
    const ONE: Self = Self::constant(T::ONE);
    const NEG_ONE: Self = Self::constant(T::NEG_ONE);
    const MAX: Self = Self::constant(T::MAX);
    const EXTREME: Self = Self::constant(T::EXTREME);

    #[inline]
    fn of(literal: f64) -> Self {
        Self::constant(T::of(literal))
    }

    #[inline]
    fn of_f32(literal: f32) -> Self {
        Self::constant(T::of_f32(literal))
    }

    #[inline]
    fn sqrt(self) -> Self {
        // divided, because in fixed point the slope 1/(2√f) has few digits
        let root = self.value.sqrt();
        Self {
            value: root,
            gradient: T::divided(self.gradient.into(), root + root).into(),
        }
    }

    #[inline]
    fn epsilon() -> Self {
        Self::constant(T::epsilon())
    }

    #[inline]
    fn if_positive(self, then: Self, otherwise: Self) -> Self {
        let select = |a, b| self.value.if_positive(a, b);
        Self {
            value: select(then.value, otherwise.value),
            gradient: Vec3::new(
                select(then.gradient.x, otherwise.gradient.x),
                select(then.gradient.y, otherwise.gradient.y),
                select(then.gradient.z, otherwise.gradient.z),
            ),
        }
    }

    #[inline]
    fn any_positive(self) -> bool {
        self.value.any_positive()
    }

    #[inline]
    fn dot(a: [Self; 3], b: [Self; 3]) -> Self {
        Self {
            value: T::dot(values(a), values(b)),
            gradient: gradient_of_dot(a, b),
        }
    }

    #[inline]
    fn divided(numbers: [Self; 3], divisor: Self) -> [Self; 3] {
        let quotients = T::divided(values(numbers), divisor.value);
        let ([x, y, z], [dx, dy, dz]) = (quotients, gradients(numbers));
        let part = |gradient: Vec3<T>, quotient| {
            let slopes = gradient - divisor.gradient * quotient;
            T::divided(slopes.into(), divisor.value).into()
        };
        with_values(quotients, [part(dx, x), part(dy, y), part(dz, z)])
    }

    #[inline]
    fn ratio(self, whole: Self) -> Self {
        let value = self.value.ratio(whole.value);
        let slopes = self.gradient - whole.gradient * value;
        Self {
            value,
            gradient: slopes.map(|slope| slope.ratio(whole.value)),
        }
    }

    #[inline]
    fn attenuated(
        v: [Self; 3],
        coefficients @ [a, b, c]: [Self; 3],
        q @ [plain, _]: [Self; 2],
        limit: impl FnOnce() -> Self,
    ) -> [Self; 3] {
        let denominator = a + plain * (b + c * plain);
        let (d, limit) = (denominator.value, limit().value);
        let divided = |v| T::attenuated(v, values(coefficients), q.map(|q| q.value), || limit);
        let attenuated = divided(values(v));
        // (v/d)′ = (v′ − (v/d) d′)/d; d′ does not matter where the factor is limited or v/d is 0
        let is_free = (d * limit - T::ONE).if_positive(T::ONE, T::ZERO);
        let part = |gradient: Vec3<T>, r: T| {
            let is_falling = is_free.if_positive(r.abs(), T::ZERO);
            let fall = |slope: T| is_falling.if_positive(slope * r, T::ZERO);
            divided((gradient - denominator.gradient.map(fall)).into()).into()
        };
        let ([x, y, z], [rx, ry, rz]) = (gradients(v), attenuated);
        with_values(attenuated, [part(x, rx), part(y, ry), part(z, rz)])
    }

    #[inline]
    fn window(q: Self, r: Self, is_squared: bool) -> Self {
        let value = T::window(q.value, r.value, is_squared);
        Self {
            value,
            ..crate::real::triple::window(q, r, is_squared)
        }
    }

    #[inline]
    fn attenuated_within(
        (r, is_squared): (Self, bool),
        v: [Self; 3],
        coefficients: [Self; 3],
        q: [Self; 2],
        to_light: impl FnOnce() -> [Self; 3],
        limit: impl FnOnce() -> Self,
    ) -> [Self; 3] {
        let limit = limit();
        let dimmed = T::attenuated_within(
            (r.value, is_squared),
            values(v),
            values(coefficients),
            q.map(|q| q.value),
            || values(to_light()),
            || limit.value,
        );
        let v = Self::scaled(v, Self::window(q[0], r, is_squared));
        let dual = Self::attenuated(v, coefficients, q, || limit);
        with_values(dimmed, gradients(dual))
    }

    #[inline]
    fn length(v: [Self; 3]) -> Self {
        let (unit, _) = T::unit(values(v));
        Self {
            value: T::length(values(v)),
            gradient: gradient_along(unit, v),
        }
    }

    #[inline]
    fn unit(v: [Self; 3]) -> ([Self; 3], Self) {
        let (unit, length) = T::unit(values(v));
        let (gradients, _) = gradients_of_unit(v, unit, T::length(values(v)));
        (with_values(unit, gradients), Self::constant(length))
    }

    #[inline]
    fn rescaled_difference(to: [Self; 3], from: [Self; 3]) -> ([Self; 3], Self) {
        let (difference, power) = T::rescaled_difference(values(to), values(from));
        let ([x, y, z], [fx, fy, fz]) = (gradients(to), gradients(from));
        let part = |to: Vec3<T>, from| T::rescaled_by((to - from).into(), power).into();
        let gradients = [part(x, fx), part(y, fy), part(z, fz)];
        (with_values(difference, gradients), Self::constant(power))
    }

    #[inline]
    fn is_any_extreme([less, more]: [Self; 2]) -> bool {
        T::is_any_extreme([less.value, more.value])
    }

    #[inline]
    fn rescaled_together([a, b, c]: [[Self; 3]; 3]) -> Option<([[Self; 3]; 3], Self)> {
        let (values, power) = T::rescaled_together([values(a), values(b), values(c)])?;
        let part = |gradient: Vec3<T>| T::rescaled_by(gradient.into(), power).into();
        let all = |v, values| {
            let [x, y, z] = gradients(v);
            with_values(values, [part(x), part(y), part(z)])
        };
        let [va, vb, vc] = values;
        Some(([all(a, va), all(b, vb), all(c, vc)], Self::constant(power)))
    }

    #[inline]
    fn rescaled_by(v: [Self; 3], power: Self) -> [Self; 3] {
        let power = power.value;
        let part = |gradient: Vec3<T>| T::rescaled_by(gradient.into(), power).into();
        let [x, y, z] = gradients(v);
        with_values(
            T::rescaled_by(values(v), power),
            [part(x), part(y), part(z)],
        )
    }

    #[inline]
    fn direction_and_distance(
        light_and_p: impl FnOnce() -> [[Self; 3]; 2],
        to_light: [Self; 3],
    ) -> ([Self; 3], [Self; 2], Self) {
        let values_of_both = || {
            let [light, p] = light_and_p();
            [values(light), values(p)]
        };
        let (l, [q, finer], distance) = T::direction_and_distance(values_of_both, values(to_light));
        let (gradients, along) = if T::is_lit(q) {
            gradients_of_unit(to_light, l, q)
        } else {
            ([Vec3::ZERO; 3], Vec3::ZERO)
        };
        let along = along.map(|slope| q.if_above(T::MAX, T::ZERO, slope));
        let dual = |value| Self {
            value,
            gradient: along,
        };
        (
            with_values(l, gradients),
            [dual(q), dual(finer)],
            dual(distance),
        )
    }

    #[inline]
    fn is_lit(q: Self) -> bool {
        T::is_lit(q.value)
    }

    /// With H = (L + V)/|L + V|, (N·H)′ = N′·H + N·H′.
    #[inline]
    fn half_cosine(n: [Self; 3], l: [Self; 3], v: [Self; 3], squared: bool) -> Self {
        let value = T::half_cosine(values(n), values(l), values(v), squared);
        let ([lx, ly, lz], [vx, vy, vz]) = (l, v);
        let h = [lx + vx, ly + vy, lz + vz];
        let (unit, _) = T::unit(values(h));
        let (gradients, _) = gradients_of_unit(h, unit, T::length(values(h)));
        let cosine = Self::dot(n, with_values(unit, gradients));
        let gradient = if squared {
            cosine.gradient * (cosine.value.abs() + cosine.value.abs())
        } else {
            cosine.gradient
        };
        Self { value, gradient }
    }

    #[inline]
    fn half_of(m: u32) -> Option<u32> {
        T::half_of(m)
    }

    /// (R·V)′ from R·V = 2(N·L)(N·V) − L·V.
    #[inline]
    fn reflected_cosine(n: [Self; 3], l: [Self; 3], v: [Self; 3]) -> Self {
        let (n_dot_l, n_dot_v) = (Self::dot(n, l), Self::dot(n, v));
        let half = n_dot_l.gradient * n_dot_v.value + n_dot_v.gradient * n_dot_l.value;
        Self {
            value: T::reflected_cosine(values(n), values(l), values(v)),
            gradient: half + half - gradient_of_dot(l, v),
        }
    }

    /// (cᵐ)′ = m cᵐ⁻¹ c′ within (0, 1], and 0 elsewhere.
    #[inline]
    fn cosine_power(m: u32) -> impl Fn(Self) -> Self {
        #[allow(clippy::cast_precision_loss)] // 16 bits each
        let (high, low) = ((m >> 16) as f32, (m & 0xFFFF) as f32);
        let factor = T::of_f32(high) * T::of_f32(65536.0) + T::of_f32(low);
        let (power, slope) = (T::cosine_power(m), T::cosine_power(m.saturating_sub(1)));
        move |cosine: Self| {
            let c = cosine.value;
            let power = power(c);
            let within = cosine.chain(power, factor * slope(c));
            let constant = Self::constant(power);
            cosine.if_positive(cosine.if_above(Self::ONE, constant, within), constant)
        }
    }
}

impl<T: Elementary> Elementary for Dual<T> {
    #[inline]
    fn sin(self) -> Self {
        self.chain(self.value.sin(), self.value.cos())
    }

    #[inline]
    fn cos(self) -> Self {
        self.chain(self.value.cos(), -self.value.sin())
    }

    #[inline]
    fn exp(self) -> Self {
        let power = self.value.exp();
        self.chain(power, power)
    }

    #[inline]
    fn ln(self) -> Self {
        let ln = self.value.ln();
        // below 0, 1/x has a value, but the logarithm does not
        let slope = (-self.value).if_positive(ln, T::ONE / self.value);
        self.chain(ln, slope)
    }
}
