//! The shininess m of a highlight.

pub(crate) mod batch;
pub(crate) mod power;

use crate::real::Real;
use batch::{OneByOne, Powers};
use power::power;

/// The shininess m of a highlight: an integer (`u32`) or a real number of the scene's type (`f32`,
/// `f64`).
///
/// An integer m uses repeated squaring. It takes about 15% less time per light on a desktop, and a
/// quarter fewer instructions on a chip without an FPU. The type of the argument decides:
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
/// use shading::f32::{DirectionalLight, Material, Rgb, UnitVec3, Vec3};
/// use shading::{Exponent, shade};
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
///
/// let (k_a, k_d, k_s) = (Rgb::BLACK, Rgb::gray(0.5), Rgb::gray(0.5));
/// let toon = Material { k_a, k_d, k_s, m: Disk(0.9) };
/// let (n, v) = (UnitVec3::Z, UnitVec3::new(0.6, 0.0, 0.8).unwrap()); // N·H = 0.95
/// let sun = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::WHITE };
/// let shaded = shade::blinn_phong(n, v, &toon, Rgb::BLACK, [sun.at(Vec3::ZERO)]);
/// assert_eq!(shaded.specular, Rgb::gray(0.5));
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

    /// m/2, if that is an exponent too. It raises the square of a cosine, whose root would cost
    /// more than the power.
    #[doc(hidden)]
    #[inline]
    fn half(self) -> Option<Self> {
        None
    }

    /// Raises the cosines of a sum, one by one or several at a time. It passes each power, with the
    /// item that the power belongs to, to `each`, in order. `_none` is an item that fills unused
    /// places.
    #[doc(hidden)]
    #[inline]
    fn powers<I: Copy>(self, _none: I, each: impl FnMut(I, T)) -> impl Powers<I, T> {
        let power = move |cosine| self.raise(cosine);
        OneByOne { power, each }
    }
}

#[diagnostic::do_not_recommend] // the trait's own message names the types
impl<T: Real> Exponent<T> for u32 {
    #[inline]
    fn raise(self, cosine: T) -> T {
        // an m that the compiler knows to be above 0 takes fewer instructions
        if self == 0 {
            cosine.if_positive(T::ONE, T::ZERO)
        } else {
            T::cosine_power(self)(cosine)
        }
    }

    #[inline]
    fn half(self) -> Option<Self> {
        T::half_of(self)
    }

    // whatever depends on m alone is computed once
    #[inline]
    fn powers<I: Copy>(self, _none: I, each: impl FnMut(I, T)) -> impl Powers<I, T> {
        let power = T::cosine_power(self);
        OneByOne { power, each }
    }
}

#[diagnostic::do_not_recommend] // the trait's own message names the types
impl Exponent<f32> for f32 {
    #[inline(always)]
    fn raise(self, cosine: f32) -> f32 {
        power(cosine, self.at_least(0.0))
    }

    #[inline]
    fn half(self) -> Option<Self> {
        Some(0.5 * self)
    }

    #[cfg(any(
        target_feature = "sse2",
        target_feature = "neon",
        target_feature = "simd128"
    ))]
    #[inline]
    fn powers<I: Copy>(self, none: I, each: impl FnMut(I, f32)) -> impl Powers<I, f32> {
        batch::by_fours::ByFours::new(self.at_least(0.0), none, each)
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

    #[inline]
    fn half(self) -> Option<Self> {
        Some(0.5 * self)
    }
}
