//! Scene files of arbitrary bytes, in JSON, RON, and postcard. Each gives either a complete valid
//! scene, which can be written and read back unchanged, or an error that says where or why.
#![no_main]

use std::str;

use features::Scene;
use libfuzzer_sys::fuzz_target;
use shading::Light;
use shading::f32::UnitVec3;

fuzz_target!(|data: &[u8]| {
    match serde_json::from_slice::<Scene>(data) {
        Ok(scene) => {
            is_valid(&scene);
            let text = serde_json::to_vec(&scene).expect("what was read can be written");
            is_the_same(
                &serde_json::from_slice(&text).expect("it can be read back"),
                &scene,
            );
        }
        Err(error) => assert!(error.line() > 0 && !error.to_string().is_empty()),
    }
    if let Ok(text) = str::from_utf8(data) {
        match ron::from_str::<Scene>(text) {
            Ok(scene) => {
                is_valid(&scene);
                let text = ron::to_string(&scene).expect("what was read can be written");
                is_the_same(&ron::from_str(&text).expect("it can be read back"), &scene);
            }
            Err(error) => assert!(error.span.end.line > 0 && !error.code.to_string().is_empty()),
        }
    }
    if let Ok(scene) = postcard::from_bytes::<Scene>(data) {
        is_valid(&scene);
        let bytes = postcard::to_allocvec(&scene).expect("what was read can be written");
        is_the_same(
            &postcard::from_bytes(&bytes).expect("it can be read back"),
            &scene,
        );
    }
});

/// `{:?}` shows all bits of a finite number.
fn is_the_same(read: &Scene, written: &Scene) {
    assert_eq!(format!("{read:?}"), format!("{written:?}"));
}

/// Checks what the constructors promise for each light, and that all numbers are finite.
fn is_valid(scene: &Scene) {
    let finite = |numbers: &[f32]| assert!(numbers.iter().all(|x| x.is_finite()), "{scene:?}");
    let three = |numbers: [f32; 3]| finite(&numbers);
    let direction = |v: UnitVec3| {
        let (x, y, z) = (f64::from(v.x), f64::from(v.y), f64::from(v.z));
        assert!((x * x + y * y + z * z - 1.0).abs() < 5e-6, "{v:?}");
    };

    three(scene.ambient.into());
    for light in &scene.lights {
        let point = match light {
            Light::Directional(light) => {
                direction(light.l);
                three(light.intensity.into());
                continue;
            }
            Light::Point(point) => point,
            Light::Spot(spot) => {
                direction(spot.axis);
                let [inner, outer] = spot.cone.cosines();
                assert!(-1.0 <= outer && outer <= inner && inner <= 1.0, "{spot:?}");
                &spot.point
            }
        };
        three(point.position.into());
        three(point.intensity.into());
        assert!(point.attenuation.range() > 0.0, "{point:?}");
        let coefficients = point.attenuation.coefficients();
        three(coefficients);
        assert!(coefficients.iter().all(|x| *x >= 0.0) && coefficients != [0.0; 3]);
    }
    for material in &scene.materials {
        for k in [material.k_a, material.k_d, material.k_s] {
            three(k.into());
        }
        finite(&[material.m]);
    }
}
