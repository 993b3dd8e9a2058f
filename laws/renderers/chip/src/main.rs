//! Shades scenes with `embedded-3dgfx`, a renderer for microcontrollers, in the format of `../docs/format.md`.
//! Its light is white, so each channel of a scene is drawn by itself, in green, which has the most bits of RGB565.

use std::io;

use embedded_3dgfx::config::MaterialProfile;
use embedded_3dgfx::pipeline::command_buffer::RenderCommand;
use embedded_3dgfx::prelude::*;
use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
use nalgebra::{Matrix4, Point3, Vector3};
use shading_laws::{Light, Model, Scene};

const PROFILE: &str = r#"{"name":"embedded-3dgfx","models":["lambert","blinn_phong"],"ambient":false,"lights":["directional"],"most_lights":1,"unit_vectors":true,"bits":6,"departs":["HighlightNotGated"]}"#;

fn shade(engine: &mut K3dengine, scene: &Scene) -> [f32; 3] {
    let Some(Light::Directional { intensity, l }) = scene.lights.first() else {
        return [0.0; 3];
    };
    let vector = |v: [f64; 3]| Vector3::from(v.map(|c| c as f32));
    let [p, n, v, l] = [scene.p, scene.n, scene.v, *l].map(vector);
    engine.camera.position = Point3::from(p + v);
    let light_dir = Vector3::new(l.x, l.y, -l.z); // the engine reverses z
    // around p, and tilted so that no eye sees its back, which is not drawn
    let vertices = [p - 2.0 * n, p + n, p + n].map(Into::into);
    let triangle = Geometry {
        vertices: &vertices,
        faces: &[[0, 1, 2]],
        normals: &[n.into()],
        vertex_normals: &[n.into(); 3],
        ..Geometry::default()
    };

    std::array::from_fn(|i| {
        let [k_d, k_s] = [scene.k_d, scene.k_s].map(|k| k[i] as f32 * intensity[i] as f32);
        let mode = match scene.model {
            Model::Lambert => RenderMode::GouraudLightDir(light_dir),
            _ => RenderMode::BlinnPhong {
                light_dir,
                specular_intensity: k_s,
                shininess: scene.m as f32,
            },
        };
        let mut mesh = K3dMesh::new(triangle);
        // the engine takes level 63 for 63/64
        #[allow(clippy::cast_sign_loss)]
        mesh.set_color(Rgb565::new(0, (k_d * 64.0).round().min(63.0) as u8, 0));
        mesh.set_render_mode(mode);
        drawn(engine, &mesh)
    })
}

/// The green that the engine gives a triangle.
fn drawn(engine: &K3dengine, mesh: &K3dMesh) -> f32 {
    let mut commands = CommandBuffer::<8>::new();
    let recorded = engine.record([mesh], &mut commands, None);
    recorded.expect("room for one triangle");
    let color = commands.iter().find_map(|command| match command {
        RenderCommand::Draw(DrawPrimitive::ColoredTriangleWithDepth { color, .. }) => Some(*color),
        RenderCommand::Draw(DrawPrimitive::GouraudTriangleWithDepth { colors, .. }) => {
            Some(colors[0])
        }
        _ => None,
    });
    f32::from(color.expect("a triangle").g()) / 63.0
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut engine = K3dengine::new(1, 1);
    // by default, the engine leaves highlights out
    engine.set_material_profile(MaterialProfile::SimpleSpecular);
    // every point is in view, at the only pixel
    engine.camera.vp_matrix = Matrix4::zeros();
    engine.camera.vp_matrix[(3, 3)] = 1.0;

    for line in io::stdin().lines() {
        match line?.as_str() {
            r#"{"shading-laws":1}"# => println!("{PROFILE}"),
            "" => {}
            scene => println!("{:?}", shade(&mut engine, &Scene::from_json(scene)?)),
        }
    }
    Ok(())
}
