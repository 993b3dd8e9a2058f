//! The library on a GPU: one thread for each item. The host calls the same functions and compares.
#![cfg_attr(target_arch = "spirv", no_std)]

pub mod functions;

use bytemuck::{Pod, Zeroable};
use shading::f32::{Attenuation, Material, PointLight, Rgb, Shaded, UnitVec3, Vec3};
use shading::{Real, normal, shade};
#[cfg(target_arch = "spirv")]
use spirv_std::{glam::UVec3, spirv};

#[cfg(target_arch = "spirv")]
use functions::{Input, Output, Value, call};

/// A point of the ring, and the direction to the eye.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub struct Point {
    pub p: Vec3,
    pub m: f32,
    pub v: Vec3,
    pub padding: f32,
}

#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub struct Lamp {
    pub position: Vec3,
    pub padding: f32,
    pub intensity: Rgb,
    pub padding_too: f32,
}

pub const RADII: [f32; 2] = [0.7, 0.25];

/// The ring's surface, where it is 0: the GPU differentiates it.
pub fn ring<T: Real>(p: shading::Vec3<T>) -> T {
    let from_circle = (p.x * p.x + p.y * p.y).sqrt() - T::of_f32(RADII[0]);
    (from_circle * from_circle + p.z * p.z).sqrt() - T::of_f32(RADII[1])
}

/// The models, with a real m and with an integer m.
pub const LAMBERT: u32 = 0;
pub const PHONG: [u32; 2] = [1, 2];
pub const BLINN_PHONG: [u32; 2] = [3, 4];

/// The light that a point of the ring sends to the eye.
pub fn shaded(how: u32, &Point { p, m, v, .. }: &Point, lamps: &[Lamp]) -> Shaded {
    let v = UnitVec3::assume_unit(v);
    let n = normal::implicit(ring, p).unwrap_or(v);
    let lights = (0..lamps.len()).map(move |i| {
        let Lamp {
            position,
            intensity,
            ..
        } = lamps[i];
        let attenuation = Attenuation::NONE;
        PointLight {
            position,
            intensity,
            attenuation,
        }
        .at(p)
    });
    let (color, k_s, i_a) = (Rgb::new(0.72, 0.42, 0.06), Rgb::gray(0.8), Rgb::gray(0.2));
    let real = Material {
        k_a: color,
        k_d: color,
        k_s,
        m,
    };
    let integer = Material {
        k_a: color,
        k_d: color,
        k_s,
        m: m as u32,
    };
    if how == LAMBERT {
        shade::lambert(n, &real, i_a, lights)
    } else if how == PHONG[0] {
        shade::phong(n, v, &real, i_a, lights)
    } else if how == PHONG[1] {
        shade::phong(n, v, &integer, i_a, lights)
    } else if how == BLINN_PHONG[0] {
        shade::blinn_phong(n, v, &real, i_a, lights)
    } else {
        shade::blinn_phong(n, v, &integer, i_a, lights)
    }
}

#[cfg(target_arch = "spirv")]
#[spirv(compute(threads(64)))]
pub fn scene(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(spec_constant(id = 0))] how: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] points: &[Point],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] outputs: &mut [Output],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] lamps: &[Lamp],
) {
    let i = id.x as usize;
    if i < points.len() {
        outputs[i] = shaded(how, &points[i], lamps).output();
    }
}

#[cfg(target_arch = "spirv")]
#[spirv(compute(threads(64)))]
pub fn function(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(spec_constant(id = 0))] function: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] inputs: &[Input],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] outputs: &mut [Output],
) {
    let i = id.x as usize;
    if i < inputs.len() {
        outputs[i] = call(function, &inputs[i]);
    }
}
