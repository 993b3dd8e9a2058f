//! Normals of planes, triangles, spheres, implicit and parametric surfaces.

use crate::dual::Dual;
use crate::real::Real;
use crate::rescale::{tame, tame_difference};
use crate::unit::UnitVec3;
use crate::vector::Vec3;

/// The normal of the plane ax + by + cz + d = 0.
///
/// ```text
/// N = (a, b, c) / |(a, b, c)|
/// ```
///
/// It points to the side where ax + by + cz + d > 0. `None` if a = b = c = 0.
///
/// Source: Foley, van Dam et al., *Computer Graphics: Principles and Practice*, 2nd ed., §11.1.3.
///
/// ```
/// use shading::{UnitVec3, normal};
/// assert_eq!(normal::plane(0.0_f32, 0.0, 2.0), Some(UnitVec3::Z)); // 2z + d = 0
/// assert_eq!(normal::plane(0.0_f32, 0.0, 0.0), None);
/// ```
#[inline]
#[must_use]
pub fn plane<T: Real + PartialOrd>(a: T, b: T, c: T) -> Option<UnitVec3<T>> {
    Vec3::new(a, b, c).unit()
}

/// The normal of a triangle.
///
/// ```text
/// N = (v₂ − v₁) × (v₃ − v₁) / |(v₂ − v₁) × (v₃ − v₁)|
/// ```
///
/// It points to the side from which the vertices appear counter-clockwise. `None` if the triangle is a
/// line or a point. The error is at most 5.7u times the conditioning |e₁||e₂|/|e₁×e₂| of the two edges, where u
/// is the unit roundoff. The size of the triangle does not matter: 10⁻³⁷ and 10³⁷ are as good as 1.
///
/// ```
/// use shading::{UnitVec3, Vec3, normal};
///
/// let [a, b, c] = [[0.0_f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Vec3::from);
/// assert_eq!(normal::triangle(a, b, c), Some(UnitVec3::Z));
/// assert_eq!(normal::triangle(a, c, b), Some(-UnitVec3::Z));
/// assert_eq!(normal::triangle(a, b, b), None);
/// ```
#[doc(alias = "face")]
#[inline]
#[must_use]
pub fn triangle<T: Real + PartialOrd>(
    v1: Vec3<T>,
    v2: Vec3<T>,
    v3: Vec3<T>,
) -> Option<UnitVec3<T>> {
    tame_difference(v2, v1)
        .cross(tame_difference(v3, v1))
        .unit()
}

/// The outward normal of a sphere at a point p on it.
///
/// ```text
/// N = (p − center) / |p − center|
/// ```
///
/// `None` if p is the center.
///
/// ```
/// use shading::{UnitVec3, Vec3, normal};
///
/// let center = Vec3::new(1.0_f32, 1.0, 1.0);
/// assert_eq!(normal::sphere(center, Vec3::new(1.0, 1.0, 4.0)), Some(UnitVec3::Z));
/// assert_eq!(normal::sphere(center, center), None);
/// ```
#[inline]
#[must_use]
pub fn sphere<T: Real + PartialOrd>(center: Vec3<T>, p: Vec3<T>) -> Option<UnitVec3<T>> {
    tame_difference(p, center).unit()
}

/// The normal of the implicit surface f(x, y, z) = 0 at a point p on it, from f itself.
///
/// ```text
/// N = ∇f / |∇f|
/// ```
///
/// It points to the side where f > 0. The gradient is exact: f computes with [`Dual`] numbers. `None`
/// where ∇f is 0 or does not exist, as at the apex of a cone.
///
/// ```
/// use shading::{UnitVec3, Vec3, normal};
///
/// let top = Vec3::new(0.0_f32, 0.0, 1.0);
/// assert_eq!(normal::implicit(|p| p.dot(p) - 1.0, top), Some(UnitVec3::Z));
///
/// let cone = normal::implicit(|p| p.x * p.x + p.y * p.y - p.z * p.z, Vec3::<f32>::ZERO);
/// assert_eq!(cone, None);
/// ```
///
/// A function that takes `f32` does not fit here: plain numbers carry no derivatives. Make the function
/// generic over [`Real`] or [`Elementary`](crate::Elementary). Then the same function finds the surface
/// with `f32` and the normal with `Dual<f32>`.
///
/// ```
/// use shading::{Real, UnitVec3, Vec3, normal};
///
/// fn torus<T: Real>(p: Vec3<T>) -> T {
///     let ring = (p.x * p.x + p.y * p.y).sqrt() - T::of(2.0);
///     ring * ring + p.z * p.z - T::of(0.25)
/// }
/// let p = Vec3::new(2.5_f32, 0.0, 0.0);
/// assert_eq!(torus(p), 0.0);
/// assert_eq!(normal::implicit(torus, p), Some(UnitVec3::X));
/// ```
#[doc(alias = "gradient")]
#[inline]
#[must_use]
pub fn implicit<T: Real + PartialOrd>(
    f: impl FnOnce(Vec3<Dual<T>>) -> Dual<T>,
    p: Vec3<T>,
) -> Option<UnitVec3<T>> {
    from_gradient(f(Dual::point(p)).gradient)
}

