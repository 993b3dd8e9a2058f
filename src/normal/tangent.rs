//! The tangent that a normal map needs.

use crate::number::{Mask, Real, Scalar, magnitude};
use crate::vector::{UnitVec3, Vec3};

/// The tangent of a triangle with texture coordinates, and its handedness:
/// [`mapped`](crate::normal::mapped) takes both, if the mesh file has no tangents.
///
/// ```text
/// p = p₁ + (x − x₁) T + (y − y₁) B on the triangle:
/// T = ((y₃ − y₁)(p₂ − p₁) − (y₂ − y₁)(p₃ − p₁))/d,  d = (x₂ − x₁)(y₃ − y₁) − (x₃ − x₁)(y₂ − y₁)
/// t = T/|T|,  h = the sign of d
/// ```
///
/// t is the direction in which the map's x grows, h is 1 or −1. With N the normal of the
/// counter-clockwise triangle, the map's y grows to the side of h (N × t). It is −1 where the map is
/// mirrored, as on one half of a face that uses the same texels for both.
///
/// **glTF.** In a glTF file, the y of the texture coordinates grows downward, but the y of a normal
/// map points upward. Pass −h to `mapped`. three.js and glTF-Transform also turn MikkTSpace's sign
/// around for glTF.
///
/// The result is `None` if the three texture coordinates lie on a line, if T is zero, or if a number
/// is not finite.
///
/// At a vertex of a smooth mesh, add up t of the triangles around it with the same h, each times its
/// angle there, which is the length of its [`corner`](crate::normal::corner). `mapped` makes the sum
/// perpendicular to N. MikkTSpace weighs by an angle too, but first projects each t and both edges
/// onto the plane of N.
///
/// The error is at most 7u times the conditioning |p₂ − p₁||y₃ − y₁| + |p₃ − p₁||y₂ − y₁| over |d T|, where
/// u is the unit roundoff. The size of the triangle does not matter from 2⁻¹²⁰ (`f32`) or 2⁻¹⁰⁰⁰ (`f64`)
/// on, nor that of the map, as long as neither edge is more than 2¹⁰⁰ (2⁹⁰⁰) times as long as the other,
/// and the same holds for the differences of the texture coordinates.
///
/// Source: Eric Lengyel, *Computing Tangent Space Basis Vectors for an Arbitrary Mesh*, 2001;
/// Mikkelsen 2008.
///
/// ```
/// use shading::{UnitVec3, Vec3, normal};
///
/// // a glTF file's square: its texture coordinates begin in the upper left corner
/// let [a, b, c] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0]].map(Vec3::<f32>::from);
/// let (t, h) = normal::tangent([a, b, c], [[0.0, 1.0], [1.0, 1.0], [1.0, 0.0]]).unwrap();
/// assert_eq!((t, h), (UnitVec3::X, -1.0));
///
/// // a texel that leans up, so −h; with h, the bump would be a dent
/// let bump = normal::mapped(UnitVec3::Z, *t, -h, Vec3::new(0.0, 0.6, 0.8)).unwrap();
/// assert_eq!(bump.y, 0.6);
/// ```
#[doc(alias("MikkTSpace", "tangent space"))]
#[inline]
#[must_use]
pub fn tangent<T: Real + Scalar>(
    [a, b, c]: [Vec3<T>; 3],
    [[x1, y1], [x2, y2], [x3, y3]]: [[T; 2]; 3],
) -> Option<(UnitVec3<T>, T)> {
    // halves, because a difference may overflow; fractions of the largest, because a product may
    let half = T::of_f32(0.5);
    let (e2, e3) = (b * half - a * half, c * half - a * half);
    let edge = e2.length().at_least(e3.length());
    let (x2, x3) = fractions(x2 * half - x1 * half, x3 * half - x1 * half);
    let (y2, y3) = fractions(y2 * half - y1 * half, y3 * half - y1 * half);
    let d = x2 * y3 - x3 * y2;
    let h = d.above(T::ZERO).select(T::ONE, T::NEG_ONE);
    let t = (e2 / edge * y3 - e3 / edge * y2) * h;
    t.unit().filter(|_| magnitude(d) > T::ZERO).map(|t| (t, h))
}

/// Two numbers as fractions of the larger one. If both are 0, they are NaN.
#[inline]
fn fractions<T: Real>(a: T, b: T) -> (T, T) {
    let larger = magnitude(a).at_least(magnitude(b));
    (a / larger, b / larger)
}
