//! Normals of planes, triangles, spheres, implicit and parametric surfaces.

use crate::dual::Dual;
use crate::number::{Real, Scalar, epsilon, magnitude};
use crate::vector::{UnitVec3, Vec3};

/// The normal of the plane ax + by + cz + d = 0.
///
/// ```text
/// N = (a, b, c) / |(a, b, c)|
/// ```
///
/// (a, b, c) may have any length. N points to the side where ax + by + cz + d > 0; d does not
/// change it. The result is `None` if a = b = c = 0, or if one of them is not finite.
///
/// Source: Foley, van Dam et al. 1990, §11.1.3.
///
/// ```
/// use shading::{UnitVec3, normal};
/// assert_eq!(normal::plane(0.0_f32, 0.0, 2.0), Some(UnitVec3::Z)); // 2z + d = 0
/// assert_eq!(normal::plane(0.0_f32, 0.0, 0.0), None);
/// ```
#[inline]
#[must_use]
pub fn plane<T: Real + Scalar>(a: T, b: T, c: T) -> Option<UnitVec3<T>> {
    Vec3::new(a, b, c).unit()
}

/// The normal of a triangle.
///
/// ```text
/// N = (v₂ − v₁) × (v₃ − v₁) / |(v₂ − v₁) × (v₃ − v₁)|
/// ```
///
/// N points to the side from which the vertices appear counter-clockwise. The result is `None` if
/// the triangle is a line or a point, or if a vertex is not finite. The error is at most 5.7u times
/// the conditioning |e₁||e₂|/|e₁ × e₂| of the two edges, where u is the unit roundoff. The size of
/// the triangle does not matter: 10⁻³⁷ and 10³⁷ work as well as 1.
///
/// Source: Foley, van Dam et al. 1990, §11.1.3.
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
#[inline(always)]
#[must_use]
pub fn triangle<T: Real + Scalar>(v1: Vec3<T>, v2: Vec3<T>, v3: Vec3<T>) -> Option<UnitVec3<T>> {
    T::crossed(v1, v2, v3).unit()
}

/// The outward normal of a sphere at a point p on it.
///
/// ```text
/// N = (p − center) / |p − center|
/// ```
///
/// The radius need not be known. A point inside the sphere gives the direction from the center. The
/// result is `None` if p is the center, or if a coordinate is not finite.
///
/// Source: Foley, van Dam et al. 1990, §15.10.1.
///
/// ```
/// use shading::{UnitVec3, Vec3, normal};
///
/// let center = Vec3::new(1.0_f32, 1.0, 1.0);
/// assert_eq!(normal::sphere(center, Vec3::new(1.0, 1.0, 4.0)), Some(UnitVec3::Z));
/// assert_eq!(normal::sphere(center, center), None);
/// ```
#[inline(always)]
#[must_use]
pub fn sphere<T: Real + Scalar>(center: Vec3<T>, p: Vec3<T>) -> Option<UnitVec3<T>> {
    T::between(center, p).unit()
}

/// The normal of the implicit surface f(x, y, z) = 0 at a point p on it, from f itself.
///
/// ```text
/// N = ∇f / |∇f|
/// ```
///
/// f is your function of the point p, which should lie on the surface. N points to the side where
/// f > 0. The gradient is exact up to rounding, because f computes with [`Dual`] numbers. The
/// result is `None` if ∇f is 0 or does not exist, as at the apex of a cone.
///
/// Source: Foley, van Dam et al. 1990, §11.4; Griewank and Walther 2008.
///
/// ```
/// use shading::{UnitVec3, Vec3, normal};
///
/// let top = Vec3::new(0.0_f32, 0.0, 1.0);
/// assert_eq!(normal::implicit(|p| p.dot(p) - 1.0, top), Some(UnitVec3::Z));
///
/// let (center, r) = (Vec3::new(0.0_f32, 1.0, 0.0), 2.0);
/// let sphere = |p: Vec3| normal::implicit(|p| (p - center).length() - r, p);
/// assert_eq!(sphere(Vec3::new(2.0, 1.0, 0.0)), Some(UnitVec3::X));
/// assert_eq!(sphere(center), None); // the apex of a cone of distances
/// ```
///
/// A function that takes `f32` does not fit here, because plain numbers carry no derivatives. Make
/// the function generic over [`Real`] or [`Elementary`](crate::Elementary). The same function then
/// finds the surface with `f32` and the normal with `Dual<f32>`.
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
pub fn implicit<T: Real + Scalar>(
    f: impl FnOnce(Vec3<Dual<T>>) -> Dual<T>,
    p: Vec3<T>,
) -> Option<UnitVec3<T>> {
    from_gradient(f(Dual::point(p)).gradient)
}

