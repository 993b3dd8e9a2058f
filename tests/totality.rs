//! What every function returns where its formula has no answer. A test here or in `conventions.rs`
//! covers each cell of the table in `docs/totality.md`.

use std::f64::consts::FRAC_1_PI;

use shading::{
    Attenuation, Cone, DirectionalLight, Dual, Elementary, IncidentLight, Material, PointLight,
    Ranged, Real, Rgb, SoftCone, SpotLight, UnitVec3, Vec3, attenuation, half_vector, normal,
    reflection, shade, term,
};
use support::flushing::Flushing;
use support::number::{Float, direction, for_f32_and_f64, vector};

for_f32_and_f64!(
    dot_and_cross_overflow_like_their_formulas,
    root_and_logarithm_below_zero_are_nan,
    flushed_subnormals_count_as_zero,
    unit_of_no_direction_is_none,
    unit_or_gives_the_fallback,
    half_vector_of_nan_is_none,
    half_vector_is_right_next_to_opposite_directions,
    the_highlight_is_right_next_to_opposite_directions,
    reflection_of_any_vector_follows_the_formula,
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
    lambert_of_nan_is_zero,
    highlight_of_a_nan_cosine_is_zero,
    highlight_with_m_zero_is_one_or_zero,
    huge_m_lights_only_the_mirror_direction,
    highlight_with_an_invalid_m_takes_zero,
    normalization_with_m_zero_is_one_over_pi,
    normalization_with_a_huge_m_is_finite,
    normalization_with_an_invalid_m_takes_zero,
    attenuation_without_a_denominator_is_infinite,
    attenuation_over_negative_zero_is_negative,
    attenuation_over_an_overflow_is_zero,
    checked_attenuation_is_never_infinite,
    cone_of_an_invalid_angle_is_none,
    cone_of_zero_lights_its_axis,
    soft_cone_of_invalid_angles_is_none,
    soft_cone_of_one_angle_is_the_hard_cone,
    soft_cone_of_nearly_equal_angles_is_hard,
    invalid_range_is_refused_infinity_is_none,
    ranged_attenuation_is_zero_out_of_its_range,
    lights_out_of_range_are_left_out,
    cone_of_a_nan_direction_gives_one,
    light_with_an_infinite_coordinate_is_black,
    light_with_a_nan_coordinate_adds_nothing,
    light_at_extreme_distances_has_its_direction,
    light_that_overflows_is_the_largest_number,
    black_light_with_infinite_attenuation_is_black,
    incident_light_of_a_nan_direction_adds_nothing,
    no_lights_give_the_ambient,
    overflowing_sum_on_black_is_black,
    overflowing_sum_is_the_largest_number,
    clamped_nan_is_zero,
    dual_root_at_zero_has_no_finite_gradient,
    dual_logarithm_at_zero_has_no_finite_gradient,
    dual_quotient_by_zero_has_no_finite_gradient,
    dual_absolute_value_at_zero_is_flat,
    dual_absolute_value_of_nan_is_nan,
    dual_root_and_logarithm_below_zero_have_no_gradient,
    dual_power_of_zero_is_one_and_flat,
);

fn at_x<T: Real>(x: T) -> Vec3<T> {
    Vec3::new(x, T::ZERO, T::ZERO)
}

/// The values that are not finite numbers.
fn not_finite<T: Float>() -> [T; 3] {
    [T::INFINITY, -T::INFINITY, T::NAN]
}

fn mirror<T: Real, M>(m: M) -> Material<T, M> {
    Material {
        k_a: Rgb::WHITE,
        k_d: Rgb::WHITE,
        k_s: Rgb::WHITE,
        m,
    }
}

fn lamp<T: Float>(position: Vec3<T>, coefficients: [f64; 3]) -> PointLight<T> {
    let attenuation = T::attenuation(coefficients).expect("coefficients");
    PointLight {
        position,
        intensity: Rgb::WHITE,
        attenuation,
    }
}

// numbers

fn root_and_logarithm_below_zero_are_nan<T: Float>() {
    for below in [-T::of(T::TINIEST), -T::ONE, -T::INFINITY] {
        assert!(below.sqrt().to_f64().is_nan(), "√{below:e}");
        assert!(below.ln().to_f64().is_nan(), "ln {below:e}");
    }
}

