//! One picture by several programs: a ball under one lamp, with Blinn's highlight, 240 × 240 pixels
//! in RGB565. The crate draws it in each of its numbers. Beside it stands the same as a careful
//! author of firmware writes it by hand: the same formula, in which nothing is computed twice, and
//! no care for what cannot happen here, and the same by the headers for C.

mod by_hand;
mod by_the_crate;
mod in_c;

use crate::is_same;

/// The sides of the picture in pixels.
pub const SIDE: i16 = 240;
const RADIUS: i16 = SIDE / 2;
/// The color beside the ball.
pub const BEHIND: u16 = 0;

/// A scene that the program for each number makes its own constants of, by the compiler.
mod scene {
    pub const LAMP: [f64; 3] = [2.0, 3.0, 4.0];
    pub const INTENSITY: [f64; 3] = [1.0, 0.9, 0.8];
    /// The coefficients a, b and c of the falloff.
    pub const FALLOFF: [f64; 3] = [0.5, 0.0, 0.03];
    pub const K_A: f64 = 0.3;
    pub const K_D: [f64; 3] = [0.78, 0.57, 0.11];
    pub const K_S: [f64; 3] = [0.99, 0.94, 0.81];
    pub const M: u32 = 28;
    pub const AMBIENT: f64 = 0.1;
}

/// Colors the pixel that is so many pixels to the right of the center and above it, on the ball.
pub type Pixel = fn(right: i16, up: i16) -> u16;

/// The programs by name. `f64` is for comparison alone.
pub const F64: Pixel = by_the_crate::in_f64::pixel;
/// In single precision.
pub const F32: Pixel = by_the_crate::in_f32::pixel;
/// In fixed point.
pub const FIXED: Pixel = by_the_crate::in_fixed::pixel;
/// In single precision by hand, with the root of `libm`.
pub const F32_BY_HAND: Pixel = by_hand::with_libm;
/// In single precision by hand, with the approximate roots of `micromath`.
pub const F32_BY_MICROMATH: Pixel = by_hand::with_micromath;
/// By hand with the numbers of the crate `fixed`.
pub const FIXED_BY_HAND: Pixel = by_hand::fixed::pixel;

/// In single precision with a real m, by the header for C.
pub const F32_IN_C: Pixel = in_c::f32;
/// In fixed point, by the header for C.
pub const FIXED_IN_C: Pixel = in_c::fixed;

/// Draws a row of the picture: `show` is given each column and its color.
#[inline(always)]
pub fn draw_row(row: i16, pixel: Pixel, mut show: impl FnMut(u8, u16)) {
    let up = RADIUS - row;
    for column in 0..SIDE as u8 {
        let right = i16::from(column) - RADIUS;
        let square = i32::from(right) * i32::from(right) + i32::from(up) * i32::from(up);
        let is_on_ball = square < i32::from(RADIUS) * i32::from(RADIUS);
        let color = if is_on_ball { pixel(right, up) } else { BEHIND };
        show(column, color);
    }
}

/// The programs that run on chips, by name.
pub const PROGRAMS: [(&str, Pixel); 7] = [
    ("f32", F32),
    ("f32_by_hand", F32_BY_HAND),
    ("f32_by_micromath", F32_BY_MICROMATH),
    ("f32_in_c", F32_IN_C),
    ("fixed", FIXED),
    ("fixed_by_hand", FIXED_BY_HAND),
    ("fixed_in_c", FIXED_IN_C),
];

/// The program that the variable `BALL` names at build time.
pub const fn chosen() -> Pixel {
    let Some(name) = option_env!("BALL") else {
        return F64;
    };
    let (mut i, name) = (0, name.as_bytes());
    while i < PROGRAMS.len() {
        if is_same(PROGRAMS[i].0.as_bytes(), name) {
            return PROGRAMS[i].1;
        }
        i += 1;
    }
    panic!("BALL names no program")
}
