//! Normals of triangles, surfaces and meshes: they turn, move, grow and mirror with their surface.

use std::f64::consts::PI;

use proptest::prelude::*;
use shading::{Dual, UnitVec3, Vec3, normal};

use crate::book::{self, Triple};
use crate::given::{Frame, Triangle};
use crate::tracked::{prop_assert_book, prop_assert_near};
use crate::{Number, Outcome, half_a_turn, has_digits, is_tame, quarter_turn};

fn xyz<T: Number>(v: impl Into<Vec3<T>>) -> Triple {
    book::xyz(v.into().map(T::exact))
}

fn u<T: Number>() -> f64 {
    T::U + T::STEP
}

/// How far two directions are apart; as far as can be, if one of them is none.
fn apart<T: Number>(a: Option<UnitVec3<T>>, b: Option<UnitVec3<T>>) -> f64 {
    match (a, b) {
        (Some(a), Some(b)) => book::length(book::minus(xyz(a), xyz(b))),
        (None, None) => 0.0,
        _ => 2.0,
    }
}

/// The edges of a triangle that is not a sliver, and how many roundings of its corners a normal may
/// be off by.
fn edges<T: Number>(t: &Triangle<T>) -> Option<([Triple; 3], f64)> {
    let [a, b, c] = [t.a, t.b, t.c].map(xyz);
    let edges = [book::minus(b, a), book::minus(c, b), book::minus(a, c)];
    let longest = edges.map(book::length).into_iter().fold(0.0, f64::max);
    let area = book::length(book::cross(edges[0], edges[1]));
    let far = [a, b, c].map(book::length).into_iter().fold(0.0, f64::max);
    let is_ordinary = longest > 1e-2 && longest < 100.0 && has_digits::<T>(area * area);
    (is_ordinary && area > 0.05 * longest * longest).then(|| {
        let conditioning = longest * (longest + far) / area;
        (
            edges,
            conditioning * (T::U + T::STEP * (1.0 + 1.0 / (longest * longest))),
        )
    })
}

/// The normal of a triangle has length 1.
pub fn a_normal_has_length_1<T: Number>(t: &Triangle<T>) -> Outcome {
    let Some((_, roundings)) = edges(t) else {
        return Ok(());
    };
    let n = normal::triangle(t.a, t.b, t.c).expect("no sliver");
    prop_assert_near!(
        book::length(xyz(n)),
        1.0,
        4.0 * T::U + 16.0 * T::STEP * roundings / u::<T>()
    );
    Ok(())
}

/// A normal is perpendicular to all edges, and looks to the side from which they run
/// counter-clockwise.
pub fn a_normal_is_perpendicular_to_its_edges<T: Number>(t: &Triangle<T>) -> Outcome {
    let Some((edges, roundings)) = edges(t) else {
        return Ok(());
    };
    let n = xyz(normal::triangle(t.a, t.b, t.c).expect("no sliver"));
    for edge in edges {
        prop_assert_near!(
            book::dot(n, edge) / book::length(edge),
            0.0,
            16.0 * roundings
        );
    }
    let product = book::cross(edges[0], edges[1]);
    prop_assert_near!(
        book::dot(n, product) / book::length(product),
        1.0,
        16.0 * roundings
    );
    Ok(())
}

/// Which vertex comes first matters by roundings only.
pub fn any_vertex_may_come_first<T: Number>(t: &Triangle<T>) -> Outcome {
    let Some((_, roundings)) = edges(t) else {
        return Ok(());
    };
    let first = normal::triangle(t.a, t.b, t.c);
    for other in [
        normal::triangle(t.b, t.c, t.a),
        normal::triangle(t.c, t.a, t.b),
    ] {
        prop_assert_near!(apart(first, other), 0.0, 32.0 * roundings);
    }
    Ok(())
}

/// Two vertices, tangents or parameters exchanged turn the normal over, to the bit.
pub fn an_exchange_turns_the_normal_over<T: Number>(t: &Triangle<T>) -> Outcome {
    let turned = |n: Option<UnitVec3<T>>| n.map(|n| -n);
    prop_assert_eq!(
        normal::triangle(t.a, t.c, t.b),
        turned(normal::triangle(t.a, t.b, t.c))
    );
    prop_assert_eq!(
        normal::from_tangents(t.b, t.a),
        turned(normal::from_tangents(t.a, t.b))
    );

    let [p, _, _] = t.corners;
    prop_assert_eq!(
        normal::parametric(|v, u| Vec3::new(u, v, u * v), p.y, p.x),
        turned(normal::parametric(|u, v| Vec3::new(u, v, u * v), p.x, p.y))
    );
    Ok(())
}