fn flushed_subnormals_count_as_zero<T: Float>() {
    // a vector of subnormal numbers is zero, and the smallest normal ones have their direction
    let [subnormal, normal] = [0.5, 1.0].map(|k| Flushing(T::of(k * T::MIN_POSITIVE)));
    assert_eq!(
        (at_x(subnormal) - at_x(normal)).unit(),
        (-at_x(normal)).unit()
    );
    assert_eq!(at_x(subnormal).unit(), None);
    assert_eq!(at_x(normal).unit(), Some(UnitVec3::X));
    let light_from = |q| {
        let lamp = PointLight {
            position: at_x(q),
            intensity: Rgb::WHITE,
            attenuation: Attenuation::NONE,
        };
        lamp.at(Vec3::ZERO).intensity
    };
    assert_eq!(light_from(subnormal), Rgb::BLACK);
    assert_eq!(light_from(normal), Rgb::WHITE);
}

// vectors

fn dot_and_cross_overflow_like_their_formulas<T: Float>() {
    let root = T::MAX.sqrt() * T::of(2.0);
    let [a, b] = [[1.0, 1.0, 0.0], [1.0, -1.0, 0.0]].map(|v| vector::<T>(v) * root);
    // ∞ + ∞ and ∞ − ∞
    assert_eq!(a.dot(a), T::INFINITY);
    assert!(a.dot(b).to_f64().is_nan());
    assert!(a.cross(a).z.to_f64().is_nan());
    assert_eq!(a.cross(b).z, -T::INFINITY);
    // as long as no product overflows, a × a is exactly 0, and the functions that need it have
    // their answer
    let c = vector::<T>([1.0, 2.0, 3.0]) * T::of(0.1) * T::MAX.sqrt();
    assert_eq!(c.cross(c), Vec3::ZERO);
    assert_eq!(normal::from_tangents(a, b), Some(-UnitVec3::Z));
    assert_eq!(normal::from_tangents(a, a), None);
}

fn unit_of_no_direction_is_none<T: Float>() {
    assert_eq!(Vec3::<T>::ZERO.unit(), None);
    assert_eq!((-Vec3::<T>::ZERO).unit(), None);
    for bad in not_finite::<T>() {
        assert_eq!(at_x(bad).unit(), None);
        assert_eq!(Vec3::new(T::ONE, T::ONE, bad).unit(), None);
    }
}

fn unit_or_gives_the_fallback<T: Float>() {
    assert_eq!(Vec3::<T>::ZERO.unit_or(UnitVec3::Y), UnitVec3::Y);
    for bad in not_finite::<T>() {
        assert_eq!(
            Vec3::new(T::ONE, T::ONE, bad).unit_or(UnitVec3::Y),
            UnitVec3::Y
        );
    }
}

fn half_vector_of_nan_is_none<T: Float>() {
    let nan = UnitVec3::assume_unit(at_x(T::NAN));
    assert_eq!(half_vector(nan, UnitVec3::X), None);
}

fn half_vector_is_right_next_to_opposite_directions<T: Float>() {
    // both are unit vectors up to rounding; their sum is (0, 0, tiny), and H is Z
    for tiny in [T::of(T::TINIEST), T::of(T::MIN_POSITIVE), T::of(T::U)] {
        let l = UnitVec3::assume_unit(Vec3::new(T::ONE, T::ZERO, tiny));
        assert_eq!(half_vector(l, -UnitVec3::X), Some(UnitVec3::Z));
    }
}

fn the_highlight_is_right_next_to_opposite_directions<T: Float>() {
    // as above, H is Z, so N·H is the z component of N: 1 and 4/5, with two roundings for each
    // factor
    for tiny in [1.0, 3.0, 1e9].map(|c| T::of(c * T::TINIEST)) {
        let light = |sign: T| DirectionalLight {
            l: UnitVec3::assume_unit(Vec3::new(T::ONE, T::ZERO, sign * tiny)),
            intensity: Rgb::WHITE,
        };
        let specular = |n, m, sign| {
            let light = [light(sign).at(Vec3::ZERO)];
            shade::blinn_phong(n, -UnitVec3::X, &mirror(m), Rgb::BLACK, light).specular
        };
        for m in [8, 9] {
            assert_eq!(specular(UnitVec3::Z, m, T::ONE), Rgb::WHITE, "{tiny:e}");
        }
        let slanted = direction::<T>([3.0, 0.0, 4.0]);
        let error = specular(slanted, 8, T::ONE).r.to_f64() - 0.8_f64.powi(8);
        assert!(error.abs() <= 32.0 * T::U, "{tiny:e}: off by {error:e}");
        // N·H = −4/5 gives no highlight
        assert_eq!(specular(slanted, 8, -T::ONE), Rgb::BLACK, "{tiny:e}");
    }
}

