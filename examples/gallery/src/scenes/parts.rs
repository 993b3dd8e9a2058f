//! One scene four times: each term alone, and their sum.

use shading::{Attenuation, Elementary, Light, PointLight, Rgb, Shaded, Vec3};

use super::{Picture, empty, floor, glossy};
use crate::render::implicit::{Field, Implicit};
use crate::render::ray::Camera;
use crate::render::scene::{Backdrop, Grid, Object, Part, Scene};
use crate::render::shape::Sphere;

pub fn pictures() -> Vec<Picture> {
    let parts: [Part; 4] = [
        |shaded| shaded.ambient,
        |shaded| shaded.diffuse,
        |shaded| shaded.specular,
        Shaded::total,
    ];
    let [ambient, diffuse, specular, total] = parts.map(|part| still_life(part, 32.0));
    let strip = Grid {
        columns: 4,
        cells: parts.map(|part| still_life(part, 41.0)).into(),
    };
    let formulas = &[
        "k_a I_a",
        "+ k_d I max(0, N\u{b7}L)",
        "+ k_s I max(0, N\u{b7}H)^m",
        "= the reflected light",
    ];
    vec![
        Picture::new("00_the_sum", formulas, strip)
            .strip()
            .for_readme(),
        Picture::new("01_ambient", &["ambient"], ambient),
        Picture::new("02_diffuse", &["diffuse"], diffuse),
        Picture::new("03_specular", &["specular"], specular),
        Picture::new("04_total", &["total"], total),
    ]
}

/// The background is black, so that the first three pictures add up to the fourth, point by point.
fn still_life(part: Part, degrees: f32) -> Scene {
    const RED: Rgb<f32> = Rgb::new(0.66, 0.07, 0.05);
    const GOLD: Rgb<f32> = Rgb::new(0.72, 0.42, 0.06);
    const BLUE: Rgb<f32> = Rgb::new(0.06, 0.2, 0.55);

    let camera = Camera::perspective([0.0, 2.7, 7.2], [0.16, 0.7, 0.0], degrees);
    Scene {
        objects: vec![
            floor(glossy(Rgb::gray(0.24), 0.25, 12)).fading(1.6, 5.2),
            Object::new(Sphere::new([-1.35, 0.8, 0.25], 0.8), glossy(RED, 0.8, 30)),
            Object::new(ring(), glossy(GOLD, 0.8, 25)),
            Object::new(cube(), glossy(BLUE, 0.8, 20)),
        ],
        lights: vec![Light::Point(PointLight {
            position: Vec3::new(-3.2, 5.2, 4.2),
            intensity: Rgb::gray(0.95),
            attenuation: Attenuation::NONE,
        })],
        ambient: Rgb::gray(0.2),
        part,
        ..empty(camera, Backdrop::BLACK)
    }
}

/// An upright ring.
fn ring() -> Implicit<Ring> {
    Implicit::new(Ring, [0.35, 0.95, -1.0], 1.0)
}

struct Ring;

impl Field for Ring {
    fn value<T: Elementary>(&self, p: Vec3<T>) -> T {
        let [x, y, z] = [p.x - T::of(0.35), p.y - T::of(0.95), p.z + T::of(1.0)];
        let from_circle = (x * x + y * y).sqrt() - T::of(0.7);
        (from_circle * from_circle + z * z).sqrt() - T::of(0.25)
    }
}

/// A cube with rounded edges, slightly turned.
fn cube() -> Implicit<Cube> {
    Implicit::new(Cube, [1.5, 0.6, 0.3], 1.1)
}

struct Cube;

impl Field for Cube {
    fn value<T: Elementary>(&self, p: Vec3<T>) -> T {
        const ROUND: f64 = 0.22;
        let [x, y, z] = [p.x - T::of(1.5), p.y - T::of(0.6), p.z - T::of(0.3)];
        // by 30° around the vertical axis
        let (cos, sin) = (T::of(0.866_025_4), T::of(0.5));
        let turned = Vec3::new(x * cos - z * sin, y, x * sin + z * cos);
        let outside = turned.map(|c| (c.abs() - T::of(0.6 - ROUND)).at_least(T::ZERO));
        outside.dot(outside).sqrt() - T::of(ROUND)
    }
}
