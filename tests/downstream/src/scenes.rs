//! Lights, materials, sums of light.

use core::iter::Sum;
use core::ops::{Add, Mul};

use shading::shade::{self, Shaded};
use shading::{
    Attenuation, Cone, DirectionalLight, IncidentLight, Light, Material, PointLight, Ranged, Rgb,
    SoftCone, SpotLight, UnitVec3, Vec3,
};

pub(crate) const SUN: DirectionalLight = DirectionalLight {
    l: UnitVec3::Z,
    intensity: Rgb::WHITE,
};
pub(crate) const LAMP: PointLight = PointLight {
    position: Vec3::new(0.0, 0.0, 2.0),
    intensity: Rgb::WHITE,
    attenuation: Attenuation::<f32>::new(1.0, 0.0, 0.25).unwrap(), // ½ at the origin
};
pub(crate) const SPOT: SpotLight = SpotLight {
    point: LAMP,
    axis: UnitVec3::NEG_Z,
    cone: Cone::<f32>::from_cosine(0.5).unwrap(),
};
pub(crate) const CLAY: Material = Material {
    k_a: Rgb::gray(0.25),
    k_d: Rgb::gray(0.5),
    k_s: Rgb::gray(0.25),
    m: 2,
};

pub fn call() {
    each_light();
    any_light();
    materials();
    sums();
    parts();
}

fn each_light() {
    let (p, n) = (Vec3::ZERO, UnitVec3::Z);
    let DirectionalLight { l, intensity } = SUN;
    let arrives = DirectionalLight::at(&SUN, p);
    assert_eq!((arrives.l, arrives.intensity), (l, intensity));
    assert_eq!(DirectionalLight::in_front(&SUN, p, n), Some(arrives));
    assert_eq!(DirectionalLight::cast(SUN, f64::from).l, UnitVec3::Z);

    let PointLight {
        position,
        intensity,
        attenuation,
    } = LAMP;
    assert_eq!(
        (position.z, intensity, attenuation.at(2.0)),
        (2.0, Rgb::WHITE, 0.5)
    );
    let arrives = PointLight::at(&LAMP, p);
    assert_eq!(PointLight::in_front(&LAMP, p, n), Some(arrives));
    assert_eq!(PointLight::all_in_front(&[LAMP, LAMP], p, n).count(), 2);
    assert_eq!(PointLight::cast(LAMP, f64::from).position.z, 2.0);
    let IncidentLight {
        l,
        intensity,
        distance,
    } = arrives;
    assert_eq!((l, intensity, distance), (n, Rgb::gray(0.5), 2.0));
    assert_eq!(IncidentLight::in_front(arrives, -n), None);
    assert_eq!(IncidentLight::cast(arrives, f64::from).distance, 2.0);

    let SpotLight { point, axis, cone } = SPOT;
    assert_eq!((point, axis, cone.cosine()), (LAMP, UnitVec3::NEG_Z, 0.5));
    assert_eq!(SpotLight::at(&SPOT, p), arrives);
    assert_eq!(SpotLight::in_front(&SPOT, p, n), Some(arrives));
    assert_eq!(SpotLight::cast(SPOT, f64::from).cone.cosine(), 0.5);
}

fn any_light() {
    let (p, n) = (Vec3::ZERO, UnitVec3::Z);
    let lights = [
        <Light as From<DirectionalLight>>::from(SUN),
        <Light as From<PointLight>>::from(LAMP),
        <Light as From<SpotLight>>::from(SPOT),
    ];
    for light in lights {
        let one = match light {
            Light::Directional(sun) => sun.at(p),
            Light::Point(lamp) => lamp.at(p),
            Light::Spot(spot) => spot.at(p),
        };
        assert_eq!(Light::at(&light, p), one);
        assert_eq!(Light::in_front(&light, p, n), Some(one));
        assert_eq!(Light::cast(light, f64::from).at(Vec3::ZERO).l, UnitVec3::Z);
    }
    assert_eq!(Light::all_in_front(&lights, p, n).count(), 3);
    let wide = lights.map(<Light<f32, SoftCone, Ranged> as From<Light>>::from);
    assert_eq!(
        wide.map(|light| light.at(p)),
        lights.map(|light| light.at(p))
    );
    let sun = <IncidentLight as From<DirectionalLight>>::from(SUN);
    assert_eq!(sun, SUN.at(p));
}

fn materials() {
    let Material { k_a, k_d, k_s, m } = CLAY;
    assert_eq!((k_a + k_d + k_s, m), (Rgb::WHITE, 2));
    assert_eq!(Material::cast(CLAY, f64::from).k_d, Rgb::gray(0.5));
}

fn sums() {
    let z = UnitVec3::Z; // N = L = V: all of the sun's light, and all of the highlight
    let lights = || [SUN.at(Vec3::ZERO)];
    let diffuse = shade::lambert(z, &CLAY, Rgb::WHITE, lights());
    assert_eq!(Shaded::total(diffuse), Rgb::gray(0.75));
    for shiny in [
        shade::phong(z, z, &CLAY, Rgb::WHITE, lights()),
        shade::blinn_phong(z, z, &CLAY, Rgb::WHITE, lights()),
    ] {
        assert_eq!(Shaded::total(shiny), Rgb::WHITE);
    }
}

fn parts() {
    let none = <Shaded as Default>::default();
    let Shaded {
        ambient,
        diffuse,
        specular,
    } = none;
    assert_eq!([ambient, diffuse, specular], [Rgb::BLACK; 3]);
    let lit = Shaded {
        ambient: Rgb::WHITE,
        ..none
    };
    assert_eq!(<Shaded as Add>::add(lit, none), lit);
    assert_eq!(<Shaded as Mul<f32>>::mul(lit, 0.5).ambient, Rgb::gray(0.5));
    assert_eq!(<Shaded as Sum>::sum([lit, none].into_iter()), lit);
}