fn reflection_of_any_vector_follows_the_formula<T: Float>() {
    // 2(N·L)N − L for |N| = 2: 2·4·2 − 1
    let long = UnitVec3::assume_unit(at_x(T::of(2.0)));
    assert_eq!(*reflection(long, UnitVec3::X), at_x(T::of(7.0)));
    let nan = UnitVec3::assume_unit(at_x(T::NAN));
    assert!(reflection(nan, UnitVec3::X).x.to_f64().is_nan());
}

// normals

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
    let file = include_str!("../examples/gallery/data/teapot.bezier");
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

// terms

fn lambert_of_nan_is_zero<T: Float>() {
    let nan = UnitVec3::assume_unit(at_x(T::NAN));
    assert_eq!(term::lambert(nan, UnitVec3::X), T::ZERO);
}

fn highlight_of_a_nan_cosine_is_zero<T: Float>() {
    let nan = UnitVec3::assume_unit(at_x(T::NAN));
    for m in [0, 1, 2, u32::MAX] {
        assert_eq!(term::phong(nan, UnitVec3::X, m), T::ZERO);
        assert_eq!(term::blinn(nan, UnitVec3::X, m), T::ZERO);
    }
    assert_eq!(term::phong(nan, UnitVec3::X, T::ZERO), T::ZERO);
}

fn highlight_with_m_zero_is_one_or_zero<T: Float>() {
    for cosine in [T::of(T::TINIEST), T::of(0.5), T::ONE] {
        let v = UnitVec3::assume_unit(at_x(cosine));
        assert_eq!(term::phong(UnitVec3::X, v, 0), T::ONE, "{cosine:e}");
        assert_eq!(term::phong(UnitVec3::X, v, T::ZERO), T::ONE, "{cosine:e}");
    }
    let horizon = UnitVec3::assume_unit(at_x(T::ZERO));
    assert_eq!(term::phong(UnitVec3::X, horizon, 0), T::ZERO);
    assert_eq!(term::phong(UnitVec3::X, horizon, T::ZERO), T::ZERO);
}

fn huge_m_lights_only_the_mirror_direction<T: Float>() {
    // (1 − 2⁻¹²)^(2³² − 1) < e^(−2²⁰), which is 0 in every float
    let beside = UnitVec3::assume_unit(at_x(T::of(1.0 - 2.0_f64.powi(-12))));
    assert_eq!(term::phong(UnitVec3::X, beside, u32::MAX), T::ZERO);
    assert_eq!(term::phong(UnitVec3::<T>::X, UnitVec3::X, u32::MAX), T::ONE);
    for m in [T::of(1e30), T::MAX, T::INFINITY] {
        assert_eq!(term::blinn(UnitVec3::X, beside, m), T::ZERO, "{m:e}");
    }
    // 1 to any power is 1, and a cosine that rounds to more than 1 counts as 1
    let above = UnitVec3::assume_unit(at_x(T::of(1.0 + 2.0 * T::U)));
    for m in [T::of(1e30), T::MAX, T::INFINITY] {
        assert_eq!(term::blinn(UnitVec3::X, UnitVec3::X, m), T::ONE, "{m:e}");
        assert_eq!(term::blinn(UnitVec3::X, above, m), T::ONE, "{m:e}");
    }
    assert_eq!(term::blinn(UnitVec3::X, above, u32::MAX), T::ONE);
}

fn highlight_with_an_invalid_m_takes_zero<T: Float>() {
    let n = UnitVec3::<T>::Z;
    let v = direction::<T>([3.0, 0.0, 4.0]);
    let light = [DirectionalLight {
        l: n,
        intensity: Rgb::WHITE,
    }
    .at(Vec3::ZERO)];
    for m in [-T::ONE, -T::of(1e30), -T::INFINITY, T::NAN] {
        assert_eq!(
            (term::phong(n, v, m), term::blinn(n, v, m)),
            (T::ONE, T::ONE),
            "{m:e}"
        );
        let shaded = shade::blinn_phong(n, v, &mirror(m), Rgb::BLACK, light);
        assert_eq!(shaded.specular, Rgb::WHITE, "{m:e}");
    }
}

// attenuation and cone

