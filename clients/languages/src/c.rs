//! The functions of `shading.h`.

use std::ffi::c_char;
use std::slice::from_ref;

use shading::f32::Rgb;

use crate::implicit::Grid;
use crate::kernel::{Out, shade_all};
use crate::light::Light;
use crate::normals;
use crate::pointer::{Taken, input, output, taken};
use crate::problem::{Problem, Status, text};
use crate::scene::{Model, Scene};
use crate::threads;

#[derive(Clone, Copy)]
#[repr(C)]
pub struct Material {
    pub k_a: [f32; 3],
    pub k_d: [f32; 3],
    pub k_s: [f32; 3],
    pub m: f32,
}

/// What differs from point to point, where a pointer is not null.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct Each {
    pub eye: *const [f32; 3],
    pub k_a: *const [f32; 3],
    pub k_d: *const [f32; 3],
    pub k_s: *const [f32; 3],
    pub m: *const f32,
    pub ambient: *const [f32; 3],
    pub visible: *const f32,
}

#[derive(Clone, Copy)]
#[repr(C)]
pub struct CScene {
    pub model: u32,
    pub parts: u32,
    pub count: usize,
    pub points: *const [f32; 3],
    pub normals: *const [f32; 3],
    pub eye: [f32; 3],
    pub ambient: [f32; 3],
    pub material: Material,
    pub lights: *const Light,
    pub light_count: usize,
    pub each: Each,
}

/// No sentence is longer, with the zero byte at its end.
const LONGEST: usize = 256;

/// Which light, point or row an error is about: this, if it is about none.
const NONE: usize = usize::MAX;

#[repr(C)]
pub struct Error {
    pub status: i32,
    pub light: usize,
    pub index: usize,
    pub text: [u8; LONGEST],
}

/// # Safety
///
/// If it is not null, `error` must be valid for an error.
unsafe fn report(result: Result<(), Problem>, error: *mut Error) -> i32 {
    let Err(problem) = result else {
        return 0;
    };
    let status = problem.status as i32;
    if !error.is_null() && error.is_aligned() {
        let mut text = [0; LONGEST];
        // sentences are ASCII, so any byte ends a character
        let sentence = problem.sentence();
        let bytes = sentence.as_bytes();
        let length = bytes.len().min(LONGEST - 1);
        text[..length].copy_from_slice(&bytes[..length]);
        let (light, index) = (problem.light.unwrap_or(NONE), problem.index.unwrap_or(NONE));
        // SAFETY: as the caller promises
        let written = Error {
            status,
            light,
            index,
            text,
        };
        unsafe { error.write(written) };
    }
    status
}

/// A value for each point, or one for all. The addresses are those of what lies in the caller's memory.
///
/// # Safety
///
/// A pointer that is not null must be valid for `count` values.
unsafe fn rows<'a, R>(
    name: &'static str,
    each: *const R,
    count: usize,
    one: &'a R,
    inputs: &mut Vec<Taken>,
) -> Result<&'a [R], Problem> {
    if each.is_null() {
        return Ok(from_ref(one));
    }
    // SAFETY: as the caller promises
    let rows = unsafe { input(name, each, count)? };
    inputs.push(taken(name, rows));
    Ok(rows)
}

/// A reflectance that the caller has not set. It is no number that a computation gives by mistake.
const NOT_GIVEN: [f32; 3] = [f32::NEG_INFINITY; 3];

/// The material, in which a reflectance that is not given is 0. One must be given. If all of it is 0,
/// the caller has forgotten it.
fn given(material: Material, each: &Each) -> Result<Material, Problem> {
    let is_texture = [each.k_a, each.k_d, each.k_s].iter().any(|k| !k.is_null());
    let all = [material.k_a, material.k_d, material.k_s];
    let is_zero = all == [[0.0; 3]; 3] && material.m == 0.0;
    if !is_texture && (is_zero || all == [NOT_GIVEN; 3]) {
        let expected = "a reflectance, such as 0.6, in k_d, k_a or k_s";
        return Err(Problem::new(Status::Reflectance, "k_d", expected, "none"));
    }
    let [k_a, k_d, k_s] = all.map(|k| if k == NOT_GIVEN { [0.0; 3] } else { k });
    let m = material.m;
    Ok(Material { k_a, k_d, k_s, m })
}

