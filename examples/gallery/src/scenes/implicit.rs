//! Implicit surfaces: one function finds the surface and gives its normals.

use shading::{DirectionalLight, Elementary, Light, Rgb, Vec3};

use super::{Picture, STUDIO, empty, floor, glossy, matte, toward};
use crate::render::implicit::{Field, Implicit};
use crate::render::ray::Camera;
use crate::render::scene::{Object, Scene};

pub fn pictures() -> Vec<Picture> {
    vec![
        Picture::new(
            "18_sphere_and_torus",
            &["normals from grad f"],
            sphere_and_torus(),
        ),
        Picture::new("19_gyroid", &["gyroid: normals by dual numbers"], gyroid()).for_readme(),
        Picture::new(
            "20_metaballs",
            &["metaballs: normals by dual numbers"],
            metaballs(),
        ),
    ]
}

/// A key light from the upper left, and a weak light from behind on the right.
fn lit(scene: Scene) -> Scene {
    Scene {
        lights: vec![
            Light::Directional(DirectionalLight {
                l: toward(-0.6, 0.9, 0.7),
                intensity: Rgb::new(0.95, 0.92, 0.86),
            }),
            Light::Directional(DirectionalLight {
                l: toward(0.8, 1.0, -1.0),
                intensity: Rgb::new(0.14, 0.18, 0.25),
            }),
        ],
        ..scene
    }
}

/// |p − c| − r
struct Sphere;

impl Field for Sphere {
    fn value<T: Elementary>(&self, p: Vec3<T>) -> T {
        let q = p - Vec3::new(T::ZERO, T::of(0.8), T::ZERO);
        q.dot(q).sqrt() - T::of(0.62)
    }
}

/// The distance from a circle minus the thickness; the circle is tilted by atan(3/4).
struct Torus;

impl Field for Torus {
    fn value<T: Elementary>(&self, p: Vec3<T>) -> T {
        let (cos, sin) = (T::of(0.8), T::of(0.6));
        let y = p.y - T::of(0.8);
        let (along, above) = (y * sin + p.x * cos, y * cos - p.x * sin);
        let from_circle = (along * along + p.z * p.z).sqrt() - T::of(1.2);
        (from_circle * from_circle + above * above).sqrt() - T::of(0.22)
    }
}

fn sphere_and_torus() -> Scene {
    let camera = Camera::perspective([0.0, 2.6, 7.0], [0.0, 0.75, 0.0], 26.0);
    lit(Scene {
        objects: vec![
            floor(matte(Rgb::gray(0.16))),
            Object::new(
                Implicit::new(Sphere, [0.0, 0.8, 0.0], 0.7),
                glossy(Rgb::new(0.55, 0.5, 0.42), 0.4, 80),
            ),
            Object::new(
                Implicit::new(Torus, [0.0, 0.8, 0.0], 1.5),
                glossy(Rgb::new(0.05, 0.28, 0.4), 0.45, 40),
            ),
        ],
        ..empty(camera, STUDIO)
    })
}

/// The gyroid, sin x cos y + sin y cos z + sin z cos x = 0, as a wall between two surfaces, cut to
/// a ball.
struct Gyroid;

impl Field for Gyroid {
    fn value<T: Elementary>(&self, p: Vec3<T>) -> T {
        const SCALE: f64 = 6.0;
        let q = p * T::of(SCALE);
        let gyroid = q.x.sin() * q.y.cos() + q.y.sin() * q.z.cos() + q.z.sin() * q.x.cos();
        // its slope is at most √3: each of its derivatives has the form ab − cd, whose square is at
        // most (a² + d²)(b² + c²), and the three add up to 3
        let wall = (gyroid.abs() - T::of(0.3)) * T::of(1.0 / (SCALE * 1.732_050_9));
        let ball = p.dot(p).sqrt() - T::of(1.3);
        (wall - ball).if_positive(wall, ball)
    }
}

fn gyroid() -> Scene {
    let camera = Camera::perspective([-0.7, 2.3, 6.4], [0.0; 3], 28.5);
    lit(Scene {
        objects: vec![Object::new(
            Implicit::new(Gyroid, [0.0; 3], 1.31),
            glossy(Rgb::new(0.6, 0.3, 0.08), 0.35, 40),
        )],
        ambient: Rgb::gray(0.17),
        ..empty(camera, STUDIO)
    })
}

/// Balls that melt into each other: −ln Σ exp(−k dᵢ)/k of their distances dᵢ, which is slightly
/// less than the smallest of them.
struct Metaballs;

impl Metaballs {
    const BALLS: [([f64; 3], f64); 6] = [
        ([0.0, 0.75, 0.0], 0.55),
        ([-0.85, 0.62, 0.25], 0.42),
        ([0.8, 0.55, 0.35], 0.38),
        ([0.35, 1.5, -0.1], 0.36),
        ([-0.5, 1.35, -0.15], 0.24),
        ([0.95, 1.15, -0.35], 0.2),
    ];
    const K: f64 = 7.0;
}

impl Field for Metaballs {
    fn value<T: Elementary>(&self, p: Vec3<T>) -> T {
        let sum = Self::BALLS
            .into_iter()
            .fold(T::ZERO, |sum, (center, radius)| {
                let q = p - Vec3::from(center).map(T::of);
                let distance = q.dot(q).sqrt() - T::of(radius);
                sum + (distance * T::of(-Self::K)).exp()
            });
        sum.ln() * T::of(-1.0 / Self::K)
    }
}

fn metaballs() -> Scene {
    let camera = Camera::perspective([0.0, 2.4, 7.0], [0.05, 0.85, 0.0], 25.0);
    lit(Scene {
        objects: vec![
            floor(matte(Rgb::gray(0.16))),
            Object::new(
                Implicit::new(Metaballs, [0.05, 0.85, 0.0], 1.7),
                glossy(Rgb::new(0.42, 0.07, 0.16), 0.5, 70),
            ),
        ],
        ..empty(camera, STUDIO)
    })
}