fn normalization_with_m_zero_is_one_over_pi<T: Float>() {
    // a highlight that is 1 everywhere is Lambert's: 2/(2π) = 1/π and 2·4/(8π) = 1/π, with three
    // roundings
    for factor in [
        term::phong_normalization(T::ZERO),
        term::blinn_normalization(T::ZERO),
    ] {
        assert!((factor.to_f64() - FRAC_1_PI).abs() <= 3.0 * T::U * FRAC_1_PI);
    }
}

fn normalization_with_a_huge_m_is_finite<T: Float>() {
    // (m + 2)/(2π), and (m + 2)(m + 4)/(8πm) = (m + 6 + 8/m)/(8π), with seven roundings
    let near = |factor: T, expected: f64| (factor.to_f64() / expected - 1.0).abs() <= 7.0 * T::U;
    for m in [T::of(1e30), T::MAX] {
        let expected = m.to_f64() * FRAC_1_PI;
        assert!(near(term::phong_normalization(m), 0.5 * expected));
        assert!(near(term::blinn_normalization(m), 0.125 * expected));
    }
    // an infinite m counts as the largest number
    assert_eq!(
        term::phong_normalization(T::INFINITY),
        term::phong_normalization(T::MAX)
    );
    assert_eq!(
        term::blinn_normalization(T::INFINITY),
        term::blinn_normalization(T::MAX)
    );
}

fn normalization_with_an_invalid_m_takes_zero<T: Float>() {
    for m in [-T::ONE, -T::of(1e30), -T::INFINITY, T::NAN] {
        assert_eq!(
            term::phong_normalization(m),
            term::phong_normalization(T::ZERO),
            "{m:e}"
        );
        assert_eq!(
            term::blinn_normalization(m),
            term::blinn_normalization(T::ZERO),
            "{m:e}"
        );
    }
}

fn attenuation_without_a_denominator_is_infinite<T: Float>() {
    let [zero, one] = [T::ZERO, T::ONE];
    assert_eq!(attenuation(zero, zero, zero, one), T::INFINITY);
    assert_eq!(attenuation(zero, one, one, zero), T::INFINITY);
}

fn attenuation_over_negative_zero_is_negative<T: Float>() {
    let [zero, one] = [T::ZERO, T::ONE];
    // −0 + −0(0 + 1·−0) = −0
    assert_eq!(attenuation(-zero, zero, one, -zero), -T::INFINITY);
    // if a or q is +0, so is the denominator
    assert_eq!(attenuation(zero, zero, one, -zero), T::INFINITY);
    assert_eq!(attenuation(-zero, zero, one, zero), T::INFINITY);
    let checked = Attenuation::of(-zero, zero, one).expect("coefficients");
    assert_eq!(checked.at(-zero), T::MAX);
}

fn attenuation_over_an_overflow_is_zero<T: Float>() {
    let [zero, one] = [T::ZERO, T::ONE];
    assert_eq!(attenuation(zero, zero, one, T::MAX), zero);
    assert_eq!(attenuation(T::MAX, T::MAX, T::MAX, T::MAX), zero);
}

fn checked_attenuation_is_never_infinite<T: Float>() {
    let steep = [
        [0.0, 1.0, 0.0],
        [-0.0, 1.0, 0.0],
        [-0.0, 0.0, 1.0],
        [T::TINIEST, 0.0, 0.0],
    ];
    for coefficients in steep {
        let [a, b, c] = coefficients.map(T::of);
        let checked = Attenuation::of(a, b, c).expect("coefficients");
        for zero in [T::ZERO, -T::ZERO] {
            assert_eq!(checked.at(zero), T::MAX);
            assert_eq!(checked.clamped().at(zero), T::ONE);
        }
    }
}

fn cone_of_an_invalid_angle_is_none<T: Float>() {
    for angle in [-T::of(T::TINIEST), T::of(3.2), T::INFINITY, T::NAN] {
        assert_eq!(Cone::of_half_angle(angle), None, "{angle:e}");
    }
    let beyond = T::of(1.0 + 2.0 * T::U);
    for cosine in [beyond, -beyond, T::INFINITY, -T::INFINITY, T::NAN] {
        assert_eq!(Cone::of_cosine(cosine), None, "{cosine:e}");
    }
}

