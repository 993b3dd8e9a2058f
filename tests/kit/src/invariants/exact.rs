//! What holds to the bit, and what holds of a result whatever its digits.

use std::format;
use std::vec::Vec;

use shading::{
    Attenuation, Cone, Dual, IncidentLight, Light, Lobe, Mask, Material, Measured, Real, Rgb,
    Select, Shaded, UnitVec3, Vec3, attenuation, half_vector, normal, reflection, shade, term,
};

use super::{Case, Law, Parts, Tried, Verdict, n};

/// The same numbers; zeros of either sign are the same, and so are two NaNs.
fn same<T: Tried>(left: &[T], right: &[T]) -> Verdict {
    let is_same =
        |(a, b): (&T, &T)| a.exact() == b.exact() || a.exact().is_nan() && b.exact().is_nan();
    if left.len() == right.len() && left.iter().zip(right).all(is_same) {
        Verdict::Holds
    } else {
        Verdict::Fails(format!("{left:?} and {right:?}"))
    }
}

fn holds(holds: bool) -> Verdict {
    if holds {
        Verdict::Holds
    } else {
        Verdict::Fails("false".into())
    }
}

/// Two kinds of rows: `left == right`, number by number, and what is true.
macro_rules! laws {
    (
        equal { $($equal:ident: |$a:ident| $left:expr => $right:expr;)* }
        scaled { $($scaled:ident: |$b:ident| $from:expr => $to:expr;)* }
        true { $($true:ident: |$c:ident| $is:expr;)* }
    ) => {
        $(fn $equal<T: Tried>($a: &Case<T>) -> Verdict {
            same(&$left.parts(), &$right.parts())
        })*
        $(fn $scaled<T: Tried>($b: &Case<T>) -> Verdict {
            let right = $to.parts();
            let keeps_bits = |x: &T| x.exact() == 0.0 || x.exact().abs() > T::SMALLEST / T::U;
            if right.iter().all(keeps_bits) { same(&$from.parts(), &right) } else { Verdict::Open }
        })*
        $(fn $true<T: Tried>($c: &Case<T>) -> Verdict {
            holds($is)
        })*

        pub fn laws<T: Tried>() -> Vec<Law<T>> {
            let mut laws: Vec<Law<T>> = [
                $((stringify!($equal), $equal as fn(&Case<T>) -> Verdict),)*
                $((stringify!($true), $true as fn(&Case<T>) -> Verdict),)*
            ].into();
            if T::IS_FLOAT {
                laws.extend([$((stringify!($scaled), $scaled as fn(&Case<T>) -> Verdict)),*]);
            }
            laws
        }
    };
}

/// Half a turn about z.
fn turned<T: Real>(v: Vec3<T>) -> Vec3<T> {
    Vec3::new(-v.x, -v.y, v.z)
}

fn turned_unit<T: Real>(u: UnitVec3<T>) -> UnitVec3<T> {
    UnitVec3::assume_unit(turned(*u))
}

fn cycled<T: Real>(c: Rgb<T>) -> Rgb<T> {
    Rgb::new(c.g, c.b, c.r)
}

/// The three sums.
fn sums<T: Real + PartialOrd>(c: &Case<T>, lights: &[IncidentLight<T>]) -> [Shaded<T>; 3] {
    let lights = || lights.iter().copied();
    [
        shade::lambert(c.n, &c.material, c.rgb, lights()),
        shade::phong(c.n, c.v, &c.material, c.rgb, lights()),
        shade::blinn_phong(c.n, c.v, &c.material, c.rgb, lights()),
    ]
}

/// Of light alone, from a white surface in the dark.
fn white<T: Real + PartialOrd>(c: &Case<T>, lights: &[IncidentLight<T>]) -> [Shaded<T>; 3] {
    let [k_a, k_d, k_s] = [Rgb::WHITE; 3];
    let material = Material {
        k_a,
        k_d,
        k_s,
        m: c.m,
    };
    sums(
        &Case {
            material,
            rgb: Rgb::BLACK,
            ..*c
        },
        lights,
    )
}

fn scene_turned<T: Tried>(c: &Case<T>) -> Case<T> {
    let mut t = *c;
    [t.n, t.l, t.v, t.axis] = [c.n, c.l, c.v, c.axis].map(turned_unit);
    [t.p, t.a, t.b, t.c] = [c.p, c.a, c.b, c.c].map(turned);
    t.sun.l = turned_unit(c.sun.l);
    t.spot.axis = turned_unit(c.spot.axis);
    for (light, of) in [
        (&mut t.lamp, c.lamp),
        (&mut t.far, c.far),
        (&mut t.spot.point, c.spot.point),
    ] {
        light.position = turned(of.position);
    }
    t
}

