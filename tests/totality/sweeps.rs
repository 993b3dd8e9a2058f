//! What holds of too many arguments for a row.

use std::f64::consts::PI;

use kit::random::Random;
use kit::{Float, direction};
use proptest::prelude::*;
use shading::{Attenuation, Cone, Dual, Real, UnitVec3, Vec3, normal};

kit::for_f32_and_f64!(
    a_diagonal_is_exact_at_any_size,
    a_constant_has_the_bits_of_the_generic_value,
    a_constant_cone_has_the_bits_of_the_generic_one,
    cones_of_every_angle_are_right_and_in_order,
    a_cone_of_zero_lights_its_axis_and_one_of_pi_everything,
    an_edge_of_no_width_is_hard,
    collapsed_edges_of_the_teapot_have_no_normal,
    a_cone_never_falls_as_l_turns_toward_its_axis,
);

/// 2² + 3² + 6² = 7²: no step rounds, from the smallest number to the largest whose sevenfold is finite.
fn a_diagonal_is_exact_at_any_size<T: Float>() {
    let [two, three, six, seven] = [2.0, 3.0, 6.0, 7.0].map(T::of);
    let mut size = T::of(T::TINIEST);
    while size * seven <= T::MAX {
        let sides = Vec3::new(size * two, -size * three, size * six);
        assert_eq!(sides.length(), size * seven, "{size:e}");
        size = size * two;
    }
}

/// The constructors that work in constants, behind one name for both floats.
trait Constants: Float {
    /// By three coefficients, and by a range in place of glTF's.
    fn attenuation(abc: [Self; 3], r: Self) -> [Option<Attenuation<Self>>; 2];
    fn half_angles(inner: Self, outer: Self) -> Option<Cone<Self>>;
}

/// With a range as glTF has it, which another range replaces.
fn ended<T: Float>(some: Option<Attenuation<T>>) -> Attenuation<T> {
    some.and_then(|some| some.within_gltf(T::ONE))
        .unwrap_or(Attenuation::NONE)
}

macro_rules! constants {
    ($($float:ident)*) => {$(
        impl Constants for $float {
            fn attenuation([a, b, c]: [Self; 3], r: Self) -> [Option<Attenuation<Self>>; 2] {
                let some = Attenuation::<$float>::const_new(a, b, c);
                [some, ended(some).const_within(r)]
            }
            fn half_angles(inner: Self, outer: Self) -> Option<Cone<Self>> {
                Cone::<$float>::const_from_half_angles(inner, outer)
            }
        }
    )*};
}

constants!(f32 f64);

/// A number at which a constructor decides, next to one, or any other; some of them of any size.
fn number<T: Float>() -> impl Strategy<Value = T> {
    let decisive = [0.0, -0.0, 1.0, -1.0, 0.5, PI, T::TINIEST, T::MAX.into()];
    let decisive = prop::sample::select([&decisive[..], &[f64::INFINITY, f64::NAN]].concat());
    let size = T::TINIEST.log2()..Into::<f64>::into(T::MAX).log2();
    prop_oneof![
        2 => (decisive, -2..=2).prop_map(|(x, k)| T::of(x * (1.0 + f64::from(k) * T::U))),
        2 => (-2.0..2.0_f64).prop_map(T::of),
        1 => (-2.0..2.0_f64, size).prop_map(|(x, size)| T::of(x * size.floor().exp2())),
    ]
}

fn a_constant_has_the_bits_of_the_generic_value<T: Constants>() {
    let config = ProptestConfig {
        cases: 4000,
        failure_persistence: None,
        ..<_>::default()
    };
    proptest!(config, |([a, b, c] in [number::<T>(), number(), number()])| {
        // as text, which tells −0 from 0
        let some = Attenuation::new(a, b, c);
        let generic = [some, ended(some).within(a)];
        prop_assert_eq!(format!("{generic:?}"), format!("{:?}", T::attenuation([a, b, c], a)));
        let generic = Cone::from_half_angles(a, b);
        prop_assert_eq!(format!("{generic:?}"), format!("{:?}", T::half_angles(a, b)));
        // a vector of length 1, or nearly 1, keeps its bits
        let v = Vec3::new(a, b, c);
        let u = v.unit().map_or(v, |u| *u);
        for v in [v, u, u * T::of(1.0 + 4.0 * T::U)] {
            let generic = UnitVec3::new(v.x, v.y, v.z);
            prop_assert_eq!(format!("{generic:?}"), format!("{:?}", T::const_unit(v)));
        }
    });
}

