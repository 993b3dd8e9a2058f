//! Scenes as the shader reads them.

use bytemuck::{Pod, Zeroable};
use shading_laws::{Light, Model, Scene, Triple};

/// The shader's `Scene`. WGSL begins each `vec3f` at a multiple of 16 bytes.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub struct SceneOfShader {
    p: [f32; 3],
    model: u32,
    n: [f32; 3],
    count: u32,
    v: [f32; 3],
    m: f32,
    k_a: [f32; 4],
    k_d: [f32; 4],
    k_s: [f32; 4],
    i_a: [f32; 4],
    lights: [LightOfShader; 8],
}

/// The shader's `Light`.
#[repr(C)]
#[derive(Clone, Copy, Default, Pod, Zeroable)]
struct LightOfShader {
    intensity: [f32; 3],
    kind: u32,
    position: [f32; 3],
    cos_angle: f32,
    axis: [f32; 4],
    attenuation: [f32; 4],
}

impl From<&Scene> for SceneOfShader {
    fn from(scene: &Scene) -> Self {
        let mut lights = [LightOfShader::default(); 8];
        for (place, light) in lights.iter_mut().zip(&scene.lights) {
            *place = light.into();
        }
        Self {
            p: narrow(scene.p),
            model: match scene.model {
                Model::Lambert => 0,
                Model::Phong => 1,
                Model::BlinnPhong => 2,
            },
            n: narrow(scene.n),
            count: u32::try_from(scene.lights.len()).unwrap_or(0),
            v: narrow(scene.v),
            m: scene.material.m as f32,
            k_a: padded(scene.material.k_a),
            k_d: padded(scene.material.k_d),
            k_s: padded(scene.material.k_s),
            i_a: padded(scene.i_a),
            lights,
        }
    }
}

impl From<&Light> for LightOfShader {
    fn from(light: &Light) -> Self {
        let intensity = narrow(light.intensity());
        match *light {
            Light::Directional { l, .. } => Self {
                intensity,
                position: narrow(l),
                ..Self::default()
            },
            Light::Point {
                position,
                attenuation,
                ..
            } => Self {
                intensity,
                kind: 1,
                position: narrow(position),
                attenuation: padded(attenuation),
                ..Self::default()
            },
            Light::Spot {
                position,
                attenuation,
                axis,
                half_angle,
                ..
            } => Self {
                intensity,
                kind: 2,
                position: narrow(position),
                cos_angle: half_angle.cos() as f32,
                axis: padded(axis),
                attenuation: padded(attenuation),
            },
        }
    }
}

fn narrow(triple: Triple) -> [f32; 3] {
    triple.map(|number| number as f32)
}

fn padded(triple: Triple) -> [f32; 4] {
    let [x, y, z] = narrow(triple);
    [x, y, z, 0.0]
}