fn cone_of_zero_lights_its_axis<T: Float>() {
    for cone in [Cone::of_half_angle(T::ZERO), Cone::of_cosine(T::ONE)] {
        let cone = cone.expect("a cone");
        for (x, y) in (1..100).flat_map(|x| (1..100).map(move |y| (x, y))) {
            let axis = direction::<T>([f64::from(x), f64::from(y), 7.0]);
            assert_eq!(cone.factor(axis, -axis), T::ONE, "{axis:?}");
        }
        assert_eq!(
            cone.factor(UnitVec3::X, direction([-1.0, 0.01, 0.0])),
            T::ZERO
        );
    }
}

fn soft_cone_of_invalid_angles_is_none<T: Float>() {
    let cone = |inner: f64, outer: f64| SoftCone::of_half_angles(T::of(inner), T::of(outer));
    let of_cosines = |inner: f64, outer: f64| SoftCone::of_cosines(T::of(inner), T::of(outer));
    assert!(cone(0.0, 0.5).is_some() && of_cosines(1.0, 0.5).is_some());
    for [inner, outer] in [[0.5, 0.4], [-0.1, 0.5], [0.5, 3.2], [-0.1, 3.2]] {
        assert_eq!(cone(inner, outer), None);
    }
    for [inner, outer] in [[0.4, 0.5], [1.1, 0.5], [0.5, -1.1]] {
        assert_eq!(of_cosines(inner, outer), None);
    }
    for bad in not_finite::<T>() {
        let good = T::of(0.5);
        assert_eq!(SoftCone::of_half_angles(bad, good), None);
        assert_eq!(SoftCone::of_half_angles(good, bad), None);
        assert_eq!(SoftCone::of_cosines(bad, good), None);
        assert_eq!(SoftCone::of_cosines(good, bad), None);
    }
}

fn soft_cone_of_one_angle_is_the_hard_cone<T: Float>() {
    // every 2⁻⁸ radians of the half-circle, on the edge and next to it
    for angle in (0..=804).map(|k| T::of(f64::from(k) / 256.0)) {
        let hard = Cone::of_half_angle(angle).expect("below π");
        let soft = SoftCone::of_half_angles(angle, angle).expect("below π");
        assert_eq!(soft.cosines(), [hard.cosine(); 2]);
        let beside = [-1.0, -0.5, 0.0, 0.5, 1.0].map(|k| hard.cosine() + T::of(k * T::U));
        for cosine in beside.into_iter().chain([-T::ONE, T::ZERO, T::ONE, T::NAN]) {
            let l = UnitVec3::assume_unit(Vec3::new(T::ZERO, T::ZERO, cosine));
            let factor = hard.factor(-UnitVec3::Z, l);
            for soft in [soft, soft.smoothstep()] {
                assert_eq!(soft.factor(-UnitVec3::Z, l), factor, "{angle} {cosine:e}");
            }
        }
    }
}

fn soft_cone_of_nearly_equal_angles_is_hard<T: Float>() {
    // beyond π/4, rounding may swap the cosines of neighboring angles; in f32 it swaps 8 pairs here
    let start = match T::NAME {
        "f32" => T::of(0.787),
        _ => T::of(std::f64::consts::FRAC_PI_4),
    };
    for k in 0..1 << 16 {
        let [inner, outer] = [k, k + 1].map(|k| T::of(start.to_f64() + f64::from(k) * T::U));
        let cone = SoftCone::of_half_angles(inner, outer).expect("below π");
        let [inner, outer] = cone.cosines();
        assert!(inner >= outer);
        let factor = cone.factor(-UnitVec3::Z, UnitVec3::Z);
        assert_eq!(factor, T::ONE);
    }
}

fn invalid_range_is_refused_infinity_is_none<T: Float>() {
    for bad in [T::ZERO, -T::ZERO, -T::ONE, -T::INFINITY, T::NAN] {
        assert_eq!(Ranged::of(Attenuation::NONE, bad), None);
    }
    // a range of ∞ is no range, not even at an infinite distance, where the attenuation is 0
    let free = Attenuation::of(T::ONE, T::ZERO, T::of(0.25)).expect("coefficients");
    let ranged = Ranged::of(free, T::INFINITY).expect("no range");
    for q in [T::ZERO, T::of(T::TINIEST), T::of(2.0), T::MAX, T::INFINITY] {
        assert_eq!(ranged.at(q), free.at(q));
        assert_eq!(ranged.unsquared().at(q), free.at(q));
    }
}

