//! Normals.

use shading::{Dual, Elementary, Real, UnitVec3, Vec3, normal};
use support::number::{Float, direction, for_f32_and_f64, vector};

use crate::{at_x, not_finite};

for_f32_and_f64!(
    plane_without_a_direction_has_no_normal,
    triangle_with_an_infinite_vertex_has_no_normal,
    sphere_has_no_normal_at_its_center,
    gradient_and_tangents_that_are_not_finite_give_none,
    tangents_of_any_length_give_the_normal,
    poles_and_collapsed_edges_have_no_normal,
    tangents_above_the_noise_give_the_normal,
    facing_edge_on_or_nan_stays,
    plane_flattened_to_a_line_has_no_normal,
    columns_of_any_size_transform_normals,
    a_degenerate_triangle_has_no_share,
    shares_of_tiny_and_huge_triangles_are_angles,
    a_triangle_without_a_map_has_no_tangent,
    tangents_of_triangles_and_maps_of_any_size,
    a_map_without_a_frame_or_a_sample_has_no_normal,
);

fn plane_without_a_direction_has_no_normal<T: Float>() {
    assert_eq!(normal::plane(T::ZERO, T::ZERO, T::ZERO), None);
    for bad in not_finite::<T>() {
        assert_eq!(normal::plane(bad, T::ONE, T::ZERO), None);
    }
}

fn triangle_with_an_infinite_vertex_has_no_normal<T: Float>() {
    let [a, b] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(vector::<T>);
    for bad in not_finite::<T>().map(at_x) {
        assert_eq!(normal::triangle(bad, a, b), None);
        assert_eq!(normal::triangle(a, bad, b), None);
        assert_eq!(normal::triangle(a, b, bad), None);
    }
}

fn sphere_has_no_normal_at_its_center<T: Float>() {
    let center = vector::<T>([1.0, 2.0, 3.0]);
    assert_eq!(normal::sphere(center, center), None);
    for bad in not_finite::<T>().map(at_x) {
        assert_eq!(normal::sphere(center, bad), None);
        assert_eq!(normal::sphere(bad, center), None);
    }
}

fn gradient_and_tangents_that_are_not_finite_give_none<T: Float>() {
    for bad in not_finite::<T>().map(at_x) {
        assert_eq!(normal::from_gradient(bad), None);
        assert_eq!(normal::from_tangents(bad, *UnitVec3::Y), None);
        assert_eq!(normal::from_tangents(*UnitVec3::Y, bad), None);
    }
    assert_eq!(normal::from_gradient(Vec3::<T>::ZERO), None);
    assert_eq!(normal::from_tangents(Vec3::ZERO, *UnitVec3::<T>::Y), None);
}

fn tangents_of_any_length_give_the_normal<T: Float>() {
    let lengths = [T::of(T::TINIEST), T::of(T::MIN_POSITIVE), T::ONE, T::MAX];
    for (a, b) in lengths.into_iter().flat_map(|a| lengths.map(|b| (a, b))) {
        let [s_u, s_v] = [*UnitVec3::X * a, *UnitVec3::Y * b];
        assert_eq!(
            normal::from_tangents(s_u, s_v),
            Some(UnitVec3::Z),
            "{a:e}, {b:e}"
        );
        assert_eq!(
            normal::from_tangents(s_u, *UnitVec3::X * b),
            None,
            "{a:e}, {b:e}"
        );
    }
}

/// A bicubic Bézier patch as a sum over Bernstein polynomials. Along a collapsed edge the control
/// points are equal; their weights add up to 1, so the derivatives of the weights add up to 0,
/// apart from rounding.
fn bezier<T: Real>(control: &[Vec3<f64>], u: T, v: T) -> Vec3<T> {
    let bernstein = |t: T| {
        let (s, three) = (T::ONE - t, T::of(3.0));
        [s * s * s, three * s * s * t, three * s * t * t, t * t * t]
    };
    let (along_u, along_v) = (bernstein(u), bernstein(v));
    control
        .iter()
        .enumerate()
        .fold(Vec3::ZERO, |sum, (i, &point)| {
            sum + point.map(T::of) * (along_u[i % 4] * along_v[i / 4])
        })
}

