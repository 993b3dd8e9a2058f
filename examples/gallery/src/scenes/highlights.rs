//! Highlights: their strength k_s, their sharpness m, and Phong's next to Blinn's.

use shading::{Attenuation, DirectionalLight, Light, PointLight, Rgb, Shaded, Vec3};

use super::{Picture, STUDIO, empty, floor, glossy, toward};
use crate::render::ray::Camera;
use crate::render::scene::{Backdrop, Finish, Grid, Model as Sum, Object, Part, Scene};
use crate::render::shape::Sphere;

const GREEN: Rgb<f32> = Rgb::new(0.04, 0.26, 0.16);
const PURPLE: Rgb<f32> = Rgb::new(0.22, 0.06, 0.3);

pub fn pictures() -> Vec<Picture> {
    vec![
        Picture::new(
            "05_ks_and_m",
            &["m = 4", "m = 20", "m = 120"],
            strength_and_sharpness(),
        )
        .for_readme(),
        Picture::new("06_m_1_5_10", &["m = 1", "m = 5", "m = 10"], sharpness()),
        Picture::new(
            "07_phong_beside_blinn_at_equal_m",
            &["Phong, m = 20", "Blinn-Phong, m = 20"],
            pair(20, 20),
        ),
        Picture::new(
            "08_phong_beside_blinn_at_4m",
            &["Phong, m = 20", "Blinn-Phong, m = 80"],
            pair(20, 80),
        ),
        Picture::new(
            "09_phong_beside_blinn_at_sunset",
            &["Phong", "Blinn-Phong"],
            sunset(),
        )
        .for_readme(),
    ]
}

/// k_s grows from top to bottom, and m from left to right.
fn strength_and_sharpness() -> Grid<Scene> {
    let cells = [0.2, 0.6].map(|k_s| [4, 20, 120].map(|m| glossy(GREEN, k_s, m)));
    Grid {
        columns: 3,
        cells: cells
            .iter()
            .flatten()
            .map(|&finish| ball(Sum::Phong, finish))
            .collect(),
    }
}

/// m grows from left to right.
fn sharpness() -> Grid<Scene> {
    with_highlights_below(&[1, 5, 10].map(|m| (Sum::Phong, glossy(GREEN, 0.5, m))))
}

/// The same ball with Phong's formula on the left and Blinn's on the right.
fn pair(m_phong: u32, m_blinn: u32) -> Grid<Scene> {
    with_highlights_below(&[
        (Sum::Phong, glossy(PURPLE, 0.6, m_phong)),
        (Sum::BlinnPhong, glossy(PURPLE, 0.6, m_blinn)),
    ])
}

/// A row of balls, and their highlights alone below it.
fn with_highlights_below(balls: &[(Sum, Finish)]) -> Grid<Scene> {
    let parts: [Part; 2] = [Shaded::total, |shaded| shaded.specular];
    let row = |part| {
        balls.iter().map(move |&(model, finish)| Scene {
            part,
            ..ball(model, finish)
        })
    };
    Grid {
        columns: balls.len(),
        cells: parts.into_iter().flat_map(row).collect(),
    }
}

/// A ball in front of the eye, with the light over the left shoulder.
fn ball(model: Sum, finish: Finish) -> Scene {
    let camera = Camera::parallel([0.0, 0.0, 5.0], [0.0, 0.0, 0.0], 2.8);
    Scene {
        objects: vec![Object::new(Sphere::new([0.0; 3], 1.0), finish)],
        lights: vec![Light::Directional(DirectionalLight {
            l: toward(-0.5, 0.55, 0.67),
            intensity: Rgb::WHITE,
        })],
        model,
        ..empty(camera, STUDIO)
    }
}

/// The sun low over water: Phong's highlight is round, but Blinn's is stretched toward the eye, as
/// on the sea. Both have the same height.
fn sunset() -> Grid<Scene> {
    const SUN: Vec3<f32> = Vec3::new(0.0, 1.5, -9.0);
    const ORANGE: Rgb<f32> = Rgb::new(1.0, 0.62, 0.3);
    let half = |model, m| {
        let camera = Camera::perspective([0.0, 1.2, 7.0], [0.0, 0.62, 0.0], 26.0);
        let sky = Backdrop {
            center: Rgb::new(0.1, 0.07, 0.075),
            edge: Rgb::new(0.012, 0.014, 0.03),
        };
        let disc = Sphere {
            center: SUN,
            radius: 0.4,
        };
        Scene {
            objects: vec![
                floor(glossy(Rgb::new(0.03, 0.06, 0.1), 0.8, m)).fading(7.0, 22.0),
                Object::glowing(disc, ORANGE),
            ],
            lights: vec![Light::Point(PointLight {
                position: SUN,
                intensity: ORANGE,
                attenuation: Attenuation::NONE,
            })],
            model,
            ..empty(camera, sky)
        }
    };
    Grid {
        columns: 2,
        cells: vec![half(Sum::Phong, 300), half(Sum::BlinnPhong, 1200)],
    }
}