fn ranged_attenuation_is_zero_out_of_its_range<T: Float>() {
    // also where the attenuation is infinite, at the smallest range, and for NaN
    let inverse_square = Attenuation::of(T::ZERO, T::ZERO, T::ONE).expect("coefficients");
    for r in [T::of(T::TINIEST), T::ONE, T::MAX] {
        let ranged = Ranged::of(inverse_square, r).expect("above 0");
        for ranged in [ranged, ranged.unsquared()] {
            for q in [r, r + r, T::INFINITY, T::NAN] {
                assert_eq!(ranged.at(q), T::ZERO, "{q:e} of {r:e}");
            }
            // at a distance of 0, all of the light is left
            assert_eq!(ranged.at(T::ZERO), T::MAX);
        }
    }
}

fn lights_out_of_range_are_left_out<T: Float>() {
    let lamp = |z: T, r: T| PointLight {
        position: Vec3::new(T::ZERO, T::ZERO, z),
        intensity: Rgb::gray(T::MAX),
        attenuation: Ranged::of(Attenuation::NONE, r).expect("above 0"),
    };
    let in_front = |lamp: PointLight<T, shading::Ranged<T>>| lamp.in_front(Vec3::ZERO, UnitVec3::Z);
    let [small, large] = [T::MIN_POSITIVE.sqrt() / 16.0, T::MAX.to_f64().sqrt() * 16.0].map(T::of);
    assert_eq!(in_front(lamp(T::of(2.0), T::ONE)), None);
    // within the range, even if the square of the distance is 0 or infinite
    for r in [small, T::ONE, large, T::INFINITY] {
        let q = if r.is_finite() {
            r * T::of(0.5)
        } else {
            T::ONE
        };
        let incident = in_front(lamp(q, r)).expect("in front");
        assert_eq!(incident, lamp(q, r).at(Vec3::ZERO));
        assert!(incident.intensity.r > T::ZERO);
    }
    // out of range, a light that is not left out is black
    for r in [small, large] {
        let incident = in_front(lamp(r + r, r));
        assert!(incident.is_none_or(|light| light.intensity == Rgb::BLACK));
    }
}

fn cone_of_a_nan_direction_gives_one<T: Float>() {
    let nan = UnitVec3::assume_unit(at_x(T::NAN));
    let cone = T::cone(45.0).expect("a cone");
    assert_eq!(cone.factor(nan, UnitVec3::X), T::ONE);
}

// lights

fn light_with_an_infinite_coordinate_is_black<T: Float>() {
    for far in [T::INFINITY, -T::INFINITY].map(at_x) {
        let incident = lamp(far, [1.0, 0.0, 0.0]).at(Vec3::ZERO);
        assert_eq!(incident.intensity, Rgb::BLACK);
        let incident = lamp(Vec3::ZERO, [1.0, 0.0, 0.0]).at(far);
        assert_eq!(incident.intensity, Rgb::BLACK);
    }
}

fn light_with_a_nan_coordinate_adds_nothing<T: Float>() {
    let n = UnitVec3::<T>::Z;
    let incident = lamp(at_x(T::NAN), [1.0, 0.0, 0.0]).at(Vec3::ZERO);
    let shaded = shade::phong(n, n, &mirror(1), Rgb::WHITE, [incident]);
    assert_eq!(shaded.total(), Rgb::WHITE);
}

fn light_at_extreme_distances_has_its_direction<T: Float>() {
    let extremes = [
        T::TINIEST,
        T::MIN_POSITIVE,
        1e-30,
        1e-15,
        1e15,
        1e30,
        T::MAX.to_f64(),
    ];
    for q in extremes.map(T::of) {
        // the square, root, reciprocal, and product are off by 2.5u; the reciprocal of the distance
        // adds 1u
        let near = |a: T, b: T| a == b || (a.to_f64() / b.to_f64() - 1.0).abs() <= 4.0 * T::U;
        let constant = lamp(at_x(q), [1.0, 0.0, 0.0]).at(Vec3::ZERO);
        assert!(
            near(constant.l.x, T::ONE) && constant.l.y == T::ZERO,
            "{q:e}"
        );
        assert_eq!(constant.intensity, Rgb::WHITE, "{q:e}");
        let linear = lamp(at_x(q), [0.0, 1.0, 0.0]).at(Vec3::ZERO);
        let expected = (T::ONE / q).at_most(T::MAX);
        assert!(near(linear.intensity.r, expected), "{q:e}: {linear:?}");
    }
}

