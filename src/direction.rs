//! The reflection vector R and the half vector H.

use crate::number::{Real, Scalar};
use crate::vector::{UnitVec3, Vec3};

/// The reflection vector R: the direction L mirrored in the normal N.
///
/// ```text
/// R = 2(N·L)N − L
/// ```
///
/// N is the normal and L the direction to the light; L and R point away from the surface. GLSL's
/// `reflect(I, N)` takes the incident direction −L, so `reflect(-L, N)` is this function. N and −N
/// give the same R. If L is below the surface, R is below it too; the [sums over
/// lights](crate::shade) ensure that such a light adds nothing. The result is defined for all
/// directions. Its length is 1 up to rounding.
///
/// Source: Phong 1975; Foley, van Dam et al. 1990, §16.1.4.
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
pub fn reflection<T: Real>(n: UnitVec3<T>, l: UnitVec3<T>) -> UnitVec3<T> {
    UnitVec3::assume_unit(mirrored(n, *l))
}

/// The [`reflection`] of a vector of any length.
#[inline]
pub(crate) fn mirrored<T: Real>(n: UnitVec3<T>, v: Vec3<T>) -> Vec3<T> {
    let n_dot_v = n.dot(v);
    *n * (n_dot_v + n_dot_v) - v
}

/// The half vector H: the direction halfway between L and V.
///
/// ```text
/// H = (L + V) / |L + V|
/// ```
///
/// L is the direction to the light and V the direction to the eye; both point away from the
/// surface. The result is `None` if they are opposite, L = −V, because no direction is then
/// halfway. Swapping L and V gives the same bits.
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
#[doc(alias("halfway", "bisector"))]
#[inline]
#[must_use]
pub fn half_vector<T: Real + Scalar>(l: UnitVec3<T>, v: UnitVec3<T>) -> Option<UnitVec3<T>> {
    (*l + *v).unit()
}