fn scene_cycled<T: Tried>(c: &Case<T>) -> Case<T> {
    let mut t = *c;
    t.rgb = cycled(c.rgb);
    let Material { k_a, k_d, k_s, m } = c.material;
    let [k_a, k_d, k_s] = [k_a, k_d, k_s].map(cycled);
    t.material = Material { k_a, k_d, k_s, m };
    t.sun.intensity = cycled(c.sun.intensity);
    for light in [&mut t.lamp, &mut t.far, &mut t.spot.point] {
        light.intensity = cycled(light.intensity);
    }
    t
}

/// Every result of a case that turns with it.
fn turning<T: Tried>(c: &Case<T>) -> Vec<Vec3<T>> {
    let normals = [
        normal::triangle(c.a, c.b, c.c),
        normal::sphere(c.a, c.p),
        normal::from_tangents(c.a, c.b),
        half_vector(c.l, c.v),
        Some(reflection(c.n, c.l)),
        normal::mapped(c.n, c.a, T::ONE, *UnitVec3::X),
    ];
    normals
        .into_iter()
        .map(|n| n.map_or(Vec3::ZERO, |n| *n))
        .chain([normal::corner(c.a, c.b, c.c)])
        .collect()
}

fn all<T: Real>(vectors: Vec<Vec3<T>>) -> Vec<T> {
    vectors.into_iter().flat_map(<[T; 3]>::from).collect()
}

/// No light, and none in a sum.
fn is_black<T: Tried>(c: &Case<T>, light: IncidentLight<T>) -> bool {
    light.intensity() == Rgb::BLACK && white(c, &[light]).iter().all(|s| s.total() == Rgb::BLACK)
}

fn is_share<T: Tried>(x: T) -> bool {
    x >= T::ZERO && x <= T::ONE
}

/// Cosines that fall with distance, as far as the type tells.
fn in_order<T: Tried>(values: &[T]) -> bool {
    values.is_sorted_by(|a, b| a >= b)
}

/// The next number above, or a larger one.
fn above<T: Tried>(x: T) -> T {
    let slightly = x * T::of(1.0 + 2.0 * T::U);
    if slightly > x {
        slightly
    } else {
        x + T::of(T::SMALLEST)
    }
}

fn gray<T: Real>(x: T) -> Rgb<T> {
    Rgb::gray(x)
}

