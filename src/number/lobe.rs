//! The shininess m of a highlight.

use core::convert::identity;

use super::power::{double, double_of_quotient, single, single_of_quotient};
use super::{Mask, Real};

/// The shininess m of a highlight: an integer (`u32`) or a real number of the scene's type (`f32`,
/// `f64`). The type of the argument decides; an integer is faster:
///
/// ```
/// use shading::{UnitVec3, term::blinn};
///
/// let n = UnitVec3::<f32>::Z;
/// let h = UnitVec3::<f32>::new(0.0, 0.6, 0.8).unwrap();
/// let integer = blinn(n, h, 32); // five multiplications
/// let real = blinn(n, h, 32.5);
/// assert!(real < integer);
/// ```
///
/// # A highlight of your own
///
/// Implement [`raise`](Lobe::raise), and it shapes the highlight of every term and every sum.
/// It need not be a power. Here the highlight is a disk with a sharp edge, as in a cartoon:
///
/// ```
/// use shading::{Lobe, UnitVec3, term::blinn};
///
/// /// The cosine at the edge of the disk.
/// #[derive(Clone, Copy)]
/// struct Disk(f32);
///
/// impl Lobe<f32> for Disk {
///     fn raise(self, cosine: f32) -> f32 {
///         if cosine > self.0 { 1.0 } else { 0.0 }
///     }
/// }
/// assert_eq!(blinn(UnitVec3::Z, UnitVec3::Z, Disk(0.9)), 1.0);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be the shininess of a highlight in numbers of type `{T}`",
    label = "expected `u32`, or one real number: `f32`, `f64`",
    note = "an integer shininess is a `u32`, as in `m: 32`; a real one has the scene's number type, as in `m: 32.5`",
    note = "`term::phong` and `term::blinn` are factors; the functions that take a material are in `shade`"
)]
#[doc(alias("exponent", "shininess"))]
pub trait Lobe<T: Real>: Copy {
    /// cosineᵐ, within [0, 1], for a cosine within [0, 1].
    ///
    /// The terms and the sums call it with no other cosine: your own highlight never has to handle
    /// light from behind. They do not use the result for a cosine of 0; the factor is then 0 for
    /// **every** m. Above 0, the power with m = 0 is 1. A negative or NaN m counts as 0. 1 to any power
    /// is 1, even if m is infinite.
    ///
    /// With an integer m the relative error is at most m·u, the conditioning of the power itself,
    /// where u is the unit roundoff (2⁻²⁴ for `f32`). With a real m the absolute error is at most
    /// 2⁻²² in `f32` and 2⁻⁵¹ in `f64`. A power that would be subnormal has fewer digits, or is 0.
    ///
    /// ```
    /// use shading::Lobe;
    ///
    /// assert_eq!(3_u32.raise(0.5_f32), 0.125);
    /// assert!((3.0_f32.raise(0.5_f32) - 0.125).abs() < 1e-6);
    /// ```
    #[doc(alias("pow", "powf"))]
    #[must_use]
    fn raise(self, cosine: T) -> T;

    /// The power of a cosine that is given by its square, within [0, 1].
    ///
    /// ```text
    /// (√square)ᵐ
    /// ```
    ///
    /// An even or real m takes no root: it is √squareᵐ = square^(m/2).
    #[inline]
    #[must_use]
    fn raise_root(self, square: T) -> T {
        self.raise(square.sqrt())
    }

    /// The power of a cosine whose square is given as a quotient. A quotient above 1, or of 0 by 0,
    /// counts as 1.
    ///
    /// ```text
    /// (√(square/of))ᵐ
    /// ```
    ///
    /// A real m needs no division but that of the logarithm.
    ///
    /// ```
    /// use shading::Lobe;
    ///
    /// assert_eq!(4_u32.raise_quotient(2.0_f32, 8.0), 0.0625); // (√¼)⁴
    /// ```
    #[inline]
    #[must_use]
    fn raise_quotient(self, square: T, of: T) -> T {
        let square = square / of;
        self.raise_root(T::ONE.above(square).select(square, T::ONE))
    }
}

