//! The conventions that trip people up, each with the test that checks it.

use shading::{
    Attenuation, Cone, Dual, Exponent, IncidentLight, Light, Material, PointLight, Real, Rgb,
    SpotLight, UnitVec3, Vec3, attenuation, half_vector, normal, reflection, shade, term,
};
use support::number::{Float, direction, for_f32_and_f64, vector};

for_f32_and_f64!(
    l_and_v_point_away_from_the_surface,
    r_is_l_mirrored_and_glsl_takes_minus_l,
    h_is_halfway_and_none_for_opposite_directions,
    opposite_directions_give_no_highlight,
    lambert_has_no_pi,
    the_factors_are_literal_and_not_gated,
    a_cosine_not_above_zero_gives_zero,
    a_cosine_above_one_counts_as_one,
    no_highlight_on_a_face_turned_from_the_light,
    ambient_counts_once_and_is_not_attenuated,
    attenuation_takes_the_distance_and_is_not_clamped,
    clamped_attenuation_is_at_most_one,
    bad_coefficients_are_refused,
    a_light_at_the_point_lights_nothing,
    a_directional_light_is_not_attenuated,
    a_spot_is_given_by_its_half_angle_and_includes_its_edge,
    colors_are_not_clamped_before_the_end,
    the_parts_are_separate_and_total_adds_them,
    lights_can_come_from_any_iterator,
    a_triangle_is_counter_clockwise,
    facing_turns_to_the_viewer_and_glsl_takes_minus_v,
    transformed_follows_the_vertices_and_the_inverse_transpose_the_inside,
    a_normal_map_is_decoded_by_the_caller,
    a_degenerate_triangle_has_no_normal,
    unit_is_right_for_numbers_of_any_size,
    new_takes_unit_vectors_only,
    assume_unit_trusts_the_caller,
    singular_points_have_no_normal,
    parametric_normals_follow_the_order_of_u_and_v,
);

/// A material that is white in every part, with shininess m.
fn white<T: Real, M>(m: M) -> Material<T, M> {
    Material {
        k_a: Rgb::WHITE,
        k_d: Rgb::WHITE,
        k_s: Rgb::WHITE,
        m,
    }
}

fn from<T: Real>(l: UnitVec3<T>) -> IncidentLight<T> {
    IncidentLight {
        l,
        intensity: Rgb::WHITE,
        distance: T::MAX,
    }
}

/// Whether two numbers differ by at most `units` u, relative to 1.
fn near<T: Float>(a: T, b: f64, units: f64) -> bool {
    (a.to_f64() - b).abs() <= units * T::U
}

fn l_and_v_point_away_from_the_surface<T: Float>() {
    // light and eye are both straight above: the surface is lit, and the highlight is full
    let n = UnitVec3::<T>::Z;
    let shaded = shade::phong(n, n, &white(5), Rgb::BLACK, [from(n)]);
    assert_eq!((shaded.diffuse, shaded.specular), (Rgb::WHITE, Rgb::WHITE));
    // an L that points into the surface belongs to a light behind it
    let behind = shade::phong(n, n, &white(5), Rgb::BLACK, [from(-n)]);
    assert_eq!(behind.total(), Rgb::BLACK);
    // a light gives the direction toward itself
    let lamp = PointLight {
        position: Vec3::new(T::ZERO, T::ZERO, T::of(2.0)),
        intensity: Rgb::WHITE,
        attenuation: Attenuation::NONE,
    };
    assert_eq!(lamp.at(Vec3::ZERO).l, UnitVec3::Z);
}

fn r_is_l_mirrored_and_glsl_takes_minus_l<T: Float>() {
    let (n, l) = (UnitVec3::<T>::Z, direction::<T>([3.0, 0.0, 4.0]));
    assert_eq!(*reflection(n, l), Vec3::new(-l.x, T::ZERO, l.z));
    // GLSL: reflect(I, N) = I − 2(N·I)N
    let glsl = |i: UnitVec3<T>| *i - *n * (T::of(2.0) * n.dot(i));
    assert_eq!(glsl(-l), *reflection(n, l));
    assert_eq!(reflection(-n, l), reflection(n, l));
}