/// The same patch by de Casteljau's algorithm, which goes from point to point by differences.
fn casteljau<T: Real>(control: &[Vec3<f64>], far: f64, u: T, v: T) -> Vec3<T> {
    let line = |points: [Vec3<T>; 4], t| {
        let mut points = points;
        for count in [3, 2, 1] {
            for i in 0..count {
                points[i] = points[i] + (points[i + 1] - points[i]) * t;
            }
        }
        points[0]
    };
    let point = |i: usize| control[i].map(|c| T::of(c + far));
    let rows = [0, 4, 8, 12].map(|i| line([i, i + 1, i + 2, i + 3].map(point), u));
    line(rows, v)
}

/// The control points of the teapot's patches, row by row.
fn teapot() -> Vec<Vec<Vec3<f64>>> {
    let file = include_str!("../../examples/gallery/data/teapot.bezier");
    let lines = |kind| file.lines().filter_map(move |line| line.strip_prefix(kind));
    let point = |line: &str| {
        let numbers = line.split(' ').map(|x| x.parse().expect("a number"));
        let xyz: Vec<f64> = numbers.collect();
        Vec3::new(xyz[0], xyz[1], xyz[2])
    };
    let points: Vec<Vec3<f64>> = lines("v ").map(point).collect();
    let patch = |line: &str| {
        let numbers = line
            .split(' ')
            .map(|i| i.parse::<usize>().expect("a number"));
        numbers.map(|i| points[i]).collect()
    };
    lines("p ").map(patch).collect()
}

fn poles_and_collapsed_edges_have_no_normal<T: Float>() {
    // for each edge: its control points, where it begins, and in which direction it runs
    let edges = [
        ([0, 1, 2, 3], [0.0, 0.0], [1.0, 0.0]),
        ([12, 13, 14, 15], [0.0, 1.0], [1.0, 0.0]),
        ([0, 4, 8, 12], [0.0, 0.0], [0.0, 1.0]),
        ([3, 7, 11, 15], [1.0, 0.0], [0.0, 1.0]),
    ];
    let mut tried = 0;
    for patch in teapot() {
        for (edge, start, along) in edges {
            if edge.iter().any(|&i| patch[i] != patch[edge[0]]) {
                continue;
            }
            for steps in [12, 997] {
                for k in 0..=steps {
                    let t = f64::from(k) / f64::from(steps);
                    let [u, v] = [0, 1].map(|i| T::of(start[i] + t * along[i]));
                    let n = normal::parametric(|u, v| bezier(&patch, u, v), u, v);
                    assert_eq!(n, None, "({u}, {v}) of {patch:?}");
                    let n = normal::parametric(|u, v| casteljau(&patch, 1e3, u, v), u, v);
                    assert_eq!(n, None, "({u}, {v}) of {patch:?}, far out");
                    tried += 1;
                }
            }
        }
    }
    // the bottom and the lid consist of four patches each
    assert_eq!(tried, 8 * (13 + 998));

    // sin π is not 0 but the rounding error of π, at most 2u
    let sphere = |u: Dual<T>, v: Dual<T>| Vec3::new(u.cos() * v.sin(), u.sin() * v.sin(), v.cos());
    for pole in [0.0, std::f64::consts::PI] {
        assert_eq!(normal::parametric(sphere, T::ONE, T::of(pole)), None);
    }
}

fn tangents_above_the_noise_give_the_normal<T: Float>() {
    // (k u, v, 0) has tangents in the ratio k: at 32u and below it has no normal, and above that
    // the normal is Z
    let plane = |k: f64, size: T| {
        let s = |u: Dual<T>, v: Dual<T>| {
            Vec3::new(u * T::of(k) * size, v * size, Dual::constant(T::ZERO))
        };
        let turned = |v, u| s(u, v);
        let [n, opposite] = [
            normal::parametric(s, T::ONE, T::ONE),
            normal::parametric(turned, T::ONE, T::ONE),
        ];
        assert_eq!(n, opposite.map(|n| -n));
        n
    };
    for size in [T::of(1e-30), T::ONE, T::of(1e30)] {
        for halvings in 0.. {
            let k = 0.5_f64.powi(halvings);
            if k <= 32.0 * T::U {
                assert_eq!(plane(k, size), None, "{k:e}");
                break;
            }
            assert_eq!(plane(k, size), Some(UnitVec3::Z), "{k:e}");
        }
        assert_eq!(
            plane(32.0 * T::U * (1.0 + 2.0 * T::U), size),
            Some(UnitVec3::Z)
        );
    }
}

