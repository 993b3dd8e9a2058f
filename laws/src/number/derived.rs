//! What can be done with normals: face the viewer, transform, average over a mesh, map.

use std::f64::consts::PI;

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;
use shading::{UnitVec3, Vec3, normal};

use super::Number;
use super::check::{
    by_spacing, check, equal, is_short_of_range, near, octaves_below_one, same, same_or_near,
    scaled_size, to_f64, within,
};
use super::exact::{cross, dot, length, square_excess};
use super::generators::{
    adversarial_vector, direction, dyadic_point, exponent, octaves, pair, point, rounded, unit,
};

type Matrix<T> = [Vec3<T>; 3];

/// (57) N·V is not negative, facing twice is the same as facing once, and the result is N or −N.
fn facing_normals_face_the_viewer<T: Number>() {
    check(pair::<T>(), |[n, v]| {
        let facing = normal::facing(n, v);
        prop_assert!(facing.dot(v) >= T::ZERO);
        same(normal::facing(facing, v), facing)?;
        same(facing, if (-n).dot(v) > T::ZERO { -n } else { n })?;
        // both sides give the same, except edge-on
        if n.dot(v) != T::ZERO {
            same(normal::facing(-n, v), facing)?;
        }
        Ok(())
    });
}

/// In an evenly spaced type, coordinates from 32 on would lose bits.
fn matrix<T: Number>() -> impl Strategy<Value = Matrix<T>> {
    let usual = [point(), point(), point()];
    let grid = [dyadic_point(), dyadic_point(), dyadic_point()];
    let size = || exponent::<T>(20, 3);
    // the columns have different sizes
    let stretched =
        (usual, [size(), size(), size()]).prop_map(|(columns, k): (Matrix<T>, [i32; 3])| {
            let scale = k.map(|k| T::of(f64::from(k).exp2()));
            [0, 1, 2].map(|i| columns[i] * scale[i])
        });
    prop_oneof![grid, stretched]
}

/// The product M v.
fn times<T: Number>(columns: Matrix<T>, v: [f64; 3]) -> [f64; 3] {
    let columns = columns.map(to_f64);
    [0, 1, 2].map(|i| dot([0, 1, 2].map(|j| columns[j][i]), v))
}

/// cof(M) N, and the conditioning of its sum. An evenly spaced type is off by u at any size, so there it is
/// the reciprocal of the sum for columns that are scaled until the largest coordinate is as large as the range allows.
fn cofactors<T: Number>(columns: Matrix<T>, n: UnitVec3<T>) -> ([f64; 3], f64) {
    let ([a, b, c], n) = (columns.map(to_f64), to_f64(n));
    let terms = [cross(b, c), cross(c, a), cross(a, b)];
    let sum = [0, 1, 2].map(|i| dot(n, [0, 1, 2].map(|j| terms[j][i])));
    let sizes = [
        length(b) * length(c),
        length(c) * length(a),
        length(a) * length(b),
    ];
    let largest = [a, b, c].into_iter().flatten();
    let largest = largest.fold(0.0, |largest: f64, c| largest.max(c.abs()));
    let size = by_spacing::<T>(
        dot(n.map(f64::abs), sizes),
        (largest / scaled_size::<T>()).powi(2),
    );
    (sum, size / length(sum))
}

/// The error of a transformed normal. The products of a cofactor and their difference are off by 2u
/// of the product of two lengths, the factor by 1u, and the two sums by 2u; the unit vector is off
/// by 4u. The expected normal is computed in `f64`, and is off by as many units of `f64`.
///
/// In an evenly spaced type, a cofactor is off by 2u, which the factor makes 2√3u in the sum of three; the
/// three products add 3u. That is 12u for the vector, and the unit vector is off by √3u.
fn transformed_tolerance<T: Number>(conditioning: f64) -> f64 {
    let k = by_spacing::<T>(5.0 * conditioning + 4.0, 12.0 * conditioning + 1.77);
    k * (T::U + f64::EPSILON)
}

