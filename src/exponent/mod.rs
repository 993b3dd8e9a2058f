//! The shininess m of a highlight.

pub(crate) mod power;

use crate::real::Real;
use power::power;

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
/// Implement [`raise`](Exponent::raise), and it shapes the highlight of every term and every sum.
/// It need not be a power. Here the highlight is a disk with a sharp edge, as in a cartoon:
///
/// ```
/// use shading::{Exponent, UnitVec3, term::blinn};
///
/// /// The cosine at the edge of the disk.
/// #[derive(Clone, Copy)]
/// struct Disk(f32);
///
/// impl Exponent<f32> for Disk {
///     fn raise(self, cosine: f32) -> f32 {
///         if cosine > self.0 { 1.0 } else { 0.0 }
///     }
/// }
/// assert_eq!(blinn(UnitVec3::Z, UnitVec3::Z, Disk(0.9)), 1.0);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be the shininess of a highlight in numbers of type `{T}`",
    label = "expected `u32` or `{T}`",
    note = "an integer shininess is a `u32`, as in `m: 32`; a real one has the scene's number type, as in `m: 32.5`",
    note = "`term::phong` and `term::blinn` are factors; the functions that take a material are in `shade`"
)]
pub trait Exponent<T: Real>: Copy {
    /// cosineᵐ, within [0, 1].
    ///
    /// A cosine above 1, as rounding may produce, counts as 1. If the cosine is 0, negative or NaN,
    /// the power is 0 for **every** m. Above 0, the power with m = 0 is 1. A negative or NaN m
    /// counts as 0. 1 to any power is 1, even if m is infinite.
    ///
    /// With an integer m the relative error is at most m·u, the conditioning of the power itself,
    /// where u is the unit roundoff (2⁻²⁴ for `f32`). With a real m in `f32` the absolute error is
    /// at most 2⁻²². In `f32`, a power that would be subnormal may be 0.
    ///
    /// ```
    /// use shading::Exponent;
    ///
    /// assert_eq!(3_u32.raise(0.5_f32), 0.125);
    /// assert!((3.0_f32.raise(0.5_f32) - 0.125).abs() < 1e-6);
    /// assert_eq!(0_u32.raise(-0.5_f32), 0.0); // turned away: no highlight, even with m = 0
    /// ```
    #[doc(alias = "pow")]
    #[doc(alias = "powf")]
    #[must_use]
    fn raise(self, cosine: T) -> T;
}

#[diagnostic::do_not_recommend] // the trait's own message names the types
impl<T: Real> Exponent<T> for u32 {
    #[inline]
    fn raise(self, cosine: T) -> T {
        if self == 0 {
            return cosine.if_positive(T::ONE, T::ZERO);
        }
        let cosine = cosine.at_most(T::ONE);
        by_squaring(cosine.if_above(least(self), cosine, T::ZERO), self)
    }
}

/// The cosine whose m-th power is the least normal number of single precision, 2^(−126/m), for
/// m ≥ 1; 0 in a type with a wider range.
///
/// Below it, squaring would pass through subnormal numbers, which cost some processors up to a
/// hundred times as much.
#[inline]
fn least<T: Real>(m: u32) -> T {
    const ONE: u32 = 1.0_f32.to_bits();
    const OCTAVE: u32 = 1 << 23;
    // The bits of a float are its logarithm, except that the significand 1 + x stands for
    // log₂(1 + x), which is about x + 0.39 (¼ − (x − ½)²). The result never exceeds the true one.
    let linear = ONE - 126 * OCTAVE / m;
    let from_half = (linear >> 12 & 0x7FF).wrapping_sub(0x400);
    let bend = 0x10_0000 - from_half.wrapping_mul(from_half);
    let least = f32::from_bits(linear - bend / 32 * 25 - 1600);
    (T::MAX - T::of_f32(f32::MAX)).if_positive(T::ZERO, T::of_f32(least))
}

/// baseᵐ by repeated squaring, from the highest bit of m down. The trailing zeros of m square the
/// base first.
#[inline]
pub(crate) fn by_squaring<T: Real>(mut base: T, m: u32) -> T {
    if m == 0 {
        return T::ONE;
    }
    // A single bit is shifted down past the trailing zeros. Compilers would unroll a loop over
    // their count, and small chips lack the registers for that.
    let mut bit = (m & m.wrapping_neg()) >> 1;
    while bit != 0 {
        base = base * base;
        bit >>= 1;
    }
    let mut power = base;
    // the bits of m below its highest 1 and down to its lowest 1, left-aligned
    let mut bits = m << m.leading_zeros() << 1;
    while bits != 0 {
        power = power * power;
        if bits >> 31 == 1 {
            power = power * base;
        }
        bits <<= 1;
    }
    power
}

#[diagnostic::do_not_recommend] // the trait's own message names the types
impl Exponent<f32> for f32 {
    #[inline(always)]
    fn raise(self, cosine: f32) -> f32 {
        power(cosine, self.at_least(0.0))
    }
}

#[diagnostic::do_not_recommend] // the trait's own message names the types
impl Exponent<f64> for f64 {
    #[inline]
    fn raise(self, cosine: f64) -> f64 {
        // not `at_least`, which may let a signaling NaN through
        let power = if self > 0.0 {
            libm::pow(cosine.at_least(0.0).at_most(1.0), self)
        } else {
            1.0
        };
        cosine.if_positive(power, 0.0)
    }
}