fn h_is_halfway_and_none_for_opposite_directions<T: Float>() {
    // halfway between X and Z is (1, 0, 1)/√2
    let h = half_vector(UnitVec3::<T>::X, UnitVec3::Z).expect("halfway");
    let expected = 0.5_f64.sqrt();
    assert!(near(h.x, expected, 2.0) && near(h.z, expected, 2.0) && h.y == T::ZERO);
    for l in [[0.0, 0.0, 1.0], [1.0, 2.0, 3.0], [-5.0, 0.1, 7.0]].map(direction::<T>) {
        assert_eq!(half_vector(l, -l), None);
    }
}

fn opposite_directions_give_no_highlight<T: Float>() {
    // the light is above, at 45°, and the eye is opposite it, below
    let (n, l) = (UnitVec3::<T>::Z, direction::<T>([1.0, 0.0, 1.0]));
    let shaded = shade::blinn_phong(n, -l, &white(0), Rgb::BLACK, [from(l)]);
    assert_eq!(shaded.specular, Rgb::BLACK);
    assert_eq!(shaded.diffuse, Rgb::gray(l.z));
}

fn lambert_has_no_pi<T: Float>() {
    assert_eq!(term::lambert(UnitVec3::<T>::Z, UnitVec3::Z), T::ONE);
    let l = direction::<T>([3.0, 0.0, 4.0]);
    assert_eq!(term::lambert(UnitVec3::Z, l), l.z);
    assert!(near(l.z, 0.8, 2.0));
}

fn the_factors_are_literal_and_not_gated<T: Float>() {
    // the light is behind the surface, and R points toward the eye: the factor alone does not know
    let (n, l) = (UnitVec3::<T>::Z, -UnitVec3::Z);
    let r = reflection(n, l);
    assert_eq!(term::phong(r, r, 3), T::ONE);
    assert_eq!(term::blinn(n, UnitVec3::Z, 3), T::ONE);
    assert_eq!(term::lambert(n, l), T::ZERO);
}

fn a_cosine_not_above_zero_gives_zero<T: Float>() {
    fn all<T: Float>(m: impl Exponent<T>) {
        let z = UnitVec3::<T>::Z;
        for at_or_below in [UnitVec3::X, -z, direction([1.0, 0.0, -0.01])] {
            assert_eq!(term::phong(z, at_or_below, m), T::ZERO);
            assert_eq!(term::blinn(z, at_or_below, m), T::ZERO);
        }
    }
    [0, 1, 2, 1000, u32::MAX].into_iter().for_each(all::<T>);
    [0.0, 0.5, 1.0, 1e30]
        .map(T::of)
        .into_iter()
        .for_each(all::<T>);
    // above 0, the cosine to the power of 0 is 1
    assert_eq!(
        term::phong(UnitVec3::<T>::Z, direction([1.0, 0.0, 0.01]), 0),
        T::ONE
    );
    assert_eq!(
        term::phong(UnitVec3::<T>::Z, direction([1.0, 0.0, 0.01]), T::ZERO),
        T::ONE
    );
}

fn a_cosine_above_one_counts_as_one<T: Float>() {
    // N·N exceeds 1 by two units in the last place: 1.0000002^1000000 would be 1.27
    let more = T::ONE + T::of(2.0 * T::U);
    let n = UnitVec3::assume_unit(Vec3::new(T::ZERO, T::ZERO, more));
    assert!(n.dot(n) > T::ONE);
    assert_eq!(term::phong(n, n, 1_000_000), T::ONE);
    assert_eq!(term::blinn(n, n, T::of(1e6)), T::ONE);
    let shaded = shade::blinn_phong(n, n, &white(T::of(1e6)), Rgb::BLACK, [from(n)]);
    assert_eq!(shaded.specular, Rgb::WHITE);
}

fn no_highlight_on_a_face_turned_from_the_light<T: Float>() {
    // L is below the horizon, and V is the mirror direction: R·V = 1, and H is close to N at
    // grazing angles
    let n = UnitVec3::<T>::Z;
    let l = direction::<T>([1.0, 0.0, -0.125]);
    let v = direction::<T>([-1.0, 0.0, 0.5]);
    assert!(term::blinn(n, half_vector(l, v).expect("H"), 1) > T::of(0.5));
    for l in [l, UnitVec3::X] {
        let phong = shade::phong(n, reflection(n, l), &white(1), Rgb::BLACK, [from(l)]);
        let blinn = shade::blinn_phong(n, v, &white(1), Rgb::BLACK, [from(l)]);
        assert_eq!((phong.specular, blinn.specular), (Rgb::BLACK, Rgb::BLACK));
    }
}