/// (58) The transformed normal is perpendicular to the transformed tangents, on the side of cof(M) N.
fn transformed_normal_is_perpendicular_to_transformed_tangents<T: Number>() {
    check((matrix::<T>(), direction()), |(columns, n)| {
        let n = rounded::<T>(n);
        let (expected, conditioning) = cofactors(columns, n);
        prop_assume!(conditioning < 0.01 / T::U);
        let transformed = to_f64(
            normal::transformed(n, columns)
                .expect("the property expects a normal, and there is none"),
        );
        let tolerance = transformed_tolerance::<T>(conditioning);
        let size = length(expected);
        for (c, expected) in transformed.into_iter().zip(expected) {
            within(c - expected / size, tolerance)?;
        }
        let n = to_f64(n);
        for axis in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
            let tangent = cross(n, axis);
            let moved = times(columns, tangent);
            // the tangent is computed in `f64`
            let moving = columns.map(to_f64).map(length).into_iter().sum::<f64>();
            within(
                dot(transformed, moved),
                2.0 * tolerance * length(moved) + 8.0 * f64::EPSILON * moving,
            )?;
        }
        Ok(())
    });
}

/// (58) It is the normal of the transformed triangle, even if the matrix mirrors. The test uses a
/// grid, on which the transformed vertices are exact. In an evenly spaced type, the grid is so coarse that
/// the cofactors are exact, too.
fn transformed_normal_is_that_of_the_transformed_triangle<T: Number>() {
    let grid = || [dyadic_point::<T>(), dyadic_point(), dyadic_point()];
    check((grid(), grid()), |(vertices, columns)| {
        // to integers up to 16, or up to 4; the transformed vertices go up to 768
        let is_short = is_short_of_range::<T>();
        let scale = T::of(if is_short { 2.0 } else { 8.0 });
        let coarse = |v: Vec3<T>| v.map(|c| T::of((c * scale).to_f64().trunc()));
        let (vertices, columns) = (vertices.map(coarse), columns.map(coarse));
        let moved = vertices.map(|v| Vec3::from(times(columns, to_f64(v)).map(T::of)));
        let [[a, b, c], [p, q, r]] = [vertices, moved];
        let Some(n) = normal::triangle(a, b, c) else {
            return Ok(());
        };
        // the plane of the triangle in integers, without rounding
        let plane = cross(to_f64(b - a), to_f64(c - a));
        let to_one = if is_short { 1.0 / 128.0 } else { 1.0 }; // within the cube of side 2
        let plane = plane.map(|c| T::of(c * to_one));
        let plane = UnitVec3::assume_unit(Vec3::from(plane));
        let (_, conditioning) = cofactors(columns, plane);
        match (
            normal::transformed(plane, columns),
            normal::triangle(p, q, r),
        ) {
            (Some(by_matrix), Some(by_vertices)) => {
                // two normals, each with its own error: that of a triangle is (2√3κ + 1)u for its
                // own conditioning κ ≥ 1, and 3.5u for its length, together at most 8κu
                let edges = [q - p, r - p].map(to_f64);
                let length = |v: [f64; 3]| v.iter().map(|c| c * c).sum::<f64>().sqrt();
                let own = length(edges[0]) * length(edges[1]) / length(cross(edges[0], edges[1]));
                let tolerance = transformed_tolerance::<T>(conditioning) + 8.0 * T::U * own;
                let exact = 2.0 * 1.77 * T::U; // two unit vectors
                let tolerance = by_spacing::<T>(tolerance, exact);
                near(by_matrix, by_vertices, tolerance)?;
                let by_unit = normal::transformed(n, columns)
                    .expect("the property expects a normal, and there is none");
                // n itself is off by 4u, or in an evenly spaced type by u in each component
                let [x, y, z] = columns.map(to_f64).map(self::length);
                let (moved, of_unit) = cofactors(columns, n);
                let off = (x * y + y * z + z * x) / self::length(moved) * T::U;
                let tolerance = by_spacing::<T>(
                    tolerance + 4.0 * T::U * conditioning,
                    off + transformed_tolerance::<T>(of_unit) + 1.77 * T::U,
                );
                near(by_unit, by_vertices, tolerance)
            }
            (by_matrix, by_vertices) => {
                prop_assert!(by_matrix.is_none() && by_vertices.is_none());
                Ok(())
            }
        }
    });
}

