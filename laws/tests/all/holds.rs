//! Right renderers obey every law.

use shading::{DirectionalLight, Material, PointLight, SpotLight};
use shading_laws::{Laws, Light, Model, Profile, Renderer, Scene, Verdict, from_fn};

use crate::by_hand::renderer;
use crate::profiles;

fn holds(renderer: &mut impl Renderer) {
    let report = Laws::new().cases(500).run(renderer).expect("an answer");
    assert!(report.passes(), "{report}");
}

#[test]
fn a_shader_by_hand_holds() {
    for profile in [
        profiles::linear(),
        profiles::bytes(),
        profiles::clamped(),
        profiles::one_lamp(),
        profiles::sunny(),
    ] {
        holds(&mut renderer(&profile, []));
    }
}

#[test]
fn what_differs_on_purpose_is_no_mistake() {
    holds(&mut renderer(&profiles::of_its_own(), []));
    holds(&mut renderer(&profiles::of_another_kind(), []));
    holds(&mut renderer(&profiles::unlit(), []));
}

macro_rules! of_shading {
    ($float:ident) => {
        /// `shading` itself, in this type.
        fn $float(scene: &Scene) -> [f64; 3] {
            use shading::$float::{Attenuation, Cone, IncidentLight, Rgb, Shaded, UnitVec3, Vec3};

            let cast = |triple: [f64; 3]| triple.map(|c| c as $float);
            let (vector, rgb) = (|v| Vec3::from(cast(v)), |c| Rgb::from(cast(c)));
            let unit = |v| -> UnitVec3 { vector(v).unit().expect("a direction") };
            let p = vector(scene.p);
            let arriving = |light: &Light| -> IncidentLight {
                let point = |position, intensity, attenuation| {
                    let [a, b, c] = cast(attenuation);
                    PointLight {
                        position: vector(position),
                        intensity: rgb(intensity),
                        attenuation: Attenuation::new(a, b, c).expect("coefficients"),
                    }
                };
                match *light {
                    Light::Directional { l, intensity } => DirectionalLight {
                        l: unit(l),
                        intensity: rgb(intensity),
                    }
                    .at(p),
                    Light::Point {
                        position,
                        intensity,
                        attenuation,
                    } => point(position, intensity, attenuation).at(p),
                    Light::Spot {
                        position,
                        intensity,
                        attenuation,
                        axis,
                        half_angle,
                    } => SpotLight {
                        point: point(position, intensity, attenuation),
                        axis: unit(axis),
                        cone: Cone::from_half_angle(half_angle as $float).expect("an angle"),
                    }
                    .at(p),
                }
            };
            let lights = scene.lights.iter().map(arriving);
            let material = Material {
                k_a: rgb(scene.material.k_a),
                k_d: rgb(scene.material.k_d),
                k_s: rgb(scene.material.k_s),
                m: scene.material.m as $float,
            };
            let (n, v, i_a) = (unit(scene.n), unit(scene.v), rgb(scene.i_a));
            let shaded: Shaded = match scene.model {
                Model::Lambert => shading::shade::lambert(n, &material, i_a, lights),
                Model::Phong => shading::shade::phong(n, v, &material, i_a, lights),
                Model::BlinnPhong => shading::shade::blinn_phong(n, v, &material, i_a, lights),
            };
            <[$float; 3]>::from(shaded.total()).map(f64::from)
        }
    };
}

of_shading!(f32);
of_shading!(f64);

fn precise() -> Profile {
    Profile {
        roundoff: f64::EPSILON / 2.0,
        ..profiles::linear()
    }
}

#[test]
fn shading_holds() {
    holds(&mut from_fn(profiles::linear(), f32));
    holds(&mut from_fn(precise(), f64));
}

/// Tolerances follow the precision: what holds for `f32` is broken for `f64`.
#[test]
fn single_precision_is_not_double() {
    let report = Laws::new().run(&mut from_fn(precise(), f32));
    let report = report.expect("an answer");
    let broken = report.laws.iter().filter(|law| law.is_broken());
    let broken: Vec<&str> = broken.map(|law| law.name).collect();
    assert!(broken.contains(&"formula"), "{broken:?}");
    assert!(broken.contains(&"rotation"), "{broken:?}");
}

/// A law that needs what a renderer lacks is listed as not tried.
#[test]
fn what_is_not_tried_has_not_passed() {
    let report = Laws::new()
        .cases(20)
        .run(&mut renderer(&profiles::sunny(), []));
    let report = report.expect("an answer");
    let not_tried = report.laws.iter().filter_map(|law| match law.verdict {
        Verdict::NotTried { because } => Some((law.name, because)),
        _ => None,
    });
    let not_tried: Vec<_> = not_tried.collect();
    assert!(not_tried.contains(&("cone", "it does not have both point and spot lights")));
    assert!(not_tried.contains(&("distance", "it has no point lights")));
    assert!(not_tried.contains(&("wider_cone", "it has no spot lights")));
}