/// Angles of any size and their neighbors; those next to where the series changes, and to the ends; and on
/// from where the two cosines of a step differ most from their exact difference, to where rounding is the
/// hardest.
fn a_constant_cone_has_the_bits_of_the_generic_one<T: Constants>() {
    let compare = |angle: T| {
        let [constant, generic] = [T::half_angles(angle, angle), Cone::from_half_angle(angle)];
        assert_eq!(format!("{constant:?}"), format!("{generic:?}"), "{angle:e}");
        generic.map_or(0.0, |cone| {
            let [cosine, _] = cone.cosines();
            (Into::<f64>::into(cosine) - Into::<f64>::into(angle).cos()).abs()
        })
    };
    for quarters in 0..=4 {
        for k in -4000..4000 {
            let end = f64::from(quarters) * PI / 4.0;
            compare(T::of(end * (1.0 + f64::from(k) * T::U)));
            compare(T::of(f64::from(k) * T::U));
        }
    }
    let mut random = Random(1);
    for _ in 0..60 {
        let mut angle = T::of(PI) * T::of(random.fraction());
        let mut highest = compare(angle);
        for _ in 0..2000 {
            let size = (-52.0 * random.fraction()).exp2();
            let next = T::of(Into::<f64>::into(angle) + size * random.signed());
            let error = compare(next);
            if error > highest {
                (angle, highest) = (next, error);
            }
        }
    }
}

/// 2¹³ consecutive angles down from π and next to π/4, where rounding swaps cosines, and as many spread over
/// the range.
fn angles<T: Float>() -> impl Iterator<Item = T> {
    let pi: f64 = T::of(PI).into(); // π rounds up in f32, and is still the last angle
    let below = |end: f64| (0..1 << 13).map(move |k| end * (1.0 - f64::from(k) * T::U));
    let throughout = (0..=1 << 13).map(move |k| pi * (f64::from(k) / f64::from(1 << 13)));
    below(pi).chain(below(0.7861)).chain(throughout).map(T::of)
}

/// Compared with the cosine of the standard library in `f64`, which is right to one unit in its last place.
///
/// In the middle, the crate computes a sine of at most 0.71: its argument rounds by ½u of itself and of the
/// rest of π/2, the second term of the series, of at most 0.11, is off by 2u of itself, and two additions
/// round by ½u: 1.5u in all. Elsewhere, it computes 1 − y²/2 (…) with y²/2 of at most 0.31: the square
/// rounds by ½u of 0.62, which counts half, the argument by ½u, which counts 0.56 times, and the difference
/// by ½u: 1.4u. At the ends, the error may be 4ε = 8u.
fn cones_of_every_angle_are_right_and_in_order<T: Constants>() {
    for angle in angles::<T>() {
        let next = T::of(Into::<f64>::into(angle) * (1.0 + 1.01 * T::U)).at_most(T::of(PI));
        let expected = Into::<f64>::into(angle).cos();
        let units = if expected.abs() > 1.0 - 9.0 * T::U {
            8.0
        } else {
            1.5
        };
        let tolerance = units * T::U + f64::EPSILON / 2.0;
        for cone in [
            T::half_angles(angle, next),
            Cone::from_half_angles(angle, next),
        ] {
            let cone = cone.expect("within π");
            let [inner, outer] = cone.cosines();
            assert!(inner >= outer, "{angle:e}");
            assert!(
                (Into::<f64>::into(inner) - expected).abs() <= tolerance,
                "{angle:e}"
            );
            assert_eq!(cone.factor(UnitVec3::NEG_Z, UnitVec3::Z), T::ONE);
        }
    }
}

fn a_cone_of_zero_lights_its_axis_and_one_of_pi_everything<T: Constants>() {
    let both = |angle: T, cosine: T| {
        [
            T::half_angles(angle, angle),
            Cone::from_half_angle(angle),
            Cone::from_cosine(cosine),
        ]
        .map(|cone| cone.expect("a cone"))
    };
    let (narrow, whole) = (both(T::ZERO, T::ONE), both(T::of(PI), -T::ONE));
    for (x, y) in (1..100).flat_map(|x| (1..100).map(move |y| (x, y))) {
        // rounding makes |d|² up to 1.0000002
        let d = direction::<T>([f64::from(x), f64::from(y), 7.0]);
        assert_eq!(narrow.map(|cone| cone.factor(d, -d)), [T::ONE; 3], "{d:?}");
        assert_eq!(whole.map(|cone| cone.factor(d, d)), [T::ONE; 3], "{d:?}");
    }
    let aside = direction::<T>([-1.0, 0.01, 0.0]);
    assert_eq!(
        narrow.map(|cone| cone.factor(UnitVec3::X, aside)),
        [T::ZERO; 3]
    );
    // two directions that `UnitVec3::new` takes, with a dot product of 1 + 5ε
    let pair = if T::NAME == "f32" {
        [
            [0.747_156_8, 0.653_168_3, -0.122_997_6],
            [0.747_156_7, 0.653_168_44, -0.122_997_58],
        ]
    } else {
        let x = [
            -0.592_000_376_987_278,
            0.630_671_241_983_182,
            0.501_786_147_858_141_1,
        ];
        [
            x,
            [
                -0.592_000_376_987_278_6,
                0.630_671_241_983_182_1,
                0.501_786_147_858_140_5,
            ],
        ]
    };
    let [a, b] = pair
        .map(|d| d.map(T::of))
        .map(|[x, y, z]| UnitVec3::new(x, y, z).expect("unit"));
    assert_eq!(whole.map(|cone| cone.factor(a, b)), [T::ONE; 3]);
}

