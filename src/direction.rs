//! Floor 3: the directions R and H, made of N, L and V.

use crate::real::Real;
use crate::unit::UnitVec3;
use crate::vector::Vec3;

/// The reflection vector: the direction L mirrored in the normal N.
///
/// ```text
/// R = 2(N·L)N − L
/// ```
///
/// L points away from the surface, and so does R. GLSL's `reflect(I, N)` takes the incident
/// direction, which is −L: `reflect(-L, N)` is this function. N and −N give the same R. For an L
/// below the surface R is below it too; the terms and the sums see to it that it lights nothing.
///
/// Source: Phong 1975; Foley, van Dam et al., *Computer Graphics*, §16.1.4.
///
/// ```
/// use shading::{UnitVec3, Vec3, reflection};
///
/// let l = UnitVec3::<f32>::new(0.6, 0.0, 0.8).unwrap();
/// let r = reflection(UnitVec3::<f32>::Z, l);
/// assert_eq!(*r, Vec3::new(-0.6, 0.0, 0.8));
/// ```
#[doc(alias = "reflect")]
#[inline]
#[must_use]
pub fn reflection<T: Real>(n: UnitVec3<T>, l: UnitVec3<T>) -> UnitVec3<T> {
    let n_dot_l = n.dot(l);
    UnitVec3::assume_unit(*n * (n_dot_l + n_dot_l) - *l)
}

/// The half vector: the direction half-way between L and V.
///
/// ```text
/// H = (L + V) / |L + V|
/// ```
///
/// L and V point away from the surface. `None` where they are opposite, L = −V: there is no
/// direction half-way. The order of L and V does not matter, to the bit.
///
/// Source: Blinn 1977.
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

/// L + V: the half vector before it is normalised.
#[inline]
pub(crate) fn between<T: Real>(l: UnitVec3<T>, v: UnitVec3<T>) -> Vec3<T> {
    *l + *v
}