#[diagnostic::do_not_recommend] // the trait's own message names the types
impl<T: Real> Lobe<T> for u32 {
    #[inline]
    fn raise(self, cosine: T) -> T {
        least::<T>(self)
            .above(cosine)
            .select(T::ZERO, cosine)
            .whole_power(self)
    }

    #[inline]
    fn raise_root(self, square: T) -> T {
        if self % 2 == 0 {
            (self / 2).raise(square)
        } else {
            self.raise(square.sqrt())
        }
    }
}

/// The cosine whose m-th power is the least normal number of single precision, 2^(−126/m), for
/// m ≥ 1; 0 in a type with a wider range, and in one without such numbers.
///
/// Below it, squaring would pass through subnormal numbers, which cost some processors up to a
/// hundred times as much.
#[inline]
fn least<T: Real>(m: u32) -> T {
    const ONE: u32 = 1.0_f32.to_bits();
    const OCTAVE: u32 = 1 << 23;
    // The bits of a float are its logarithm, except that the significand 1 + x stands for
    // log₂(1 + x), which is about x + 0.39 (¼ − (x − ½)²). The result never exceeds the true one.
    // Of integers: with floats, the saturation of the conversion makes a sum up to 7 % slower on x86-64.
    let linear = ONE.wrapping_sub(126 * OCTAVE / if m > 1 { m } else { 1 });
    let from_half = (linear >> 12 & 0x7FF).wrapping_sub(0x400);
    let bend = 0x10_0000 - from_half.wrapping_mul(from_half);
    let least = f32::from_bits(linear.wrapping_sub(bend / 32 * 25 + 1600));
    let is_wider = T::MAX.above(T::of_f32(f32::MAX));
    let is_fine = T::of_f32(f32::MIN_POSITIVE).above(T::ZERO);
    let least = is_wider.select(T::ZERO, T::of_f32(least));
    is_fine.select(least, T::ZERO)
}

/// baseᵐ by repeated squaring, from the lowest bit of m up, so that no square waits for a product.
#[inline]
pub(crate) fn by_squaring<T: Real>(mut base: T, mut m: u32) -> T {
    let mut power = T::ONE;
    loop {
        if m & 1 == 1 {
            power = power * base;
        }
        m >>= 1;
        if m == 0 {
            return power;
        }
        base = base * base;
    }
}

/// m/2 as the powers take it. The product has quieted a signaling NaN, so [`shininess`] can be shorter.
#[inline]
pub(crate) fn half_shininess<T: Real>(m: T) -> T {
    (T::of_f32(0.5) * m).at_least(T::ZERO).at_most(T::MAX)
}

/// m as the powers take it: finite and at least 0.
#[inline]
pub(crate) fn shininess<T: Real>(m: T) -> T {
    // not `at_least`, which may let a signaling NaN through
    m.above(T::ZERO).select(m.at_most(T::MAX), T::ZERO)
}

/// One real m, for a number or for all lanes, to which `of` takes it.
macro_rules! real {
    ($float:ident in $number:ty, $of:path, $power:path, $quotient:path) => {
        #[diagnostic::do_not_recommend] // the trait's own message names the types
        impl Lobe<$number> for $float {
            #[inline]
            fn raise(self, cosine: $number) -> $number {
                $power(cosine, $of(shininess(self)))
            }

            #[inline]
            fn raise_root(self, square: $number) -> $number {
                (0.5 * self).raise(square)
            }

            #[inline]
            fn raise_quotient(self, square: $number, of: $number) -> $number {
                $quotient(square, of, $of(half_shininess(self)))
            }
        }
    };
}
#[cfg(feature = "wide")]
pub(crate) use real;

real!(f32 in f32, identity, single, single_of_quotient);
real!(f64 in f64, identity, double, double_of_quotient);
