//! Normals made of normals: turned to the eye, transformed, averaged over a mesh, from a normal map.

use super::surface::from_tangents;
use crate::real::Real;
use crate::rescale::{extreme_difference, is_extreme, tame, tame_difference};
use crate::unit::UnitVec3;
use crate::vector::Vec3;

/// The normal on the side of the viewer, for surfaces that are seen from both sides.
///
/// ```text
/// N where N·V ≥ 0, else −N
/// ```
///
/// V points away from the surface, to the eye. Seen edge-on (N·V = 0), and where a number is NaN, N
/// stays as it is.
///
/// GLSL's `faceforward(N, I, N)` takes the incident direction, which is −V: `faceforward(N, -V, N)`
/// is this function, but for N·V = 0, where it gives −N.
///
/// Source: *The OpenGL Shading Language* 4.60, §8.5.
///
/// ```
/// use shading::{UnitVec3, normal};
///
/// let v = UnitVec3::<f32>::new(0.0, 0.6, 0.8).unwrap();
/// assert_eq!(normal::facing(UnitVec3::Z, v), UnitVec3::Z);
/// assert_eq!(normal::facing(-UnitVec3::Z, v), UnitVec3::Z);
/// assert_eq!(normal::facing(-UnitVec3::X, v), -UnitVec3::X); // edge-on
/// ```
#[doc(alias = "faceforward")]
#[doc(alias = "two-sided")]
#[inline]
#[must_use]
pub fn facing<T: Real>(n: UnitVec3<T>, v: UnitVec3<T>) -> UnitVec3<T> {
    let away = (-n).dot(v);
    UnitVec3::assume_unit(n.map(|c| away.if_positive(-c, c)))
}

/// The normal of a surface whose points are transformed by a matrix M with the columns a, b, c.
///
/// ```text
/// N′ = cof(M) N / |cof(M) N|,  cof(M) N = n_x (b × c) + n_y (c × a) + n_z (a × b)
/// ```
///
/// M is the linear part of the transformation, without the translation: the point p goes to
/// p_x a + p_y b + p_z c. The normal of a triangle goes to the
/// [`triangle`](crate::normal::triangle()) of its transformed vertices, for every M.
///
/// **Mirrored.** The commonly used inverse transpose is cof(M)/det(M). Where M mirrors (det(M) < 0)
/// it gives −N′: the outward normal of an outward one, while the vertices are then seen clockwise.
/// Use `-n` where that is wanted.
///
/// `None` where M flattens the surface to a line or a point, to rounding, and where a number is not
/// finite. A singular M has a normal for all other surfaces: M need not be inverted. The error is a
/// few u times the conditioning (|n_x||b||c| + |n_y||c||a| + |n_z||a||b|)/|cof(M) N|, whatever the
/// size of each column.
///
/// Source: Turkowski, *Properties of Surface-Normal Transformations*, Graphics Gems, 1990.
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
#[doc(alias = "inverse transpose")]
#[doc(alias = "normal matrix")]
#[inline]
#[must_use]
pub fn transformed<T: Real + PartialOrd>(
    n: UnitVec3<T>,
    columns: [Vec3<T>; 3],
) -> Option<UnitVec3<T>> {
    let [a, b, c] = columns;
    if is_extreme(a.dot(a)) || is_extreme(b.dot(b)) || is_extreme(c.dot(c)) {
        by_cofactors_of_any_size(n, columns)
    } else {
        b.cross(c) * n.x + c.cross(a) * n.y + a.cross(b) * n.z
    }
    .unit()
}

/// cof(M) N but for its length, where the columns differ so much in length that no power of two
/// brings all their products into range. Each product is a tame vector and a whole power of
/// [`RESCALE`](Real::RESCALE), and the sum is taken relative to the highest power.
#[cold]
#[inline(never)]
fn by_cofactors_of_any_size<T: Real + PartialOrd>(
    n: UnitVec3<T>,
    columns: [Vec3<T>; 3],
) -> Vec3<T> {
    let [a, b, c] = columns.map(|column| tame_power(column, 0));
    let products = [(n.x, b, c), (n.y, c, a), (n.z, a, b)].map(|(n, (b, of_b), (c, of_c))| {
        let (cross, power) = tame_power(b.cross(c), of_b + of_c);
        let (n, power) = tame_power(Vec3::new(n, T::ZERO, T::ZERO), power);
        (cross * n.x, power)
    });
    let mut highest = i32::MIN;
    for (product, power) in products {
        if product != Vec3::ZERO && power > highest {
            highest = power;
        }
    }
    let mut sum = Vec3::ZERO;
    for (product, power) in products {
        if power == highest {
            sum += product;
        } else if power + 1 == highest {
            sum += product * (T::ONE / T::RESCALE);
        }
    }
    sum
}

