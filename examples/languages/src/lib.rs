//! `shading` for C and whatever can call C. `shading.h` declares and explains the functions.
//!
//! Nothing here panics. If it did, the panic would end the program and not unwind into C.

mod buffer;
#[cfg(target_family = "wasm")]
mod memory;
mod scene;

use buffer::{input, one, output};
use scene::{Light, Material, Model, color, lights, material};
use shading::f32::{Rgb, Vec3};
use shading::{Exponent, shade};

/// What a function returns, as in `shading.h`.
#[derive(Clone, Copy)]
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
    let buffers = || unsafe {
        let places = [input(points, count)?, input(normals, count)?];
        let [eye, ambient] = [one(eye)?, one(ambient)?];
        let (material, lights) = (one(material)?, input(lights, light_count)?);
        let [points, normals] = places.map(<[_]>::as_ptr_range);
        let inputs = [
            buffer::bytes(&points),
            buffer::bytes(&normals),
            buffer::bytes(&lights.as_ptr_range()),
        ];
        Ok((
            places,
            *eye,
            *ambient,
            *material,
            lights,
            output(out, count, &inputs)?,
        ))
    };
    code(
        buffers().and_then(|(places, eye, ambient, material, lights, out)| {
            shade_each(model, places, eye.into(), material, ambient, lights, out)
        }),
    )
}

fn shade_each(
    model: u32,
    places: [&[[f32; 3]]; 2],
    eye: Vec3,
    surface: Material,
    ambient: [f32; 3],
    given: &[Light],
    out: &mut [[f32; 3]],
) -> Result<(), Status> {
    let model = Model::of(model)?;
    let i_a = color(ambient).ok_or(Status::Material)?;
    let lights = lights(given)?;
    let m = surface.m;
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // it is a whole number
    if m.fract() == 0.0 && m < 65_536.0 {
        let surface = material(surface, m as u32)?;
        shade_all(model, places, eye, &surface, i_a, &lights, out);
    } else {
        let surface = material(surface, m)?;
        shade_all(model, places, eye, &surface, i_a, &lights, out);
    }
    Ok(())
}

fn shade_all<M: Exponent<f32>>(
    model: Model,
    [points, normals]: [&[[f32; 3]]; 2],
    eye: Vec3,
    material: &shading::f32::Material<M>,
    i_a: Rgb,
    lights: &[scene::AnyLight],
    out: &mut [[f32; 3]],
) {
    for ((p, n), out) in points.iter().zip(normals).zip(out) {
        let p = Vec3::from(*p);
        let directions = Vec3::from(*n).unit().zip((eye - p).unit());
        *out = directions.map_or([0.0; 3], |(n, v)| {
            let arriving = lights.iter().map(|light| light.at(p));
            let shaded = match model {
                Model::Lambert => shade::lambert(n, material, i_a, arriving),
                Model::Phong => shade::phong(n, v, material, i_a, arriving),
                Model::BlinnPhong => shade::blinn_phong(n, v, material, i_a, arriving),
            };
            shaded.total().into()
        });
    }
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
    let buffers = || unsafe {
        let colors = input(colors, count)?;
        let inputs = [buffer::bytes(&colors.as_ptr_range())];
        Ok((colors, output(out, count, &inputs)?))
    };
    code(buffers().map(|(colors, out)| {
        for (color, out) in colors.iter().zip(out) {
            *out = Rgb::from(*color).to_srgb8();
        }
    }))
}
