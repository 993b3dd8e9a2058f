//! `shading` for C and whatever can call C: `shading.h` declares and explains the functions. With
//! the feature `python`, it is a module for Python.
//!
//! Nothing here panics. If it did, the panic would end the program and not unwind into C.

#[cfg(feature = "python")]
mod python;
mod scene;
#[cfg(test)]
mod tests;

use std::ops::Range;
use std::slice::{from_raw_parts, from_raw_parts_mut};

use scene::{Light, Material, Model, Scene};
use shading::f32::Rgb;

/// What a function returns, as in `shading.h`.
#[derive(Clone, Copy, Debug)]
#[repr(i32)]
enum Status {
    Null = 1,
    Alignment,
    Size,
    Overlap,
    Model,
    Material,
    Light,
}

fn code(result: Result<(), Status>) -> i32 {
    result.map_or_else(|status| status as i32, |()| 0)
}

// Pointers from another language are checked as far as a pointer can be.

fn check<T>(data: *const T, count: usize) -> Result<(), Status> {
    let size = count.checked_mul(size_of::<T>());
    if data.is_null() {
        Err(Status::Null)
    } else if !data.is_aligned() {
        Err(Status::Alignment)
    } else if size.is_none_or(|size| isize::try_from(size).is_err()) {
        Err(Status::Size)
    } else {
        Ok(())
    }
}

/// # Safety
///
/// A pointer that is not null must be valid for `count` values.
unsafe fn input<'a, T>(data: *const T, count: usize) -> Result<&'a [T], Status> {
    if count == 0 {
        return Ok(&[]);
    }
    check(data, count)?;
    // SAFETY: the pointer is neither null nor misaligned, and valid as the caller promises
    Ok(unsafe { from_raw_parts(data, count) })
}

/// # Safety
///
/// A pointer that is not null must be valid for `count` values, which nothing else uses meanwhile.
unsafe fn output<'a, T>(
    data: *mut T,
    count: usize,
    inputs: &[Range<usize>],
) -> Result<&'a mut [T], Status> {
    if count == 0 {
        return Ok(&mut []);
    }
    check(data, count)?;
    let start = data.addr();
    let end = start + count * size_of::<T>();
    let overlaps = |input: &Range<usize>| start < input.end && input.start < end;
    if inputs.iter().any(overlaps) {
        return Err(Status::Overlap);
    }
    // SAFETY: as above, and no input overlaps it
    Ok(unsafe { from_raw_parts_mut(data, count) })
}

/// The addresses of a buffer.
fn addresses<T>(buffer: &[T]) -> Range<usize> {
    let Range { start, end } = buffer.as_ptr_range();
    start.addr()..end.addr()
}

/// # Safety
///
/// A pointer that is not null must be valid for as many numbers as `shading.h` says.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn shading_shade(
    model: u32,
    count: usize,
    points: *const [f32; 3],
    normals: *const [f32; 3],
    eye: *const [f32; 3],
    material: *const Material,
    ambient: *const [f32; 3],
    lights: *const Light,
    light_count: usize,
    out: *mut [f32; 3],
) -> i32 {
    // SAFETY: as the caller promises
    let shade = || unsafe {
        let (points, normals) = (input(points, count)?, input(normals, count)?);
        let (eye, ambient) = (input(eye, 1)?, input(ambient, 1)?);
        let (material, lights) = (input(material, 1)?, input(lights, light_count)?);
        let inputs = [points, normals, eye, ambient].map(addresses);
        let [a, b, c, d] = inputs;
        let out = output(
            out,
            count,
            &[a, b, c, d, addresses(material), addresses(lights)],
        )?;
        let scene = Scene {
            model: Model::of(model)?,
            points,
            normals,
            eye: eye[0],
            material: material[0],
            ambient: ambient[0],
            lights,
        };
        scene.shade(out)
    };
    code(shade())
}

/// # Safety
///
/// A pointer that is not null must be valid for `count` colors.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn shading_to_srgb8(
    count: usize,
    colors: *const [f32; 3],
    out: *mut [u8; 3],
) -> i32 {
    // SAFETY: as the caller promises
    let encode = || unsafe {
        let colors = input(colors, count)?;
        for (color, out) in colors.iter().zip(output(out, count, &[addresses(colors)])?) {
            *out = Rgb::from(*color).to_srgb8();
        }
        Ok(())
    };
    code(encode())
}

/// Room for so many floats in the module's memory, for JavaScript, until `shading_free` is called
/// with the same number.
#[cfg(target_family = "wasm")]
#[unsafe(no_mangle)]
pub extern "C" fn shading_room(floats: usize) -> *mut f32 {
    Box::into_raw(vec![0.0_f32; floats].into_boxed_slice()).cast()
}

/// # Safety
///
/// `room` must come from `shading_room(floats)`, and nothing may use it afterward.
#[cfg(target_family = "wasm")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn shading_free(room: *mut f32, floats: usize) {
    // SAFETY: as the caller promises
    drop(unsafe { Box::from_raw(std::ptr::slice_from_raw_parts_mut(room, floats)) });
}
