//! The encodings of light, in a language whose textures do not encode.

use shading::Rgb;

use crate::dialect::{Dialect, filled};

/// The text of the encodings, with the least light of each level.
pub fn encodings(dialect: &Dialect) -> String {
    let rgb565 = |x: f32| u32::from(Rgb::gray(x).to_rgb565());
    let of_5_bits = edges(dialect, 32, |x| rgb565(x) & 31);
    let of_6_bits = edges(dialect, 64, |x| rgb565(x) >> 5 & 63);
    let of_8_bits = edges(dialect, 256, |x| u32::from(Rgb::gray(x).to_srgb8()[0]));
    let places = [
        ("5_bits", &of_5_bits[..]),
        ("6_bits", &of_6_bits),
        ("8_bits", &of_8_bits),
    ];
    filled(dialect.encodings, &places)
}

/// The least number of each level but 0, found by bisection.
fn edges(dialect: &Dialect, count: u32, level: impl Fn(f32) -> u32) -> String {
    let edge = |of| {
        let (mut below, mut from) = (0.0_f32.to_bits(), 1.0_f32.to_bits());
        while from - below > 1 {
            let middle = u32::midpoint(below, from);
            if level(f32::from_bits(middle)) < of {
                below = middle;
            } else {
                from = middle;
            }
        }
        dialect.number(f32::from_bits(from)) + ","
    };
    let edges: Vec<_> = (1..count).map(edge).collect();
    let line = |edges: &[String]| format!("    {}\n", edges.join(" "));
    edges.chunks(7).map(line).collect()
}