/// A vector times a `power` of [`RESCALE`](Real::RESCALE), as a tame vector times a power.
#[inline(never)]
fn tame_power<T: Real + PartialOrd>(v: Vec3<T>, power: i32) -> (Vec3<T>, i32) {
    let (tame, scale) = extreme_difference(v, Vec3::ZERO, v.dot(v));
    let grown = i32::from(scale > T::ONE) - i32::from(scale < T::ONE);
    (tame, power - grown)
}

/// The share of a triangle in the normal of its vertex v₁: its own normal, weighted by its angle
/// there.
///
/// ```text
/// α (e₁ × e₂)/|e₁ × e₂|,  e₁ = v₂ − v₁,  e₂ = v₃ − v₁,  α = the angle between them
/// ```
///
/// The normal of a vertex is the sum of the shares of all triangles around it, made
/// [`unit`](Vec3::unit). The vertices are seen counter-clockwise, as for
/// [`triangle`](crate::normal::triangle()). A triangle that is a line or a point has no share: the
/// zero vector. Neither has one with a vertex that is not finite. The size of a triangle does not
/// matter: 10⁻²⁰ and 10²⁰ are as good as 1, also side by side.
///
/// The angle is the one weight under which it does not matter how a flat face is split into
/// triangles. The mean error of vertex normals, against the exact normals of the surface that the
/// mesh lies on (`tests/weights.rs`):
///
/// | mesh | angle | Max | area |
/// |---|---|---|---|
/// | the teapot, all squares split alike | 0.38° | 0.67° | 0.26° |
/// | the teapot, each square split either way | 0.39° | 0.71° | 0.76° |
/// | the same, its vertices out of line | 0.84° | 1.09° | 1.41° |
/// | the bunny | 2.25° | 2.72° | 2.02° |
/// | a sphere, as irregular | 1.05° | 0.00° | 2.78° |
///
/// Max's weights are exact on a sphere and need no angle: `e1.cross(e2)` over |e₁|²|e₂|². Areas are
/// the shortest to write, `e1.cross(e2)`, and best where a mesh is regular.
///
/// Source: Thürmer and Wüthrich, *Computing Vertex Normals from Polygonal Facets*, 1998; Max,
/// *Weights for Computing Vertex Normals from Facet Normals*, 1999.
///
/// A mesh is smoothed in one pass, without allocation:
///
/// ```
/// use shading::{UnitVec3, Vec3, normal};
///
/// let positions = [[0.0_f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vec3::from);
/// let triangles = [[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]];
///
/// let mut sums = [Vec3::ZERO; 4];
/// for triangle in triangles {
///     for [i, j, k] in [[0, 1, 2], [1, 2, 0], [2, 0, 1]].map(|corner| corner.map(|i| triangle[i])) {
///         sums[i] += normal::corner(positions[i], positions[j], positions[k]);
///     }
/// }
/// let normals = sums.map(|sum| sum.unit().unwrap());
/// let diagonal = Vec3::new(-1.0, -1.0, -1.0).unit().unwrap(); // three faces meet at the origin
/// assert!((*normals[0] - *diagonal).length() < 1e-6);
/// ```
#[doc(alias = "vertex normal")]
#[doc(alias = "smooth")]
#[inline]
#[must_use]
pub fn corner<T: Real>(v1: Vec3<T>, v2: Vec3<T>, v3: Vec3<T>) -> Vec3<T> {
    let none = UnitVec3::assume_unit(Vec3::ZERO);
    let (e1, e2) = (tame_difference(v2, v1), tame_difference(v3, v1));
    let product = e1.cross(e2);
    let n = product.unit_or(none);
    let lengths = e1.dot(e1).sqrt() * e2.dot(e2).sqrt();
    let sine = n.dot(product);
    *n * sine.if_positive(angle(sine / lengths, e1.dot(e2) / lengths), T::ZERO)
}

