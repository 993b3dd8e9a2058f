//! The number type that every formula is written over.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::triple::{Rgb, Vec3};
use super::{Lobe, Mask, by_squaring, falloff, length};

/// A real number: `f32`, `f64`, a dual number, a set of SIMD lanes, or a type of your own.
///
/// The trait has the operations that the formulas of this crate need. `f32`, `f64` and the SIMD
/// lanes round each of + − × ÷ √ correctly, so their results have the same bits on every machine.
/// A comparison gives a [`Mask`](Real::Mask), a `bool` for each lane, and [`select`](Mask::select)
/// makes each decision by one.
///
/// ```
/// use shading::Real;
///
/// /// The length of the hypotenuse, for every number type.
/// fn hypotenuse<T: Real>(a: T, b: T) -> T {
///     (a * a + b * b).sqrt()
/// }
/// assert_eq!(hypotenuse(3.0_f32, 4.0), 5.0);
/// ```
///
/// # A number of your own
///
/// Write the items without a default: two types, five constants and three functions. For a scalar, the
/// types are `type Mask = bool;` and `type Sum = Rgb<Self>;`.
///
/// - No operation may panic. A division by zero may give any number.
/// - If the operations round correctly, results have the same bits on every machine, and the error
///   bounds of [`guide::precision`](mod@crate::guide::precision) hold in units of the type's
///   roundoff. Otherwise, everything but these two guarantees still holds.
///
/// The methods from [`of_f32`](Real::of_f32) to [`finite`](Real::finite) are derived; override one if a
/// processor has a better way to the same result. Those from [`dot`](Real::dot) on are **hooks**: each
/// computes several operations at once. A number overrides one to keep digits between them, as fixed
/// point must, or to choose another order. What wraps a number, as [`Dual`](crate::Dual) does, calls the
/// hooks of the number inside.
///
/// [`guide::numbers`](mod@crate::guide::numbers) has a complete number, and says how to test it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a number type that this crate computes with",
    label = "expected `f32`, `f64`, `Dual<_>` or SIMD lanes",
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
    /// Where a comparison holds: `bool`, or one for each lane.
    type Mask: Mask<Self>;
    /// What a sum over lights is held in: `Rgb<Self>`, or a sum with more digits.
    type Sum: LightSum<Self>;

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
    /// `f32` p is 2¹⁰⁰ and for `f64` 2⁷²⁰.
    const EXTREME: Self;

    /// Converts an `f64` literal to the nearest number.
    #[must_use]
    fn of(literal: f64) -> Self;

    /// The square root. The root of a negative number is NaN.
    #[must_use]
    fn sqrt(self) -> Self;

    /// Where `self` > `other`; nowhere, if either is NaN.
    #[doc(alias("gt", "greater"))]
    #[must_use]
    fn above(self, other: Self) -> Self::Mask;

    /// The number nearest to a single-precision literal, for processors without double precision,
    /// such as many GPUs.
    #[inline]
    #[must_use]
    fn of_f32(literal: f32) -> Self {
        Self::of(literal.into())
    }

    /// The maximum, max(self, floor); `floor` if `self` is NaN. A signaling NaN, which no operation
    /// produces, may stay NaN on AArch64 and POWER.
    #[doc(alias = "max")]
    #[inline]
    #[must_use]
    fn at_least(self, floor: Self) -> Self {
        self.above(floor).select(self, floor)
    }

    /// The minimum, min(self, limit).
    #[doc(alias = "min")]
    #[inline]
    #[must_use]
    fn at_most(self, limit: Self) -> Self {
        self.above(limit).select(limit, self)
    }

    /// Whether `self` is outside of the range from `low` to `high`, both positive, or NaN; for lanes,
    /// whether any lane is. The ends may count as either.
    #[inline]
    #[must_use]
    fn any_outside(self, low: Self, high: Self) -> bool {
        !self.above(low).all() || !high.above(self).all()
    }

    /// The number, or [`MAX`](Real::MAX) if it is infinite or NaN.
    #[inline]
    #[must_use]
    fn finite(self) -> Self {
        Self::MAX.above(self).select(self, Self::MAX)
    }

    /// The dot product of two vectors. A fixed-point number may round it once, and keep its sign.
    ///
    /// ```text
    /// a.x b.x + a.y b.y + a.z b.z
    /// ```
    #[inline(always)]
    #[must_use]
    fn dot(a: Vec3<Self>, b: Vec3<Self>) -> Self {
        a.x * b.x + a.y * b.y + a.z * b.z
    }

    /// Where v points to the front of a surface with the normal n: where n·v > 0. It decides which lights
    /// count, before any root. A float takes the sign of the rounded sum, and fixed point that of the exact one.
    #[inline(always)]
    #[must_use]
    fn faces(n: Vec3<Self>, v: Vec3<Self>) -> Self::Mask {
        Self::dot(n, v).above(Self::ZERO)
    }

    /// The length of v, and its direction, not yet divided by a length: one root for both.
    ///
    /// For a float, w is v, or v times a power of two if the square of v is out of range. A
    /// fixed-point number may divide by |v| here, and return 1 for |w|.
    #[inline(always)]
    #[must_use]
    fn measured(v: Vec3<Self>) -> Measured<Self> {
        length::measured(v)
    }

    /// [`measured`](Real::measured), and n·w, for a v that [faces](Real::faces) the surface.
    #[inline(always)]
    #[must_use]
    fn toward(n: Vec3<Self>, v: Vec3<Self>) -> Toward<Self> {
        length::toward(n, v)
    }

    /// The cosine of the angle between n and v, from what [`toward`](Real::toward) returned for the two.
    /// A processor that would rather compute n·w late than keep it may do so here.
    ///
    /// ```text
    /// max(0, n·w/|w|), at most 1
    /// ```
    // One hook for this and `toward` was tried: Phong −4 to −6 % of the time, but Blinn with a whole m +6
    // to +15 %.
    #[inline(always)]
    #[must_use]
    fn cosine(_n: Vec3<Self>, toward: &Toward<Self>) -> Self {
        length::cosine(toward.n_dot_w, toward.measured.w_length)
    }

    /// The vector from one point to another, times a power of two if its square or its products would overflow or
    /// vanish. A fixed-point number may scale every vector, so that their products have digits.
    #[inline(always)]
    fn between(origin: Vec3<Self>, v: Vec3<Self>) -> Vec3<Self> {
        length::between(origin, v)
    }

    /// A vector in the direction of the normal of a triangle, whose length means nothing; 0 if there is none.
    ///
    /// ```text
    /// (a − origin) × (b − origin)
    /// ```
    #[inline(always)]
    fn crossed(origin: Vec3<Self>, a: Vec3<Self>, b: Vec3<Self>) -> Vec3<Self> {
        length::crossed(origin, a, b)
    }

    /// The power of a number within [0, 1] by a whole number; a number above 1 may count as 1.
    ///
    /// ```text
    /// selfᵐ
    /// ```
    #[inline]
    #[must_use]
    fn whole_power(self, m: u32) -> Self {
        by_squaring(self, m)
    }

    /// The lobe of the cosine between a direction n and the vector halfway between w and a direction v,
    /// limited to 1. It is 0 if the cosine is not above 0, and if there is no such vector.
    ///
    /// ```text
    /// max(0, n·h/|h|)ᵐ,  h = w + |w| v
    /// ```
    #[inline(always)]
    #[must_use]
    fn halfway_power(n: Vec3<Self>, w: Measured<Self>, v: Vec3<Self>, m: impl Lobe<Self>) -> Self {
        length::halfway_power(n, w, v, m)
    }

    /// A light after the distance q ≥ 0, with a factor of at most `limit`. The factor is 0 if the
    /// denominator is negative or NaN.
    ///
    /// ```text
    /// color · min(limit, 1/(a + bq + cq²))
    /// ```
    #[inline(always)]
    #[must_use]
    fn attenuated(color: Rgb<Self>, coefficients: [Self; 3], q: Self, limit: Self) -> Dimmed<Self> {
        let factor = falloff::attenuation(coefficients, q, limit);
        Dimmed { color, factor }
    }

    /// A light times the window of a range r, which ends it at r. The light is at the end of the vector v, of
    /// length q.
    ///
    /// ```text
    /// light · max(0, 1 − (q/r)⁴)², or not squared
    /// ```
    #[inline(always)]
    #[must_use]
    fn windowed(
        Dimmed { color, factor }: Dimmed<Self>,
        _v: Vec3<Self>,
        q: Self,
        range: Self,
        is_squared: Self::Mask,
    ) -> Dimmed<Self> {
        let factor = factor * falloff::window(q, range, is_squared);
        Dimmed { color, factor }
    }

    /// A light times the factor of a cone, given its axis, the cosines of its half-angles, inner ≥ outer, which
    /// are equal for a hard edge, and the vector v to the light, of the direction w.
    ///
    /// ```text
    /// light · t², or light · t²(3 − 2t) if it is smooth,
    /// t = (−axis·w/|w| − outer)/(inner − outer) within [0, 1]
    /// ```
    #[inline(always)]
    #[must_use]
    fn beamed(
        Dimmed { color, factor }: Dimmed<Self>,
        axis: Vec3<Self>,
        inner_and_outer: [Self; 2],
        is_smooth: Self::Mask,
        _v: Vec3<Self>,
        Measured { w, w_length, .. }: &Measured<Self>,
    ) -> Dimmed<Self> {
        let cosine = Self::dot(-axis, *w) / *w_length;
        let factor = factor * falloff::beam(cosine, inner_and_outer, is_smooth);
        Dimmed { color, factor }
    }

    /// The cosine of an angle within [0, π], for the edge of a cone: by a series of + − × ÷, with an error
    /// below ε. Of a scene in flash, the compiler computes the same in a constant.
    #[inline]
    #[must_use]
    fn half_angle_cosine(self) -> Self {
        super::cosine::cosine(self)
    }
}

