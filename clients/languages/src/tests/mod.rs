//! What `shading.h` promises, by the functions of C.
#![allow(clippy::float_cmp, reason = "the bits are what is compared")]

mod bits;
mod interface;
mod pointers;

use std::ffi::CStr;
use std::mem::MaybeUninit;

use crate::c::{CScene, Error, shading_default_light, shading_default_scene, shading_shade};
use crate::light::Light;

const POINTS: [[f32; 3]; 2] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0]];
const NORMALS: [[f32; 3]; 2] = [[0.0, 0.0, 1.0], [0.0, 0.0, 2.0]];

fn sun() -> Light {
    Light {
        toward: [0.0, 0.0, 1.0],
        ..shading_default_light(0)
    }
}

/// Two points under the lights.
fn scene(lights: &[Light]) -> CScene {
    let mut scene = shading_default_scene();
    scene.count = 2;
    scene.points = POINTS.as_ptr();
    scene.normals = NORMALS.as_ptr();
    scene.eye = [0.0, 0.0, 5.0];
    scene.material.k_d = [0.5; 3];
    scene.lights = lights.as_ptr();
    scene.light_count = lights.len();
    scene
}

/// What a function of C says about its arguments.
fn refusal(call: impl FnOnce(*mut Error) -> i32) -> Result<(), (i32, usize, usize, String)> {
    let mut error = MaybeUninit::<Error>::uninit();
    let status = call(error.as_mut_ptr());
    if status == 0 {
        return Ok(());
    }
    // SAFETY: the function has written it
    let Error {
        status: written,
        light,
        index,
        text,
    } = unsafe { error.assume_init() };
    assert_eq!(written, status);
    let text = CStr::from_bytes_until_nul(&text)
        .expect("a zero byte")
        .to_str();
    Err((status, light, index, text.expect("ASCII").to_owned()))
}

/// The colors, or what is wrong; then the output is as it was.
fn shade(scene: &CScene) -> Result<Vec<[f32; 3]>, (i32, usize, usize, String)> {
    let mut out = vec![[-1.0; 3]; scene.count * if scene.parts == 1 { 3 } else { 1 }];
    // SAFETY: the pointers of the scenes here are those of arrays that are long enough
    let result = refusal(|error| unsafe { shading_shade(scene, out.as_mut_ptr(), error) });
    assert_eq!(
        result.is_err(),
        out.iter().any(|color| *color == [-1.0; 3]),
        "{result:?}"
    );
    result.map(|()| out)
}
