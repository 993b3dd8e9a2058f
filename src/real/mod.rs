//! The number type that every formula is written over.

mod angle;
mod float;
pub(crate) mod root;
mod scalar;
mod several;
pub(crate) mod triple;
pub(crate) mod whole_power;

use core::ops::{Add, Div, Mul, Neg, Sub};

pub use scalar::Scalar;
pub(crate) use several::Several;

/// A real number: `f32`, `f64`, a dual number, a set of SIMD lanes, or a type of your own.
///
/// The trait has the operations that the formulas of this crate need. `f32`, `f64` and the SIMD
/// lanes round each of + − × ÷ √ correctly, so their results have the same bits on every machine.
/// There is no comparison: [`if_positive`](Real::if_positive) makes each decision, separately for
/// each lane.
///
/// ```
/// use shading::Real;
///
/// /// The length of the hypotenuse, for every number type.
/// fn hypotenuse<T: Real>(a: T, b: T) -> T {
///     (a * a + b * b).sqrt()
/// }
/// assert_eq!(hypotenuse(3.0_f32, 4.0), 5.0);
/// assert_eq!(hypotenuse(3.0_f64, 4.0), 5.0);
/// ```
///
/// # A number of your own
///
/// Write the items without a default: the constants, [`of`](Real::of), [`sqrt`](Real::sqrt),
/// [`if_positive`](Real::if_positive) and [`any_positive`](Real::any_positive). The other methods
/// are derived from them. If a processor has a better way, override the method, provided that it
/// gives the same result.
///
/// - No operation may panic. A division by zero gives an infinity or, in a type without infinities,
///   any number.
/// - [`if_positive`](Real::if_positive) selects lane by lane and computes nothing.
///   [`any_positive`](Real::any_positive) says whether it would select `then` in some lane.
/// - If the operations round correctly, results have the same bits on every machine, and the error
///   bounds of [`guide::precision`](mod@crate::guide::precision) hold in units of the type's
///   roundoff. If they do not, nothing else is lost.
///
/// [`guide::invariants`](mod@crate::guide::invariants) explains how to test such a type.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a number type that this crate computes with",
    label = "expected `f32`, `f64`, `Fixed`, `Dual<_>` or SIMD lanes",
    note = "write numbers with a decimal point: `Vec3::new(0.0, 0.0, 1.0)`, not `Vec3::new(0, 0, 1)`"
)]
pub trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;
    /// Minus one.
    const NEG_ONE: Self;
    /// The largest finite number.
    const MAX: Self;
    /// A power of two *p* for scaling vectors whose squared length is out of range. If |v|² is not
    /// within [1/p, p], the formulas square v/p or p·v instead of v.
    ///
    /// Choose p so that a sum of three squares within [1/p, p] loses no bits, the largest vector
    /// divided by p has its square below p, and the smallest number times p is not below 1/p. For
    /// `f32` p is 2¹⁰⁰ and for `f64` 2⁷²⁰. For a fixed-point number with 16 bits before the point
    /// and 16 after it, 2⁹ is best.
    const EXTREME: Self;

    /// The number nearest to a literal. The literal is an `f64`, so that users of `f64` lose
    /// nothing. If single precision holds the literal, [`of_f32`](Real::of_f32) avoids `f64` even
    /// in constants.
    #[must_use]
    fn of(literal: f64) -> Self;

    /// The square root. The root of a negative number is NaN.
    #[must_use]
    fn sqrt(self) -> Self;

    /// Selects `then` where `self` > 0 and `otherwise` elsewhere, also for 0, −0 and NaN. In lanes,
    /// each lane is selected on its own. Maximum, clamp and all guards are built from this method.
    ///
    /// ```
    /// use shading::Real;
    ///
    /// assert_eq!(2.0_f32.if_positive(10.0, 20.0), 10.0);
    /// assert_eq!(0.0_f32.if_positive(10.0, 20.0), 20.0);
    /// ```
    #[doc(alias = "select")]
    #[must_use]
    fn if_positive(self, then: Self, otherwise: Self) -> Self;

    /// Whether `self` > 0 or, for lanes, whether any lane is. If it is false, a whole computation
    /// may be skipped.
    #[must_use]
    fn any_positive(self) -> bool;

    // the methods below are derived

    /// The number nearest to a single-precision literal, for processors without double precision,
    /// such as many GPUs.
    #[inline]
    #[must_use]
    fn of_f32(literal: f32) -> Self {
        Self::of(literal.into())
    }

    /// `then` where `self` > `threshold`, and `otherwise` elsewhere, lane by lane.
    #[doc(alias = "select")]
    #[inline]
    #[must_use]
    fn if_above(self, threshold: Self, then: Self, otherwise: Self) -> Self {
        (self - threshold).if_positive(then, otherwise)
    }

    /// The absolute value. Its derivative at 0 is taken to be 0, the mean of the slopes on the two
    /// sides.
    #[inline]
    #[must_use]
    fn abs(self) -> Self {
        // 0, −0 and NaN are neither above nor below 0; NaN stays NaN
        self.if_positive(self, (-self).if_positive(-self, self + -self))
    }

    /// The maximum, max(self, floor); `floor` if `self` is NaN. A signaling NaN, which no operation
    /// produces, may stay NaN on AArch64 and POWER.
    #[doc(alias = "max")]
    #[inline]
    #[must_use]
    fn at_least(self, floor: Self) -> Self {
        self.if_above(floor, self, floor)
    }

    /// The minimum, min(self, limit).
    #[doc(alias = "min")]
    #[inline]
    #[must_use]
    fn at_most(self, limit: Self) -> Self {
        self.if_above(limit, limit, self)
    }

    /// Whether `self` or, for lanes, any lane is outside [low, high]. The limits must not be
    /// negative. NaN is outside. For −0 and for the limits themselves, except a `high` of 1, the
    /// result is unspecified.
    #[doc(hidden)]
    #[inline]
    #[must_use]
    fn any_outside(self, low: Self, high: Self) -> bool {
        let outside = (self - low).if_positive(Self::ZERO, Self::ONE);
        (high - self).if_positive(outside, Self::ONE).any_positive()
    }

    // What is computed of three numbers at once, or of a cosine. The defaults are for floats; a number
    // whose precision is not relative overrides them.

    /// The dot product.
    #[doc(hidden)]
    #[inline]
    #[must_use]
    fn dot([ax, ay, az]: [Self; 3], [bx, by, bz]: [Self; 3]) -> Self {
        ax * bx + ay * by + az * bz
    }

    /// Each number times a factor.
    #[doc(hidden)]
    #[inline]
    #[must_use]
    fn scaled([x, y, z]: [Self; 3], factor: Self) -> [Self; 3] {
        [x * factor, y * factor, z * factor]
    }

    /// Each number divided by a divisor.
    #[doc(hidden)]
    #[inline(always)]
    #[must_use]
    fn divided(numbers: [Self; 3], divisor: Self) -> [Self; 3] {
        root::divided(numbers, divisor)
    }

    /// self/whole, where `whole` may be infinite; in a type without infinities, `MAX` counts as infinite.
    #[doc(hidden)]
    #[inline]
    #[must_use]
    fn ratio(self, whole: Self) -> Self {
        self / whole
    }

    /// The share of a light that its range r leaves, which may be infinite as for [`ratio`](Real::ratio).
    ///
    /// ```text
    /// max(0, 1 − (q/r)⁴), or its square
    /// ```
    #[doc(hidden)]
    #[inline]
    #[must_use]
    fn window(q: Self, r: Self, is_squared: bool) -> Self {
        triple::window(q, r, is_squared)
    }

    /// The distance from 1 to the next number above.
    #[doc(hidden)]
    #[inline]
    #[must_use]
    fn epsilon() -> Self {
        epsilon()
    }

    /// The cosine of a half-angle in radians; `None` outside [0, π].
    #[doc(hidden)]
    #[must_use]
    fn cosine_of_half_angle(self) -> Option<Self>
    where
        Self: PartialOrd,
    {
        angle::cosine_of_half_angle(self)
    }

    /// v/(a + bq + cq²), where 1/(a + bq + cq²) counts as `limit` at most, given the two q of
    /// [`direction_and_distance`](Real::direction_and_distance).
    #[doc(hidden)]
    #[inline(always)]
    #[must_use]
    fn attenuated(
        v: [Self; 3],
        coefficients: [Self; 3],
        q: [Self; 2],
        limit: impl FnOnce() -> Self,
    ) -> [Self; 3] {
        triple::attenuated(v, coefficients, q[0], limit)
    }

    /// The same times the [`window`](Real::window) of a range r and whether it is squared. q is the
    /// length of `to_light`.
    #[doc(hidden)]
    #[inline(always)]
    #[must_use]
    fn attenuated_within(
        (r, is_squared): (Self, bool),
        v: [Self; 3],
        coefficients: [Self; 3],
        q: [Self; 2],
        _to_light: impl FnOnce() -> [Self; 3],
        limit: impl FnOnce() -> Self,
    ) -> [Self; 3] {
        let v = Self::scaled(v, Self::window(q[0], r, is_squared));
        Self::attenuated(v, coefficients, q, limit)
    }

    /// |v|.
    #[doc(hidden)]
    #[inline]
    #[must_use]
    fn length(v: [Self; 3]) -> Self {
        triple::length(v)
    }

    /// v/|v|, and a number that is positive exactly if v has a direction.
    #[doc(hidden)]
    #[inline]
    #[must_use]
    fn unit(v: [Self; 3]) -> ([Self; 3], Self) {
        triple::unit(v)
    }

    /// `to` − `from`, times a power of two that keeps its products within range, and that power, for
    /// [`rescaled_by`](Real::rescaled_by).
    #[doc(hidden)]
    #[inline]
    #[must_use]
    fn rescaled_difference(to: [Self; 3], from: [Self; 3]) -> ([Self; 3], Self) {
        triple::rescaled_difference(to, from)
    }

    /// Whether the product of two vectors may need them [rescaled](Real::rescaled_difference), given the sizes
    /// of their largest components, the smaller one first.
    #[doc(hidden)]
    #[inline]
    #[must_use]
    fn is_any_extreme(sizes: [Self; 2]) -> bool {
        triple::is_any_extreme(sizes)
    }

    /// Three vectors times one power of two, likewise, if there is one for all.
    #[doc(hidden)]
    #[inline]
    #[must_use]
    fn rescaled_together(vectors: [[Self; 3]; 3]) -> Option<([[Self; 3]; 3], Self)> {
        triple::rescaled_together(vectors)
    }

    /// v times a power that rescaled another vector.
    #[doc(hidden)]
    #[inline]
    #[must_use]
    fn rescaled_by(v: [Self; 3], power: Self) -> [Self; 3] {
        Self::scaled(v, power)
    }

    /// L, q and the distance of a light, given its position and the point, and the way to the light. There
    /// are two q: one to compute with, and one that may be finer, for [`attenuated`](Real::attenuated) alone.
    /// A light without a direction has a q at which it is black or [`is_lit`](Real::is_lit) is false.
    #[doc(hidden)]
    #[inline(always)]
    #[must_use]
    fn direction_and_distance(
        light_and_p: impl FnOnce() -> [[Self; 3]; 2],
        to_light: [Self; 3],
    ) -> ([Self; 3], [Self; 2], Self) {
        triple::direction_and_distance(light_and_p, to_light)
    }

    /// Whether light may arrive from q.
    #[doc(hidden)]
    #[inline(always)]
    #[must_use]
    fn is_lit(_q: Self) -> bool {
        true
    }

    /// N·H, where H is the half vector of L and V, or its square; 0 if L = −V.
    #[doc(hidden)]
    #[inline(always)]
    #[must_use]
    fn half_cosine(n: [Self; 3], l: [Self; 3], v: [Self; 3], squared: bool) -> Self {
        triple::half_cosine(n, l, v, squared)
    }

    /// m/2, if the square of N·H costs less than N·H itself and is raised instead.
    #[doc(hidden)]
    #[inline]
    #[must_use]
    fn half_of(m: u32) -> Option<u32> {
        (m % 2 == 0).then_some(m / 2)
    }

    /// R·V, where R is the reflection of L.
    #[doc(hidden)]
    #[inline]
    #[must_use]
    fn reflected_cosine(n: [Self; 3], l: [Self; 3], v: [Self; 3]) -> Self {
        Self::dot(triple::reflection(n, l), v)
    }

    /// The m-th power of a cosine, as a function of the cosine.
    #[doc(hidden)]
    #[inline]
    #[must_use]
    fn cosine_power(m: u32) -> impl Fn(Self) -> Self {
        whole_power::of_cosine(m)
    }
}

/// The distance from 1 to the next number above, or 2⁻¹⁰⁰ if that is smaller: what is computed from
/// a sum of two numbers, as some types are, errs by more than the next number above 1 tells.
fn epsilon<T: Real>() -> T {
    let half = T::ONE / (T::ONE + T::ONE);
    let mut epsilon = T::ONE;
    for _ in 0..100 {
        let smaller = epsilon * half;
        if !(T::ONE + smaller - T::ONE).any_positive() {
            break;
        }
        epsilon = smaller;
    }
    epsilon
}

/// A constant as the sum of three numbers in single precision, split by the compiler.
/// `constant(const { parts(PI) })` uses no `f64` on the path of `f32`.
#[inline]
pub(crate) fn constant<T: Real>([first, second, third]: [f32; 3]) -> T {
    T::of_f32(first) + T::of_f32(second) + T::of_f32(third)
}

#[allow(clippy::cast_possible_truncation, clippy::cast_lossless)]
pub(crate) const fn parts(constant: f64) -> [f32; 3] {
    let first = constant as f32;
    let rest = constant - first as f64;
    let second = rest as f32;
    [first, second, (rest - second as f64) as f32]
}
