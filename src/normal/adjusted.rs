//! Normals made from normals: turned to the eye, transformed, or perturbed by a normal map.

use super::surface::from_tangents;
use crate::number::{Mask, Real, Scalar, is_extreme, magnitude};
use crate::vector::{UnitVec3, Vec3};

/// The normal on the viewer's side, for surfaces that are seen from both sides.
///
/// ```text
/// N where F·V ≥ 0, else −N
/// ```
///
/// N is the normal to shade with, V the direction to the eye, away from the surface, and `face`, F,
/// the normal of the surface itself: that of the triangle which the ray has hit. F decides which side
/// the eye sees. If the surface is seen edge-on (F·V = 0), or if F or V is NaN, the result is N.
///
/// For an exact surface, such as a sphere, F is N. Where N is interpolated over a mesh or comes from a
/// normal map, N·V may be negative although the eye sees the front: such an N must not be turned.
/// Turn it **last**: interpolate first, then apply the [normal map](mapped), then call this function.
///
/// GLSL's `faceforward(N, I, F)` takes the incident direction, which is −V. `faceforward(N, -V, F)`
/// is this function, except that it gives −N for F·V = 0.
///
/// Source: *The OpenGL Shading Language*, version 4.60, 2017, §8.5.
///
/// ```
/// use shading::{UnitVec3, normal};
///
/// let v = UnitVec3::<f32>::new(0.0, 0.6, 0.8).unwrap();
/// let (front, back) = (UnitVec3::Z, -UnitVec3::Z);
/// assert_eq!(normal::facing(front, v, front), UnitVec3::Z);
/// assert_eq!(normal::facing(back, v, back), UnitVec3::Z);
///
/// // a smooth normal near the outline, which leans away from the eye on a face seen from the front
/// let smooth = UnitVec3::new(0.0, -0.96, 0.28).unwrap();
/// assert!(smooth.dot(v) < 0.0);
/// assert_eq!(normal::facing(smooth, v, front), smooth);
/// ```
#[doc(alias("faceforward", "flip", "two_sided", "two-sided"))]
#[inline]
pub fn facing<T: Real>(n: UnitVec3<T>, v: UnitVec3<T>, face: UnitVec3<T>) -> UnitVec3<T> {
    let away = (-face).dot(v).above(T::ZERO);
    UnitVec3::assume_unit(Vec3::select(away, -*n, *n))
}

/// The normal of a surface after its points are transformed by a matrix M with the columns a, b and
/// c.
///
/// ```text
/// N′ = cof(M) N / |cof(M) N|,  cof(M) N = n_x (b × c) + n_y (c × a) + n_z (a × b)
/// ```
///
/// M is the linear part of the transformation, without the translation: it moves the point p to p_x
/// a + p_y b + p_z c. The normal of a triangle becomes the normal of its transformed vertices, as
/// given by [`triangle`](crate::normal::triangle()), for every M.
///
/// **Mirroring.** The commonly used inverse transpose is cof(M)/det(M). If M mirrors (det(M) < 0),
/// the inverse transpose gives −N′. It keeps an outward normal outward, while the transformed
/// vertices appear clockwise. If you want that, use `-n` where `a.cross(b).dot(c) < 0`.
///
/// The result is `None` if M flattens the surface to a line or a point, up to rounding, or if a
/// number is not finite. A singular M still gives a normal to every other surface, because M is not
/// inverted. The error is a few u times the conditioning (|n_x||b||c| + |n_y||c||a| +
/// |n_z||a||b|)/|cof(M) N|, whatever the length of each column from 2⁻¹²⁰ (`f32`) or 2⁻¹⁰⁰⁰ (`f64`)
/// on, where u is the unit roundoff. It is an error of a vector of length 1: a component that M
/// makes much smaller than the others has fewer correct digits, and below 2⁻⁷⁵ (`f32`) or 2⁻⁶⁶⁰
/// (`f64`) it may be 0.
///
/// Source: Eric Lengyel, *Transforming Normals*, 2024; Ken Turkowski, *Properties of Surface-Normal
/// Transformations*, in *Graphics Gems*, 1990, for the inverse transpose.
///
/// ```
/// use shading::{UnitVec3, Vec3, normal};
///
/// // half as wide: the slope of a roof is twice as steep
/// let narrow = [[0.5, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vec3::from);
/// let roof = UnitVec3::<f32>::new(0.6, 0.0, 0.8).unwrap();
/// let steep = normal::transformed(roof, narrow).unwrap();
/// assert!((steep.x / steep.z - 2.0 * roof.x / roof.z).abs() < 1e-6);
///
/// // squashed to the plane z = 0, it lies in that plane; a wall becomes a line
/// let flat = [*UnitVec3::X, *UnitVec3::Y, Vec3::ZERO];
/// assert_eq!(normal::transformed(roof, flat), Some(UnitVec3::Z));
/// assert_eq!(normal::transformed(UnitVec3::X, flat), None);
/// ```
#[doc(alias("inverse transpose", "normal matrix"))]
#[inline(always)]
#[must_use]
pub fn transformed<T: Real + Scalar>(n: UnitVec3<T>, columns: [Vec3<T>; 3]) -> Option<UnitVec3<T>> {
    let cofactors = |[a, b, c]: [Vec3<T>; 3], n: Vec3<T>| {
        b.cross(c) * n.x + c.cross(a) * n.y + a.cross(b) * n.z
    };
    let [a, b, c] = columns;
    if is_extreme(a.dot(a)) || is_extreme(b.dot(b)) || is_extreme(c.dot(c)) {
        // cof(M) N is proportional to the same with each column over its length, and n_x over that of a;
        // the least length that counts keeps the quotients within range
        let none = UnitVec3::assume_unit(Vec3::ZERO);
        let (x, y, z) = (a.length(), b.length(), c.length());
        let counts = |n: T, length| magnitude(n).above(T::ZERO).select(length, T::MAX);
        let least = counts(n.x, x)
            .at_most(counts(n.y, y))
            .at_most(counts(n.z, z));
        let scaled = |n: T, length: T| {
            let scaled = length.above(least).select(n * (least / length), n);
            magnitude(n).above(T::ZERO).select(scaled, T::ZERO)
        };
        let n = Vec3::new(scaled(n.x, x), scaled(n.y, y), scaled(n.z, z));
        // the product with 0 keeps what is not finite
        let along = |v: Vec3<T>| *v.unit_or(none) + v * T::ZERO;
        cofactors([along(a), along(b), along(c)], n)
    } else {
        cofactors(columns, *n)
    }
    .unit()
}