fn light_that_overflows_is_the_largest_number<T: Float>() {
    let bright = PointLight {
        intensity: Rgb::gray(T::MAX),
        ..lamp(at_x(T::of(0.5)), [0.0, 0.0, 1.0])
    };
    assert_eq!(bright.at(Vec3::ZERO).intensity, Rgb::gray(T::MAX));
    let spot = SpotLight {
        point: bright,
        axis: -UnitVec3::X,
        cone: T::cone(1.0).expect("a cone"),
    };
    assert_eq!(spot.at(Vec3::ZERO).intensity, Rgb::gray(T::MAX));
}

fn black_light_with_infinite_attenuation_is_black<T: Float>() {
    for q in [T::ZERO, T::of(T::TINIEST), T::of(T::MIN_POSITIVE)] {
        let black = PointLight {
            intensity: Rgb::BLACK,
            ..lamp(at_x(q), [0.0, 0.0, 1.0])
        };
        assert_eq!(black.at(Vec3::ZERO).intensity, Rgb::BLACK, "{q:e}");
    }
}

fn incident_light_of_a_nan_direction_adds_nothing<T: Float>() {
    let l = UnitVec3::assume_unit(at_x(T::NAN));
    let light = IncidentLight {
        l,
        intensity: Rgb::WHITE,
        distance: T::MAX,
    };
    let n = UnitVec3::X;
    assert_eq!(light.in_front(n), None);
    for shaded in [
        shade::phong(n, n, &mirror(1), Rgb::WHITE, [light]),
        shade::blinn_phong(n, n, &mirror(1), Rgb::WHITE, [light]),
    ] {
        assert_eq!(shaded.total(), Rgb::WHITE);
    }
}

// the sum

fn no_lights_give_the_ambient<T: Float>() {
    let n = UnitVec3::<T>::Z;
    let shaded = shade::phong(n, n, &mirror(1), Rgb::gray(T::of(0.5)), []);
    let expected = [0.5, 0.0, 0.0].map(|part| Rgb::gray(T::of(part)));
    assert_eq!([shaded.ambient, shaded.diffuse, shaded.specular], expected);
}

/// Two lights from above, each with the largest number as its intensity.
fn overflowing<T: Float>() -> [IncidentLight<T>; 2] {
    [IncidentLight {
        l: UnitVec3::Z,
        intensity: Rgb::gray(T::MAX),
        distance: T::MAX,
    }; 2]
}

fn overflowing_sum_on_black_is_black<T: Float>() {
    let n = UnitVec3::<T>::Z;
    let black = Material {
        k_a: Rgb::BLACK,
        k_d: Rgb::BLACK,
        k_s: Rgb::BLACK,
        m: 1,
    };
    let shaded = shade::phong(n, n, &black, Rgb::gray(T::MAX), overflowing());
    assert_eq!(shaded.total(), Rgb::BLACK);
}

fn overflowing_sum_is_the_largest_number<T: Float>() {
    let n = UnitVec3::<T>::Z;
    let shaded = shade::phong(n, n, &mirror(1), Rgb::BLACK, overflowing());
    assert_eq!([shaded.diffuse, shaded.specular], [Rgb::gray(T::MAX); 2]);
    assert_eq!(shaded.total().clamped(), Rgb::WHITE);
}

fn clamped_nan_is_zero<T: Float>() {
    let color = Rgb::new(T::NAN, T::INFINITY, -T::INFINITY).clamped();
    assert_eq!(color, Rgb::new(T::ZERO, T::ONE, T::ZERO));
}

// encodings, which exist for `f32` only

#[test]
fn dark_and_invalid_channels_get_the_lowest_level() {
    let least = f32::from_bits(1);
    let negative_nan = f32::from_bits(u32::MAX);
    for dark in [
        -0.0,
        least,
        -least,
        -1.0,
        f32::MIN,
        f32::NEG_INFINITY,
        f32::NAN,
        negative_nan,
    ] {
        assert_eq!(Rgb::gray(dark).to_srgb8(), [0; 3], "{dark:e}");
        assert_eq!(Rgb::gray(dark).to_rgb565(), 0, "{dark:e}");
        assert_eq!(Rgb::gray(dark).to_linear8(), [0; 3], "{dark:e}");
        assert_eq!(Rgb::gray(dark).to_linear565(), 0, "{dark:e}");
    }
}