fn facing_edge_on_or_nan_stays<T: Float>() {
    for n in [UnitVec3::<T>::X, -UnitVec3::X] {
        assert_eq!(normal::facing(n, UnitVec3::Z), n);
        assert_eq!(normal::facing(n, UnitVec3::assume_unit(at_x(T::NAN))), n);
    }
}

fn plane_flattened_to_a_line_has_no_normal<T: Float>() {
    let [x, y, z] = [UnitVec3::<T>::X, UnitVec3::Y, UnitVec3::Z];
    // projected onto the plane z = 0, that plane keeps its normal, and a wall becomes a line
    let flat = [*x, *y, Vec3::ZERO];
    assert_eq!(normal::transformed(z, flat), Some(z));
    assert_eq!(normal::transformed(x, flat), None);
    // projected onto a line, and onto a point
    for columns in [[*x, *x * T::of(2.0), -*x], [Vec3::ZERO; 3]] {
        assert!(
            [x, y, z]
                .iter()
                .all(|&n| normal::transformed(n, columns).is_none())
        );
    }
    for bad in not_finite::<T>() {
        for i in 0..3 {
            let mut columns = [*x, *y, *z];
            columns[i].y = bad;
            let transformed = [x, y, z].map(|n| normal::transformed(n, columns));
            assert_eq!(transformed, [None; 3], "{columns:?}");
            // even beside columns of any other size
            for size in [T::of(T::TINIEST), T::MAX] {
                let columns = [0, 1, 2].map(|j| columns[j] * if i == j { T::ONE } else { size });
                let transformed = [x, y, z].map(|n| normal::transformed(n, columns));
                assert_eq!(transformed, [None; 3], "{columns:?}");
            }
        }
    }
}

fn columns_of_any_size_transform_normals<T: Float>() {
    let sizes = [T::of(T::TINIEST), T::of(T::MIN_POSITIVE), T::ONE, T::MAX];
    for a in sizes {
        for (b, c) in sizes.into_iter().flat_map(|b| sizes.map(|c| (b, c))) {
            let columns = [*UnitVec3::X * a, *UnitVec3::Y * b, *UnitVec3::Z * c];
            for n in [UnitVec3::X, UnitVec3::Y, UnitVec3::Z] {
                assert_eq!(
                    normal::transformed(n, columns),
                    Some(n),
                    "{a:e} {b:e} {c:e}"
                );
            }
        }
        // (1, 1, 0) stretched by a along x and y, and by any size along z; the unit vectors round
        let diagonal = direction::<T>([1.0, 1.0, 0.0]);
        for c in sizes {
            let columns = [*UnitVec3::X * a, *UnitVec3::Y * a, *UnitVec3::Z * c];
            let transformed = normal::transformed(diagonal, columns).expect("a normal");
            let off = (transformed.x - diagonal.x).to_f64().abs();
            assert!(
                off <= 4.0 * T::U && transformed.y == transformed.x,
                "{a:e} {c:e}"
            );
        }
    }
}

fn a_degenerate_triangle_has_no_share<T: Float>() {
    let [a, b, between] = [[1.0, 2.0, 3.0], [4.0, 6.0, 8.0], [2.5, 4.0, 5.5]].map(vector::<T>);
    for [v1, v2, v3] in [
        [a, a, a],
        [a, a, b],
        [a, b, a],
        [a, b, b],
        [a, between, b],
        [between, a, b],
    ] {
        assert_eq!(normal::corner(v1, v2, v3), Vec3::ZERO);
    }
    let c = vector([0.0, 1.0, 0.0]);
    for bad in not_finite::<T>().map(at_x) {
        for [v1, v2, v3] in [[bad, b, c], [a, bad, c], [a, b, bad], [bad, bad, bad]] {
            assert_eq!(normal::corner(v1, v2, v3), Vec3::ZERO);
        }
    }
}

