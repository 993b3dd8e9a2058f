//! A hard spotlight next to two with a soft edge.

use std::f32::consts::PI;

use shading::{Attenuation, PointLight, Rgb, SoftCone, SpotLight, UnitVec3, Vec3};

use super::{Picture, empty, glossy, matte, tiles};
use crate::render::ray::Camera;
use crate::render::scene::{Backdrop, Object, Scene, SoftLight};
use crate::render::shape::{Plane, Sphere};

pub fn pictures() -> Vec<Picture> {
    vec![Picture::new(
        "24_soft_spot",
        &["a hard edge", "squared: glTF", "smoothstep: three.js"],
        downlights(),
    )]
}

/// Three lamps in front of a wall. All have the same outer half-angle.
fn downlights() -> Scene {
    const OUTER: f32 = PI / 9.0;
    const INNER: f32 = PI / 30.0;
    let camera = Camera::perspective([0.0, 1.5, 9.6], [0.0, 1.13, 0.0], 20.5);
    let wall = Plane::new(0.0, 0.0, 1.0, 0.5).expect("it has a normal");
    let plaster = |value| matte(Rgb::new(value, 0.95 * value, 0.88 * value));
    let mut scene = Scene {
        objects: vec![
            tiles(plaster(0.5), plaster(0.4)),
            Object::new(wall, plaster(0.62)),
        ],
        ambient: Rgb::gray(0.035),
        ..empty(camera, Backdrop::BLACK)
    };
    let [hard, soft] = [OUTER, INNER]
        .map(|inner| SoftCone::<f32>::from_half_angles(inner, OUTER).expect("inner ≤ outer"));
    let cones = [(-1.55, hard), (0.0, soft), (1.55, soft.smoothstep())];
    for (x, cone) in cones {
        let position = Vec3::new(x, 2.55, 0.05);
        scene.soft_lights.push(downlight(position, cone));
        scene.objects.extend([
            Object::new(
                Sphere::new([x, 0.32, 0.1], 0.32),
                glossy(Rgb::new(0.55, 0.12, 0.07), 0.4, 60),
            ),
            Object::glowing(
                Sphere {
                    center: position,
                    radius: 0.06,
                },
                Rgb::new(1.0, 0.95, 0.85),
            ),
        ]);
    }
    scene
}

fn downlight(position: Vec3<f32>, cone: SoftCone<f32>) -> SoftLight {
    let point = PointLight {
        position,
        intensity: Rgb::new(4.4, 3.9, 3.1),
        attenuation: Attenuation::<f32>::new(1.0, 0.0, 0.4).expect("coefficients"),
    };
    let axis = UnitVec3::<f32>::normalized(0.0, -1.0, -0.1).expect("a direction");
    SpotLight { point, axis, cone }.into()
}