#[test]
fn channels_above_one_get_the_highest_level() {
    for bright in [1.0 + f32::EPSILON, 1e30, f32::MAX, f32::INFINITY] {
        assert_eq!(Rgb::gray(bright).to_srgb8(), [255; 3], "{bright:e}");
        assert_eq!(Rgb::gray(bright).to_rgb565(), u16::MAX, "{bright:e}");
        assert_eq!(Rgb::gray(bright).to_linear8(), [255; 3], "{bright:e}");
        assert_eq!(Rgb::gray(bright).to_linear565(), u16::MAX, "{bright:e}");
    }
}

// dual numbers

/// The first variable, with this value.
fn variable<T: Float>(value: f64) -> Dual<T> {
    Dual::point(at_x(T::of(value))).x
}

/// The value is the result for the plain number, and the derivative does not exist.
fn assert_no_derivative<T: Float>(dual: Dual<T>, value: T) {
    assert_eq!(dual.value, value);
    assert!(!dual.gradient.x.is_finite(), "{dual:?}");
}

fn dual_root_at_zero_has_no_finite_gradient<T: Float>() {
    assert_no_derivative(variable::<T>(0.0).sqrt(), T::ZERO);
}

fn dual_logarithm_at_zero_has_no_finite_gradient<T: Float>() {
    assert_no_derivative(variable::<T>(0.0).ln(), -T::INFINITY);
}

fn dual_quotient_by_zero_has_no_finite_gradient<T: Float>() {
    let x = variable::<T>(0.0);
    assert_no_derivative(Dual::constant(T::ONE) / x, T::INFINITY);
    assert_no_derivative(x.powi(-1), T::INFINITY);
    assert_no_derivative(variable::<T>(1.0) / T::ZERO, T::INFINITY);
}

fn dual_absolute_value_at_zero_is_flat<T: Float>() {
    let zero = variable::<T>(0.0).abs();
    assert_eq!((zero.value, zero.gradient), (T::ZERO, Vec3::ZERO));
}

fn dual_absolute_value_of_nan_is_nan<T: Float>() {
    let nan = (-variable::<T>(1.0)).sqrt().abs();
    assert!(nan.value.to_f64().is_nan());
    assert!(!nan.gradient.x.is_finite(), "{nan:?}");
    assert!(Dual::constant(T::NAN).abs().value.to_f64().is_nan());
}

fn dual_root_and_logarithm_below_zero_have_no_gradient<T: Float>() {
    for below in [T::TINIEST, 1.0, T::MAX.to_f64()].map(|x| -variable::<T>(x)) {
        for dual in [below.sqrt(), below.ln()] {
            assert!(dual.value.to_f64().is_nan());
            assert!(!dual.gradient.x.is_finite(), "{dual:?}");
        }
    }
    // a function has no normal where it is undefined
    let f = |p: Vec3<Dual<T>>| p.x.ln() + p.z;
    assert_eq!(normal::implicit(f, at_x(-T::ONE)), None);
    let f = |p: Vec3<Dual<T>>| p.x.ln().abs() + p.z;
    assert_eq!(normal::implicit(f, at_x(-T::ONE)), None);
}

fn dual_power_of_zero_is_one_and_flat<T: Float>() {
    let x = variable::<T>(0.0).powi(0);
    assert_eq!((x.value, x.gradient), (T::ONE, Vec3::ZERO));
}

/// The table in the documentation cites only tests that exist.
#[test]
fn every_row_of_the_table_names_a_test() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let read = |file: &str| std::fs::read_to_string(root.join(file)).expect(file);
    let tests = [
        "totality.rs",
        "conventions.rs",
        "extremes.rs",
        "shadows.rs",
        "lengths.rs",
        "lanes/main.rs",
        "fixed/colors.rs",
        "fixed/falloff.rs",
        "fixed/numbers.rs",
        "fixed/scene.rs",
        "fixed/totality.rs",
        "fixed/vectors.rs",
    ]
    .map(|name| read(&format!("tests/{name}")));
    let table = read("docs/totality.md");
    let cited = table
        .lines()
        .filter(|line| line.ends_with(" |"))
        .filter_map(|row| {
            let cell = row.trim_end_matches(" |").rsplit("| ").next()?;
            cell.strip_prefix('`')?.split('`').next()
        });
    let cited: Vec<&str> = cited.collect();
    for name in &cited {
        let definitions = [format!("fn {name}<"), format!("fn {name}(")];
        let defines = |text: &String| {
            definitions
                .iter()
                .any(|definition| text.contains(definition))
        };
        let is_there = tests.iter().any(defines);
        assert!(is_there, "no test {name}");
    }
    assert_eq!(cited.len(), 128, "rows");
}
