//! The laws of local illumination on a program that shades the scenes of `shading-laws`.

use std::io::{Read, Write};
use std::process::{Command, Stdio};
use std::thread;

use bytemuck::{Pod, Zeroable};
use shading::f32::{Rgb, Vec3};
use shading_laws::{Laws, Light, Renderer, Scene, Triple};
use wgpu::ShaderSource;

use crate::Result;
use crate::buffers::{GpuLight, GpuMaterial};
use crate::gpu::{Gpu, Kernel};

/// A scene as the shaders read it.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
struct GpuScene {
    p: Vec3,
    model: f32, // 0: Lambert, 1: Phong, 2: Blinn–Phong
    n: Vec3,
    count: f32,
    v: Vec3,
    padding: f32,
    material: GpuMaterial,
    i_a: Rgb,
    padding_too: f32,
    lights: [GpuLight; 8],
}

fn vector([x, y, z]: Triple) -> Vec3 {
    Vec3::new(x as f32, y as f32, z as f32)
}

fn color([r, g, b]: Triple) -> Rgb {
    Rgb::new(r as f32, g as f32, b as f32)
}

impl From<&Scene> for GpuScene {
    fn from(scene: &Scene) -> Self {
        let mut lights = [GpuLight::zeroed(); 8];
        for (place, light) in lights.iter_mut().zip(&scene.lights) {
            *place = gpu_light(light);
        }
        let material = GpuMaterial {
            k_a: color(scene.k_a),
            m: scene.m as f32,
            k_d: color(scene.k_d),
            k_s: color(scene.k_s),
            ..GpuMaterial::zeroed()
        };
        Self {
            p: vector(scene.p),
            model: f32::from(scene.model as u8),
            n: vector(scene.n),
            count: scene.lights.len() as f32,
            v: vector(scene.v),
            material,
            i_a: color(scene.i_a),
            lights,
            ..Self::zeroed()
        }
    }
}

fn gpu_light(light: &Light) -> GpuLight {
    let base = GpuLight {
        intensity: color(light.intensity()),
        limit: f32::MAX,
        coefficients: [1.0, 0.0, 0.0],
        range: f32::MAX,
        cosines: [-1.0; 2],
        ..GpuLight::zeroed()
    };
    let lamp = |position, attenuation: Triple| GpuLight {
        position: vector(position),
        coefficients: attenuation.map(|x| x as f32),
        ..base
    };
    match *light {
        Light::Directional { l, .. } => GpuLight {
            position: vector(l),
            is_sun: 1.0,
            ..base
        },
        Light::Point {
            position,
            attenuation,
            ..
        } => lamp(position, attenuation),
        Light::Spot {
            position,
            attenuation,
            axis,
            half_angle,
            ..
        } => GpuLight {
            axis: vector(axis),
            cosines: [half_angle.cos() as f32; 2],
            ..lamp(position, attenuation)
        },
    }
}

/// A program that reads scenes and writes colors, each with a number that fills it.
struct Program<'a>(&'a str);

type Shaded = std::result::Result<Vec<Triple>, String>;

impl Renderer for Program<'_> {
    fn shade(&mut self, scenes: &[Scene]) -> Shaded {
        let scenes: Vec<_> = scenes.iter().map(GpuScene::from).collect();
        let mut child = Command::new(self.0)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|error| format!("{}: {error}", self.0))?;
        let mut stdin = child.stdin.take().expect("a pipe");
        let mut bytes = vec![];
        thread::scope(|scope| {
            scope.spawn(move || stdin.write_all(bytemuck::cast_slice(&scenes)));
            child.stdout.take().expect("a pipe").read_to_end(&mut bytes)
        })
        .map_err(|error| error.to_string())?;
        child.wait().map_err(|error| error.to_string())?;
        Ok(triples(&bytemuck::pod_collect_to_vec(&bytes)))
    }
}

impl Renderer for Kernel<'_> {
    fn shade(&mut self, scenes: &[Scene]) -> Shaded {
        if scenes.is_empty() {
            return Ok(vec![]); // a buffer holds something
        }
        let scenes: Vec<_> = scenes.iter().map(GpuScene::from).collect();
        let colors = self.run(&[bytemuck::cast_slice(&scenes)], scenes.len(), 4);
        Ok(triples(&colors))
    }
}

fn triples(numbers: &[f32]) -> Vec<Triple> {
    let triple = |color: &[f32]| [color[0], color[1], color[2]].map(f64::from);
    numbers.chunks_exact(4).map(triple).collect()
}

/// Fails unless all laws hold, or, where a mistake is planted, one is broken.
fn judge(name: &str, renderer: &mut impl Renderer, is_mistaken: bool) -> Result<()> {
    let report = Laws::default().run(renderer)?;
    match (report.findings.is_empty(), is_mistaken) {
        (true, false) => println!("{name}: all laws hold"),
        (false, true) => println!("{name}: the mistake is found"),
        (true, true) => return Err(format!("{name}: the mistake is not found").into()),
        (false, false) => return Err(format!("{name}: {report}").into()),
    }
    Ok(())
}

/// The laws on a program in C.
pub fn of_program(program: &str, is_mistaken: bool) -> Result<()> {
    judge(program, &mut Program(program), is_mistaken)
}

/// The laws on a file in WGSL, and on the file with a reflection that is wrong.
pub fn of_file(gpu: &Gpu, name: &str, file: &str) -> Result<()> {
    let mistaken = file.replace("n_dot_w + n_dot_w", "n_dot_w");
    if mistaken == file {
        return Err(format!("{name}: there is no reflection").into());
    }
    for (file, is_mistaken) in [(file, false), (&mistaken, true)] {
        let source = format!("{file}{}", include_str!("../shaders/laws.wgsl"));
        let mut kernel = gpu.kernel(ShaderSource::Wgsl(source.into()));
        judge(name, &mut kernel, is_mistaken)?;
    }
    Ok(())
}
