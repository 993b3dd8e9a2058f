//! What the pages say of input that is not valid: negative light, and directions that are not of length 1.

use kit::Float;
use shading::{
    Attenuation, DirectionalLight, IncidentLight, Material, PointLight, Rgb, UnitVec3, Vec3, shade,
};

kit::for_f32_and_f64!(
    negative_light_subtracts,
    a_short_normal_dims_the_highlight,
    a_light_that_is_nearer_may_count_as_behind,
);

fn sun<T: Float>(intensity: T) -> IncidentLight<T> {
    let (l, intensity) = (UnitVec3::Z, Rgb::gray(intensity));
    DirectionalLight { l, intensity }.into()
}

fn material<T: Float>(k: f64) -> Material<T> {
    let [k_a, k_d, k_s] = [Rgb::gray(T::of(k)); 3];
    Material {
        k_a,
        k_d,
        k_s,
        m: 32,
    }
}

fn negative_light_subtracts<T: Float>() {
    let diffuse = |k: f64, lights: &[T]| {
        let lights = lights.iter().map(|i| sun(*i));
        shade::lambert(UnitVec3::Z, &material(k), Rgb::BLACK, lights)
            .diffuse
            .r
    };
    assert_eq!(diffuse(0.5, &[T::of(3.0), T::NEG_ONE]), T::ONE);
    assert_eq!(diffuse(0.5, &[T::MAX, T::MAX]), T::MAX / T::of(2.0));
    assert_eq!(diffuse(2.0, &[-T::MAX]), -T::INFINITY);
    assert_eq!(diffuse(1.0, &[-T::MAX, -T::MAX]), -T::INFINITY);
}

/// 0.9³² = 0.0343
fn a_short_normal_dims_the_highlight<T: Float>() {
    let n = UnitVec3::assume_unit(Vec3::new(T::ZERO, T::ZERO, T::of(0.9)));
    let shaded = shade::blinn_phong(n, UnitVec3::Z, &material(1.0), Rgb::BLACK, [sun(T::ONE)]);
    assert!((shaded.specular.r.into() - 0.0343).abs() < 1e-4);
    assert!((shaded.diffuse.r.into() - 0.9).abs() < 1e-6);
}

/// N·L is 0.4, and 0.4 of the least number rounds to 0.
fn a_light_that_is_nearer_may_count_as_behind<T: Float>() {
    let n = Vec3::from([0.0, 0.917, 0.4].map(T::of))
        .unit()
        .expect("not 0");
    let lamp = PointLight {
        position: Vec3::new(T::ZERO, T::ZERO, T::of(T::TINIEST)),
        intensity: Rgb::WHITE,
        attenuation: Attenuation::NONE,
    };
    let incident = lamp.at(Vec3::ZERO);
    assert!(n.dot(incident.l()) > T::of(0.39));
    assert!(!incident.is_in_front(n));
}
