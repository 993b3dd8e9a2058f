//! Points and angles at the limits of the number types.

use std::f64::consts::FRAC_1_SQRT_2;

use shading::{Attenuation, Cone, PointLight, Rgb, UnitVec3, Vec3, normal};
use support::number::{Float, for_f32_and_f64};

for_f32_and_f64!(
    a_triangle_whose_edges_overflow_has_its_normal,
    a_tiny_triangle_far_out_has_its_normal,
    a_sphere_whose_diameter_overflows_has_its_normal,
    a_light_at_an_overflowing_distance_shines,
    the_cone_of_pi_is_everything,
    the_cone_of_half_pi_ends_at_the_horizon,
    a_soft_edge_between_two_zeros_is_hard,
    every_half_angle_up_to_pi_is_a_cone,
    cosines_of_half_angles_are_right,
    a_sample_of_any_length_is_the_same_normal,
    a_light_is_left_out_where_rounding_cannot_matter,
);

fn a_triangle_whose_edges_overflow_has_its_normal<T: Float>() {
    // both edges overflow: they are (2, 0, 0) and (1, 1, 0) times the largest number
    let [a, b, c] = [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
        .map(|v| Vec3::from(v).map(T::of) * T::MAX);
    assert_eq!(normal::triangle(a, b, c), Some(UnitVec3::Z));
    assert_eq!(normal::triangle(a, c, b), Some(-UnitVec3::Z));
    // only one coordinate of one edge overflows
    let near = Vec3::new(-T::MAX, T::ONE, T::ZERO);
    assert_eq!(normal::triangle(a, b, near), Some(UnitVec3::Z));
}

fn a_tiny_triangle_far_out_has_its_normal<T: Float>() {
    // x is the largest number in all three vertices, and the edges are subnormal
    let tiny = T::of(T::TINIEST);
    let a = Vec3::new(T::MAX, T::ZERO, T::ZERO);
    let b = Vec3::new(T::MAX, tiny, T::ZERO);
    let c = Vec3::new(T::MAX, T::ZERO, tiny);
    assert_eq!(normal::triangle(a, b, c), Some(UnitVec3::X));
    assert_eq!(normal::triangle(a, a, a), None);
}

fn a_sphere_whose_diameter_overflows_has_its_normal<T: Float>() {
    let [west, east] = [-T::MAX, T::MAX].map(|x| Vec3::new(x, T::ZERO, T::ZERO));
    assert_eq!(normal::sphere(west, east), Some(UnitVec3::X));
    assert_eq!(normal::sphere(east, west), Some(-UnitVec3::X));
}

fn a_light_at_an_overflowing_distance_shines<T: Float>() {
    let [west, east] = [-T::MAX, T::MAX].map(|x| Vec3::new(x, T::ZERO, T::ZERO));
    let light = |attenuation| PointLight {
        position: east,
        intensity: Rgb::WHITE,
        attenuation,
    };
    let constant = light(Attenuation::NONE).at(west);
    assert_eq!((constant.l, constant.intensity), (UnitVec3::X, Rgb::WHITE));
    // the distance counts as the largest number: 1/q² is 0, and 1/(q/MAX) is 1
    let inverse_square = Attenuation::of(T::ZERO, T::ZERO, T::ONE).expect("coefficients");
    assert_eq!(light(inverse_square).at(west).intensity, Rgb::BLACK);
}

/// −0 is not below 0, so it may be the inner cosine; the width of such an edge is −0.
fn a_soft_edge_between_two_zeros_is_hard<T: Float>() {
    let tiny = T::of(T::TINIEST);
    let zeros = [T::ZERO, -T::ZERO];
    for (inner, outer) in zeros.into_iter().flat_map(|a| zeros.map(|b| (a, b))) {
        let cone = Cone::of_cosines(inner, outer).expect("an edge");
        for (cosine, factor) in [(-tiny, T::ZERO), (T::ZERO, T::ONE), (tiny, T::ONE)] {
            let l = UnitVec3::assume_unit(Vec3::new(cosine, T::ZERO, T::ONE));
            for cone in [cone, cone.smoothstep()] {
                assert_eq!(
                    cone.factor(UnitVec3::NEG_X, l),
                    factor,
                    "{inner:?} {outer:?}"
                );
            }
        }
    }
}

fn the_cone_of_pi_is_everything<T: Float>() {
    // two directions that `UnitVec3::new` takes, with a dot product of 1 + 5ε
    let too_long = if T::NAME == "f32" {
        [
            [0.747_156_8, 0.653_168_3, -0.122_997_6],
            [0.747_156_7, 0.653_168_44, -0.122_997_58],
        ]
    } else {
        [
            [
                -0.592_000_376_987_278,
                0.630_671_241_983_182,
                0.501_786_147_858_141_1,
            ],
            [
                -0.592_000_376_987_278_6,
                0.630_671_241_983_182_1,
                0.501_786_147_858_140_5,
            ],
        ]
    };
    let [a, b] = too_long
        .map(|d| d.map(T::of))
        .map(|[x, y, z]| UnitVec3::of(x, y, z).expect("a direction"));
    let whole = [
        T::cone(180.0).expect("π"),
        Cone::of_cosines(-T::ONE, -T::ONE).expect("−1"),
    ];
    for cone in whole {
        assert_eq!(cone.cosines()[0], -T::ONE);
        assert_eq!(cone.factor(a, b), T::ONE);
        // opposite to the axis, even where rounding makes |d|² 1.0000002
        for x in 1..100 {
            for y in 1..100 {
                let d = Vec3::new(T::of(f64::from(x)), T::of(f64::from(y)), T::of(7.0));
                let d = d.unit().expect("a direction");
                assert_eq!(cone.factor(d, d), T::ONE, "{d:?}");
            }
        }
    }
}

fn the_cone_of_half_pi_ends_at_the_horizon<T: Float>() {
    // fl(π/2) is below π/2 in f64 and above it in f32; its cosine is the rounding error
    let cone = T::cone(90.0).expect("π/2");
    let expected = if T::NAME == "f32" {
        -4.371_139e-8
    } else {
        6.123_233_995_736_766e-17
    };
    assert_eq!(cone.cosines()[0], T::of(expected));
    assert_eq!(
        Cone::of_cosines(T::ZERO, T::ZERO)
            .expect("0")
            .factor(UnitVec3::X, UnitVec3::Y),
        T::ONE
    );
}

/// 2¹⁶ consecutive angles down from π, and as many spread over the range.
fn angles<T: Float>() -> impl Iterator<Item = T> {
    let pi = T::of(std::f64::consts::PI).to_f64();
    // π rounds up in f32, and is still the last angle
    let from_the_end = (0..1 << 16).map(move |k| pi * (1.0 - f64::from(k) * T::U));
    let throughout = (0..=1 << 16).map(move |k| pi * (f64::from(k) / f64::from(1 << 16)));
    from_the_end.chain(throughout).map(T::of)
}

fn every_half_angle_up_to_pi_is_a_cone<T: Float>() {
    for angle in angles::<T>() {
        assert!(T::half_angles(angle, angle).is_some(), "{angle:e}");
    }
}

/// Compared with the cosine of the standard library in `f64`, which is right to one unit in its
/// last place.
///
/// In the middle, the crate computes a sine of at most 0.71: its argument rounds by ½u, the second
/// term of the series is off by ⅓u, and each of five additions rounds by ½u: 3.4u. Elsewhere, it
/// computes 1 − 2s² with s ≤ 0.39. The argument is off by ½u, which counts 0.71 times. s is off by
/// 0.8u, three additions of ¼u and the error of the second term, which counts 4s times. The square
/// rounds by ¼u and the difference by ½u: 2.4u. At the ends, the error may be 4ε = 8u.
fn cosines_of_half_angles_are_right<T: Float>() {
    for angle in angles::<T>() {
        let cosine = T::half_angles(angle, angle).expect("a cone").cosines()[0].to_f64();
        let expected = angle.to_f64().cos();
        let units = if expected.abs() > 1.0 - 9.0 * T::U {
            8.0
        } else if expected.abs() > FRAC_1_SQRT_2 {
            2.4
        } else {
            3.4
        };
        let tolerance = units * T::U + f64::EPSILON / 2.0;
        assert!(
            (cosine - expected).abs() <= tolerance,
            "{angle:e}: {cosine} for {expected}"
        );
    }
}

/// The length of a sample of a normal map does not matter, to the bit where it changes by a power of
/// two: down to the smallest subnormal numbers, and up to where the sum would overflow.
fn a_sample_of_any_length_is_the_same_normal<T: Float>() {
    let n = Vec3::new(T::of(2.0), T::of(-1.0), T::of(3.0))
        .unit()
        .expect("a direction");
    let tangent = Vec3::new(T::ONE, T::of(4.0), T::of(-2.0));
    let sample = Vec3::new(-T::ONE, T::of(0.75), T::of(0.875));
    let mapped = |sample| normal::mapped(n, tangent, T::ONE, sample);
    let expected = mapped(sample).expect("a normal");
    // ⅛ is the last bit of the sample
    let largest = T::of(T::MAX.to_f64() * 0.5 * (1.0 + 2.0 * T::U)); // a power of two
    for scale in [T::of(8.0 * T::TINIEST), T::of(T::MIN_POSITIVE), largest] {
        assert_eq!(mapped(sample * scale), Some(expected), "{scale:e}");
    }
    // (MAX, MAX, MAX) is along the diagonal, up to rounding
    let [diagonal, huge] = [T::ONE, T::MAX].map(|c| mapped(Vec3::new(c, c, c)).expect("a normal"));
    assert!((*diagonal - *huge).length().to_f64() <= 16.0 * T::U);
}

/// Below the horizon, a light is kept up to 2⁻⁹ of |x| + |y| + |z|, where the rounding of a number
/// with 12 bits may matter, and up to 1/`EXTREME`, where products lose bits. From there on it is left
/// out.
fn a_light_is_left_out_where_rounding_cannot_matter<T: Float>() {
    let is_kept = |x: T, y: T, z: T| {
        let lamp = PointLight {
            position: Vec3::new(x, y, z),
            intensity: Rgb::WHITE,
            attenuation: Attenuation::NONE,
        };
        lamp.at(Vec3::ZERO).in_front(UnitVec3::Z).is_some()
    };
    // the height h is kept for h ≤ (1 + h)/512, that is, h ≤ 1/511
    for (height, kept) in [(1.0 / 511.5, true), (1.0 / 510.5, false), (0.5, false)] {
        let z = -T::of(height);
        assert_eq!(is_kept(T::ONE, T::ZERO, z), kept, "{height}");
        assert_eq!(is_kept(T::ZERO, T::ONE, z), kept, "{height}");
    }
    // straight below, h is kept for h ≤ h/512 + 1/EXTREME
    let least = T::ONE / T::EXTREME;
    for (height, kept) in [(1.0, true), (1.001, true), (1.003, false), (2.0, false)] {
        assert_eq!(
            is_kept(T::ZERO, T::ZERO, -T::of(height) * least),
            kept,
            "{height}"
        );
    }
}

/// A scale of each axis by a power of two multiplies each component by the other two, which double
/// precision does without leaving its range. The conditioning is √3 at most. No product rounds here but
/// those with n; with these and 3.5u for the unit vector, 5u is enough.
#[test]
fn scales_of_any_size_transform_a_normal() {
    let n = UnitVec3::<f32>::new(0.48, 0.6, 0.64).expect("length 1");
    let exponents = || (-120..=120).step_by(12);
    for i in exponents() {
        for (j, k) in exponents().flat_map(|j| exponents().map(move |k| (j, k))) {
            let [a, b, c] = [i, j, k].map(|exponent| 2_f64.powi(exponent));
            let [x, y, z] = [n.x, n.y, n.z].map(f64::from);
            let expected = Vec3::new(x * b * c, y * c * a, z * a * b).unit();
            let columns = [*UnitVec3::X * a, *UnitVec3::Y * b, *UnitVec3::Z * c];
            #[allow(clippy::cast_possible_truncation)] // powers of two, which `f32` has
            let columns = columns.map(|column| column.map(|x| x as f32));
            let computed = normal::transformed(n, columns).expect("regular");
            let pairs = <[f32; 3]>::from(computed).into_iter();
            for (c, exact) in pairs.zip(<[f64; 3]>::from(expected.expect("regular"))) {
                let error = (f64::from(c) - exact).abs();
                assert!(error <= 5.0 * 2_f64.powi(-24), "{error:e} {columns:?}");
            }
        }
    }
}

/// Rounding swaps the cosines of some neighboring half-angles, such as 0.78597474 and 0.7859748.
#[test]
fn edges_of_neighboring_angles_are_in_order() {
    for bits in 0.785_f32.to_bits()..0.787_f32.to_bits() {
        let [inner, outer] = [bits, bits + 1].map(f32::from_bits);
        let [in_constants, generic] =
            [Cone::<f32>::from_half_angles, Cone::<f32>::from_half_angles]
                .map(|of| of(inner, outer).expect("half-angles"));
        let cosines = in_constants.cosines();
        assert!(cosines[0] >= cosines[1], "{inner:?} {outer:?}");
        assert_eq!(in_constants, generic);
    }
}

/// As above, for the constructor that works in constants.
#[test]
fn a_constant_soft_edge_between_two_zeros_is_hard() {
    let zeros = [0.0_f32, -0.0];
    for (inner, outer) in zeros.into_iter().flat_map(|a| zeros.map(|b| (a, b))) {
        let cone = Cone::<f32>::from_cosines(inner, outer).expect("an edge");
        for (cosine, factor) in [(-1e-45, 0.0), (0.0, 1.0), (1e-45, 1.0)] {
            let l = UnitVec3::assume_unit(Vec3::new(cosine, 0.0, 1.0));
            assert_eq!(
                cone.factor(UnitVec3::NEG_X, l).to_bits(),
                f32::to_bits(factor)
            );
        }
    }
}
