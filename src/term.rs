//! Floor 3: the terms of the illumination model, literal as in the books.

use crate::exponent::Exponent;
use crate::real::Real;
use crate::rgb::Rgb;
use crate::unit::UnitVec3;
use crate::vector::Vec3;

/// The ambient term: light that has no direction.
///
/// ```text
/// k_a I_a
/// ```
///
/// Counted once for the scene, not once a light, and never attenuated.
///
/// Source: Foley, van Dam et al. §16.1.1.
///
/// ```
/// use shading::{Rgb, term::ambient};
/// assert_eq!(ambient(Rgb::gray(0.5_f32), Rgb::new(0.2, 0.2, 0.4)), Rgb::new(0.1, 0.1, 0.2));
/// ```
#[inline]
#[must_use]
pub fn ambient<T: Real>(k_a: Rgb<T>, i_a: Rgb<T>) -> Rgb<T> {
    k_a * i_a
}

/// The factor of diffuse reflection, Lambert's cosine law.
///
/// ```text
/// max(0, N·L)
/// ```
///
/// It is multiplied by k_d and I; there is no 1/π in it. 0 for a light behind the surface.
///
/// Source: Lambert 1760; Foley, van Dam et al. §16.1.2.
///
/// ```
/// use shading::{UnitVec3, term::lambert};
///
/// let n = UnitVec3::<f32>::Z;
/// let l = UnitVec3::<f32>::new(0.6, 0.0, 0.8).unwrap();
/// assert_eq!(lambert(n, l), 0.8);
/// assert_eq!(lambert(n, -l), 0.0);
/// ```
#[doc(alias = "diffuse")]
#[inline]
#[must_use]
pub fn lambert<T: Real>(n: UnitVec3<T>, l: UnitVec3<T>) -> T {
    n.dot(l).positive_part()
}

/// The factor of Phong's highlight.
///
/// ```text
/// max(0, R·V)ᵐ
/// ```
///
/// R is the [`reflection`](crate::reflection()) of L, V the direction to the eye, m ≥ 0 the
/// shininess: a `u32`, or a real number of the type of the cosine. It is multiplied by k_s and I.
/// The cosine is at most 1, whatever the rounding; where R·V ≤ 0 the factor is 0 for every m,
/// also for m = 0. The factor alone does not know whether the light is behind the surface: the
/// [sum over lights](crate::shade) does.
///
/// Source: Phong 1975.
///
/// ```
/// use shading::{UnitVec3, term::phong};
///
/// let r = UnitVec3::<f32>::Z;
/// let v = UnitVec3::<f32>::new(0.6, 0.0, 0.8).unwrap();
/// assert!((phong(r, v, 2) - 0.64).abs() < 1e-7);
/// assert!((phong(r, v, 2.0) - 0.64).abs() < 1e-7);
/// assert_eq!(phong(r, -v, 0), 0.0);
/// ```
#[doc(alias = "specular")]
#[doc(alias = "shininess")]
#[inline(always)]
#[must_use]
pub fn phong<T: Real, M: Exponent<T>>(r: UnitVec3<T>, v: UnitVec3<T>, m: M) -> T {
    highlight(r.dot(v), m)
}

/// The factor of Blinn's highlight.
///
/// ```text
/// max(0, N·H)ᵐ
/// ```
///
/// H is the [`half_vector`](crate::half_vector). With about four times the m it looks like
/// [`phong`], and the same holds of m, of the cosine and of a light behind the surface.
///
/// Source: Blinn 1977.
///
/// ```
/// use shading::{UnitVec3, term::blinn};
///
/// let n = UnitVec3::<f64>::Z;
/// let h = UnitVec3::<f64>::new(0.0, 0.6, 0.8).unwrap();
/// assert!((blinn(n, h, 3) - 0.512).abs() < 1e-15);
/// assert!((blinn(n, h, 3.0) - 0.512).abs() < 1e-15);
/// ```
#[doc(alias = "specular")]
#[doc(alias = "shininess")]
#[inline]
#[must_use]
pub fn blinn<T: Real, M: Exponent<T>>(n: UnitVec3<T>, h: UnitVec3<T>, m: M) -> T {
    highlight(n.dot(h), m)
}

/// (N·H)², with the sign of N·H, for an h = L + V that is not normalised: (N·h)²/(h·h) takes a
/// division; normalising h would take a square root and a division. It is what
/// [`Exponent::raise_root`] raises.
#[inline]
pub(crate) fn n_dot_h_squared<T: Real>(n: UnitVec3<T>, h: Vec3<T>) -> T {
    let n_dot_h = n.dot(h);
    // Not h.dot(h): of two sums in the same order compilers make one in SIMD registers, and to bring
    // the numbers there takes longer than the second sum.
    let h_dot_h = h.z * h.z + h.y * h.y + h.x * h.x;
    // not a number, which counts as 0, where L = −V
    let square = n_dot_h * n_dot_h.abs() / h_dot_h;
    square.at_most(T::ONE)
}

/// The power of a cosine, cut off at the horizon.
#[inline(always)]
fn highlight<T: Real, M: Exponent<T>>(cosine: T, m: M) -> T {
    m.raise(cosine.at_most(T::ONE))
}