/// # Safety
///
/// Each pointer that is not null must be valid for as many numbers as `shading.h` says.
unsafe fn shade(scene: *const CScene, out: *mut [f32; 3]) -> Result<(), Problem> {
    // SAFETY: as the caller promises, here and below
    let scene = &unsafe { input("scene", scene, 1) }?[0];
    let CScene {
        count,
        each,
        material,
        ..
    } = *scene;
    let material = given(material, &each)?;
    let mut inputs = vec![taken("scene", from_ref(scene))];
    let inputs = &mut inputs;
    let (points, normals, lights) = unsafe {
        (
            input("points", scene.points, count)?,
            input("normals", scene.normals, count)?,
            input("lights", scene.lights, scene.light_count)?,
        )
    };
    inputs.extend([
        taken("points", points),
        taken("normals", normals),
        taken("lights", lights),
    ]);
    let fractions = count.saturating_mul(scene.light_count);
    let described = unsafe {
        Scene {
            model: Model::of(scene.model)?,
            count,
            points,
            normals,
            lights,
            eye: rows("each.eye", each.eye, count, &scene.eye, inputs)?,
            k_a: rows("each.k_a", each.k_a, count, &material.k_a, inputs)?,
            k_d: rows("each.k_d", each.k_d, count, &material.k_d, inputs)?,
            k_s: rows("each.k_s", each.k_s, count, &material.k_s, inputs)?,
            m: rows("each.m", each.m, count, &material.m, inputs)?,
            ambient: rows("each.ambient", each.ambient, count, &scene.ambient, inputs)?,
            visible: if each.visible.is_null() {
                None
            } else {
                Some(rows("each.visible", each.visible, fractions, &1.0, inputs)?)
            },
        }
    };
    let is_in_parts = match scene.parts {
        0 => false,
        1 => true,
        parts => return Err(Problem::new(Status::Count, "parts", "0 or 1", parts)),
    };
    let lights = described.checked()?;
    let all = count.saturating_mul(if is_in_parts { 3 } else { 1 });
    let out = unsafe { output(out, all, inputs)? };
    let out = if is_in_parts {
        let (ambient, rest) = out.split_at_mut(count);
        let (diffuse, specular) = rest.split_at_mut(count);
        Out::Parts([ambient, diffuse, specular])
    } else {
        Out::Total(out)
    };
    shade_all(&described, &lights, out);
    Ok(())
}

/// # Safety
///
/// Each pointer that is not null must be valid for as many numbers as `shading.h` says.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn shading_shade(
    scene: *const CScene,
    out: *mut [f32; 3],
    error: *mut Error,
) -> i32 {
    // SAFETY: as the caller promises
    unsafe { report(shade(scene, out), error) }
}

/// The scene with the defaults of all languages. Its eye is NaN, so that forgetting it is an error.
#[unsafe(no_mangle)]
pub extern "C" fn shading_default_scene() -> CScene {
    use std::ptr::null;
    CScene {
        model: 2,
        parts: 0,
        count: 0,
        points: null(),
        normals: null(),
        eye: [f32::NAN; 3],
        ambient: [1.0; 3],
        material: Material {
            k_a: NOT_GIVEN,
            k_d: NOT_GIVEN,
            k_s: NOT_GIVEN,
            m: 1.0,
        },
        lights: null(),
        light_count: 0,
        each: Each {
            eye: null(),
            k_a: null(),
            k_d: null(),
            k_s: null(),
            m: null(),
            ambient: null(),
            visible: null(),
        },
    }
}

#[unsafe(no_mangle)]
pub extern "C" fn shading_default_light(kind: u32) -> Light {
    Light::default_of(kind)
}

#[unsafe(no_mangle)]
pub extern "C" fn shading_status_text(status: i32) -> *const c_char {
    text(status).as_ptr().cast()
}

/// Makes each row of the output from the row of the input.
///
/// # Safety
///
/// A pointer that is not null must be valid for `count` values.
unsafe fn convert<A: Copy + Sync, B: Send>(
    count: usize,
    from: *const A,
    to: *mut B,
    f: impl Fn(A) -> B + Send + Sync,
) -> i32 {
    // SAFETY: as the caller promises
    let convert = || unsafe {
        let from = input("colors", from, count)?;
        threads::map(from, output(to, count, &[taken("colors", from)])?, f);
        Ok(())
    };
    // SAFETY: there is no error to write
    unsafe { report(convert(), std::ptr::null_mut()) }
}

pub fn rgba(color: [f32; 3]) -> [u8; 4] {
    let [r, g, b] = Rgb::from(color).to_srgb8();
    [r, g, b, 255]
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
    unsafe { convert(count, colors, out, |color| Rgb::from(color).to_srgb8()) }
}