/// The normal of an implicit surface, from its gradient.
///
/// ```text
/// N = ∇f / |∇f|
/// ```
///
/// ∇f may have any length. N points to the side where f > 0. The result is `None` if ∇f is 0 or not
/// finite.
///
/// Source: Foley, van Dam et al. 1990, §11.4.
///
/// ```
/// use shading::f32::{UnitVec3, Vec3};
/// use shading::normal;
///
/// // f = x² + y²/4 + z² − 1 at (0, 2, 0): ∇f = (2x, y/2, 2z)
/// let gradient = Vec3::new(0.0, 1.0, 0.0);
/// assert_eq!(normal::from_gradient(gradient), Some(UnitVec3::Y));
/// assert_eq!(normal::from_gradient(Vec3::new(0.0, 0.0, 0.0)), None);
/// ```
#[inline]
#[must_use]
pub fn from_gradient<T: Real + Scalar>(gradient: Vec3<T>) -> Option<UnitVec3<T>> {
    gradient.unit()
}

/// The normal of the parametric surface s(u, v), from s itself.
///
/// ```text
/// N = (∂s/∂u × ∂s/∂v) / |∂s/∂u × ∂s/∂v|
/// ```
///
/// s is your function of the parameters u and v. The tangents are exact up to rounding, because s
/// computes with [`Dual`] numbers. The order of u and v decides to which side N points.
///
/// The result is `None` if the tangents are parallel, or if one of them is 0 or does not exist, as
/// at the pole of a sphere. At a pole, and where the edge of a patch collapses to a point, a
/// tangent is a sum of terms that cancel, and rounding leaves noise instead of 0. The result is
/// therefore also `None` if one tangent is at most 32u times as long as the other: 2⁻¹⁹ for `f32`
/// and 2⁻⁴⁸ for `f64`. (u is the unit roundoff; the length is that of the largest component.)
///
/// - Tangents whose lengths differ by a factor of up to 10⁵ have a normal. If yours differ by more
///   in `f32`, choose other units for u and v, or pass the tangents to [`from_tangents`], which
///   accepts any length.
/// - Far from the origin, the terms are longer than the tangents, and the noise may exceed 32u.
///   Describe a patch relative to one of its own points, or by the differences of its control
///   points, as in de Casteljau's algorithm. The difference of equal points is exactly 0.
///
/// Source: Foley, van Dam et al. 1990, §11.3.4.
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
#[inline(always)]
#[must_use]
pub fn parametric<T: Real + Scalar>(
    s: impl FnOnce(Dual<T>, Dual<T>) -> Vec3<Dual<T>>,
    u: T,
    v: T,
) -> Option<UnitVec3<T>> {
    let parameters = Dual::point(Vec3::new(u, v, T::ZERO));
    let s = s(parameters.x, parameters.y);
    let (s_u, s_v) = (s.map(|s| s.gradient.x), s.map(|s| s.gradient.y));
    let largest = |v: Vec3<T>| {
        magnitude(v.x)
            .at_least(magnitude(v.y))
            .at_least(magnitude(v.z))
    };
    let (a, b) = (largest(s_u), largest(s_v));
    // two roundings for each of the 16 control points of a bicubic patch; on the teapot, the noise
    // reaches 14u
    let noise = T::of_f32(16.0) * epsilon();
    let is_noise = a.at_most(b) <= a.at_least(b) * noise;
    from_tangents(s_u, s_v).filter(|_| !is_noise)
}

/// The normal of a parametric surface, from its two tangents.
///
/// ```text
/// N = s_u × s_v / |s_u × s_v|
/// ```
///
/// The tangents may have any length. Their order decides to which side N points. The result is `None`
/// if they are parallel, 0 or not finite. They may count as parallel if the sine of the angle between
/// them is below u², where u is the unit roundoff.
///
/// Source: Foley, van Dam et al. 1990, §11.3.4.
///
/// ```
/// use shading::{UnitVec3, Vec3, normal};
///
/// let (s_u, s_v) = (Vec3::new(1e-30_f32, 0.0, 0.0), Vec3::new(0.0, 1e30, 0.0));
/// assert_eq!(normal::from_tangents(s_u, s_v), Some(UnitVec3::Z));
/// assert_eq!(normal::from_tangents(s_u, s_u), None);
/// ```
#[inline(always)]
#[must_use]
pub fn from_tangents<T: Real + Scalar>(s_u: Vec3<T>, s_v: Vec3<T>) -> Option<UnitVec3<T>> {
    T::crossed(Vec3::ZERO, s_u, s_v).unit()
}
