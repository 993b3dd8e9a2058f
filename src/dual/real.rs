//! [`Real`] for dual numbers. Each hook for vectors, lengths and powers has a derivative of its own, by the
//! chain rule: the value is that of the number's own hook, to the bit, and the gradient is that of the
//! formula. What dims a light and what sums it are the formulas, with their values and gradients.

use super::Dual;
use crate::color::Rgb;
use crate::number::cosine::cosine;
use crate::number::{Lobe, Mask, Measured, Real, Toward, length, whole};
use crate::vector::Vec3;

impl<T: Real> Dual<T> {
    /// The gradient with another value: that of the number's own hook.
    #[inline]
    fn of_value(self, value: T) -> Self {
        Self::new(value, self.gradient)
    }
}

#[inline]
fn values<T: Copy>(v: Vec3<Dual<T>>) -> Vec3<T> {
    v.map(|x| x.value)
}

/// a·b by the product rule.
#[inline]
fn plain_dot<T: Real>(a: Vec3<Dual<T>>, b: Vec3<Dual<T>>) -> Dual<T> {
    a.x * b.x + a.y * b.y + a.z * b.z
}

#[inline]
fn zip<A, B, C>(a: Vec3<A>, b: Vec3<B>, f: impl Fn(A, B) -> C) -> Vec3<C> {
    Vec3::new(f(a.x, b.x), f(a.y, b.y), f(a.z, b.z))
}

/// The vector that T gives for `plain`, of a length that it chose, and the gradient for that length.
#[inline(always)] // with `between` and `crossed`: without, a triangle's gradient takes 1.36 times the instructions
fn rescaled<T: Real>(plain: Vec3<Dual<T>>, value: Vec3<T>) -> Vec3<Dual<T>> {
    let [before, after] = [values(plain), value].map(|v| T::measured(v).length);
    let scale = after / before; // exactly 1, unless T has a hook of its own
    let with_value = |plain: Dual<T>, value| Dual::new(value, plain.gradient * scale);
    zip(plain, value, with_value)
}

impl<T: Real> Measured<Dual<T>> {
    #[inline]
    fn values(self) -> Measured<T> {
        Measured {
            w: values(self.w),
            w_length: self.w_length.value,
            length: self.length.value,
        }
    }

    /// What T measured of v, with its gradients. ∇|v| is w·∇v/|w|, and w is v times a number, which its
    /// gradient takes for constant: a formula uses the direction of w alone.
    #[inline]
    fn of(v: Vec3<Dual<T>>, measured: Measured<T>) -> Self {
        let (w, w_length) = (measured.w, measured.w_length);
        let along = v.x.gradient * w.x + v.y.gradient * w.y + v.z.gradient * w.z;
        let length_gradient = along * (T::ONE / w_length);
        let shrunk = measured.length / w_length; // exact for a float, whose w is v times a power of two
        Self {
            w: zip(v, w, |v, w| Dual::new(w, v.gradient / shrunk)),
            w_length: Dual::new(w_length, length_gradient / shrunk),
            length: Dual::new(measured.length, length_gradient),
        }
    }
}

#[diagnostic::do_not_recommend] // the trait's own message names the types
impl<T: Real> Real for Dual<T> {
    type Mask = Where<T::Mask>;
    type Sum = Rgb<Self>;

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
        Dual::sqrt(self)
    }

    #[inline]
    fn above(self, other: Self) -> Where<T::Mask> {
        Where(self.value.above(other.value))
    }

    #[inline]
    fn any_outside(self, low: Self, high: Self) -> bool {
        self.value.any_outside(low.value, high.value)
    }

    #[inline]
    fn dot(a: Vec3<Self>, b: Vec3<Self>) -> Self {
        plain_dot(a, b).of_value(T::dot(values(a), values(b)))
    }

    #[inline]
    fn faces(n: Vec3<Self>, v: Vec3<Self>) -> Where<T::Mask> {
        Where(T::faces(values(n), values(v)))
    }

    #[inline]
    fn measured(v: Vec3<Self>) -> Measured<Self> {
        Measured::of(v, T::measured(values(v)))
    }

    #[inline]
    fn toward(n: Vec3<Self>, v: Vec3<Self>) -> Toward<Self> {
        let toward = T::toward(values(n), values(v));
        let measured = Measured::of(v, toward.measured);
        let n_dot_w = plain_dot(n, measured.w).of_value(toward.n_dot_w);
        Toward { measured, n_dot_w }
    }

    #[inline]
    fn cosine(n: Vec3<Self>, toward: &Toward<Self>) -> Self {
        let plain = length::cosine(toward.n_dot_w, toward.measured.w_length);
        let toward = Toward {
            measured: toward.measured.values(),
            n_dot_w: toward.n_dot_w.value,
        };
        plain.of_value(T::cosine(values(n), &toward))
    }

    #[inline(always)]
    fn between(origin: Vec3<Self>, v: Vec3<Self>) -> Vec3<Self> {
        let value = T::between(values(origin), values(v));
        rescaled(length::between(origin, v), value)
    }

    #[inline(always)]
    fn crossed(origin: Vec3<Self>, a: Vec3<Self>, b: Vec3<Self>) -> Vec3<Self> {
        let value = T::crossed(values(origin), values(a), values(b));
        let (a, b) = (Self::between(origin, a), Self::between(origin, b));
        rescaled(a.cross(b), value)
    }

    #[inline]
    fn whole_power(self, m: u32) -> Self {
        let slope = match m {
            0 => T::ZERO,
            m => whole::<T>(m) * self.value.whole_power(m - 1),
        };
        self.chain(self.value.whole_power(m), slope)
    }

    #[inline]
    fn halfway_power(n: Vec3<Self>, w: Measured<Self>, v: Vec3<Self>, m: impl Lobe<Self>) -> Self {
        let power = T::halfway_power(values(n), w.values(), values(v), OfValue(m));
        let cosine = Self::cosine(n, &Self::toward(n, w.w + v * w.w_length));
        let varies = cosine.above(Self::ZERO);
        varies.select(m.raise(cosine), Self::ZERO).of_value(power)
    }

    fn half_angle_cosine(self) -> Self {
        cosine(self).of_value(self.value.half_angle_cosine())
    }
}

/// A lobe of dual numbers as one of their values.
#[derive(Clone, Copy)]
struct OfValue<M>(M);

impl<T: Real, M: Lobe<Dual<T>>> Lobe<T> for OfValue<M> {
    #[inline]
    fn raise(self, cosine: T) -> T {
        self.0.raise(Dual::constant(cosine)).value
    }

    #[inline]
    fn raise_root(self, square: T) -> T {
        self.0.raise_root(Dual::constant(square)).value
    }

    #[inline]
    fn raise_quotient(self, square: T, of: T) -> T {
        let (square, of) = (Dual::constant(square), Dual::constant(of));
        self.0.raise_quotient(square, of).value
    }
}

/// Where a comparison of values holds.
#[derive(Clone, Copy)]
pub struct Where<M>(M);

impl<T: Real> Mask<Dual<T>> for Where<T::Mask> {
    #[inline]
    fn any(self) -> bool {
        self.0.any()
    }

    #[inline]
    fn all(self) -> bool {
        self.0.all()
    }

    #[inline]
    fn select(self, then: Dual<T>, otherwise: Dual<T>) -> Dual<T> {
        Dual::new(
            self.0.select(then.value, otherwise.value),
            Vec3::select(self.0, then.gradient, otherwise.gradient),
        )
    }
}