/// Two vertices exchanged turn the share of a corner over, to the bit.
pub fn an_exchange_turns_the_corner_over<T: Number>(t: &Triangle<T>) -> Outcome {
    let corner = normal::corner(t.a, t.b, t.c);
    prop_assert_eq!(normal::corner(t.a, t.c, t.b), -corner);
    Ok(())
}

/// A point or a segment is no degenerate triangle with a normal: there is none, and no corner.
pub fn a_degenerate_triangle_has_no_normal<T: Number>(t: &Triangle<T>) -> Outcome {
    for [a, b, c] in [
        [t.a, t.a, t.a],
        [t.a, t.a, t.b],
        [t.a, t.b, t.a],
        [t.a, t.b, t.b],
    ] {
        prop_assert_eq!(normal::triangle(a, b, c), None);
        prop_assert_eq!(normal::corner(a, b, c), Vec3::ZERO);
    }
    Ok(())
}

/// Three points on a line have no normal and no corner, in any order, where the edges are exact.
pub fn a_line_has_no_normal<T: Number>(t: &Triangle<T>) -> Outcome {
    let [a, edge, _] = t.corners;
    let (b, c) = (a + edge, a - edge);
    for [a, b, c] in [[a, b, c], [b, c, a], [c, a, b]] {
        prop_assert_eq!(normal::triangle(a, b, c), None);
        prop_assert_eq!(normal::corner(a, b, c), Vec3::ZERO);
    }
    prop_assert_eq!(normal::from_tangents(edge, edge * T::of(2.0)), None);
    Ok(())
}

/// A surface that moves keeps its normal, to the bit where the sums are exact.
pub fn a_normal_does_not_move_with_its_surface<T: Number>(t: &Triangle<T>) -> Outcome {
    let ([a, b, c], o) = (t.corners, t.offset);
    prop_assert_eq!(
        normal::triangle(a + o, b + o, c + o),
        normal::triangle(a, b, c)
    );
    prop_assert_eq!(normal::sphere(a + o, b + o), normal::sphere(a, b));
    prop_assert_eq!(normal::corner(a + o, b + o, c + o), normal::corner(a, b, c));
    Ok(())
}

/// Half a turn about z turns every normal, too, to the bit.
pub fn a_normal_turns_with_its_surface<T: Number>(t: &Triangle<T>) -> Outcome {
    let turned = |n: Option<UnitVec3<T>>| n.map(|n| UnitVec3::assume_unit(half_a_turn(*n)));
    let [a, b, c] = [t.a, t.b, t.c].map(half_a_turn);
    prop_assert_eq!(
        normal::triangle(a, b, c),
        turned(normal::triangle(t.a, t.b, t.c))
    );
    prop_assert_eq!(normal::sphere(a, b), turned(normal::sphere(t.a, t.b)));
    prop_assert_eq!(
        normal::from_tangents(a, b),
        turned(normal::from_tangents(t.a, t.b))
    );
    prop_assert_eq!(
        normal::corner(a, b, c),
        half_a_turn(normal::corner(t.a, t.b, t.c))
    );
    Ok(())
}

/// A triangle of twice the size has the same normal, to the bit; so has its image in a point.
pub fn a_normal_has_no_size<T: Number>(t: &Triangle<T>) -> Outcome {
    let [a, b, c] = t.corners;
    let [x, y, z] = t.corners.map(xyz);
    let area = book::length(book::cross(book::minus(y, x), book::minus(z, x)));
    // in a half, a larger square is out of range
    prop_assume!(area == 0.0 || is_tame::<T>(area * area) && is_tame::<T>(16.0 * area * area));
    let n = normal::triangle(a, b, c);
    let two = T::of(2.0);
    prop_assert_eq!(normal::triangle(a * two, b * two, c * two), n);
    prop_assert_eq!(
        normal::plane(a.x * two, a.y * two, a.z * two),
        normal::plane(a.x, a.y, a.z)
    );
    Ok(())
}