/// The normal of an implicit surface from its gradient: ∇f/|∇f|. `None` if ∇f is 0 or not finite.
///
/// ```
/// use shading::{UnitVec3, Vec3, normal};
/// assert_eq!(normal::from_gradient(Vec3::new(0.0_f32, 0.0, 1e-30)), Some(UnitVec3::Z));
/// ```
#[inline]
#[must_use]
pub fn from_gradient<T: Real + PartialOrd>(gradient: Vec3<T>) -> Option<UnitVec3<T>> {
    gradient.unit()
}

/// The normal of the parametric surface s(u, v), from s itself.
///
/// ```text
/// N = (∂s/∂u × ∂s/∂v) / |∂s/∂u × ∂s/∂v|
/// ```
///
/// The tangents are exact up to rounding: s computes with [`Dual`] numbers. The order of u and v decides
/// to which side N points.
///
/// `None` where the tangents are parallel, or one is 0 or does not exist, as at the pole of a sphere.
/// There, and where the edge of a patch collapses to a point, a tangent is a sum of terms that cancel,
/// and rounding leaves noise instead of 0. So the result is also `None` if one tangent is at most 32u
/// times as long as the other: 2⁻¹⁹ for `f32`, 2⁻⁴⁸ for `f64` (u is the unit roundoff; the length is
/// that of the largest component).
///
/// - Tangents whose lengths differ by a factor of up to 10⁵ have a normal. If yours differ by more in
///   `f32`, choose other units for u and v, or pass the tangents to [`from_tangents`], which accepts any
///   length.
/// - Far from the origin the terms are longer than the tangents, and the noise may exceed 32u. Describe a
///   patch relative to one of its own points, or by differences of its control points as in de
///   Casteljau's algorithm: the difference of equal points is exactly 0.
///
/// ```
/// use shading::{Elementary, UnitVec3, Vec3, normal};
///
/// let cylinder = |u: shading::Dual<f64>, v| Vec3::new(u.cos(), u.sin(), v);
/// assert_eq!(normal::parametric(cylinder, 0.0, 5.0), Some(UnitVec3::X));
///
/// // the south pole of a sphere: in floats, sin π is 10⁻¹⁶ and not 0
/// let sphere = |u: shading::Dual<f64>, v: shading::Dual<f64>|
///     Vec3::new(u.cos() * v.sin(), u.sin() * v.sin(), v.cos());
/// assert_eq!(normal::parametric(sphere, 1.0, core::f64::consts::PI), None);
/// ```
#[doc(alias = "tangent")]
#[inline]
#[must_use]
pub fn parametric<T: Real + PartialOrd>(
    s: impl FnOnce(Dual<T>, Dual<T>) -> Vec3<Dual<T>>,
    u: T,
    v: T,
) -> Option<UnitVec3<T>> {
    let parameters = Dual::point(Vec3::new(u, v, T::ZERO));
    let s = s(parameters.x, parameters.y);
    let (s_u, s_v) = (s.map(|s| s.gradient.x), s.map(|s| s.gradient.y));
    if is_one_noise(s_u, s_v) {
        None
    } else {
        from_tangents(s_u, s_v)
    }
}

/// Whether one tangent is so short beside the other that it may be rounding noise: two roundings for
/// each of the 16 control points of a bicubic patch. On the teapot the noise reaches 14u.
#[inline]
fn is_one_noise<T: Real + PartialOrd>(s_u: Vec3<T>, s_v: Vec3<T>) -> bool {
    // 4/3 is rounded by a third of ε, which is 2u, in any binary float (Kahan)
    let three = T::ONE + T::ONE + T::ONE;
    let epsilon = (three * ((T::ONE + three) / three - T::ONE) - T::ONE).abs();
    let noise = (T::ONE + three) * (T::ONE + three) * epsilon;

    let largest = |t: Vec3<T>| t.x.abs().at_least(t.y.abs()).at_least(t.z.abs());
    let (u, v) = (largest(s_u), largest(s_v));
    u.at_most(v) <= u.at_least(v) * noise
}

/// The normal of a parametric surface from its two tangents: s_u × s_v/|s_u × s_v|. `None` if they are
/// parallel, 0 or not finite.
///
/// The tangents are scaled to about 1 before they are multiplied, and so is the product before its length
/// is taken, so that nothing overflows or vanishes.
///
/// ```
/// use shading::{UnitVec3, Vec3, normal};
///
/// let (s_u, s_v) = (Vec3::new(1e-30_f32, 0.0, 0.0), Vec3::new(0.0, 1e30, 0.0));
/// assert_eq!(normal::from_tangents(s_u, s_v), Some(UnitVec3::Z));
/// assert_eq!(normal::from_tangents(s_u, s_u), None);
/// ```
#[inline]
#[must_use]
pub fn from_tangents<T: Real + PartialOrd>(s_u: Vec3<T>, s_v: Vec3<T>) -> Option<UnitVec3<T>> {
    tame(s_u).cross(tame(s_v)).unit()
}