/// (58) A rotation transforms a normal like a vector: its columns are off by 1u each, and the
/// normal by 5u of √3.
fn rotation_transforms_a_normal_like_a_vector<T: Number>() {
    check((direction(), direction(), direction()), |(x, aside, n)| {
        let z = cross(x, aside);
        prop_assume!(length(z) > 0.01);
        let z = z.map(|c| c / length(z));
        let columns = [x, cross(z, x), z].map(|column| *rounded::<T>(column));
        let n = rounded::<T>(n);
        let expected = times(columns, to_f64(n));
        let transformed = to_f64(
            normal::transformed(n, columns)
                .expect("the property expects a rotation, and there is none"),
        );
        for (c, expected) in transformed.into_iter().zip(expected) {
            within(c - expected, 24.0 * T::U)?;
        }
        Ok(())
    });
}

/// (58) A matrix 2^k times as large gives the same normal, and so does one of the opposite sign. In an
/// evenly spaced type, where the larger one is off by less, they agree within the errors of both.
fn scaling_the_matrix_by_a_power_of_two_is_exact<T: Number>() {
    let inputs = (matrix::<T>(), unit::<T>(), exponent::<T>(30, 1));
    check(inputs, |(columns, n, k)| {
        let scale = T::of(f64::from(k).exp2());
        let transformed = |factor: T| normal::transformed(n, columns.map(|c| c * factor));
        if is_short_of_range::<T>() {
            let (_, conditioning) = cofactors(columns, n);
            prop_assume!(conditioning < 0.01 / T::U);
            let n = transformed(T::ONE).expect("the property expects a normal, and there is none");
            for factor in [scale, -scale] {
                let scaled =
                    transformed(factor).expect("the property expects a normal, and there is none");
                near(scaled, n, 2.0 * transformed_tolerance::<T>(conditioning))?;
            }
            return Ok(());
        }
        optionally(transformed(scale), transformed(T::ONE))?;
        optionally(transformed(-scale), transformed(T::ONE))
    });
}

/// (58) A plane that the matrix flattens to a line or a point has no normal, and no other plane
/// lacks one. Here two columns are the same, up to a power of two, and the test also takes a plane
/// that stays a plane.
fn only_a_plane_flattened_to_a_line_has_no_transformed_normal<T: Number>() {
    check(
        (point::<T>(), point(), 0..3_usize, exponent::<T>(8, 3)),
        |(a, b, i, k)| {
            let area = length(cross(to_f64(a), to_f64(b)));
            prop_assume!(area > 0.01);
            // |a||b| is at most 3; in an evenly spaced type, coordinates go up to 8, and the cross product
            // that is expected is off by 2√3u itself
            let conditioning = by_spacing::<T>(300.0, 0.6 / area);
            let [j, l] = [(i + 1) % 3, (i + 2) % 3];
            let mut columns = [a; 3];
            columns[j] = b;
            columns[l] = b * T::of(f64::from(k).exp2());
            // the matrix crushes the direction j − l/2^k, so a plane that contains it becomes a
            // line
            let axes = [UnitVec3::<T>::X, UnitVec3::Y, UnitVec3::Z];
            prop_assert!(normal::transformed(axes[i], columns).is_none());
            let expected = a
                .cross(b)
                .unit()
                .expect("the property expects vectors that are not parallel, and there is none");
            near(
                normal::transformed(axes[l], columns)
                    .expect("the property expects a plane, and there is none"),
                expected,
                transformed_tolerance::<T>(conditioning),
            )?;
            prop_assert!(normal::transformed(axes[j], [a, a * T::of(2.0), a]).is_none());
            prop_assert!(normal::transformed(axes[j], [Vec3::ZERO; 3]).is_none());
            Ok(())
        },
    );
}