/// The normal of a surface with a normal map: a sample of the map, interpreted in the frame of the
/// tangent, the bitangent and the normal.
///
/// ```text
/// t = the unit vector along T − (N·T)N,  b = h (N × t)
/// N′ = (x t + y b + z N)/|x t + y b + z N|
/// ```
///
/// N is the normal of the surface. T is a tangent of any length: the direction in which the map's x
/// grows (the `u` of its texture coordinates). Only the part of T perpendicular to N counts. The
/// handedness h is the sign of the fourth number of a tangent in a glTF file. b points to where the
/// map's y grows. If h is positive, so does N × t; otherwise, N × t points the other way.
///
/// The sample (x, y, z) must be decoded: (0, 0, 1) is N itself, and the length does not matter. To
/// decode a texel with channels within [0, 1], compute 2·texel − 1, as in OpenGL and glTF. In maps
/// made for Direct3D, y points down: negate it. If a glTF file has no tangents, pass the t and the
/// **negative** h of [`tangent`](crate::normal::tangent), which explains why. A valid texel has a blue
/// channel above ½. A black texel is the direction (−1, −1, −1), below the surface.
///
/// The result is `None` if T is zero or parallel to N, if the sample is zero, or if a coordinate is not
/// finite. The nearer T is to N, the more its rounding errors matter, as in
/// [`from_tangents`](crate::normal::from_tangents).
///
/// Unlike this function, MikkTSpace neither normalizes the interpolated N and T nor makes them
/// perpendicular before it adds. Its result is the same at the vertices and differs slightly
/// between them.
///
/// Source: Khronos, *glTF 2.0 Specification*, 2021, §3.7.2.1 and §3.9.3; Mikkelsen 2008; Blinn 1978
/// for the idea.
///
/// ```
/// use shading::f32::{UnitVec3, Vec3};
/// use shading::normal;
///
/// let (n, tangent) = (UnitVec3::Z, Vec3::new(1.0, 0.0, 0.0));
/// let decode = |texel: [u8; 3]| Vec3::from(texel.map(|c| f32::from(c) / 255.0 * 2.0 - 1.0));
///
/// let flat = normal::mapped(n, tangent, 1.0, decode([128, 128, 255])).unwrap();
/// assert!(n.dot(flat) > 0.9999);
/// let bump = normal::mapped(n, tangent, 1.0, decode([218, 128, 218])).unwrap();
/// assert!(bump.x > 0.7 && bump.z > 0.7);
///
/// // without a frame the surface keeps its own normal
/// assert_eq!(normal::mapped(n, *n, 1.0, decode([218, 128, 218])).unwrap_or(n), n);
/// ```
#[doc(alias("normal map", "tangent space", "bump", "texture"))]
#[inline(always)]
#[must_use]
pub fn mapped<T: Real + Scalar>(
    n: UnitVec3<T>,
    tangent: Vec3<T>,
    handedness: T,
    sample: Vec3<T>,
) -> Option<UnitVec3<T>> {
    let side = from_tangents(*n, tangent)?;
    let t = side.cross(n);
    let b = *side * handedness.above(T::ZERO).select(T::ONE, T::NEG_ONE);
    let sample = sample.unit()?;
    (t * sample.x + b * sample.y + *n * sample.z).unit()
}