/// Mirrored in a point, a triangle keeps its normal: both edges turn over, to the bit.
pub fn a_normal_survives_a_point_reflection<T: Number>(t: &Triangle<T>) -> Outcome {
    prop_assert_eq!(
        normal::triangle(-t.a, -t.b, -t.c),
        normal::triangle(t.a, t.b, t.c)
    );
    Ok(())
}

/// The normal of the plane ax + by + cz = d is (a, b, c), and that of a sphere points from its
/// center.
pub fn planes_and_spheres_have_their_direction<T: Number>(t: &Triangle<T>) -> Outcome {
    prop_assert_book!(
        t,
        normal::plane(t.a.x, t.a.y, t.a.z),
        book::direction(book::xyz(t.a))
    );
    prop_assert_book!(
        t,
        normal::sphere(t.a, t.b),
        book::direction(book::minus(book::xyz(t.b), book::xyz(t.a)))
    );
    prop_assert_eq!(
        normal::from_gradient(t.a),
        normal::plane(t.a.x, t.a.y, t.a.z)
    );
    prop_assert_eq!(normal::sphere(t.a, t.a), None);
    Ok(())
}

/// The saddle z = xy has the same normal by its equation, by its parameters and by hand: (−y, −x,
/// 1)/√(x² + y² + 1).
pub fn equation_and_parameters_agree<T: Number>(t: &Triangle<T>) -> Outcome {
    let [p, _, _] = t.corners;
    let point = Vec3::new(p.x, p.y, p.x * p.y);
    let by_equation = normal::implicit(|p: Vec3<Dual<T>>| p.z - p.x * p.y, point);
    let by_parameters = normal::parametric(|u, v| Vec3::new(u, v, u * v), p.x, p.y);
    let [x, y, _] = xyz(p);
    let by_hand = book::direction([-y, -x, 1.0]).expect("z is 1");
    for n in [by_equation, by_parameters] {
        let n = xyz(n.expect("a saddle is smooth"));
        prop_assert_near!(book::length(book::minus(n, by_hand)), 0.0, 12.0 * u::<T>());
        // the gradient is perpendicular to both tangents, (1, 0, y) and (0, 1, x)
        for tangent in [[1.0, 0.0, y], [0.0, 1.0, x]] {
            prop_assert_near!(
                book::dot(n, tangent),
                0.0,
                24.0 * u::<T>() * book::length(tangent)
            );
        }
    }
    Ok(())
}

/// An equation times −1 turns the normal over, to the bit.
pub fn a_negative_equation_turns_the_normal_over<T: Number>(t: &Triangle<T>) -> Outcome {
    let f = |p: Vec3<Dual<T>>| p.x * p.y + p.z * p.z;
    let [p, _, _] = t.corners;
    let n = normal::implicit(f, p);
    prop_assert_eq!(normal::implicit(|p| -f(p), p), n.map(|n| -n));
    prop_assert!(apart(normal::implicit(|p| f(p) * T::of(3.0), p), n) <= 12.0 * u::<T>());
    Ok(())
}

/// An equation times a power of two, or parameters that run half as fast, keep the normal, to the
/// bit.
pub fn a_multiple_of_an_equation_has_its_normal<T: Number>(t: &Triangle<T>) -> Outcome {
    let [p, q, _] = t.corners;
    let f = |p: Vec3<Dual<T>>| p.x * p.y + p.z * p.z;
    prop_assert_eq!(
        normal::implicit(|p| f(p) * T::of(4.0), p),
        normal::implicit(f, p)
    );
    let s = |u: Dual<T>, v: Dual<T>| Vec3::new(u, v, u * v);
    let (two, half) = (T::of(2.0), T::of(0.5));
    prop_assert_eq!(
        normal::parametric(|u, v| s(u * two, v * two), q.x * half, q.y * half),
        normal::parametric(s, q.x, q.y)
    );
    Ok(())
}

