//! Floor 3: the terms of the illumination model, literal as in the books.

use core::f64::consts::{FRAC_1_PI, FRAC_1_SQRT_2};

use crate::exponent::Exponent;
use crate::real::{Real, constant, parts};
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
    n.dot(l).at_least(T::ZERO)
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
#[inline]
#[must_use]
pub fn phong<T: Real, M: Exponent<T>>(r: UnitVec3<T>, v: UnitVec3<T>, m: M) -> T {
    m.raise(r.dot(v))
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
    m.raise(n.dot(h))
}

/// The factor that normalizes the highlight of [`phong`], for renderers whose diffuse term has a 1/π.
///
/// ```text
/// (m + 2)/(2π)
/// ```
///
/// The books' highlight returns less light the larger m is. With this factor it becomes a BRDF, which N·L
/// multiplies as it does the diffuse term:
///
/// ```text
/// Σ I max(0, N·L) (k_d/π + k_s (m + 2)/(2π) max(0, R·V)ᵐ)
/// ```
///
/// Integrated over all directions of L, the highlight then returns exactly k_s of what arrives where
/// V = N, for every m, and less the farther V is from N: at grazing V, at most half of k_s. So a material
/// with k_d + k_s ≤ 1 never returns more than arrives. The same holds with L and V exchanged. The sums in
/// [`mod@crate::shade`] keep the books' formula.
///
/// m is the shininess as a number: an integer one is converted first. Below 0, or not a number, it counts
/// as 0; an infinite one counts as the largest number.
///
/// Source: Lewis, *Making Shaders More Physically Plausible*, 1994; Lafortune and Willems, *Using the
/// Modified Phong Reflectance Model for Physically Based Rendering*, 1994.
///
/// ```
/// use core::f32::consts::FRAC_1_PI;
/// use shading::{PointLight, Rgb, UnitVec3, Vec3, reflection, term};
///
/// # let (n, v) = (UnitVec3::<f32>::Z, UnitVec3::Z);
/// # let [k_d, k_s] = [0.5, 0.25].map(Rgb::gray);
/// # let lamp = PointLight { position: Vec3::new(0.0, 0.0, 1.0), intensity: Rgb::WHITE, attenuation: shading::Attenuation::NONE };
/// # let light = lamp.at(Vec3::ZERO);
/// let normalization = term::phong_normalization(32.0); // once for a material
/// let highlight = normalization * term::phong(reflection(n, light.l), v, 32);
/// let brdf = k_d * FRAC_1_PI + k_s * highlight;
/// let returned = light.intensity * brdf * term::lambert(n, light.l);
/// # assert!((returned.r - (0.5 + 0.25 * 17.0) * FRAC_1_PI).abs() < 1e-6);
/// ```
#[doc(alias = "energy")]
#[inline]
#[must_use]
pub fn phong_normalization<T: Real>(m: T) -> T {
    (valid(m) + T::of_f32(2.0)) * constant(const { parts(0.5 * FRAC_1_PI) })
}

/// The factor that normalizes the highlight of [`blinn`], for renderers whose diffuse term has a 1/π.
///
/// ```text
/// (m + 2)(m + 4)/(8π(2^(−m/2) + m))
/// ```
///
/// It is used as [`phong_normalization`] is: the highlight returns exactly k_s of what arrives where V = N,
/// for every m, and never more elsewhere. With m = 0 the highlight is Lambert's, 1/π.
///
/// The usual (m + 8)/(8π) is simpler, and returns up to 7.5 % more than arrives, near m = 9.
///
/// m is the shininess as a number: an integer one is converted first. Below 0, or not a number, it counts
/// as 0; an infinite one counts as the largest number.
///
/// Source: Giesen, *Derivation of Phong and Blinn-Phong BRDF Normalization Factors*, 2009.
///
/// ```
/// use core::f64::consts::FRAC_1_PI;
/// use shading::term::blinn_normalization;
///
/// let factor = blinn_normalization(2.0_f64); // 4·6/(8π(½ + 2)) = 1.2/π
/// assert!((factor - 1.2 * FRAC_1_PI).abs() < 1e-15);
/// ```
#[doc(alias = "energy")]
#[inline]
#[must_use]
pub fn blinn_normalization<T: Real + Exponent<T>>(m: T) -> T {
    let m = valid(m);
    let power = m.raise(constant(const { parts(FRAC_1_SQRT_2) }));
    // divided first: the product of the two sums could overflow
    let eighth = constant(const { parts(0.125 * FRAC_1_PI) });
    (m + T::of_f32(2.0)) * eighth * ((m + T::of_f32(4.0)) / (m + power))
}

/// The shininess as a number, at least 0 and finite.
#[inline]
fn valid<T: Real>(m: T) -> T {
    // not `at_least`, which may leave a signaling NaN as it is
    m.if_positive(m.at_most(T::MAX), T::ZERO)
}

/// (N·H)², with the sign of N·H, for an h = L + V that is not normalised: (N·h)²/(h·h) takes a
/// division; normalising h would take a square root and a division. Rounding may leave it above 1.
#[inline(always)] // on a Cortex-M0 a call from the sum would take 56 bytes of stack
pub(crate) fn n_dot_h_squared<T: Real>(n: UnitVec3<T>, mut h: Vec3<T>) -> T {
    // Not h.dot(h): of two sums in the same order compilers make one in SIMD registers, and to bring
    // the numbers there takes longer than the second sum.
    let square = |h: Vec3<T>| h.z * h.z + h.y * h.y + h.x * h.x;
    let mut h_dot_h = square(h);
    // L next to −V, where the square loses bits or all of itself
    let least = T::ONE / T::EXTREME;
    if least.if_above(h_dot_h, T::ONE, T::ZERO).any_positive() {
        h *= least.if_above(h_dot_h, T::EXTREME, T::ONE);
        h_dot_h = square(h);
    }
    let n_dot_h = n.dot(h);
    // not a number, which counts as 0, where L = −V
    n_dot_h * n_dot_h.abs() / h_dot_h
}