fn ambient_counts_once_and_is_not_attenuated<T: Float>() {
    let (k_a, i_a) = (Rgb::new(0.5, 0.25, 1.0), Rgb::new(0.5, 2.0, 0.0));
    let (k_a, i_a) = (k_a.map(T::of), i_a.map(T::of));
    let expected = Rgb::new(0.25, 0.5, 0.0).map(T::of);
    assert_eq!(term::ambient(k_a, i_a), expected);
    let material = Material { k_a, ..white(1) };
    let lamp = from(UnitVec3::Z);
    for count in 0..4 {
        let lights = std::iter::repeat_n(lamp, count);
        let shaded = shade::lambert(UnitVec3::Z, &material, i_a, lights);
        assert_eq!(shaded.ambient, expected);
    }
}

fn attenuation_takes_the_distance_and_is_not_clamped<T: Float>() {
    // at a distance of 4, the factor is 1/(1 + 2·4 + 0.5·16) = 1/17
    let [one, two, half, four] = [1.0, 2.0, 0.5, 4.0].map(T::of);
    assert_eq!(attenuation(one, two, half, four), T::of(1.0 / 17.0));
    // at ¼, the inverse square is 16
    assert_eq!(attenuation(T::ZERO, T::ZERO, one, T::of(0.25)), T::of(16.0));
    let inverse_square = T::attenuation([0.0, 0.0, 1.0]).expect("coefficients");
    assert_eq!(inverse_square.at(T::of(0.25)), T::of(16.0));
}

fn clamped_attenuation_is_at_most_one<T: Float>() {
    let inverse_square = T::attenuation([0.0, 0.0, 1.0])
        .expect("coefficients")
        .clamped();
    assert_eq!(inverse_square.at(T::of(0.25)), T::ONE);
    assert_eq!(inverse_square.at(T::of(2.0)), T::of(0.25));
}

fn bad_coefficients_are_refused<T: Float>() {
    let [zero, one, huge] = [T::ZERO, T::ONE, T::MAX];
    for bad in [-one, -T::of(T::TINIEST), T::INFINITY, -T::INFINITY, T::NAN] {
        for [a, b, c] in [[bad, one, one], [one, bad, one], [one, one, bad]] {
            assert_eq!(Attenuation::of(a, b, c), None);
        }
    }
    assert_eq!(Attenuation::of(zero, zero, zero), None);
    assert_eq!(Attenuation::of(-zero, zero, zero), None);
    for [a, b, c] in [
        [one, zero, zero],
        [zero, one, zero],
        [zero, zero, one],
        [huge; 3],
    ] {
        assert!(Attenuation::of(a, b, c).is_some());
    }
}

fn a_light_at_the_point_lights_nothing<T: Float>() {
    let position = vector::<T>([1.0, 2.0, 3.0]);
    for coefficients in [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]] {
        let attenuation = T::attenuation(coefficients).expect("coefficients");
        let point = PointLight {
            position,
            intensity: Rgb::WHITE,
            attenuation,
        };
        assert_eq!(point.at(position).intensity, Rgb::BLACK);
        let spot = SpotLight {
            point,
            axis: UnitVec3::Z,
            cone: T::cone(180.0).expect("π"),
        };
        assert_eq!(spot.at(position).intensity, Rgb::BLACK);
        let n = UnitVec3::Z;
        let shaded = shade::phong(n, n, &white(1), Rgb::BLACK, [point.at(position)]);
        assert_eq!(shaded.total(), Rgb::BLACK);
    }
}

fn a_directional_light_is_not_attenuated<T: Float>() {
    let sun = shading::DirectionalLight {
        l: UnitVec3::<T>::Z,
        intensity: Rgb::WHITE,
    };
    for p in [Vec3::ZERO, vector([1e30, -1e30, 1e30])] {
        assert_eq!(sun.at(p), from(UnitVec3::Z));
        assert_eq!(Light::<T>::Directional(sun).at(p), from(UnitVec3::Z));
    }
}

