//! The scenes that the pictures show.

mod attenuation;
mod bunny;
mod highlights;
mod implicit;
mod lights;
mod normal_map;
mod parts;
mod range;
mod soft_spot;
mod teapot;

use shading::{Rgb, Shaded, UnitVec3};

use crate::render::film::View;
use crate::render::ray::Camera;
use crate::render::scene::{Backdrop, Finish, Model as Sum, Object, Scene};
use crate::render::shape::Plane;

pub use bunny::model;

/// A picture of the gallery.
pub struct Picture {
    /// The name of its file without the extension.
    pub name: &'static str,
    /// What it shows, from left to right.
    pub labels: &'static [&'static str],
    pub view: Box<dyn View>,
    /// Four square views side by side, twice as wide as other pictures.
    is_strip: bool,
    in_readme: bool,
}

impl Picture {
    fn new(name: &'static str, labels: &'static [&'static str], view: impl View + 'static) -> Self {
        Self {
            name,
            labels,
            view: Box::new(view),
            is_strip: false,
            in_readme: false,
        }
    }

    /// Marks a picture that a README shows.
    fn for_readme(self) -> Self {
        Self {
            in_readme: true,
            ..self
        }
    }

    /// Makes the picture a strip of four square views side by side.
    fn strip(self) -> Self {
        Self {
            is_strip: true,
            ..self
        }
    }

    /// The width and height of the picture if ordinary pictures have `size`.
    pub fn size(&self, (width, height): (usize, usize)) -> (usize, usize) {
        if self.is_strip {
            (2 * width, width.div_ceil(2))
        } else {
            (width, height)
        }
    }
}

/// The whole gallery, in order.
pub fn all() -> Vec<Picture> {
    let mut pictures = parts::pictures();
    pictures.extend(highlights::pictures());
    pictures.extend(lights::pictures());
    pictures.extend(attenuation::pictures());
    pictures.extend(teapot::pictures());
    pictures.extend(implicit::pictures());
    pictures.extend(bunny::pictures());
    pictures.extend(soft_spot::pictures());
    pictures.extend(range::pictures());
    pictures.extend(normal_map::pictures());
    pictures
}

/// The pictures that the READMEs show.
pub fn of_readme() -> Vec<Picture> {
    let mut pictures = all();
    pictures.retain(|picture| picture.in_readme);
    pictures
}

/// A scene without objects and lights, which are added later.
fn empty(camera: Camera, backdrop: Backdrop) -> Scene {
    Scene {
        camera,
        objects: Vec::new(),
        lights: Vec::new(),
        soft_lights: Vec::new(),
        ambient: Rgb::gray(0.12),
        model: Sum::BlinnPhong,
        part: Shaded::total,
        backdrop,
    }
}

/// A quiet gray, darker toward the edges.
const STUDIO: Backdrop = Backdrop {
    center: Rgb::new(0.055, 0.06, 0.07),
    edge: Rgb::new(0.008, 0.009, 0.011),
};

/// A material with one color that reflects ambient light as it does diffuse light.
const fn glossy(color: Rgb<f32>, k_s: f32, m: u32) -> Finish {
    Finish {
        k_a: color,
        k_d: color,
        k_s: Rgb::gray(k_s),
        m,
    }
}

const fn matte(color: Rgb<f32>) -> Finish {
    glossy(color, 0.0, 1)
}

/// The floor y = 0 around the origin.
fn floor(finish: Finish) -> Object {
    Object::new(floor_plane(), finish).fading(1.0, 4.6)
}

/// The same floor in squares of one unit.
fn tiles(light: Finish, dark: Finish) -> Object {
    Object::painted(floor_plane(), move |hit| {
        let odd = (hit.p.x.floor() + hit.p.z.floor()).rem_euclid(2.0) > 0.5;
        if odd { dark } else { light }
    })
}

fn floor_plane() -> Plane {
    Plane::new(0.0, 1.0, 0.0, 0.0).expect("it has a normal")
}

/// The direction (x, y, z), which is not zero.
fn toward(x: f32, y: f32, z: f32) -> UnitVec3<f32> {
    shading::Vec3::new(x, y, z).unit_or(UnitVec3::Y)
}
