//! Lights.

use shading::{IncidentLight, PointLight, Rgb, SpotLight, UnitVec3, Vec3, shade};
use support::number::{Float, distances, for_f32_and_f64};

use crate::{at_x, lamp, mirror};

for_f32_and_f64!(
    light_with_an_infinite_coordinate_is_black,
    light_with_a_nan_coordinate_adds_nothing,
    light_at_extreme_distances_has_its_direction,
    light_that_overflows_is_the_largest_number,
    black_light_with_infinite_attenuation_is_black,
    incident_light_of_a_nan_direction_adds_nothing,
);

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
    for q in distances::<T>().map(T::of) {
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
