//! Loads a scene, shades a point in it, and fills a uniform buffer. Comments enclose the glue, which converts the library's
//! types into the rows of the buffer.
//!
//!     cargo run -p features --example scene_file tests/features/scenes/lamps.json

use std::process::ExitCode;

use serde::Deserialize;
use shading::f32::{Light, Material, Rgb, UnitVec3, Vec3};
use shading::shade;

/// What the file holds. There is nothing to convert: the file's types are the library's.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    ambient: Rgb,
    lights: Vec<Light>,
    material: Material<f32>,
}

/// The light that a point sends along `v`.
#[must_use]
pub fn shaded(scene: &Scene, p: Vec3, n: UnitVec3, v: UnitVec3) -> Rgb {
    let lights = scene.lights.iter().filter_map(|light| light.in_front(p, n));
    shade::blinn_phong(n, v, &scene.material, scene.ambient, lights).total()
}

/// The bytes of the material and of the lights, in rows of four numbers:
///
/// ```glsl
/// struct Light {
///     vec4 position;  // and 1; or L and 0
///     vec4 intensity;
///     vec4 falloff;   // a, b, c; 1 if it is clamped
///     vec4 axis;      // and the cosine; 0 for a light without a cone
/// };
/// layout(std140) uniform Scene {
///     vec4 reflectances[3]; // k_a, k_d, k_s; each with m
///     Light lights[16];
/// };
/// ```
#[must_use]
pub fn uniform_buffer(scene: &Scene) -> Vec<u8> {
    let Material { k_a, k_d, k_s, m } = scene.material;
    // glue:
    let reflectances = [k_a, k_d, k_s].map(|k| row(k, m));
    // end of glue
    let lights: Vec<_> = scene.lights.iter().map(rows).collect();
    let (head, tail) = (
        bytemuck::bytes_of(&reflectances),
        bytemuck::cast_slice(&lights),
    );
    [head, tail].concat()
}

// glue:
fn row(v: impl Into<[f32; 3]>, w: f32) -> [f32; 4] {
    glam::Vec3::from_array(v.into()).extend(w).to_array()
}

fn rows(light: &Light) -> [[f32; 4]; 4] {
    let (lamp, axis) = match light {
        Light::Directional(s) => return [row(s.l, 0.), row(s.intensity, 0.), [0.; 4], [0.; 4]],
        Light::Point(lamp) => (lamp, [0.; 4]),
        Light::Spot(spot) => (&spot.point, row(spot.axis, spot.cone.cosine())),
    };
    let (p, i, a) = (lamp.position, lamp.intensity, lamp.attenuation);
    let falloff = row(a.coefficients(), a.is_clamped().into());
    [row(p, 1.), row(i, 0.), falloff, axis]
}
// end of glue

fn main() -> ExitCode {
    let path = std::env::args()
        .nth(1)
        .expect("usage: scene_file SCENE.json");
    let text = std::fs::read_to_string(&path).expect("a readable file");
    let scene: Scene = match serde_json::from_str(&text) {
        Ok(scene) => scene,
        Err(error) => {
            eprintln!("{path}: {error}");
            return ExitCode::FAILURE;
        }
    };
    let [r, g, b] = shaded(&scene, Vec3::ZERO, UnitVec3::Y, UnitVec3::Y).to_srgb8();
    println!("the origin, seen from above: #{r:02x}{g:02x}{b:02x}");
    println!("the uniform buffer: {} bytes", uniform_buffer(&scene).len());
    ExitCode::SUCCESS
}