fn optionally<T: Number>(
    a: Option<UnitVec3<T>>,
    b: Option<UnitVec3<T>>,
) -> Result<(), TestCaseError> {
    match (a, b) {
        (Some(a), Some(b)) => same(a, b),
        (a, b) => {
            prop_assert!(a.is_none() && b.is_none(), "{a:?} is not {b:?}");
            Ok(())
        }
    }
}

/// The sum of the shares at a vertex whose neighbors are given in order.
fn vertex_normal<T: Number>(vertex: Vec3<T>, around: &[Vec3<T>]) -> Vec3<T> {
    let next = around.iter().cycle().skip(1);
    around
        .iter()
        .zip(next)
        .map(|(&a, &b)| normal::corner(vertex, a, b))
        .sum()
}

/// (59) A share has the direction of the triangle's normal and the length of the angle, which is
/// below π; the three angles of a triangle add up to π. The unit vector is off by 4u, the sine and
/// the cosine by 8u, and the angle by 16u; the conditioning of the triangle magnifies 4u of the
/// cross product.
fn shares_are_angles<T: Number>() {
    check([point::<T>(), point(), point()], |[a, b, c]| {
        let [ab, ac] = [b - a, c - a].map(to_f64);
        let sine = length(cross(ab, ac)) / (length(ab) * length(ac));
        prop_assume!(sine > 1e-2);
        let n =
            normal::triangle(a, b, c).expect("the property expects a triangle, and there is none");
        let shares = [[a, b, c], [b, c, a], [c, a, b]].map(|[a, b, c]| normal::corner(a, b, c));
        let angles = shares.map(|share| length(to_f64(share)));
        near(shares[0], *n * T::of(angles[0]), 40.0 * T::U / sine)?;
        within(
            angles[0] - sine.atan2(dot(ab, ac) / (length(ab) * length(ac))),
            40.0 * T::U,
        )?;
        within(angles.into_iter().sum::<f64>() - PI, 120.0 * T::U)
    });
}

/// (59) The order of the triangles does not matter, apart from the rounding of a sum, which is exact in an
/// evenly spaced type.
fn order_of_the_triangles_does_not_matter<T: Number>() {
    check(
        (point::<T>(), vec(point::<T>(), 3..9)),
        |(vertex, around)| {
            let sum = vertex_normal(vertex, &around);
            let mut turned = around.clone();
            turned.rotate_left(around.len() / 2);
            let n = around.len() as f64;
            let tolerance = by_spacing::<T>(2.0 * n * n * PI * T::U, 0.0);
            near(sum, vertex_normal(vertex, &turned), tolerance)
        },
    );
}

/// (59) Splitting a flat polygon differently changes nothing: the angle of two adjacent triangles
/// is the sum of their angles. The polygon lies on a grid, so that it is flat.
fn splitting_a_flat_polygon_differently_changes_nothing<T: Number>() {
    let grid = dyadic_point::<T>;
    let inputs = ([grid(), grid(), grid()], [-4..=4_i8, -4..=4]);
    check(inputs, |([a, b, c], [k, l])| {
        // a fourth corner in the plane, between b and c as seen from a
        let d = b + c - a + (b - a) * T::of(k.abs().into()) + (c - a) * T::of(l.abs().into());
        let [ab, ac, ad] = [b - a, c - a, d - a].map(to_f64);
        prop_assume!(length(cross(ab, ac)) > 0.01);
        let whole = normal::corner(a, b, c);
        let split = normal::corner(a, b, d) + normal::corner(a, d, c);
        // the normals of slivers on the grid are right, apart from the rounding of the unit vector
        let thinnest = [[ab, ad], [ad, ac], [ab, ac]]
            .map(|[e, f]| length(cross(e, f)) / (length(e) * length(f)))
            .into_iter()
            .fold(1.0, f64::min);
        near(whole, split, 80.0 * T::U / thinnest)
    });
}