fn a_spot_is_given_by_its_half_angle_and_includes_its_edge<T: Float>() {
    let axis = -UnitVec3::<T>::Z;
    // with a half-angle of 45°, a direction 44° off the axis is inside, and one 46° off is not
    let cone = T::cone(45.0).expect("a half-angle");
    let off_axis = |degrees: f64| {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        direction::<T>([sine, 0.0, cosine])
    };
    assert_eq!(cone.factor(axis, off_axis(44.0)), T::ONE);
    assert_eq!(cone.factor(axis, off_axis(46.0)), T::ZERO);
    // the edge itself: a cosine of exactly ½, and one smaller by u
    let cone = Cone::of_cosines(T::of(0.5), T::of(0.5)).expect("a cosine");
    let at =
        |cosine: f64| UnitVec3::assume_unit(vector([(1.0 - cosine * cosine).sqrt(), 0.0, cosine]));
    assert_eq!(cone.cosines()[0], T::of(0.5));
    assert_eq!(cone.factor(axis, at(0.5)), T::ONE);
    assert_eq!(cone.factor(axis, at(0.5 - T::U)), T::ZERO);
    assert_eq!(T::half_angles(T::of(-0.1), T::of(-0.1)), None);
    assert_eq!(T::half_angles(T::of(3.2), T::of(3.2)), None);
    assert_eq!(Cone::of_cosines(T::of(1.1), T::of(1.1)), None);
}

fn colors_are_not_clamped_before_the_end<T: Float>() {
    let n = UnitVec3::<T>::Z;
    let lights = [from(n); 3];
    let shaded = shade::lambert(n, &white(1), Rgb::WHITE, lights);
    assert_eq!(shaded.total(), Rgb::gray(T::of(4.0)));
    assert_eq!(shaded.total().clamped(), Rgb::WHITE);
}

fn the_parts_are_separate_and_total_adds_them<T: Float>() {
    let grays = [0.25, 0.5, 0.125].map(|k| Rgb::gray(T::of(k)));
    let [k_a, k_d, k_s] = grays;
    let n = UnitVec3::<T>::Z;
    let material = Material {
        k_a,
        k_d,
        k_s,
        m: 3,
    };
    for shaded in [
        shade::phong(n, n, &material, Rgb::WHITE, [from(n)]),
        shade::blinn_phong(n, n, &material, Rgb::WHITE, [from(n)]),
    ] {
        assert_eq!([shaded.ambient, shaded.diffuse, shaded.specular], grays);
        assert_eq!(shaded.total(), Rgb::gray(T::of(0.875)));
    }
}

fn lights_can_come_from_any_iterator<T: Float>() {
    let n = UnitVec3::<T>::Z;
    let shade = |lights: &mut dyn Iterator<Item = IncidentLight<T>>| {
        shade::lambert(n, &white(1), Rgb::BLACK, lights).diffuse
    };
    assert_eq!(shade(&mut std::iter::empty()), Rgb::BLACK);
    assert_eq!(shade(&mut Some(from(n)).into_iter()), Rgb::WHITE);
    // a shadow is a filter
    let lights = vec![from(n), from(direction([1.0, 0.0, 1.0]))];
    let unshadowed = lights.into_iter().filter(|light| light.l == n);
    assert_eq!(shade(&mut { unshadowed }), Rgb::WHITE);
}

fn a_triangle_is_counter_clockwise<T: Float>() {
    // (1, 0, 0) × (0, 1, 0) = (0, 0, 1)
    let [a, b, c] = [[0.0, 0.0, 5.0], [1.0, 0.0, 5.0], [0.0, 1.0, 5.0]].map(vector::<T>);
    for (vertices, expected) in [([a, b, c], UnitVec3::Z), ([a, c, b], -UnitVec3::Z)] {
        let [v1, v2, v3] = vertices;
        assert_eq!(normal::triangle(v1, v2, v3), Some(expected));
        assert_eq!(normal::triangle(v2, v3, v1), Some(expected));
    }
}

