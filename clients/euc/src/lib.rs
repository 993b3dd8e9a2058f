//! The Utah teapot on `euc`, a software rasterizer that others wrote. Its pipeline and vectors are its
//! own; `shading` computes the normals from the patches, and the color of each fragment.

pub mod patch;

use euc::{Pipeline, buffer::Buffer2d, rasterizer};
use shading::f32::{Attenuation, Material, PointLight, Rgb, UnitVec3};
use shading::shade;
use vek::{Mat4, Vec3, Vec4};

pub static LAMPS: [PointLight; 2] = [
    PointLight {
        position: shading::Vec3::new(4.0, -5.0, 6.0),
        intensity: Rgb::new(1.0, 0.95, 0.85),
        attenuation: Attenuation::new(0.6, 0.0, 0.008).unwrap(),
    },
    PointLight {
        position: shading::Vec3::new(-6.0, -2.0, 2.0),
        intensity: Rgb::new(0.15, 0.25, 0.6),
        attenuation: Attenuation::NONE,
    },
];

pub static BRASS: Material = Material {
    k_a: Rgb::new(0.33, 0.22, 0.03),
    k_d: Rgb::new(0.78, 0.57, 0.11),
    k_s: Rgb::new(0.99, 0.94, 0.81),
    m: 28,
};

pub const SURROUNDINGS: Rgb = Rgb::gray(0.15);
pub const EYE: [f32; 3] = [1.5, -8.0, 5.0];

/// Opacity, red, green and blue.
const BACKGROUND: u32 = 0xff20_2428;

/// A corner of a triangle: its position and its normal.
pub type Vertex = (Vec3<f32>, Vec3<f32>);

struct Teapot {
    view_projection: Mat4<f32>,
    eye: Vec3<f32>,
}

impl Pipeline for Teapot {
    type Vertex = Vertex;
    type VsOut = Vertex;
    type Pixel = u32;

    fn vert(&self, &(p, n): &Vertex) -> ([f32; 4], Vertex) {
        let clip = self.view_projection * Vec4::from_point(p);
        (clip.into_array(), (p, n))
    }

    fn frag(&self, &(p, n): &Vertex) -> u32 {
        let n = ours(n).unit_or(UnitVec3::Z); // interpolated: not of length 1
        let v = ours(self.eye - p).unit_or(n);
        let lights = LAMPS.iter().map(|lamp| lamp.at(ours(p)));
        pixel(shade::blinn_phong(n, v, &BRASS, SURROUNDINGS, lights).total())
    }
}

// glue
fn ours(v: Vec3<f32>) -> shading::Vec3<f32> {
    v.into_array().into()
}
fn theirs(v: impl Into<[f32; 3]>) -> Vec3<f32> {
    v.into().into()
}
fn pixel(light: Rgb) -> u32 {
    let [r, g, b] = light.to_srgb8();
    u32::from_be_bytes([255, r, g, b])
}
// end of glue

/// The triangles of all patches as `euc` takes them, three vertices each.
pub fn vertices() -> Vec<Vertex> {
    patch::triangles()
        .map(|(p, n)| (theirs(p), theirs(n)))
        .collect()
}

/// The bytes of the picture: red, green and blue of each pixel. Triangles without an area are not seen.
pub fn draw(vertices: &[Vertex], width: usize, height: usize) -> Vec<u8> {
    if width == 0 || height == 0 {
        return Vec::new();
    }
    let mut color = Buffer2d::new([width, height], BACKGROUND);
    let mut depth = Buffer2d::new([width, height], 1.0);
    let eye = Vec3::from(EYE);
    let view = Mat4::look_at_rh(eye, Vec3::new(0.2, 0.0, 1.4), Vec3::unit_z());
    let projection = Mat4::perspective_fov_rh_no(0.7, width as f32, height as f32, 0.1, 100.0);
    let teapot = Teapot {
        view_projection: projection * view,
        eye,
    };
    teapot.draw::<rasterizer::Triangles<_>, _>(vertices, &mut color, Some(&mut depth));
    let bytes = |pixel: &u32| pixel.to_be_bytes().into_iter().skip(1);
    color.as_ref().iter().flat_map(bytes).collect()
}
