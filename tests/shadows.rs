//! The distance to a light, where a shadow ray ends.

use shading::{
    Attenuation, DirectionalLight, IncidentLight, Light, PointLight, Rgb, SpotLight, UnitVec3, Vec3,
};
use support::number::{Float, distances, for_f32_and_f64, vector};

for_f32_and_f64!(
    wall_behind_a_lamp_casts_no_shadow,
    any_wall_hides_the_sun,
    distance_is_that_between_the_positions,
    distance_is_right_at_any_size,
    distance_is_never_infinite_or_nan,
);

fn lamp<T: Float>(position: Vec3<T>) -> PointLight<T> {
    PointLight {
        position,
        intensity: Rgb::WHITE,
        attenuation: Attenuation::NONE,
    }
}

/// Each kind of light that has a position, at this one.
fn lamps<T: Float>(position: Vec3<T>) -> [Light<T>; 2] {
    let point = lamp(position);
    let cone = T::cone(180.0).expect("a cone");
    [
        point.into(),
        SpotLight {
            point,
            axis: UnitVec3::Z,
            cone,
        }
        .into(),
    ]
}

/// Whether the wall z = `height` stands between p and the light.
fn is_blocked<T: Float>(p: Vec3<T>, height: f64, light: &IncidentLight<T>) -> bool {
    let t = (T::of(height) - p.z) / light.l.z;
    t > T::ZERO && t < light.distance
}

fn wall_behind_a_lamp_casts_no_shadow<T: Float>() {
    let p = vector::<T>([1.0, 0.0, 0.0]);
    // the lamp is two units to the side and two up: a wall at height 1 is in front of it, one at 3
    // behind it
    for light in lamps(vector([3.0, 0.0, 2.0])) {
        assert!(is_blocked(p, 1.0, &light.at(p)), "{light:?}");
        assert!(!is_blocked(p, 3.0, &light.at(p)), "{light:?}");
        let lit = light.at(p).in_front(UnitVec3::Z).expect("it is in front");
        assert!(!is_blocked(p, 3.0, &lit), "{light:?}");
    }
}

fn any_wall_hides_the_sun<T: Float>() {
    let sun = DirectionalLight::<T> {
        l: UnitVec3::Z,
        intensity: Rgb::WHITE,
    };
    for light in [sun.at(Vec3::ZERO), Light::<T>::from(sun).at(Vec3::ZERO)] {
        assert_eq!(light.distance, T::MAX);
        assert!(is_blocked(Vec3::ZERO, 1e30, &light));
        assert!(!is_blocked(Vec3::ZERO, -1.0, &light));
    }
}

fn distance_is_that_between_the_positions<T: Float>() {
    // 2² + 3² + 6² = 7²
    for light in lamps::<T>(vector([3.0, 1.0, 5.0])) {
        let p = vector([1.0, 4.0, -1.0]);
        assert_eq!(light.at(p).distance, T::of(7.0));
    }
}

fn distance_is_right_at_any_size<T: Float>() {
    for q in distances::<T>() {
        let distance = lamp::<T>(vector([0.0, q, 0.0])).at(Vec3::ZERO).distance;
        assert_eq!(distance, T::of(q));
    }
}

fn distance_is_never_infinite_or_nan<T: Float>() {
    let p = Vec3::new(T::ZERO, T::MAX, T::ZERO);
    // the distance is twice the largest number
    assert_eq!(lamp(-p).at(p).distance, T::MAX);
    // at its own position a light lights nothing
    assert_eq!(lamp(p).at(p).distance, T::MAX);
    for nowhere in [T::INFINITY, -T::INFINITY, T::NAN] {
        let nowhere = Vec3::new(T::ONE, nowhere, T::ZERO);
        assert_eq!(lamp(nowhere).at(p).distance, T::MAX);
        assert_eq!(lamp(p).at(nowhere).distance, T::MAX);
        assert_eq!(lamp(nowhere).at(nowhere).distance, T::MAX);
    }
}
