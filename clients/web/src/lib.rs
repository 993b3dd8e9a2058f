//! A page to play with: a sphere or the Utah teapot, shaded by WebAssembly at every move of a control.
//!
//! The page writes its controls into the memory at [`settings`] and reads the picture from the memory
//! to which [`draw`] points. There is nothing between the two but these functions. The host runs the same
//! code, and the tests compare the two pictures byte by byte.

mod mesh;
pub mod page;
pub mod scene;
pub mod surface;

use std::sync::{Mutex, MutexGuard, PoisonError};

use page::Page;
use scene::Part;
use shading::f32::Vec3;

static PAGE: Mutex<Page> = Mutex::new(Page::EMPTY);

fn page() -> MutexGuard<'static, Page> {
    PAGE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The numbers of the controls, for the page to write.
#[unsafe(no_mangle)]
pub extern "C" fn settings() -> *mut f32 {
    page().settings.as_mut_ptr()
}

/// The bytes of the picture: the whole, or its ambient (1), diffuse (2) or specular part (3).
#[unsafe(no_mangle)]
pub extern "C" fn draw(part: u32, width: u32, height: u32) -> *const u8 {
    page()
        .draw(numbered(part), width as usize, height as usize)
        .as_ptr()
}

/// The part of the number that the page gives it.
#[must_use]
pub fn numbered(part: u32) -> Part {
    match part {
        1 => Part::Ambient,
        2 => Part::Diffuse,
        3 => Part::Specular,
        _ => Part::Total,
    }
}

/// The numbers of a pixel.
#[unsafe(no_mangle)]
pub extern "C" fn probe(width: u32, height: u32, x: u32, y: u32) -> *const f32 {
    page()
        .probe(width as usize, height as usize, x as usize, y as usize)
        .as_ptr()
}

/// The bytes of the picture of a coarse mesh: flat, or by Gouraud.
#[unsafe(no_mangle)]
pub extern "C" fn draw_mesh(is_smooth: bool, width: u32, height: u32) -> *const u8 {
    page()
        .draw_mesh(is_smooth, width as usize, height as usize)
        .as_ptr()
}

/// A number of the place of a point in the picture, in pixels: 0 and 1 for where it is, and 2 for its depth.
#[unsafe(no_mangle)]
pub extern "C" fn projected(x: f32, y: f32, z: f32, width: u32, height: u32, number: usize) -> f32 {
    page().project(Vec3::new(x, y, z), width as usize, height as usize)[number.min(2)]
}

/// Where a lamp, 0 or 1, is in the picture, in pixels.
#[unsafe(no_mangle)]
pub extern "C" fn lamp_x(lamp: u32, width: u32, height: u32) -> f32 {
    page().lamp(lamp as usize, width as usize, height as usize)[0]
}

/// As [`lamp_x`].
#[unsafe(no_mangle)]
pub extern "C" fn lamp_y(lamp: u32, width: u32, height: u32) -> f32 {
    page().lamp(lamp as usize, width as usize, height as usize)[1]
}

/// A coordinate, 0, 1 or 2, of a lamp that is moved to a place in the picture and keeps its depth.
#[unsafe(no_mangle)]
pub extern "C" fn moved(
    lamp: u32,
    width: u32,
    height: u32,
    x: f32,
    y: f32,
    coordinate: usize,
) -> f32 {
    page().moved(lamp as usize, width as usize, height as usize, [x, y])[coordinate.min(2)]
}

/// The text for the user, in UTF-8.
#[unsafe(no_mangle)]
pub extern "C" fn message() -> *const u8 {
    page().message().as_ptr()
}

#[unsafe(no_mangle)]
pub extern "C" fn message_length() -> usize {
    page().message().len()
}