/// (59) The corners of a cube get its diagonals, however its faces are split.
fn corner_of_a_cube_gets_its_diagonal<T: Number>() {
    // the smallest normal number, or the smallest
    let normal = by_spacing::<T>((-octaves_below_one::<T>()).exp2(), T::TINY.to_f64());
    let tiny = f64::max(normal, 1e-20);
    let huge = if T::EVENLY_SPACED { 1e4 } else { 1e20 };
    let huge = (T::MAX.to_f64() / 4.0).min(huge);
    let side = select(vec![1.0, 3.0, tiny, huge]);
    check(
        (side, [any::<bool>(); 3], dyadic_point::<T>()),
        |(side, split, offset)| {
            let side = T::of(side);
            let corner = if side == T::ONE { offset } else { Vec3::ZERO };
            let at = |x: i8, y: i8, z: i8| {
                corner + Vec3::from([x, y, z].map(|c| T::of(c.into()))) * side
            };
            let (edges, faces) = (
                [at(1, 0, 0), at(0, 1, 0), at(0, 0, 1)],
                [at(1, 1, 0), at(0, 1, 1), at(1, 0, 1)],
            );
            let mut around = Vec::new();
            for i in 0..3 {
                around.push(edges[i]);
                if split[i] {
                    around.push(faces[i]);
                }
            }
            let n = vertex_normal(corner, &around)
                .unit()
                .expect("the property expects a normal, and there is none");
            let expected = UnitVec3::assume_unit(Vec3::from([T::of(1.0 / 3.0_f64.sqrt()); 3]));
            near(n, expected, 40.0 * T::U)
        },
    );
}

/// The size of a triangle does not matter for its share; for a power of two, the share is exactly
/// the same. In an evenly spaced type, it may be computed at another size, and the errors are its own.
fn size_of_a_triangle_does_not_matter_for_its_share<T: Number>() {
    check(
        ([point::<T>(), point(), point()], octaves::<T>()),
        |(triangle, k)| {
            let share = |scale: T| {
                let [a, b, c] = triangle.map(|p| p * scale);
                normal::corner(a, b, c)
            };
            let scale = T::of(k.exp2());
            let [ab, ac] = [triangle[1] - triangle[0], triangle[2] - triangle[0]].map(to_f64);
            let sine = length(cross(ab, ac)) / (length(ab) * length(ac));
            prop_assume!(sine > 1e-2);
            if !is_short_of_range::<T>() {
                same(share(T::of(0.125)), share(T::ONE))?;
            }
            // the smallest size is that at which the coordinates lose bits
            near(share(scale), share(T::ONE), 80.0 * T::U / sine)
        },
    );
}

/// For any vertices, a share is finite and no longer than π.
fn shares_are_finite<T: Number>() {
    let any = adversarial_vector::<T>;
    check([any(), any(), any()], |[a, b, c]| {
        within(
            length(to_f64(normal::corner(a, b, c))),
            PI * (1.0 + 8.0 * T::U),
        )
    });
}

/// N, and a tangent at least a hundredth of a radian away from it.
fn frame<T: Number>() -> impl Strategy<Value = (UnitVec3<T>, Vec3<T>)> {
    (unit::<T>(), point::<T>()).prop_filter("parallel", |(n, t)| {
        let (n, t) = (to_f64(*n), to_f64(*t));
        length(cross(n, t)) > 0.01 * length(t)
    })
}

/// How far off a mapped normal may be, in u. N × T is off by 4u of |T|, which is more relative to its own length the
/// nearer T is to N. In an evenly spaced type, it is off by 4u of 1, and the components of T by u more where T is
/// scaled down, so a short T adds to it. The axes made from it, their sum, and the lengths of N and of the
/// sample add less than 16u.
fn off_in_frame<T: Number>(n: UnitVec3<T>, tangent: Vec3<T>) -> f64 {
    let (n, tangent, extreme) = (to_f64(n), to_f64(tangent), T::EXTREME.to_f64());
    let size = length(tangent);
    let sine = length(cross(n, tangent)) / size;
    let rescaled = match size * size {
        square if square < 1.0 / extreme => size * extreme,
        square if square > extreme => size / extreme,
        _ => size,
    };
    16.0 + by_spacing::<T>(4.0, 6.0 / rescaled.min(1.0)) / sine
}

