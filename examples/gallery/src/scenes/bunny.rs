//! Triangles: flat, and smooth with the same triangles.

use shading::{DirectionalLight, Light, Rgb};

use super::{Picture, STUDIO, empty, floor, glossy, matt, towards};
use crate::model::Model;
use crate::render::ray::{Camera, Surface};
use crate::render::scene::{Object, Scene};

const DATA: &str = include_str!("../../data/bunny.obj");

pub fn pictures() -> Vec<Picture> {
    let bunny = Model::parse(DATA).expect("the gallery's own model is in order");
    vec![
        Picture::new(
            "21_bunny_flat",
            &["a normal for each triangle"],
            shown(bunny.flat(), bunny.height),
        ),
        Picture::new(
            "22_bunny_smooth",
            &["a normal for each vertex"],
            shown(bunny.smooth(), bunny.height),
        ),
    ]
}

/// A model of the user's.
pub fn model(model: &Model) -> Vec<Picture> {
    vec![
        Picture::new(
            "model_flat",
            &["a normal for each triangle"],
            shown(model.flat(), model.height),
        ),
        Picture::new(
            "model_smooth",
            &["a normal for each vertex"],
            shown(model.smooth(), model.height),
        ),
    ]
}

/// A model of a known height, in the middle of the picture.
fn shown(surface: impl Surface + 'static, height: f32) -> Scene {
    let camera = Camera::perspective([0.0, 2.6, 7.4], [0.0, 0.465 * height, 0.0], 21.0);
    Scene {
        objects: vec![
            floor(matt(Rgb::gray(0.16))),
            Object::new(surface, glossy(Rgb::new(0.45, 0.36, 0.28), 0.2, 15)),
        ],
        lights: vec![
            Light::Directional(DirectionalLight {
                l: towards(-0.8, 0.9, 0.7),
                intensity: Rgb::new(0.95, 0.92, 0.86),
            }),
            Light::Directional(DirectionalLight {
                l: towards(0.8, 1.0, -1.0),
                intensity: Rgb::new(0.14, 0.18, 0.25),
            }),
        ],
        ..empty(camera, STUDIO)
    }
}