/// After `facing`, N·V ≥ 0; it gives N or −N and nothing else; twice is once, to the bit.
pub fn a_normal_can_face_the_eye<T: Number>(f: &Frame<T>) -> Outcome {
    let n = normal::facing(f.n, f.v, f.n);
    prop_assert!(n.dot(f.v) >= T::ZERO, "{n:?}");
    prop_assert!(n == f.n || n == -f.n, "{n:?}");
    prop_assert_eq!(normal::facing(n, f.v, n), n);
    if f.n.dot(f.v) > T::ZERO {
        prop_assert_eq!(n, f.n);
    }
    Ok(())
}

/// A matrix turns the normal of a triangle into that of the triangle it makes, a mirror and its
/// size included.
pub fn a_normal_is_transformed_with_its_surface<T: Number>(f: &Frame<T>) -> Outcome {
    let [x, y, z] = f.columns.map(xyz);
    let det = book::dot(x, book::cross(y, z));
    let size = [x, y, z].map(book::length).into_iter().fold(0.0, f64::max);
    prop_assume!(det.abs() > 0.05 * size * size * size);
    let tolerance =
        24.0 * (T::U + T::STEP * (1.0 + 1.0 / (size * size))) * size.powi(3) / det.abs();
    // the tangents of the plane z = 0 are the columns x and y, and so on
    for (n, [s, t]) in [
        (UnitVec3::Z, [x, y]),
        (UnitVec3::X, [y, z]),
        (UnitVec3::Y, [z, x]),
    ] {
        let n = xyz(normal::transformed(n, f.columns).expect("regular"));
        let expected = book::direction(book::cross(s, t)).expect("regular");
        prop_assert_near!(book::length(book::minus(n, expected)), 0.0, tolerance);
    }
    Ok(())
}

/// A rotation turns a normal as it turns a vector.
pub fn a_rotation_transforms_a_normal_as_a_vector<T: Number>(f: &Frame<T>) -> Outcome {
    let turn = [UnitVec3::X, UnitVec3::Y, UnitVec3::Z].map(|axis| quarter_turn(*axis));
    let turned = normal::transformed(f.n, turn);
    let expected = UnitVec3::assume_unit(quarter_turn(*f.n));
    prop_assert_near!(apart(turned, Some(expected)), 0.0, 6.0 * u::<T>());
    // a projection along N keeps it, and one along a direction in the surface leaves none
    let flat = [*UnitVec3::<T>::X, *UnitVec3::Y, Vec3::ZERO];
    prop_assert_eq!(normal::transformed(UnitVec3::Z, flat), Some(UnitVec3::Z));
    prop_assert_eq!(normal::transformed(UnitVec3::X, flat), None);
    Ok(())
}

/// A matrix times a power of two transforms a normal alike, to the bit.
pub fn a_matrix_has_no_size<T: Number>(f: &Frame<T>) -> Outcome {
    let twice = f.columns.map(|column| column * T::of(2.0));
    prop_assert_eq!(
        normal::transformed(f.n, twice),
        normal::transformed(f.n, f.columns)
    );
    Ok(())
}

/// The corners of a triangle are its normal times its angles, which add up to π.
pub fn the_angles_of_a_triangle_add_up_to_pi<T: Number>(t: &Triangle<T>) -> Outcome {
    let Some((_, roundings)) = edges(t) else {
        return Ok(());
    };
    let n = xyz(normal::triangle(t.a, t.b, t.c).expect("no sliver"));
    let corners = [(t.a, t.b, t.c), (t.b, t.c, t.a), (t.c, t.a, t.b)];
    let corners = corners.map(|(a, b, c)| xyz(normal::corner(a, b, c)));
    let sum = corners.into_iter().fold([0.0; 3], book::plus);
    let error = book::length(book::minus(sum, book::times(PI, n)));
    prop_assert_near!(error, 0.0, 64.0 * PI * roundings);
    Ok(())
}

/// Each corner is as long as the angle between its edges, by the cosine rule.
pub fn a_corner_is_as_long_as_its_angle<T: Number>(t: &Triangle<T>) -> Outcome {
    let Some(([ab, _, ca], roundings)) = edges(t) else {
        return Ok(());
    };
    let ac = book::times(-1.0, ca);
    let cosine = book::dot(ab, ac) / (book::length(ab) * book::length(ac));
    let angle = book::length(xyz(normal::corner(t.a, t.b, t.c)));
    // compared by the cosine, which is as near as the angle
    prop_assert_near!(angle.cos(), cosine, 64.0 * roundings);
    Ok(())
}

