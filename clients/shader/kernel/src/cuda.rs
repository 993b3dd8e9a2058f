//! The entry point of CUDA: one thread per point.

use core::arch::nvptx::{_block_dim_x, _block_idx_x, _thread_idx_x};
use core::panic::PanicInfo;
use core::slice;

use crate::buffers::{GpuLight, GpuMaterial, Point, Reflected};
use crate::shaded;

/// # Safety
///
/// Each pointer must point to as many items as the number after it says, and `reflected` to as many as there are
/// points.
#[unsafe(no_mangle)]
pub unsafe extern "ptx-kernel" fn draw(
    how: u32,
    points: *const Point,
    point_count: usize,
    reflected: *mut Reflected,
    materials: *const GpuMaterial,
    material_count: usize,
    lights: *const GpuLight,
    light_count: usize,
) {
    // SAFETY: as the caller promises; each thread writes one item of its own.
    unsafe {
        let i = (_block_idx_x() * _block_dim_x() + _thread_idx_x()) as usize;
        if i < point_count {
            let materials = slice::from_raw_parts(materials, material_count);
            let lights = slice::from_raw_parts(lights, light_count);
            *reflected.add(i) = shaded(how, &*points.add(i), materials, lights).into();
        }
    }
}

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    loop {}
}