/// # Safety
///
/// A pointer that is not null must be valid for `count` colors.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn shading_to_srgba8(
    count: usize,
    colors: *const [f32; 3],
    out: *mut [u8; 4],
) -> i32 {
    // SAFETY: as the caller promises
    unsafe { convert(count, colors, out, rgba) }
}

/// # Safety
///
/// A pointer that is not null must be valid for `count` colors.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn shading_from_srgb8(
    count: usize,
    texture: *const [u8; 3],
    out: *mut [f32; 3],
) -> i32 {
    // SAFETY: as the caller promises
    unsafe { convert(count, texture, out, |bytes| Rgb::from_srgb8(bytes).into()) }
}

/// # Safety
///
/// Each pointer that is not null must be valid for as many numbers as `shading.h` says.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn shading_height_field(
    rows: usize,
    columns: usize,
    z: *const f32,
    dx: f32,
    dy: f32,
    out: *mut [f32; 3],
    error: *mut Error,
) -> i32 {
    let count = rows.saturating_mul(columns);
    // SAFETY: as the caller promises
    unsafe {
        let field = || {
            let z = input("z", z, count)?;
            normals::check_field(z, dx, dy)?;
            normals::height_field(z, columns, dx, dy, output(out, count, &[taken("z", z)])?);
            Ok(())
        };
        report(field(), error)
    }
}

/// # Safety
///
/// Each pointer that is not null must be valid for as many numbers as `shading.h` says.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn shading_mesh_normals(
    count: usize,
    vertices: *const [f32; 3],
    face_count: usize,
    faces: *const [u32; 3],
    crease: f32,
    out: *mut [f32; 3],
    error: *mut Error,
) -> i32 {
    // SAFETY: as the caller promises
    unsafe {
        let normals = || {
            let (vertices, faces) = (
                input("vertices", vertices, count)?,
                input("faces", faces, face_count)?,
            );
            let inputs = [taken("vertices", vertices), taken("faces", faces)];
            normals::check_mesh(vertices, faces)?;
            if crease < 0.0 {
                normals::of_vertices(vertices, faces, output(out, count, &inputs)?);
            } else {
                normals::check_crease(crease)?;
                let corners = output(out, face_count.saturating_mul(3), &inputs)?;
                normals::of_corners(vertices, faces, crease, corners.as_chunks_mut().0);
            }
            Ok(())
        };
        report(normals(), error)
    }
}

/// # Safety
///
/// Each pointer that is not null must be valid for as many numbers as `shading.h` says.
#[allow(clippy::too_many_arguments)] // as C has them
#[unsafe(no_mangle)]
pub unsafe extern "C" fn shading_implicit(
    layers: usize,
    rows: usize,
    columns: usize,
    values: *const f32,
    dx: f32,
    dy: f32,
    dz: f32,
    count: usize,
    points: *const [f32; 3],
    out: *mut [f32; 3],
    error: *mut Error,
) -> i32 {
    let nodes = layers.saturating_mul(rows).saturating_mul(columns);
    // SAFETY: as the caller promises
    unsafe {
        let normals = || {
            let (values, points) = (
                input("values", values, nodes)?,
                input("points", points, count)?,
            );
            let grid = Grid {
                values,
                counts: [columns, rows, layers],
                steps: [dx, dy, dz],
            };
            grid.check(points)?;
            let inputs = [taken("values", values), taken("points", points)];
            grid.normals(points, output(out, count, &inputs)?);
            Ok(())
        };
        report(normals(), error)
    }
}

/// Room for so many words in the module's memory, for JavaScript, until `shading_free` is called with the
/// same number. It is null if there is not so much room. Nothing is written into it.
#[cfg(target_family = "wasm")]
#[unsafe(no_mangle)]
pub extern "C" fn shading_room(words: usize) -> *mut f32 {
    let mut room = Vec::new();
    match room.try_reserve_exact(words) {
        Ok(()) => std::mem::ManuallyDrop::new(room).as_mut_ptr(),
        Err(_) => std::ptr::null_mut(),
    }
}

/// # Safety
///
/// `room` must come from `shading_room(words)`, and nothing may use it afterward.
#[cfg(target_family = "wasm")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn shading_free(room: *mut f32, words: usize) {
    // SAFETY: as the caller promises
    drop(unsafe { Vec::from_raw_parts(room, 0, words) });
}