/// The angle within [0, π] of a sine and a cosine, by three half-angles and a series.
///
/// ```text
/// θ = sin θ · (φ/sin φ)/(cos θ/2 · cos θ/4 · cos θ/8),  φ = θ/8,
/// φ/sin φ = 1 + y/3 (1 + 2y/5 (1 + 3y/7 (1 + …))),  y = 1 − cos φ
/// ```
///
/// For an acute angle, and an obtuse one is made of that, y is at most 0.02, and what the series leaves
/// out below 10⁻¹⁶.
///
/// Source: Euler, *Institutiones calculi differentialis*, 1755, part II, chapter II, §30.
#[inline]
fn angle<T: Real>(sine: T, cosine: T) -> T {
    let halved = |cosine: T| ((cosine + T::ONE) * T::of(0.5)).sqrt();
    // not abs, which is flat at 0
    let half = halved((-cosine).if_positive(-cosine, cosine));
    let quarter = halved(half);
    let eighth = halved(quarter);
    let y = T::ONE - eighth;
    let next = |ratio: f64, rest: T| T::ONE + y * T::of(ratio) * rest;
    let rest = next(5.0 / 11.0, next(6.0 / 13.0, next(7.0 / 15.0, T::ONE)));
    let series = next(
        1.0 / 3.0,
        next(2.0 / 5.0, next(3.0 / 7.0, next(4.0 / 9.0, rest))),
    );
    let acute = sine * series / (half * quarter * eighth);
    (-cosine).if_positive(T::of(core::f64::consts::PI) - acute, acute)
}

/// The normal of a surface with a normal map: a sample of the map, taken in the frame of tangent,
/// bitangent and normal.
///
/// ```text
/// t = the unit vector along T − (N·T)N,  b = h (N × t)
/// N′ = (x t + y b + z N)/|x t + y b + z N|
/// ```
///
/// N is the surface's normal, T a tangent of any length: the direction in which the map's x grows
/// (the `u` of its texture coordinates). Only its part perpendicular to N counts. The handedness h
/// is the sign of the fourth number of a tangent in a glTF file: b points to where y grows if it is
/// positive, and the other way if it is not.
///
/// The sample (x, y, z) is decoded: (0, 0, 1) is N itself, and its length does not matter. A texel
/// with channels within [0, 1] is decoded by 2·texel − 1, as OpenGL and glTF have it. Maps made for
/// Direct3D have y downwards: negate it. A texel of a map must have a blue above ½; a black one is
/// the direction (−1, −1, −1), below the surface.
///
/// `None` where T is zero or parallel to N, where the sample is zero, and where a number is not
/// finite. The nearer T is to N, the more its rounding shows, as in
/// [`from_tangents`](crate::normal::from_tangents).
///
/// MikkTSpace neither normalizes the interpolated N and T nor makes them perpendicular before it
/// adds. Its result is the same at the vertices and differs a little between them.
///
/// Source: Blinn, *Simulation of Wrinkled Surfaces*, 1978; Khronos, *glTF 2.0 Specification*,
/// §3.7.2.1 and §3.9.3; Mikkelsen, *Simulation of Wrinkled Surfaces Revisited*, 2008.
///
/// ```
/// use shading::{UnitVec3, Vec3, normal};
///
/// let (n, tangent) = (UnitVec3::<f32>::Z, Vec3::new(1.0, 0.0, 0.0));
/// let decode = |texel: [u8; 3]| Vec3::from(texel).map(|c| f32::from(c) / 255.0 * 2.0 - 1.0);
///
/// let flat = normal::mapped(n, tangent, 1.0, decode([128, 128, 255])).unwrap();
/// assert!(n.dot(flat) > 0.9999);
/// let bump = normal::mapped(n, tangent, 1.0, decode([218, 128, 218])).unwrap();
/// assert!(bump.x > 0.7 && bump.z > 0.7);
///
/// // without a frame the surface keeps its own normal
/// assert_eq!(normal::mapped(n, *n, 1.0, decode([218, 128, 218])).unwrap_or(n), n);
/// ```
#[doc(alias = "normal map")]
#[doc(alias = "tangent space")]
#[doc(alias = "bump")]
#[inline]
#[must_use]
pub fn mapped<T: Real + PartialOrd>(
    n: UnitVec3<T>,
    tangent: Vec3<T>,
    handedness: T,
    sample: Vec3<T>,
) -> Option<UnitVec3<T>> {
    let side = from_tangents(*n, tangent)?;
    let (t, b) = (
        side.cross(n),
        *side * handedness.if_positive(T::ONE, T::NEG_ONE),
    );
    let sample = tame(sample);
    (t * sample.x + b * sample.y + *n * sample.z).unit()
}