/// In the frame, the mapped normal has the coordinates of the sample.
fn mapped_normal_has_the_coordinates_of_the_sample<T: Number>() {
    check(
        (frame::<T>(), unit::<T>(), any::<bool>()),
        |((n, tangent), sample, right)| {
            let h = if right { T::ONE } else { -T::ONE };
            let mapped = to_f64(
                normal::mapped(n, tangent, h, *sample)
                    .expect("the property expects a frame, and there is none"),
            );
            let tolerance = off_in_frame(n, tangent) * T::U;
            let (n, tangent, sample) = (to_f64(n), to_f64(tangent), to_f64(sample));
            let side = cross(n, tangent);
            let along = [dot(mapped, cross(side, n)), h.to_f64() * dot(mapped, side)]
                .map(|c| c / length(side));
            within(along[0] - sample[0], tolerance)?;
            within(along[1] - sample[1], tolerance)?;
            within(dot(mapped, n) - sample[2], tolerance)
        },
    );
}

/// A flat sample gives N. The lengths of the sample and of the tangent do not matter, exactly so
/// for powers of two, and neither does the size of the handedness; the opposite handedness negates
/// y. In an evenly spaced type, larger or mirrored vectors may be computed at another size, and the
/// normals agree within what each is off.
fn length_of_sample_and_tangent_do_not_matter<T: Number>() {
    let inputs = (frame::<T>(), point::<T>(), exponent::<T>(20, 14), 0.1..10.0);
    check(inputs, |((n, tangent), sample, k, h)| {
        let scale = T::of(f64::from(k).exp2());
        let (h, up) = (T::of(h), Vec3::new(T::ZERO, T::ZERO, scale));
        near(
            normal::mapped(n, tangent, h, up)
                .expect("the property expects a frame, and there is none"),
            n,
            4.0 * T::U,
        )?;
        let mapped = normal::mapped(n, tangent, T::ONE, sample);
        let [off, off_scaled] = [tangent, tangent * scale].map(|t| off_in_frame(n, t));
        match (
            normal::mapped(n, tangent * scale, h, sample * scale),
            mapped,
        ) {
            (Some(a), Some(b)) => same_or_near(a, b, off + off_scaled)?,
            (a, b) => optionally(a, b)?,
        }
        let mirrored = Vec3::new(sample.x, -sample.y, sample.z);
        match (normal::mapped(n, tangent, -h, mirrored), mapped) {
            (Some(a), Some(b)) if T::EVENLY_SPACED => near(a, b, 2.0 * off * T::U),
            (Some(a), Some(b)) => equal(a, b),
            (a, b) => {
                prop_assert!(a.is_none() && b.is_none());
                Ok(())
            }
        }
    });
}

/// For any numbers, the result is a unit vector or `None`.
fn derived_normals_have_length_one_or_are_none<T: Number>() {
    let any = adversarial_vector::<T>;
    check((unit::<T>(), [any(), any(), any()]), |(n, [a, b, c])| {
        let normals = [
            normal::transformed(n, [a, b, c]),
            normal::mapped(n, a, b.x, c),
        ];
        for n in normals.into_iter().flatten() {
            within(square_excess(to_f64(n)), 8.0 * T::U)?;
        }
        Ok(())
    });
}

properties! { derived:
    facing_normals_face_the_viewer,
    transformed_normal_is_perpendicular_to_transformed_tangents,
    transformed_normal_is_that_of_the_transformed_triangle,
    rotation_transforms_a_normal_like_a_vector,
    scaling_the_matrix_by_a_power_of_two_is_exact,
    only_a_plane_flattened_to_a_line_has_no_transformed_normal,
    shares_are_angles,
    order_of_the_triangles_does_not_matter,
    splitting_a_flat_polygon_differently_changes_nothing,
    corner_of_a_cube_gets_its_diagonal,
    size_of_a_triangle_does_not_matter_for_its_share,
    shares_are_finite,
    mapped_normal_has_the_coordinates_of_the_sample,
    length_of_sample_and_tangent_do_not_matter,
    derived_normals_have_length_one_or_are_none,
}
