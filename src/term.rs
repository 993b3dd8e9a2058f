//! The terms of the illumination model, exactly as in the textbooks.
//!
//! Each function gives one part of the reflected light, or a factor of it. The sums in
//! [`shade`](mod@crate::shade) multiply these by the material and the intensity of the lights, and
//! add them:
//!
//! ```text
//! I_r = k_a I_a + Σ I (k_d max(0, N·L) + k_s highlight)
//! ```
//!
//! The directions N, L, V, R and H are [`UnitVec3`] and point away from the surface.

use core::f64::consts::{FRAC_1_PI, FRAC_1_SQRT_2};

use crate::color::Rgb;
use crate::number::{Lobe, Mask, Real, constant, parts, shininess};
use crate::vector::UnitVec3;

/// The ambient term, for light without a direction.
///
/// ```text
/// k_a I_a
/// ```
///
/// k_a is the reflectance of the material for ambient light, and I_a the intensity of the ambient
/// light of the scene; both are 0 or more in each channel. Add this term once per scene, not once
/// per light. It is never attenuated.
///
/// Source: Foley, van Dam et al. 1990, §16.1.1.
///
/// ```
/// use shading::f32::Rgb;
/// use shading::term;
///
/// let (clay, sky) = (Rgb::new(0.5, 0.25, 0.125), Rgb::new(0.25, 0.5, 1.0));
/// assert_eq!(term::ambient(clay, sky), Rgb::gray(0.125));
/// ```
#[inline]
pub fn ambient<T: Real>(k_a: Rgb<T>, i_a: Rgb<T>) -> Rgb<T> {
    k_a * i_a
}

/// The diffuse factor, by Lambert's cosine law.
///
/// ```text
/// max(0, N·L)
/// ```
///
/// N is the normal and L the direction to the light. The result is within [0, 1], up to rounding;
/// it is 0 for a light behind the surface. Multiply it by k_d and I. It contains no 1/π.
///
/// Source: Lambert 1760; Foley, van Dam et al. 1990, §16.1.2.
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
/// R is the [`reflection`](crate::reflection()) of L, V the direction to the eye, and m ≥ 0 the
/// shininess: a `u32`, or a real number of the scene's type. The result is within [0, 1]. Multiply
/// it by k_s and I.
///
/// The cosine is limited to 1, so rounding cannot make the highlight brighter. If R·V ≤ 0, the
/// factor is 0 for every m, even m = 0. The factor alone does not know whether the light is behind
/// the surface; the [sum over lights](crate::shade) does.
///
/// Source: Phong 1975.
///
/// ```
/// use shading::{UnitVec3, term::phong};
///
/// let r = UnitVec3::<f32>::Z;
/// let v = UnitVec3::<f32>::new(0.6, 0.0, 0.8).unwrap();
/// assert!((phong(r, v, 2) - 0.64).abs() < 1e-7);
/// assert_eq!(phong(r, -v, 0), 0.0);
/// ```
#[doc(alias("specular", "shininess"))]
#[inline]
#[must_use]
pub fn phong<T: Real, M: Lobe<T>>(r: UnitVec3<T>, v: UnitVec3<T>, m: M) -> T {
    highlight(r.dot(v), m)
}

/// The factor of Blinn's highlight.
///
/// ```text
/// max(0, N·H)ᵐ
/// ```
///
/// N is the normal, and H the [`half_vector`](crate::half_vector) of L and V. What [`phong`] says about
/// m, the range and the degenerate cases also holds for N·H. With about four times the m, the
/// highlight is as large as that of `phong`, except at grazing angles, where it is narrower from side
/// to side.
///
/// Source: Blinn 1977.
///
/// ```
/// use shading::{UnitVec3, term::blinn};
///
/// let n = UnitVec3::<f64>::Z;
/// let h = UnitVec3::<f64>::new(0.0, 0.6, 0.8).unwrap();
/// assert!((blinn(n, h, 3) - 0.512).abs() < 1e-15);
/// ```
#[doc(alias("specular", "shininess"))]
#[inline]
#[must_use]
pub fn blinn<T: Real, M: Lobe<T>>(n: UnitVec3<T>, h: UnitVec3<T>, m: M) -> T {
    highlight(n.dot(h), m)
}

