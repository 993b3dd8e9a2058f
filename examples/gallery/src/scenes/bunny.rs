//! Triangles: flat shading and smooth shading of the same mesh.

use shading::{DirectionalLight, Light, Rgb, normal};

use super::{Picture, STUDIO, empty, floor, glossy, matte, toward};
use crate::model::Model;
use crate::render::mesh::Share;
use crate::render::ray::{Camera, Surface};
use crate::render::scene::{Grid, Object, Scene};

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
        Picture::new(
            "23_bunny_by_weights",
            &[
                "flat",
                "by area",
                "by Max's weights",
                "by angle: normal::corner",
            ],
            weights(&bunny),
        )
        .strip(),
    ]
}

/// Vertex normals with three kinds of weights, next to the flat triangles.
fn weights(bunny: &Model) -> Grid<Scene> {
    let by_area: Share = |v1, v2, v3| (v2 - v1).cross(v3 - v1);
    let by_max: Share = |v1, v2, v3| {
        let (e1, e2) = (v2 - v1, v3 - v1);
        e1.cross(e2) / (e1.dot(e1) * e2.dot(e2))
    };
    let averaged = [by_area, by_max, normal::corner].map(|share| bunny.averaged(share));
    let mut cells = vec![porcelain(bunny.flat())];
    cells.extend(averaged.map(porcelain));
    Grid { columns: 4, cells }
}

/// The head in a light that shows every dent.
fn porcelain(surface: impl Surface + 'static) -> Scene {
    let camera = Camera::perspective([-2.3, 2.2, 5.2], [-0.62, 1.22, 0.1], 11.0);
    Scene {
        objects: vec![
            floor(matte(Rgb::gray(0.16))),
            Object::new(surface, glossy(Rgb::new(0.3, 0.31, 0.34), 0.7, 30)),
        ],
        lights: vec![
            Light::Directional(DirectionalLight {
                l: toward(0.9, 0.8, 0.35),
                intensity: Rgb::new(0.95, 0.92, 0.86),
            }),
            Light::Directional(DirectionalLight {
                l: toward(-1.0, 0.5, -0.4),
                intensity: Rgb::new(0.2, 0.3, 0.5),
            }),
        ],
        ..empty(camera, STUDIO)
    }
}

/// The pictures of a user's model.
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

/// A model of a known height in the middle of the picture.
fn shown(surface: impl Surface + 'static, height: f32) -> Scene {
    let camera = Camera::perspective([0.0, 2.6, 7.4], [0.0, 0.465 * height, 0.0], 21.0);
    Scene {
        objects: vec![
            floor(matte(Rgb::gray(0.16))),
            Object::new(surface, glossy(Rgb::new(0.45, 0.36, 0.28), 0.2, 15)),
        ],
        lights: vec![
            Light::Directional(DirectionalLight {
                l: toward(-0.8, 0.9, 0.7),
                intensity: Rgb::new(0.95, 0.92, 0.86),
            }),
            Light::Directional(DirectionalLight {
                l: toward(0.8, 1.0, -1.0),
                intensity: Rgb::new(0.14, 0.18, 0.25),
            }),
        ],
        ..empty(camera, STUDIO)
    }
}