/// A triangle that is cut in two leaves the corner as it was: the angles of the halves add up.
pub fn a_corner_can_be_split<T: Number>(t: &Triangle<T>) -> Outcome {
    let [a, b, c] = t.corners;
    let [x, y, z] = [a, b, c].map(xyz);
    let [ab, ac] = [book::minus(y, x), book::minus(z, x)];
    let area = book::length(book::cross(ab, ac));
    prop_assume!(
        area > 0.25 && has_digits::<T>(area * area) && has_digits::<T>(0.25 * area * area)
    );
    let middle = b + (c - b) * T::of(0.5);
    let whole = xyz(normal::corner(a, b, c));
    let halves = [normal::corner(a, b, middle), normal::corner(a, middle, c)].map(xyz);
    let error = book::length(book::minus(whole, book::plus(halves[0], halves[1])));
    let conditioning = (book::dot(ab, ab) + book::dot(ac, ac)) / area;
    prop_assert_near!(error, 0.0, 64.0 * u::<T>() * (1.0 + conditioning));
    Ok(())
}

/// Along the tangent of a texture map, u rises and v stays: T = αe₂ + βe₃ with αv₂ + βv₃ = 0 and
/// αu₂ + βu₃ > 0.
pub fn a_tangent_follows_the_texture<T: Number>(t: &Triangle<T>) -> Outcome {
    let [a, b, c] = t.corners.map(xyz);
    let (e2, e3) = (book::minus(b, a), book::minus(c, a));
    let [[u1, v1], [u2, v2], [u3, v3]] = t.map.map(|uv| uv.map(T::exact));
    let (u2, u3, v2, v3) = (u2 - u1, u3 - u1, v2 - v1, v3 - v1);
    let d = u2 * v3 - u3 * v2;
    let area = book::length(book::cross(e2, e3));
    let Some((tangent, h)) = normal::tangent(t.corners, t.map) else {
        // the texture coordinates lie on a line, or T vanishes
        let t = book::minus(book::times(v3, e2), book::times(v2, e3));
        prop_assert!(d == 0.0 || t == [0.0; 3], "{d} {t:?}");
        return Ok(());
    };
    prop_assert_eq!(h.exact(), d.signum());
    prop_assume!(area > 0.25);
    let tangent = xyz(tangent);
    let size = book::length(e2).max(book::length(e3)) / area;
    let tolerance = 64.0 * u::<T>() * (1.0 + size * size) * 4.0;
    prop_assert_near!(book::length(tangent), 1.0, tolerance);
    // α and β by the dual basis of e₂ and e₃
    let normal = book::times(1.0 / (area * area), book::cross(e2, e3));
    let (alpha, beta) = (
        book::dot(tangent, book::cross(e3, normal)),
        book::dot(tangent, book::cross(normal, e2)),
    );
    prop_assert_near!(alpha * v2 + beta * v3, 0.0, tolerance * 8.0);
    prop_assert!(alpha * u2 + beta * u3 > -tolerance, "u falls along T");
    Ok(())
}

/// A sample of a normal map keeps its share along N, gets the handedness's side across, and turns T
/// with it: the rest of the sample lies along the part of T that is perpendicular to N.
pub fn a_normal_map_is_relative_to_its_frame<T: Number>(f: &Frame<T>) -> Outcome {
    let (n, tangent) = (xyz(f.n), xyz(f.tangent));
    let across = book::minus(tangent, book::times(book::dot(n, tangent), n));
    let (size, length) = (book::length(across), book::length(xyz(f.sample)));
    prop_assume!(size > 0.1 && length > 0.1);
    let t = book::times(1.0 / size, across);
    let b = book::cross(n, t);
    let [x, y, z] = book::times(1.0 / length, xyz(f.sample));
    let tolerance = 32.0 * u::<T>() * (1.0 + 1.0 / size + 1.0 / length) * 4.0;
    for (handedness, y) in [(T::ONE, y), (T::NEG_ONE, -y)] {
        let mapped = normal::mapped(f.n, f.tangent, handedness, f.sample).expect("a frame");
        for (is, should) in [(n, z), (t, x), (b, y)] {
            prop_assert_near!(book::dot(xyz(mapped), is), should, tolerance);
        }
    }
    Ok(())
}
