//! Shades scenes with `embedded-3dgfx`, a renderer for microcontrollers. It reads and writes the
//! format of `../docs/format.md`.
//!
//! The crate has one directional light, white and of intensity 1, and a white highlight. So the
//! mesh's color is k_d I, and each channel has a rendering of its own, with the highlight k_s I of
//! that channel. It adds a tenth of the mesh's color as ambient light; the host measures that
//! behind the terminator and subtracts it.

use std::io::{self, BufRead, Write};

use embedded_3dgfx::config::MaterialProfile;
use embedded_3dgfx::pipeline::command_buffer::RenderCommand;
use embedded_3dgfx::prelude::*;
use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
use nalgebra::{Matrix4, Point3, Vector3};
use serde::Deserialize;

const PROFILE: &str = r#"{"name":"embedded-3dgfx","models":["lambert","blinn_phong"],"ambient":false,"lights":["directional"],"most_lights":1,"unit_vectors":true,"clamps":[0,0.9],"bits":5,"highlight_on_the_dark_side":true}"#;

type Triple = [f32; 3];

#[derive(Deserialize)]
struct Scene {
    model: String,
    p: Triple,
    n: Triple,
    v: Triple,
    k_d: Triple,
    k_s: Triple,
    m: f32,
    lights: Vec<Light>,
}

#[derive(Deserialize)]
struct Light {
    intensity: Triple,
    l: Triple,
}

/// The channels of a color, from 0 to 1.
fn channels(color: Rgb565) -> Triple {
    [
        f32::from(color.r()) / 31.0,
        f32::from(color.g()) / 63.0,
        f32::from(color.b()) / 31.0,
    ]
}

/// The nearest color. `as` clamps.
#[allow(clippy::cast_sign_loss)]
fn nearest(color: Triple) -> Rgb565 {
    let level = |x: f32, highest: f32| (x * highest).round().min(highest) as u8;
    Rgb565::new(
        level(color[0], 31.0),
        level(color[1], 63.0),
        level(color[2], 31.0),
    )
}

/// The color that the engine gives a triangle.
fn color(engine: &K3dengine, triangle: Geometry, color: Rgb565, mode: RenderMode) -> Triple {
    let mut mesh = K3dMesh::new(triangle);
    mesh.set_color(color);
    mesh.set_render_mode(mode);
    let mut commands = CommandBuffer::<8>::new();
    engine
        .record([&mesh], &mut commands, None)
        .expect("room for one triangle");
    let color = commands.iter().find_map(|command| match command {
        RenderCommand::Draw(DrawPrimitive::ColoredTriangleWithDepth { color, .. }) => Some(*color),
        RenderCommand::Draw(DrawPrimitive::GouraudTriangleWithDepth { colors, .. }) => {
            Some(colors[0])
        }
        _ => None,
    });
    channels(color.expect("a triangle"))
}

fn shade(engine: &mut K3dengine, scene: &Scene) -> Triple {
    let Some(light) = scene.lights.first() else {
        return [0.0; 3];
    };
    let [p, n, v, l] = [scene.p, scene.n, scene.v, light.l].map(Vector3::from);
    engine.camera.position = Point3::from(p + v);

    // around p, and tilted so that no eye sees its back
    let vertices = [p - 2.0 * n, p + n, p + n].map(Into::into);
    let triangle = Geometry {
        vertices: &vertices,
        faces: &[[0, 1, 2]],
        normals: &[scene.n],
        vertex_normals: &[scene.n; 3],
        ..Geometry::default()
    };
    let surface = nearest(std::array::from_fn(|i| scene.k_d[i] * light.intensity[i]));
    // the engine turns the z of a light's direction around
    let toward = |l: Vector3<f32>| Vector3::new(l.x, l.y, -l.z);

    let ambient = color(
        engine,
        triangle,
        surface,
        RenderMode::GouraudLightDir(toward(-n)),
    );
    std::array::from_fn(|i| {
        let mode = match scene.model.as_str() {
            "lambert" => RenderMode::GouraudLightDir(toward(l)),
            _ => RenderMode::BlinnPhong {
                light_dir: toward(l),
                specular_intensity: scene.k_s[i] * light.intensity[i],
                shininess: scene.m,
            },
        };
        let lit = color(engine, triangle, surface, mode)[i];
        (lit - ambient[i]).clamp(0.0, 0.9)
    })
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut engine = K3dengine::new(1, 1);
    // otherwise the engine leaves the highlight out
    engine.set_material_profile(MaterialProfile::SimpleSpecular);
    // every point is in view, at the only pixel
    engine.camera.vp_matrix = Matrix4::zeros();
    engine.camera.vp_matrix[(3, 3)] = 1.0;

    let mut output = io::BufWriter::new(io::stdout().lock());
    for line in io::stdin().lock().lines() {
        match line?.as_str() {
            r#"{"shading-laws":1}"# => writeln!(output, "{PROFILE}")?,
            "" => {}
            scene => {
                let color = shade(&mut engine, &serde_json::from_str(scene)?);
                serde_json::to_writer(&mut output, &color)?;
                writeln!(output)?;
                continue;
            }
        }
        output.flush()?;
    }
    Ok(())
}