fn facing_turns_to_the_viewer_and_glsl_takes_minus_v<T: Float>() {
    // GLSL: faceforward(N, I, N_ref) = N where N_ref·I < 0, else −N
    let glsl = |n: UnitVec3<T>, i: UnitVec3<T>| if n.dot(i) < T::ZERO { n } else { -n };
    let (v, n) = (UnitVec3::Z, direction::<T>([3.0, 0.0, 4.0]));
    assert_eq!((normal::facing(n, v), glsl(n, -v)), (n, n));
    assert_eq!((normal::facing(-n, v), glsl(-n, -v)), (n, n));
    // edge-on, the two differ
    let aside = UnitVec3::X;
    assert_eq!((normal::facing(aside, v), glsl(aside, -v)), (aside, -aside));
    assert_eq!(normal::facing(-aside, v), -aside);
}

fn transformed_follows_the_vertices_and_the_inverse_transpose_the_inside<T: Float>() {
    // mirrored in the plane x = 0, a triangle in that plane stays where it is, and so does its
    // normal
    let columns = [-*UnitVec3::X, *UnitVec3::Y, *UnitVec3::Z];
    assert_eq!(
        normal::transformed(UnitVec3::<T>::X, columns),
        Some(UnitVec3::X)
    );
    // the inverse transpose is the same matrix, and it reverses the normal
    let inverse_transpose = |n: UnitVec3<T>| columns[0] * n.x + columns[1] * n.y + columns[2] * n.z;
    assert_eq!(inverse_transpose(UnitVec3::X), -*UnitVec3::X);
    // a mirrored roof slopes the other way, and its vertices appear counter-clockwise from below
    let roof = direction::<T>([3.0, 0.0, 4.0]);
    let mirrored = normal::transformed(roof, columns).expect("a normal");
    assert_eq!(*mirrored, Vec3::new(roof.x, T::ZERO, -roof.z));
}

fn a_normal_map_is_decoded_by_the_caller<T: Float>() {
    let (n, tangent) = (UnitVec3::<T>::Z, *UnitVec3::X);
    let mapped = |h: T, x, y, z| normal::mapped(n, tangent, h, vector([x, y, z]));
    // x is along the tangent, and y is along N × T = Y or against it
    assert_eq!(mapped(T::ONE, 1.0, 0.0, 0.0), Some(UnitVec3::X));
    assert_eq!(mapped(T::ONE, 0.0, 1.0, 0.0), Some(UnitVec3::Y));
    assert_eq!(mapped(-T::ONE, 0.0, 1.0, 0.0), Some(-UnitVec3::Y));
    assert_eq!(mapped(T::ONE, 0.0, 0.0, 1.0), Some(UnitVec3::Z));
    // only the sign of the handedness counts, and a number without a sign counts as negative
    assert_eq!(mapped(T::of(0.1), 0.0, 1.0, 0.0), Some(UnitVec3::Y));
    assert_eq!(mapped(T::ZERO, 0.0, 1.0, 0.0), Some(-UnitVec3::Y));
    assert_eq!(mapped(T::NAN, 0.0, 1.0, 0.0), Some(-UnitVec3::Y));
    // T need not be perpendicular to N: its component along N is ignored
    let slanted = normal::mapped(n, vector([1.0, 0.0, 5.0]), T::ONE, vector([3.0, 0.0, 4.0]));
    assert_eq!(slanted, Some(direction([3.0, 0.0, 4.0])));
    // a sample that points below the surface is used as it is
    let black = mapped(T::ONE, -1.0, -1.0, -1.0).expect("a direction");
    assert_eq!(black, direction([-1.0, -1.0, -1.0]));
}

fn a_degenerate_triangle_has_no_normal<T: Float>() {
    let [a, b] = [[1.0, 2.0, 3.0], [4.0, 6.0, 8.0]].map(vector::<T>);
    let between = vector::<T>([2.5, 4.0, 5.5]);
    for [v1, v2, v3] in [[a, a, a], [a, a, b], [a, b, a], [a, b, b], [a, between, b]] {
        assert_eq!(normal::triangle(v1, v2, v3), None);
    }
    let outside = Vec3::new(T::INFINITY, T::ZERO, T::ZERO);
    assert_eq!(normal::triangle(a, outside, b), None);
    assert_eq!(
        normal::triangle(a, Vec3::new(T::NAN, T::ZERO, T::ZERO), b),
        None
    );
}

