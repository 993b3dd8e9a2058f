//! Floor 3: the reflection vector R and the half vector H.

use crate::real::Real;
use crate::unit::UnitVec3;
use crate::vector::Vec3;

/// The reflection vector: the direction L mirrored in the normal N.
///
/// ```text
/// R = 2(N·L)N − L
/// ```
///
/// N is the normal, L the direction to the light; L and R point away from the surface. GLSL's
/// `reflect(I, N)` takes the incident direction −L, so `reflect(-L, N)` is this function. N and −N give
/// the same R. If L is below the surface, so is R; the sums over lights make sure that it adds nothing.
///
/// Source: Bui Tuong Phong, "Illumination for Computer Generated Pictures", 1975; Foley, van Dam et al.,
/// *Computer Graphics: Principles and Practice*, 2nd ed., §16.1.4.
///
/// ```
/// use shading::f32::{UnitVec3, Vec3};
/// use shading::reflection;
///
/// let l = UnitVec3::new(0.6, 0.0, 0.8).unwrap();
/// let r = reflection(UnitVec3::Z, l);
/// assert_eq!(*r, Vec3::new(-0.6, 0.0, 0.8));
/// ```
#[doc(alias = "reflect")]
#[inline]
#[must_use]
pub fn reflection<T: Real>(n: UnitVec3<T>, l: UnitVec3<T>) -> UnitVec3<T> {
    let n_dot_l = n.dot(l);
    UnitVec3::assume_unit(*n * (n_dot_l + n_dot_l) - *l)
}

/// The half vector: the direction halfway between L and V.
///
/// ```text
/// H = (L + V) / |L + V|
/// ```
///
/// L is the direction to the light, V the direction to the eye. `None` if they are opposite, L = −V:
/// then no direction is halfway. Swapping L and V gives the same bits.
///
/// Source: James Blinn, "Models of Light Reflection for Computer Synthesized Pictures", 1977.
///
/// ```
/// use shading::{UnitVec3, half_vector};
///
/// let (l, v) = (UnitVec3::<f32>::Z, UnitVec3::X);
/// let h = half_vector(l, v).unwrap();
/// assert!((h.x - 0.5_f32.sqrt()).abs() < 1e-7 && h.x == h.z);
/// assert_eq!(half_vector(l, -l), None);
/// ```
#[doc(alias = "halfway")]
#[inline]
#[must_use]
pub fn half_vector<T: Real + PartialOrd>(l: UnitVec3<T>, v: UnitVec3<T>) -> Option<UnitVec3<T>> {
    between(l, v).unit()
}

/// L + V: the half vector before it is normalized.
#[inline]
pub(crate) fn between<T: Real>(l: UnitVec3<T>, v: UnitVec3<T>) -> Vec3<T> {
    *l + *v
}
