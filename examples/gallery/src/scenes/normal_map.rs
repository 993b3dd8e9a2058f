//! Bricks, dimples, and ribs that are not there: a plane and spheres with normal maps.

use shading::{Attenuation, Dual, Elementary, Light, PointLight, Rgb, Vec3, normal};

use super::{Picture, STUDIO, empty, glossy, matte};
use crate::render::ray::{Camera, Hit, Ray, Surface};
use crate::render::scene::{Finish, Object, Scene};
use crate::render::shape::{Plane, Sphere};

pub fn pictures() -> Vec<Picture> {
    vec![Picture::new(
        "26_normal_map",
        &["a plane and three spheres, with normal maps"],
        bricks_and_balls(),
    )]
}

fn bricks_and_balls() -> Scene {
    const RADIUS: f32 = 0.63;
    let camera = Camera::perspective([0.0, 1.8, 8.6], [0.0, 1.0, 0.0], 23.0);
    let wall = Plane::new(0.0, 0.0, 1.0, 1.1).expect("it has a normal");
    let floor = Plane::new(0.0, 1.0, 0.0, 0.0).expect("it has a normal");
    let ball = |x: f32, relief: Relief| {
        let center = Vec3::new(x, RADIUS, 0.2);
        let surface = Mapped {
            surface: Sphere::new(center.into(), RADIUS),
            // projected onto the ball from the front
            place: move |p: Vec3<f32>| (p - center) * (1.0 / RADIUS),
            relief,
        };
        Object::new(surface, glossy(Rgb::new(0.5, 0.31, 0.05), 0.5, 45))
    };
    let bricks = Mapped {
        surface: wall,
        place: in_brick,
        relief: Relief::Bricks,
    };
    Scene {
        objects: vec![
            Object::painted(bricks, |hit| brick(hit.p)),
            Object::new(floor, matte(Rgb::gray(0.22))),
            ball(-1.5, Relief::None),
            ball(0.0, Relief::Dimples),
            ball(1.5, Relief::Ribs),
        ],
        lights: vec![Light::Point(PointLight {
            position: Vec3::new(-3.4, 3.4, 4.0),
            intensity: Rgb::new(1.75, 1.65, 1.45),
            attenuation: Attenuation::<f32>::new(1.0, 0.0, 0.025).expect("coefficients"),
        })],
        ambient: Rgb::gray(0.07),
        ..empty(camera, STUDIO)
    }
}

/// A surface with simulated relief: its normals come from a map along x and y.
struct Mapped<S, P> {
    surface: S,
    /// The place on the map, of which only x and y count.
    place: P,
    relief: Relief,
}

impl<S: Surface, P: Fn(Vec3<f32>) -> Vec3<f32> + Sync> Surface for Mapped<S, P> {
    fn hit(&self, ray: &Ray, limit: f32) -> Option<Hit> {
        let hit = self.surface.hit(ray, limit)?;
        let sample = self.relief.sample((self.place)(hit.p));
        let along_x = Vec3::new(1.0, 0.0, 0.0);
        let n = normal::mapped(hit.n, along_x, 1.0, sample).unwrap_or(hit.n);
        Some(Hit { n, ..hit })
    }

    fn blocks(&self, ray: &Ray, limit: f32) -> bool {
        self.surface.blocks(ray, limit)
    }
}

#[derive(Clone, Copy)]
enum Relief {
    None,
    Bricks,
    Dimples,
    Ribs,
}

impl Relief {
    /// The sample of the map at a place: exactly (−∂h/∂x, −∂h/∂y, 1).
    fn sample(self, place: Vec3<f32>) -> Vec3<f32> {
        let Vec3 { x, y, .. } = Dual::point(place);
        let slope = self.height(x, y).gradient;
        Vec3::new(-slope.x, -slope.y, 1.0)
    }

    fn height<T: Elementary>(self, x: T, y: T) -> T {
        match self {
            Self::None => T::ZERO,
            Self::Bricks => {
                let from_edge = (T::of(HALF[0]) - x.abs()).at_most(T::of(HALF[1]) - y.abs());
                let bevel = (from_edge * T::of(16.0)).at_least(T::ZERO).at_most(T::ONE);
                let rough = (x * T::of(43.0)).sin() * (y * T::of(37.0)).sin();
                bevel * bevel * T::of(0.03) + rough * T::of(0.002)
            }
            // three waves at 60° to each other
            Self::Dimples => {
                let [a, b] = [x * T::of(12.0), y * T::of(20.78)];
                let waves = (a + a).cos() + (a + b).cos() + (a - b).cos();
                waves * T::of(0.011)
            }
            Self::Ribs => ((x + y) * T::of(17.0)).sin() * T::of(0.03),
        }
    }
}

/// The distance from brick to brick, across and up.
const PITCH: [f32; 2] = [0.62, 0.26];
/// Half the size of a brick; the rest is mortar.
const HALF: [f64; 2] = [0.295, 0.115];

/// The indices of the brick at a point of the wall. Every other row is shifted by half a brick.
fn number([x, y]: [f32; 2]) -> [f32; 2] {
    let row = (y / PITCH[1]).floor();
    let off = 0.5 * row.rem_euclid(2.0);
    [(x / PITCH[0] + off).floor() - off, row]
}

/// A point of the wall relative to the middle of its brick.
fn in_brick(p: Vec3<f32>) -> Vec3<f32> {
    let [column, row] = number([p.x, p.y]);
    let middle = Vec3::new(PITCH[0] * (column + 0.5), PITCH[1] * (row + 0.5), p.z);
    p - middle
}

fn brick(p: Vec3<f32>) -> Finish {
    let place = in_brick(p);
    if place.x.abs() > HALF[0] as f32 || place.y.abs() > HALF[1] as f32 {
        return matte(Rgb::gray(0.32));
    }
    let [column, row] = number([p.x, p.y]);
    let shade = 0.8 + 0.08 * (14.0 * column + 3.0 * row).rem_euclid(5.0);
    matte(Rgb::new(0.46, 0.17, 0.1) * shade)
}