/// The power of a cosine: 0 if it is not above 0, and 1 if rounding has put it above 1.
#[inline]
pub(crate) fn highlight<T: Real, M: Lobe<T>>(cosine: T, m: M) -> T {
    let power = m.raise(cosine.at_least(T::ZERO).at_most(T::ONE));
    cosine.above(T::ZERO).select(power, T::ZERO)
}

/// The factor that normalizes the highlight of [`phong`], for renderers whose diffuse term has a 1/π.
///
/// ```text
/// (m + 2)/(2π)
/// ```
///
/// The larger m is, the less light the textbooks' highlight returns. This factor turns it into a
/// BRDF, which is multiplied by N·L as the diffuse term is:
///
/// ```text
/// Σ I max(0, N·L) (k_d/π + k_s (m + 2)/(2π) max(0, R·V)ᵐ)
/// ```
///
/// Integrated over all directions L, the highlight then returns exactly k_s of the arriving light
/// if V = N, for every m. The farther V is from N, the less it returns: at a grazing V, at most
/// half of k_s. A material with k_d + k_s ≤ 1 therefore never returns more light than arrives. The
/// same holds with L and V exchanged. The sums in [`shade`](mod@crate::shade) keep the textbooks' formula.
///
/// m ≥ 0 is the shininess as a number of the scene's type; convert an integer first. If it is
/// negative or NaN, it counts as 0; if it is infinite, it counts as the largest finite number.
///
/// Source: Robert R. Lewis, *Making Shaders More Physically Plausible*, 1994; Eric P. Lafortune and
/// Yves D. Willems, *Using the Modified Phong Reflectance Model for Physically Based Rendering*,
/// 1994.
///
/// ```
/// use core::f32::consts::FRAC_1_PI;
/// use shading::f32::{Arrival, DirectionalLight, Rgb, UnitVec3, Vec3};
/// use shading::{reflection, term};
///
/// let (n, v) = (UnitVec3::Z, UnitVec3::Z);
/// let (k_d, k_s) = (Rgb::gray(0.5), Rgb::gray(0.25));
/// let sun = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::WHITE };
///
/// let normalization = term::phong_normalization(32.0); // once per material
/// let Arrival { l, intensity, .. } = sun.at(Vec3::ZERO).arrival();
/// let highlight = normalization * term::phong(reflection(n, l), v, 32);
/// let brdf = k_d * FRAC_1_PI + k_s * highlight;
/// let returned = intensity * brdf * term::lambert(n, l);
/// assert!((returned.r - (0.5 + 0.25 * 17.0) * FRAC_1_PI).abs() < 1e-6);
/// ```
#[doc(alias = "energy")]
#[inline]
#[must_use]
pub fn phong_normalization<T: Real>(m: T) -> T {
    (shininess(m) + T::of_f32(2.0)) * constant(const { parts(0.5 * FRAC_1_PI) })
}

/// The factor that normalizes the highlight of [`blinn`], for renderers whose diffuse term has a 1/π.
///
/// ```text
/// (m + 2)(m + 4)/(8π(2^(−m/2) + m))
/// ```
///
/// Use it as you would use [`phong_normalization`], with the same m. The highlight then returns
/// exactly k_s of the arriving light if V = N, for every m, and never more for other V. With m = 0
/// the highlight is Lambert's, 1/π.
///
/// The common (m + 8)/(8π) is simpler, but near m = 9 it returns up to 7.5 % more light than
/// arrives.
///
/// Source: Fabian Giesen, *Derivation of Phong and Blinn-Phong BRDF Normalization Factors*, 2009.
///
/// ```
/// let factor = shading::term::blinn_normalization(2.0_f64); // 4·6/(8π(½ + 2)) = 1.2/π
/// assert!((factor - 1.2 / core::f64::consts::PI).abs() < 1e-15);
/// ```
#[doc(alias = "energy")]
#[inline]
#[must_use]
pub fn blinn_normalization<T: Real + Lobe<T>>(m: T) -> T {
    let m = shininess(m);
    let power = m.raise(constant(const { parts(FRAC_1_SQRT_2) }));
    // the division comes first, because the product of the two sums could overflow
    let eighth = constant(const { parts(0.125 * FRAC_1_PI) });
    (m + T::of_f32(2.0)) * eighth * ((m + T::of_f32(4.0)) / (m + power))
}
