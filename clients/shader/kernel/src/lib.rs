//! The library on a GPU. The host calls the same functions and compares.
#![cfg_attr(any(target_arch = "spirv", target_arch = "nvptx64"), no_std)]
#![cfg_attr(target_arch = "nvptx64", feature(abi_ptx, stdarch_nvptx))]

pub mod buffers;
#[cfg(target_arch = "nvptx64")]
pub mod cuda;
pub mod functions;
pub mod scene;
#[cfg(target_arch = "spirv")]
pub mod vulkan;

use shading::f32::{IncidentLight, Material, Rgb, Shaded, UnitVec3};
use shading::{Exponent, normal, shade};

use buffers::{GpuLight, GpuMaterial, Point};

/// I_a
const AMBIENT: Rgb = Rgb::gray(0.2);

/// The models; the last bit takes m as an integer.
pub const LAMBERT: u32 = 0;
pub const PHONG: u32 = 1;
pub const BLINN_PHONG: u32 = 2;
pub const INTEGER: u32 = 4;

/// The light that a point of a surface sends to the eye.
pub fn shaded(how: u32, point: &Point, materials: &[GpuMaterial], lights: &[GpuLight]) -> Shaded {
    let Point { p, object, v, lit } = *point;
    let v = UnitVec3::assume_unit(v);
    let n = normal::implicit(|p| scene::surface(object, p), p).unwrap_or(v);
    let material = materials[object as usize];
    let lights = (0..lights.len()).filter_map(move |i| {
        let is_lit = lit >> i & 1 == 1;
        if is_lit {
            lights[i].in_front(p, n)
        } else {
            None
        }
    });
    if how & INTEGER == 0 {
        by_model(how, n, v, &material.with(material.m), lights)
    } else {
        by_model(
            how - INTEGER,
            n,
            v,
            &material.with(material.m as u32),
            lights,
        )
    }
}

fn by_model<M: Exponent<f32>>(
    model: u32,
    n: UnitVec3,
    v: UnitVec3,
    material: &Material<M>,
    lights: impl Iterator<Item = IncidentLight>,
) -> Shaded {
    match model {
        LAMBERT => shade::lambert(n, material, AMBIENT, lights),
        PHONG => shade::phong(n, v, material, AMBIENT, lights),
        _ => shade::blinn_phong(n, v, material, AMBIENT, lights),
    }
}