/// The length of a vector v, and its direction, not yet divided by a length: what [`Real::measured`]
/// gives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured<T> {
    /// w, a vector in the direction of v. Its square, and those of its sums with vectors of its length,
    /// neither overflow nor vanish.
    pub w: Vec3<T>,
    /// |w|; 0 if v has no direction, because it is zero, infinite or NaN.
    pub w_length: T,
    /// |v|; the largest finite number if it overflows, and infinite if v is.
    pub length: T,
}

impl<T: Real> Measured<T> {
    /// A vector whose direction has length 1.
    #[inline(always)]
    pub(crate) fn along(w: Vec3<T>, length: T) -> Self {
        let w_length = T::ONE;
        Self {
            w,
            w_length,
            length,
        }
    }
}

/// A vector that a surface with the normal n faces: what [`Real::toward`] gives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Toward<T> {
    /// The direction w and the length of the vector.
    pub measured: Measured<T>,
    /// n·w.
    pub n_dot_w: T,
}

/// A light and the factor that dims it, not yet multiplied: a factor near 0 has few digits in fixed
/// point. A number may multiply at once, and let the factor be 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dimmed<T> {
    /// The light.
    pub color: Rgb<T>,
    /// The factor.
    pub factor: T,
}

impl<T: Real> Dimmed<T> {
    /// A light that nothing dims.
    #[inline(always)]
    pub(crate) fn full(color: Rgb<T>) -> Self {
        Self {
            color,
            factor: T::ONE,
        }
    }

    /// The light times its factor.
    #[inline(always)]
    pub(crate) fn multiplied(self) -> Rgb<T> {
        self.color * self.factor
    }
}

/// A sum over lights. For a float it is a color; a fixed-point number may hold it with more digits.
pub trait LightSum<T>: Copy {
    /// No light.
    const DARK: Self;
    /// The sum plus a light times a cosine or a highlight within [0, 1].
    ///
    /// ```text
    /// self + light.color · light.factor · cosine
    /// ```
    #[must_use]
    fn add(self, light: Dimmed<T>, cosine: T) -> Self;
    /// The sum as a color; the largest finite number in a channel that overflowed.
    fn total(self) -> Rgb<T>;
}

impl<T: Real> LightSum<T> for Rgb<T> {
    const DARK: Self = Self::new(T::ZERO, T::ZERO, T::ZERO);

    #[inline(always)]
    fn add(self, Dimmed { color, factor }: Dimmed<T>, cosine: T) -> Self {
        self + color * (factor * cosine)
    }

    #[inline(always)]
    fn total(self) -> Self {
        self.map(T::finite)
    }
}

/// |x|
#[inline]
pub(crate) fn magnitude<T: Real>(x: T) -> T {
    x.at_least(-x)
}
