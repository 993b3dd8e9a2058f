//! Numbers and vectors.

use shading::{
    Attenuation, DirectionalLight, PointLight, Rgb, UnitVec3, Vec3, half_vector, normal,
    reflection, shade,
};
use support::flushing::Flushing;
use support::number::{Float, direction, for_f32_and_f64, vector};

use crate::{at_x, mirror, not_finite};

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
);

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
