//! From linear light to the numbers that a display takes.

use shading::Elementary;

/// The sRGB encoding of linear light within [0, 1].
///
/// The power is made of the crate's own exponential and logarithm: the standard library's may
/// differ from machine to machine, and with it the bytes of a picture.
///
/// Source: IEC 61966-2-1.
pub fn encode(linear: f32) -> f32 {
    if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * Elementary::exp(Elementary::ln(linear) / 2.4) - 0.055
    }
}

/// The same as a byte.
pub fn byte(linear: f32) -> u8 {
    (255.0 * encode(linear) + 0.5) as u8
}