fn shares_of_tiny_and_huge_triangles_are_angles<T: Float>() {
    // the angles are 90° and 45°; the edges of the largest triangle overflow
    let sizes = [
        T::TINIEST,
        T::MIN_POSITIVE,
        1e-20,
        1.0,
        1e20,
        T::MAX.to_f64(),
    ];
    for size in sizes.map(T::of) {
        let [a, b, c] =
            [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [-1.0, 1.0, 0.0]].map(|v| vector::<T>(v) * size);
        for ([v1, v2, v3], angle) in [([a, b, c], 2.0), ([b, c, a], 4.0), ([c, a, b], 4.0)] {
            let share = normal::corner(v1, v2, v3);
            let expected = core::f64::consts::PI / angle;
            assert!(
                (share.z.to_f64() - expected).abs() <= 8.0 * T::U * expected,
                "{size:e}"
            );
            assert_eq!(normal::corner(v1, v3, v2), -share);
        }
    }
}

/// A right angle at the origin, whose map is the plane it lies in.
fn mapped_corner<T: Float>(size: T, map: T) -> ([Vec3<T>; 3], [[T; 2]; 3]) {
    let o = T::ZERO;
    let vertices = [[o, o, o], [size, o, o], [o, size, o]].map(Vec3::from);
    (vertices, [[o, o], [map, o], [o, map]])
}

fn a_triangle_without_a_map_has_no_tangent<T: Float>() {
    let (vertices, map) = mapped_corner(T::ONE, T::ONE);
    assert_eq!(normal::tangent(vertices, map), Some((UnitVec3::X, T::ONE)));
    let [a, b, c] = map;
    for on_a_line in [
        [a, a, a],
        [a, b, b],
        [a, b, a],
        [b, b, c],
        [a, [T::of(2.0), T::ZERO], b],
    ] {
        assert_eq!(normal::tangent(vertices, on_a_line), None);
    }
    let [o, x, _] = vertices;
    assert_eq!(normal::tangent([o, o, o], map), None);
    assert_eq!(normal::tangent([o, o, x], map), None); // y grows along it, and x nowhere
    for bad in not_finite::<T>() {
        assert_eq!(normal::tangent([o, at_x(bad), at_x(T::ONE)], map), None);
        assert_eq!(normal::tangent(vertices, [a, [bad, T::ZERO], c]), None);
        assert_eq!(normal::tangent(vertices, [a, b, [T::ZERO, bad]]), None);
    }
}

fn tangents_of_triangles_and_maps_of_any_size<T: Float>() {
    // half of the smallest number is 0
    let sizes = [T::of(T::TINIEST) * T::of(2.0), T::ONE, T::MAX];
    for (size, map) in sizes
        .into_iter()
        .flat_map(|size| sizes.map(|map| (size, map)))
    {
        let (vertices, map) = mapped_corner(size, map);
        assert_eq!(normal::tangent(vertices, map), Some((UnitVec3::X, T::ONE)));
        let [a, b, c] = map;
        let mirrored = normal::tangent(vertices, [a, c, b]); // x and y change places
        assert_eq!(mirrored, Some((UnitVec3::Y, -T::ONE)));
    }
    // the differences overflow
    let far = |x: T, y: T| Vec3::new(x, y, T::ZERO);
    let max = T::MAX;
    let vertices = [far(-max, -max), far(max, -max), far(-max, max)];
    let map = [[-max, -max], [max, -max], [-max, max]];
    assert_eq!(normal::tangent(vertices, map), Some((UnitVec3::X, T::ONE)));
}

fn a_map_without_a_frame_or_a_sample_has_no_normal<T: Float>() {
    let (n, tangent) = (UnitVec3::<T>::Z, *UnitVec3::X);
    let sample = vector([0.5, 0.0, 1.0]);
    let mapped = |tangent, sample| normal::mapped(n, tangent, T::ONE, sample);
    assert!(mapped(tangent, sample).is_some());
    for parallel in [*n, -*n, *n * T::MAX, *n * T::of(T::TINIEST), Vec3::ZERO] {
        assert_eq!(mapped(parallel, sample), None);
    }
    assert_eq!(mapped(tangent, Vec3::ZERO), None);
    for bad in not_finite::<T>() {
        assert_eq!(mapped(at_x(bad), sample), None);
        assert_eq!(mapped(tangent, at_x(bad)), None);
    }
    // their lengths do not matter
    for size in [T::of(T::TINIEST), T::MAX] {
        let aside = vector::<T>([1.0, 0.0, 0.0]) * size;
        assert_eq!(mapped(aside, aside), Some(UnitVec3::X));
        assert_eq!(mapped(aside, *n * size), Some(n));
    }
}