/// Every 2⁻⁸ of the cosines, on the edge and next to it.
fn an_edge_of_no_width_is_hard<T: Float>() {
    for edge in (-256..=256).map(|k| T::of(f64::from(k) / 256.0)) {
        let cone = Cone::from_cosine(edge).expect("a cosine");
        let [stored, outer] = cone.cosines();
        assert_eq!(stored, outer);
        for units in [-2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0] {
            let cosine = stored + T::of(units * T::U);
            let l = UnitVec3::assume_unit(Vec3::new(T::ZERO, T::ZERO, cosine));
            let is_lit = cosine >= stored || edge < T::of(-1.0 + 8.0 * T::U);
            let expected = if is_lit { T::ONE } else { T::ZERO };
            for cone in [cone, cone.smoothstep()] {
                assert_eq!(
                    cone.factor(UnitVec3::NEG_Z, l),
                    expected,
                    "{edge:e} {cosine:e}"
                );
            }
        }
    }
}

/// A bicubic Bézier patch: two of its corners coincide in the teapot's lid and bottom. In exact
/// arithmetic the derivatives of the weights along such an edge add up to 0.
fn bezier<T: Real>(control: &[[[f64; 3]; 4]; 4], far: f64, u: T, v: T) -> Vec3<T> {
    let line = |mut points: [Vec3<T>; 4], t| {
        for count in [3, 2, 1] {
            for i in 0..count {
                points[i] = points[i] + (points[i + 1] - points[i]) * t;
            }
        }
        points[0]
    };
    let point = |xyz: [f64; 3]| Vec3::from(xyz).map(|c| T::of(c + far));
    line(control.map(|row| line(row.map(point), u)), v)
}

/// The same patch as a sum over Bernstein polynomials.
fn bernstein<T: Real>(control: &[[[f64; 3]; 4]; 4], u: T, v: T) -> Vec3<T> {
    let weights = |t: T| {
        let (s, three) = (T::ONE - t, T::of(3.0));
        [s * s * s, three * s * s * t, three * s * t * t, t * t * t]
    };
    let (along_u, along_v) = (weights(u), weights(v));
    let all = (0..16).map(|i| (control[i / 4][i % 4], along_u[i % 4] * along_v[i / 4]));
    all.map(|(point, weight)| Vec3::from(point).map(T::of) * weight)
        .sum()
}

/// A quarter of the teapot's lid (Newell, 1975), whose first row is the knob's tip.
const LID: [[[f64; 3]; 4]; 4] = [
    [[0.0, 0.0, 3.15]; 4],
    [
        [0.8, 0.0, 3.15],
        [0.8, -0.45, 3.15],
        [0.45, -0.8, 3.15],
        [0.0, -0.8, 3.15],
    ],
    [[0.0, 0.0, 2.85]; 4],
    [
        [0.2, 0.0, 2.7],
        [0.2, -0.112, 2.7],
        [0.112, -0.2, 2.7],
        [0.0, -0.2, 2.7],
    ],
];

fn collapsed_edges_of_the_teapot_have_no_normal<T: Float>() {
    for k in 0..=997 {
        let u = T::of(f64::from(k) / 997.0);
        let normals = [
            normal::parametric(|u, v| bernstein(&LID, u, v), u, T::ZERO),
            normal::parametric(|v, u| bernstein(&LID, u, v), T::ZERO, u),
            normal::parametric(|u, v| bezier(&LID, 0.0, u, v), u, T::ZERO),
            normal::parametric(|u, v| bezier(&LID, 1e3, u, v), u, T::ZERO),
        ];
        assert_eq!(normals, [None; 4], "{u:e}");
        let inside = normal::parametric(|u, v: Dual<T>| bezier(&LID, 0.0, u, v), u, T::of(0.25));
        assert!(inside.is_some(), "{u:e}");
    }
}

/// As far as the cosine tells: with the cosine of the two directions, the factor does not fall.
fn a_cone_never_falls_as_l_turns_toward_its_axis<T: Float>() {
    let cones = [
        [0.999_999_5, 0.945_790_35],
        [0.9, 0.5],
        [0.5, 0.499_999],
        [1.0, -1.0],
    ]
    .map(|edges| edges.map(T::of))
    .map(|[inner, outer]| Cone::from_cosines(inner, outer).expect("an edge"));
    for cone in cones {
        let [inner, outer] = cone.cosines().map(Into::<f64>::into);
        let mut last = [T::ZERO; 2];
        for k in 0..=4096 {
            let cosine = outer + (inner - outer) * f64::from(k) / 4096.0;
            let l = UnitVec3::assume_unit(Vec3::new(T::ZERO, T::ZERO, T::of(cosine)));
            let [hard, smooth] = [cone, cone.smoothstep()].map(|c| c.factor(UnitVec3::NEG_Z, l));
            let slack = T::ONE - T::of(2.0 * T::U); // one unit in the last place, of a smoothstep
            assert!(hard >= last[0] && smooth >= last[1] * slack, "{cosine}");
            last = [hard, smooth];
        }
        assert_eq!(last[0], T::ONE);
    }
}
