//! The effect of the coefficients of 1/(a + bq + cq²).

use shading::{Attenuation, Light, PointLight, Rgb, Vec3};

use super::{Picture, empty, glossy, matte, tiles};
use crate::render::ray::Camera;
use crate::render::scene::{Backdrop, Grid, Object, Scene};
use crate::render::shape::{Plane, Sphere};

pub fn pictures() -> Vec<Picture> {
    vec![Picture::new(
        "15_attenuation",
        &["from the top: 1, 1/(0.5 q), 1/(0.25 q\u{b2})"],
        strips(),
    )]
}

/// One lamp and three attenuations: from the top, constant, linear, and quadratic. All are the same
/// at a distance of 2.
fn strips() -> Grid<Scene> {
    let coefficients = [
        Attenuation::<f32>::new(1.0, 0.0, 0.0),
        Attenuation::<f32>::new(0.0, 0.5, 0.0),
        Attenuation::<f32>::new(0.0, 0.0, 0.25),
    ];
    Grid {
        columns: 1,
        cells: coefficients.into_iter().flatten().map(strip).collect(),
    }
}

/// A row of balls that leads away from the lamp, with one ball per unit.
fn strip(attenuation: Attenuation<f32>) -> Scene {
    let camera = Camera::perspective([3.7, 2.4, 12.0], [3.7, 0.72, 0.0], 10.6);
    let gray = |value| matte(Rgb::new(value, 0.98 * value, 0.95 * value));
    let wall = Plane::new(0.0, 0.0, 1.0, 1.4).expect("it has a normal");
    let lamp = Vec3::new(-0.1, 1.3, 1.2);
    let mut objects = vec![tiles(gray(0.42), gray(0.34)), Object::new(wall, gray(0.36))];
    objects.extend((0..8).map(|i| {
        let center = [0.5 + i as f32, 0.27, 0.0];
        let blue = Rgb::new(0.1, 0.3, 0.6);
        Object::new(Sphere::new(center, 0.27), glossy(blue, 0.3, 40))
    }));
    let shape = Sphere {
        center: lamp,
        radius: 0.07,
    };
    objects.push(Object::glowing(shape, Rgb::new(1.0, 0.95, 0.85)));
    Scene {
        objects,
        lights: vec![Light::Point(PointLight {
            position: lamp,
            intensity: Rgb::new(0.85, 0.79, 0.68),
            attenuation,
        })],
        ambient: Rgb::gray(0.03),
        ..empty(camera, Backdrop::BLACK)
    }
}
