//! Floor 0: the number that every formula is written over.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// A real number: `f32`, `f64`, a dual number, a set of SIMD lanes, or a type of your own.
///
/// It holds the operations that the formulas of this crate need and no more. All of them round
/// correctly, which is why a result has the same bits on every machine. There is no comparison:
/// a decision is taken lane by lane, by [`if_positive`](Real::if_positive).
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
/// Write the constants, [`of`](Real::of), [`sqrt`](Real::sqrt), [`if_positive`](Real::if_positive) and
/// [`any_positive`](Real::any_positive), which stand first. The rest is derived; where a processor has
/// better, replace it by what gives the same result.
///
/// - No operation panics. Division by zero gives an infinity or, in a type without one, any number.
/// - [`if_positive`](Real::if_positive) chooses lane by lane and computes nothing;
///   [`any_positive`](Real::any_positive) is whether it would choose `then` in some lane.
/// - Operations that round correctly give the same bits on every machine, and the error bounds of
///   [`mod@crate::guide::precision`] in units of the type's roundoff. Others cost no more than that.
///
/// [`mod@crate::guide::invariants`] tells how to test it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a number that this crate computes with",
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
    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;
    /// Minus one.
    const NEG_ONE: Self;
    /// The largest finite number.
    const MAX: Self;
    /// A power of two *p* that tames a vector of any length: where |v|² is not within [1/p, p], the
    /// vector is extreme, and v/p or p·v is squared in its place.
    ///
    /// So 1/p and p are far enough from the ends of the range for a sum of three squares within them to
    /// lose no bits; the largest vector over p has its square below p, and the smallest number times p
    /// is not below 1/p. It is 2¹⁰⁰ for `f32` and 2⁷²⁰ for `f64`; for a number with 16 bits before its point
    /// and 16 behind it, 2⁹ is best.
    const EXTREME: Self;

    /// The number nearest to a literal. It is an `f64` so that users of `f64` lose nothing; where single
    /// precision holds the literal, [`of_f32`](Real::of_f32) has no `f64` even in constants.
    #[must_use]
    fn of(literal: f64) -> Self;

    /// The square root; not a number below zero.
    #[must_use]
    fn sqrt(self) -> Self;

    /// `then` where `self` > 0, and `otherwise` where it is not (0, −0 and NaN included), lane by
    /// lane. Maximum, clamp and every guard against a degenerate case are made of it.
    #[must_use]
    fn if_positive(self, then: Self, otherwise: Self) -> Self;

    /// Whether `self` > 0, for lanes: in at least one of them. It tells whether a computation may
    /// be skipped as a whole.
    #[must_use]
    fn any_positive(self) -> bool;

    // what follows is derived

    /// [`of`](Real::of) a literal in single precision: for processors without double precision, as
    /// GPUs often are.
    #[inline]
    #[must_use]
    fn of_f32(literal: f32) -> Self {
        Self::of(literal.into())
    }

    /// `then` where `self` > `threshold`, and `otherwise` where it is not, lane by lane.
    #[inline]
    #[must_use]
    fn if_above(self, threshold: Self, then: Self, otherwise: Self) -> Self {
        (self - threshold).if_positive(then, otherwise)
    }

    /// The absolute value. At 0 its derivative is taken to be 0, the mean of the two sides.
    #[inline]
    #[must_use]
    fn abs(self) -> Self {
        // neither above nor below 0 are 0, −0 and NaN, which stays
        self.if_positive(self, (-self).if_positive(-self, self + -self))
    }

    /// max(self, floor), and the floor for NaN. A signaling NaN, which no operation produces, may stay
    /// NaN on AArch64 and POWER.
    #[inline]
    #[must_use]
    fn at_least(self, floor: Self) -> Self {
        self.if_above(floor, self, floor)
    }

    /// min(self, limit).
    #[inline]
    #[must_use]
    fn at_most(self, limit: Self) -> Self {
        self.if_above(limit, limit, self)
    }

    /// Whether `self` is outside [low, high], for lanes: in at least one of them. The limits are
    /// not negative, NaN is outside, and for −0 and the limits themselves, but a `high` of 1, the answer
    /// is open.
    #[doc(hidden)]
    #[inline]
    #[must_use]
    fn any_outside(self, low: Self, high: Self) -> bool {
        let outside = (self - low).if_positive(Self::ZERO, Self::ONE);
        (high - self).if_positive(outside, Self::ONE).any_positive()
    }
}

/// A constant as the sum of three numbers in single precision, which the compiler computes:
/// `constant(const { parts(PI) })` has no `f64` on the path of `f32`.
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

macro_rules! float {
    ($float:ident, $extreme:expr, $sqrt:path) => {
        #[diagnostic::do_not_recommend] // the trait's own message names the types
        impl Real for $float {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const NEG_ONE: Self = -1.0;
            const MAX: Self = $float::MAX;
            const EXTREME: Self = $extreme;

            #[inline]
            #[allow(clippy::cast_possible_truncation, clippy::cast_lossless)]
            fn of(literal: f64) -> Self {
                literal as Self
            }

            #[inline]
            #[allow(clippy::useless_conversion)]
            fn of_f32(literal: f32) -> Self {
                literal.into()
            }

            #[inline]
            fn sqrt(self) -> Self {
                $sqrt(self)
            }

            #[inline]
            fn if_positive(self, then: Self, otherwise: Self) -> Self {
                if self > 0.0 { then } else { otherwise }
            }

            #[inline]
            fn any_positive(self) -> bool {
                self > 0.0
            }

            // the bits of positive numbers are ordered as the numbers are, and one comparison
            // of whole numbers takes the place of two subtractions; where `high` itself is outside,
            // Arm has the two constants of that comparison in its instructions
            #[inline]
            fn any_outside(self, low: Self, high: Self) -> bool {
                let above_low = self.to_bits().wrapping_sub(low.to_bits());
                let range = high.to_bits().wrapping_sub(low.to_bits());
                if low > 0.0 {
                    above_low >= range
                } else {
                    above_low > range
                }
            }

            #[inline]
            fn abs(self) -> Self {
                $float::abs(self)
            }

            // a comparison that the compiler can turn into the processor's minimum or maximum;
            // `f32::min` is a library call on Arm
            #[inline]
            fn if_above(self, threshold: Self, then: Self, otherwise: Self) -> Self {
                if self > threshold { then } else { otherwise }
            }
        }
    };
}

// 2^100 and 2^720, as their bits
float!(f32, f32::from_bits((127 + 100) << 23), crate::root::sqrtf);
float!(f64, f64::from_bits((1023 + 720) << 52), crate::root::sqrt);
