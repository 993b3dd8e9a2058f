//! Many lamps, without and with a range.

use std::f32::consts::TAU;

use shading::{Attenuation, Elementary, PointLight, Rgb, Vec3};

use super::{Picture, empty, matte, tiles};
use crate::render::ray::Camera;
use crate::render::scene::{Backdrop, Grid, Object, Scene};
use crate::render::shape::Sphere;

pub fn pictures() -> Vec<Picture> {
    vec![Picture::new(
        "25_range",
        &["above: every lamp lights everything; below: the same within a range of 1.5"],
        Grid {
            columns: 1,
            cells: [f32::INFINITY, 1.5].map(lanterns).into(),
        },
    )]
}

/// Lamps of many colors, close to a floor.
fn lanterns(range: f32) -> Scene {
    const COLUMNS: u8 = 7;
    let camera = Camera::perspective([0.0, 4.2, 9.5], [0.0, 0.0, -0.35], 20.0);
    let gray = |value| matte(Rgb::gray(value));
    let mut scene = Scene {
        objects: vec![tiles(gray(0.75), gray(0.6))],
        ambient: Rgb::BLACK,
        ..empty(camera, Backdrop::BLACK)
    };
    // 1/(0.05 + q²) is nearly inverse-square, and finite at the lamp
    let free = Attenuation::<f32>::new(0.05, 0.0, 1.0).expect("coefficients");
    let attenuation = free.within(range).expect("above 0");
    for i in 0..3 * COLUMNS {
        let (row, column) = (f32::from(i / COLUMNS), f32::from(i % COLUMNS));
        let x = 1.7 * (column - 0.5 * f32::from(COLUMNS - 1)) + 0.85 * (row - 1.0);
        let position = Vec3::new(x, 0.3, 1.7 * (row - 1.0) - 0.4);
        let color = hue((column + 2.3 * row) / f32::from(COLUMNS));
        scene.soft_lights.push(
            PointLight {
                position,
                intensity: color * 0.22,
                attenuation,
            }
            .into(),
        );
        let shape = Sphere {
            center: position,
            radius: 0.07,
        };
        scene.objects.push(Object::glowing(shape, color));
    }
    scene
}

/// A color on the color circle, which has a circumference of 1.
fn hue(turn: f32) -> Rgb<f32> {
    let channel = |third: f32| 0.5 + 0.5 * Elementary::cos(TAU * (turn - third / 3.0));
    Rgb::new(channel(0.0), channel(1.0), channel(2.0))
}