laws! {
    equal {
        // directions
        reflection_has_no_side: |c| reflection(-c.n, c.l) => reflection(c.n, c.l);
        halfway_is_symmetric: |c| half_vector(c.l, c.v) => half_vector(c.v, c.l);
        opposites_have_no_halfway: |c| half_vector(c.l, -c.l) => None::<UnitVec3<T>>;
        facing_twice_is_once: |c| normal::facing(normal::facing(c.n, c.v), c.v) => normal::facing(c.n, c.v);
        no_direction_has_no_length: |c| n([T::measured(Vec3::ZERO).w_length, T::measured(Vec3::splat(T::ZERO * c.x)).length]) => n([T::ZERO; 2]);
        // normals
        exchanged_vertices_turn_the_normal: |c| normal::triangle(c.a, c.c, c.b) => normal::triangle(c.a, c.b, c.c).map(|n| -n);
        exchanged_tangents_turn_the_normal: |c| normal::from_tangents(c.b, c.a) => normal::from_tangents(c.a, c.b).map(|n| -n);
        exchanged_corners_turn_the_share: |c| normal::corner(c.a, c.c, c.b) => -normal::corner(c.a, c.b, c.c);
        a_negative_function_turns_the_normal: |c| normal::implicit(|p| -(p.x * p.y + p.z * p.z), c.grid[0])
            => normal::implicit(|p| p.x * p.y + p.z * p.z, c.grid[0]).map(|n| -n);
        exchanged_parameters_turn_the_normal: |c| normal::parametric(|v, u| Vec3::new(u, v, u * v), c.y, c.x)
            => normal::parametric(|u, v| Vec3::new(u, v, u * v), c.x, c.y).map(|n| -n);
        a_point_is_no_triangle: |c| [normal::triangle(c.a, c.a, c.b), normal::triangle(c.a, c.b, c.b)] => None::<UnitVec3<T>>;
        translated_normals: |c| { let [o, a, b, d] = c.grid; [normal::triangle(a + o, b + o, d + o), normal::sphere(a + o, b + o)] }
            => { let [_, a, b, d] = c.grid; [normal::triangle(a, b, d), normal::sphere(a, b)] };
        a_projection_along_n_keeps_it: |c| normal::transformed(UnitVec3::Z, [*UnitVec3::X, *UnitVec3::Y, Vec3::ZERO * c.x]) => UnitVec3::Z;
        handedness_turns_y: |c| normal::mapped(c.n, *c.l, -c.x, Vec3::new(c.v.x, -c.v.y, c.v.z))
            => normal::mapped(c.n, *c.l, c.x.above(T::ZERO).select(T::ONE, T::NEG_ONE), if c.x > T::ZERO { *c.v } else {
                Vec3::new(c.v.x, -c.v.y, c.v.z) });
        half_a_turn_turns_normals: |c| all(turning(&scene_turned(c))) => all(turning(c).into_iter().map(turned).collect());
        // terms and falloff
        the_power_0_is_1: |c| n([0.raise(c.x.at_least(T::of(T::SMALLEST))), term::phong(c.n, c.v, 0), term::blinn(UnitVec3::X,
            UnitVec3::Y, 0)])
            => n([T::ONE, c.n.dot(c.v).above(T::ZERO).select(T::ONE, T::ZERO), T::ZERO]);
        the_power_1_is_the_cosine: |c| n([1.raise(c.x)]) => n([c.x]);
        a_power_of_1_is_1: |c| n([c.m.raise(T::ONE), u32::MAX.raise(T::ONE)]) => n([T::ONE; 2]);
        no_attenuation_is_1: |c| n([Attenuation::NONE.at(c.q), Attenuation::NONE.at(T::MAX),
            Attenuation::NONE.within(T::MAX).expect("none").at(T::MAX)])
            => n([T::ONE; 3]);
        clamped_is_at_most_1: |c| n([c.falloff.clamped().at(c.q)]) => n([c.falloff.at(c.q).at_most(T::ONE)]);
        nothing_from_the_range_on: |c| n([c.ranged.at(c.ranged.range()), c.gltf().at(above(c.ranged.range())),
            c.ranged.at(T::MAX)])
            => n([T::ZERO; 3]);
        a_hard_cone_is_0_or_1: |c| n([c.hard.factor(c.axis, c.l)])
            => n([if c.hard.factor(c.axis, c.l) > T::ZERO { T::ONE } else { T::ZERO }]);
        a_cone_lights_its_axis: |c| n([c.hard, c.soft, c.soft.smoothstep(), Cone::from_cosine(T::ONE).expect("0"),
            Cone::from_cosine(T::NEG_ONE).expect("π")].map(|cone| cone.factor(c.axis, -c.axis)))
            => n([T::ONE; 5]);
        a_cone_of_pi_lights_everything: |c| n({ let cone = Cone::from_cosine(T::NEG_ONE).expect("π"); [cone, cone.cast(|x| x)]
            .map(|cone| cone.factor(c.axis, c.l)) })
            => n([T::ONE; 2]);
        // lights
        a_lamp_is_black_at_its_position: |c| [c.lamp.at(c.a), c.spot.at(c.b), Light::from(c.far).at(c.c)].map(|light| light.intensity())
            => [Rgb::BLACK; 3];
        a_spot_is_a_lamp: |c| c.spot.at(c.p).l() => c.spot.point.at(c.p).l();
        a_light_of_any_kind_is_that_light: |c| c.lights()[2].at(c.p).intensity() => c.spot.at(c.p).intensity();
        a_translated_lamp: |c| { let [o, a, p, _] = c.grid; let mut lamp = c.lamp; lamp.position = a + o; lamp.at(p + o).intensity() }
            => { let [_, a, p, _] = c.grid; let mut lamp = c.lamp; lamp.position = a; lamp.at(p).intensity() };
        a_dimmed_sun: |c| (c.sun.at(c.p) * c.rgb).intensity() => c.sun.intensity * c.rgb;
        // sums
        no_lights_leave_the_ambient: |c| sums(c, &[]).map(|s| [s.ambient, s.diffuse, s.specular])
            => [[c.material.k_a * c.rgb, Rgb::BLACK, Rgb::BLACK]; 3];
        a_sum_goes_from_first_to_last: |c| white(c, &c.arriving()).map(|s| [s.diffuse, s.specular])
            => { let each = c.arriving().map(|light| white(c, &[light])); [0, 1, 2]
                .map(|i| { let [a, b, d, e] = [0, 1, 2, 3].map(|j| each[j][i]); [a.diffuse + b.diffuse + d.diffuse + e.diffuse,
                a.specular + b.specular + d.specular + e.specular] }) };
        a_sum_is_of_its_terms: |c| white(c, &[c.sun.at(c.p)]).map(|s| [s.diffuse, s.specular])
            => { let lit = term::lambert(c.n, c.l); let shine = |x: T| c.sun.intensity * lit.above(T::ZERO).select(x, T::ZERO); let [phong,
                blinn] = [term::phong(reflection(c.n, c.l), c.v, c.m), T::halfway_power(*c.n, Measured { w: *c.l, w_length: T::ONE, length: T::ONE }, *c.v, c.m)];
                [[c.sun.intensity * lit, Rgb::BLACK], [c.sun.intensity * lit, shine(phong)], [c.sun.intensity * lit, shine(blinn)]] };
        lights_behind_are_left_out: |c| sums(c, &c.arriving().into_iter().filter(|light| light.is_in_front(c.n)).collect::<Vec<_>>())
            => sums(c, &c.arriving());
        a_black_light_changes_nothing: |c| { let [a, b, d, e] = c.arriving(); sums(c, &[a, b * Rgb::BLACK, d, e, a * T::ZERO]) }
            => { let [a, _, d, e] = c.arriving(); sums(c, &[a, d, e]) };
        diffuse_does_not_see_the_eye: |c| shade::phong(c.n, c.l, &c.material, c.rgb, c.arriving()).diffuse
            => shade::lambert(c.n, &c.material, c.rgb, c.arriving()).diffuse;
        channels_are_apart: |c| sums(&scene_cycled(c), &scene_cycled(c).arriving())
            => sums(c, &c.arriving()).map(|s| Shaded { ambient: cycled(s.ambient), diffuse: cycled(s.diffuse),
                specular: cycled(s.specular) });
        half_a_turn_changes_nothing: |c| sums(&scene_turned(c), &scene_turned(c).arriving()) => sums(c, &c.arriving());
        opposite_the_eye_nothing_shines: |c| shade::blinn_phong(c.n, -c.l, &c.material, c.rgb, [c.sun.at(c.p)]).specular => gray(T::ZERO);
        // numbers
        derived_methods: |c| n([c.x.at_least(-c.x), (-c.x).at_least(c.x), c.x.at_least(c.y), c.x.at_most(c.y), c.x.above(c.y).select(c.q,
            c.x), T::of_f32(0.375)])
            => n([c.x, c.x, if c.x > c.y { c.x } else { c.y }, if c.x > c.y { c.y } else { c.x }, if c.x > c.y { c.q } else { c.x },
                T::of(0.375)]);
        zero_and_one: |c| n([c.x + T::ZERO, c.x - T::ZERO, c.x * T::ONE, c.x / T::ONE, c.x + -c.x, c.x * T::ZERO, c.x * T::NEG_ONE,
            T::ZERO.sqrt(), T::ONE.sqrt()])
            => n([c.x, c.x, c.x, c.x, T::ZERO, T::ZERO, -c.x, T::ZERO, T::ONE]);
        constants: |c| n([T::of(0.0) * c.x, T::of(1.0), T::of(-1.0), T::of(T::LARGEST), T::of(T::LARGE)])
            => n([T::ZERO, T::ONE, T::NEG_ONE, T::MAX, T::EXTREME]);
        a_constant_has_no_slope: |c| { let x = Dual::constant(c.x); (x * x + x).gradient } => Vec3::ZERO;
    }
    scaled {
        a_dual_number_has_the_value_of_its_number: |c| { let d = c.cast(Dual::constant); sums(&d, &d.arriving())
            .map(|s| [s.diffuse, s.specular].map(|rgb| rgb.map(|x| x.value))) }
            => sums(c, &c.arriving()).map(|s| [s.diffuse, s.specular]);
        half_the_light_is_half_as_bright: |c| white(c, &[c.sun.at(c.p) * T::of(0.5)]).map(|s| s * T::of(2.0)) => white(c, &[c.sun.at(c.p)]);
        a_triangle_of_twice_the_size: |c| { let [o, a, b, _] = c.grid.map(|v| v * T::of(0.25)); normal::triangle(o, a, b) }
            => { let [o, a, b, _] = c.grid; normal::triangle(o, a, b) };
        an_axis_of_any_length: |c| { let two = T::of(2.0); normal::transformed(c.n, [*UnitVec3::X * two, *UnitVec3::Y * two,
            *UnitVec3::Z * two]) }
            => normal::transformed(c.n, [*UnitVec3::X, *UnitVec3::Y, *UnitVec3::Z]);
        a_scene_of_twice_the_size: |c| { let [_, a, p, _] = c.grid.map(|v| v * T::of(2.0)); let [x, y, z] = c.falloff.coefficients();
            let half = T::of(0.5); let mut lamp = c.lamp; lamp.position = a; lamp.attenuation = Attenuation::new(x, y * half,
            z * half * half).expect("coefficients"); [lamp.at(p).intensity(), gray(lamp.at(p).distance() * half)] }
            => { let [_, a, p, _] = c.grid; let mut lamp = c.lamp; lamp.position = a; [lamp.at(p).intensity(),
                gray(lamp.at(p).distance())] };
    }
    true {
        light_is_never_negative: |c| sums(c, &c.arriving()).parts().iter().all(|x| *x >= T::ZERO);
        terms_are_shares: |c| [term::phong(c.n, c.v, c.m), term::blinn(c.n, c.v, c.m), c.hard.factor(c.axis, c.l), c.soft.factor(c.axis,
            c.l), c.soft.smoothstep().factor(c.axis, c.l)].into_iter().all(is_share);
        falloff_never_rises: |c| { let [a, b, k] = c.falloff.coefficients(); let q = c.q;
            [[attenuation(a, b, k, q), attenuation(above(a), b, k, q), attenuation(above(a) + c.x, b, k, q)], [attenuation(a, b, k, q),
            attenuation(a, above(b), k, q), attenuation(a, above(b) + c.x, k, q)], [attenuation(a, b, k, q),
            attenuation(a, b, above(k), q), attenuation(a, b, above(k) + c.x, q)]].iter().all(|values| in_order(values)) };
        falloff_never_rises_with_distance: |c| [c.falloff, c.ranged, c.gltf(), c.ranged.clamped()].iter().all(|f|
            in_order(&[c.q, above(c.q), above(c.q) + c.x].map(|q| f.at(q))));
        a_range_never_brightens: |c| c.ranged.at(c.q) <= c.falloff.at(c.q) && c.gltf().at(c.q) <= c.falloff.at(c.q);
        distance_does_not_overflow: |c| [c.lamp.at(c.p), c.far.at(c.a), c.sun.at(c.b)].iter().all(|light| light.distance() >= T::ZERO
            && light.distance() <= T::MAX);
        a_power_rises_with_its_cosine: |c| [0, 1, 2, 3, 8, 33, 100].iter().all(|&m| {
            let (x, y) = (c.x.at_most(c.y), c.x.at_least(c.y)); m.raise(x) <= m.raise(y) && m.raise(x) <= m.raise(above(x)) });
        a_wider_cone_never_darkens: |c| { let [inner, outer] = c.soft.cosines(); let [wide, narrow] = [outer, inner]
            .map(|x| Cone::from_cosine(x).expect("a cosine")); narrow.factor(c.axis, c.l) <= c.soft.factor(c.axis, c.l)
            && c.soft.factor(c.axis, c.l) <= wide.factor(c.axis, c.l) };
        facing_faces: |c| { let f = normal::facing(c.n, c.v); f.dot(c.v) >= T::ZERO && (f == c.n || f == -c.n) };
        a_lamp_at_p_adds_nothing: |c| is_black(c, c.lamp.at(c.a)) && is_black(c, c.spot.at(c.b));
        selection: |c| { let [p, z, n] = [T::of(T::SMALLEST), T::ZERO, -T::of(T::SMALLEST)]; let is = |x: T| x.above(T::ZERO).any();
            let pick = |x: T| x.above(T::ZERO).select(c.x, c.y); is(p) && !is(z) && !is(n) && !is(-z) && pick(p) == c.x
            && pick(z) == c.y && pick(n) == c.y };
        order: |c| (c.x < c.y) == (c.x.exact() < c.y.exact()) && T::MAX > c.x && -T::MAX < c.x && T::ZERO < T::ONE;
        a_cast_to_f64_and_back: |c| { let there = c.cast(T::exact); let back = there.cast(T::of); format!("{:?}{:?}", c.arriving(),
            c.falloff) == format!("{:?}{:?}", back.arriving(), back.falloff) };
    }
}