fn unit_is_right_for_numbers_of_any_size<T: Float>() {
    // (1, 2, 2)/3 at any size
    let expected = [1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0];
    for size in [
        T::of(T::TINIEST),
        T::of(T::MIN_POSITIVE),
        T::ONE,
        T::MAX * T::of(0.5),
    ] {
        let v = vector::<T>([1.0, 2.0, 2.0]) * size;
        let n: [T; 3] = v.unit().expect("a direction").into();
        // the squares, sums, and root are off by 2.5u, and the division by 1u
        assert!(
            (0..3).all(|i| near(n[i], expected[i], 3.5)),
            "{size:e}: {n:?}"
        );
        assert_eq!(v.unit_or(UnitVec3::X), v.unit().expect("a direction"));
    }
    for none in [T::ZERO, -T::ZERO, T::INFINITY, T::NAN] {
        let v = Vec3::new(T::ZERO, none, T::ZERO);
        assert_eq!((v.unit(), v.unit_or(UnitVec3::Y)), (None, UnitVec3::Y));
    }
}

fn new_takes_unit_vectors_only<T: Float>() {
    let checked = |v: [f64; 3]| {
        let [x, y, z] = v.map(T::of);
        UnitVec3::of(x, y, z)
    };
    assert_eq!(checked([0.0, 0.0, 1.0]), Some(UnitVec3::Z));
    let third = 1.0 / 3.0;
    for v in [
        [0.0, 0.0, 1.0],
        [0.6, 0.0, -0.8],
        [-0.48, 0.6, 0.64],
        [2.0 * third, 2.0 * third, -third],
        [third.sqrt(); 3],
    ] {
        let taken = checked(v).expect("a unit vector");
        assert_eq!(*taken, vector(v));
        // the square of the length is off by 16ε, whereas that of a rounded unit vector is off by
        // at most 4ε
        for factor in [1.0 - 16.0 * T::U, 1.0 + 16.0 * T::U] {
            assert_eq!(checked(v.map(|c| c * factor)), None);
        }
        for i in 0..3 {
            let mut wrong = v;
            wrong[i] = 0.5 - v[i];
            assert_eq!(checked(wrong), None, "{wrong:?}");
        }
    }
    for v in [[0.0; 3], [1.0, 0.0, 1.0], [f64::NAN, 0.0, 1.0]] {
        assert_eq!(checked(v), None);
    }
    for i in 0..3 {
        let mut infinite = [0.0; 3];
        infinite[i] = f64::INFINITY;
        assert_eq!(checked(infinite), None);
    }
}

fn assume_unit_trusts_the_caller<T: Float>() {
    let v = vector::<T>([1.0, 2.0, 3.0]);
    assert_eq!(*UnitVec3::assume_unit(v), v);
}

fn singular_points_have_no_normal<T: Float>() {
    // the apex of a cone: ∇(x² + y² − z²) = 0
    let cone = |p: Vec3<Dual<T>>| p.x * p.x + p.y * p.y - p.z * p.z;
    assert_eq!(normal::implicit(cone, Vec3::ZERO), None);
    assert!(normal::implicit(cone, vector([3.0, 4.0, 5.0])).is_some());
    // the pole of a sphere, v = 0: ∂s/∂u = 0
    let sphere = |u: Dual<T>, v: Dual<T>| {
        use shading::Elementary;
        Vec3::new(u.cos() * v.sin(), u.sin() * v.sin(), v.cos())
    };
    assert_eq!(normal::parametric(sphere, T::ONE, T::ZERO), None);
    // tangents that are parallel everywhere
    assert_eq!(
        normal::parametric(|u, v| Vec3::new(u + v, u + v, u + v), T::ONE, T::ONE),
        None
    );
    // a gradient that does not exist: √ at 0
    assert_eq!(
        normal::implicit(|p: Vec3<Dual<T>>| p.x.sqrt(), Vec3::ZERO),
        None
    );
}

fn parametric_normals_follow_the_order_of_u_and_v<T: Float>() {
    // the plane (u, v, 0): S_u × S_v = X × Y = Z, and nothing reverses it
    let zero = Dual::constant(T::ZERO);
    assert_eq!(
        normal::parametric(|u, v| Vec3::new(u, v, zero), T::ONE, T::ONE),
        Some(UnitVec3::Z)
    );
    assert_eq!(
        normal::parametric(|u, v| Vec3::new(v, u, zero), T::ONE, T::ONE),
        Some(-UnitVec3::Z)
    );
}
