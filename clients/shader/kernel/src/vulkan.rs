//! The entry points of the Vulkan shader: one thread per item.

use spirv_std::glam::UVec3;
use spirv_std::spirv;

use crate::buffers::{GpuLight, GpuMaterial, Point, Reflected};
use crate::functions::{Input, Output, call};
use crate::shaded;

#[spirv(compute(threads(64)))]
pub fn draw(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(spec_constant(id = 0))] how: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] points: &[Point],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] reflected: &mut [Reflected],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] materials: &[GpuMaterial],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] lights: &[GpuLight],
) {
    let i = id.x as usize;
    if i < points.len() {
        reflected[i] = shaded(how, &points[i], materials, lights).into();
    }
}

#[spirv(compute(threads(64)))]
pub fn one_function(
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
