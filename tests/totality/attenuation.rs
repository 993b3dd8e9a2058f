//! Attenuation and cones.

use shading::{Attenuation, Cone, PointLight, Rgb, UnitVec3, Vec3, attenuation};
use support::number::{Float, direction, for_f32_and_f64};

use crate::{at_x, not_finite};

for_f32_and_f64!(
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
    lights_out_of_range_are_black,
    cone_of_a_nan_direction_gives_one,
);

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
        assert_eq!(T::half_angles(angle, angle), None, "{angle:e}");
    }
    let beyond = T::of(1.0 + 2.0 * T::U);
    for cosine in [beyond, -beyond, T::INFINITY, -T::INFINITY, T::NAN] {
        assert_eq!(Cone::of_cosines(cosine, cosine), None, "{cosine:e}");
    }
}

fn cone_of_zero_lights_its_axis<T: Float>() {
    for cone in [
        T::half_angles(T::ZERO, T::ZERO),
        Cone::of_cosines(T::ONE, T::ONE),
    ] {
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
    let cone = |inner: f64, outer: f64| T::half_angles(T::of(inner), T::of(outer));
    let of_cosines = |inner: f64, outer: f64| Cone::of_cosines(T::of(inner), T::of(outer));
    assert!(cone(0.0, 0.5).is_some() && of_cosines(1.0, 0.5).is_some());
    for [inner, outer] in [[0.5, 0.4], [-0.1, 0.5], [0.5, 3.2], [-0.1, 3.2]] {
        assert_eq!(cone(inner, outer), None);
    }
    for [inner, outer] in [[0.4, 0.5], [1.1, 0.5], [0.5, -1.1]] {
        assert_eq!(of_cosines(inner, outer), None);
    }
    for bad in not_finite::<T>() {
        let good = T::of(0.5);
        assert_eq!(T::half_angles(bad, good), None);
        assert_eq!(T::half_angles(good, bad), None);
        assert_eq!(Cone::of_cosines(bad, good), None);
        assert_eq!(Cone::of_cosines(good, bad), None);
    }
}

fn soft_cone_of_one_angle_is_the_hard_cone<T: Float>() {
    // every 2⁻⁸ radians of the half-circle, on the edge and next to it
    for angle in (0..=804).map(|k| T::of(f64::from(k) / 256.0)) {
        let hard = T::half_angles(angle, angle).expect("below π");
        let soft = T::half_angles(angle, angle).expect("below π");
        assert_eq!(soft.cosines(), [hard.cosines()[0]; 2]);
        let beside = [-1.0, -0.5, 0.0, 0.5, 1.0].map(|k| hard.cosines()[0] + T::of(k * T::U));
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
        let cone = T::half_angles(inner, outer).expect("below π");
        let [inner, outer] = cone.cosines();
        assert!(inner >= outer);
        let factor = cone.factor(-UnitVec3::Z, UnitVec3::Z);
        assert_eq!(factor, T::ONE);
    }
}

fn invalid_range_is_refused_infinity_is_none<T: Float>() {
    for bad in [T::ZERO, -T::ZERO, -T::ONE, -T::INFINITY, T::NAN] {
        assert_eq!(Attenuation::NONE.of_range(bad), None);
    }
    // a range of ∞ is no range, not even at an infinite distance, where the attenuation is 0
    let free = Attenuation::of(T::ONE, T::ZERO, T::of(0.25)).expect("coefficients");
    let ranged = free.of_range(T::INFINITY).expect("no range");
    for q in [T::ZERO, T::of(T::TINIEST), T::of(2.0), T::MAX, T::INFINITY] {
        assert_eq!(ranged.at(q), free.at(q));
        assert_eq!(ranged.unsquared().at(q), free.at(q));
    }
}

fn ranged_attenuation_is_zero_out_of_its_range<T: Float>() {
    // also where the attenuation is infinite, at the smallest range, and for NaN
    let inverse_square = Attenuation::of(T::ZERO, T::ZERO, T::ONE).expect("coefficients");
    for r in [T::of(T::TINIEST), T::ONE, T::MAX / T::of(2.0)] {
        let ranged = inverse_square.of_range(r).expect("above 0");
        for ranged in [ranged, ranged.unsquared()] {
            for q in [r, r + r, T::INFINITY, T::NAN] {
                assert_eq!(ranged.at(q), T::ZERO, "{q:e} of {r:e}");
            }
            // at a distance of 0, all of the light is left
            assert_eq!(ranged.at(T::ZERO), T::MAX);
        }
    }
}

fn lights_out_of_range_are_black<T: Float>() {
    let lamp = |z: T, r: T| PointLight {
        position: Vec3::new(T::ZERO, T::ZERO, z),
        intensity: Rgb::gray(T::MAX),
        attenuation: Attenuation::NONE.of_range(r).expect("above 0"),
    };
    let in_front = |lamp: PointLight<T>| lamp.at(Vec3::ZERO);
    let [small, large] = [T::MIN_POSITIVE.sqrt() / 16.0, T::MAX.to_f64().sqrt() * 16.0].map(T::of);
    assert_eq!(in_front(lamp(T::of(2.0), T::ONE)).intensity, Rgb::BLACK);
    // within the range, even if the square of the distance is 0 or infinite
    for r in [small, T::ONE, large, T::INFINITY] {
        let q = if r.is_finite() {
            r * T::of(0.5)
        } else {
            T::ONE
        };
        let incident = in_front(lamp(q, r));
        assert_eq!(incident, lamp(q, r).at(Vec3::ZERO));
        assert!(incident.intensity.r > T::ZERO);
    }
    // out of range, a light that is not left out is black
    for r in [small, large] {
        let incident = in_front(lamp(r + r, r));
        assert!(incident.intensity == Rgb::BLACK);
    }
}

fn cone_of_a_nan_direction_gives_one<T: Float>() {
    let nan = UnitVec3::assume_unit(at_x(T::NAN));
    let cone = T::cone(45.0).expect("a cone");
    assert_eq!(cone.factor(nan, UnitVec3::X), T::ONE);
}
