//! Colors to bytes and back.
#![allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // bytes

use palette::{LinSrgb, Srgb};
use shading::f32::Rgb;

use crate::data::colors;
use crate::race::{Race, limit, twice};

fn encoded(linear: f32) -> f32 {
    let linear = linear.clamp(0.0, 1.0);
    if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * linear.powf(1.0 / 2.4) - 0.055
    }
}

/// Rounds each channel to one of its levels.
fn packed([r, g, b]: [f32; 3]) -> u16 {
    let level = |channel: f32, highest: f32| (channel * highest + 0.5) as u16;
    level(r, 31.0) << 11 | level(g, 63.0) << 5 | level(b, 31.0)
}

pub fn race() -> usize {
    let colors = colors();
    let bytes: Vec<_> = colors
        .iter()
        .map(|(kind, colors)| {
            (
                *kind,
                colors.iter().map(|&c| Rgb::from(c).to_srgb8()).collect(),
            )
        })
        .collect();
    Race::of("to_srgb8", twice!(|&c| Rgb::from(c).to_srgb8()))
        .against(
            "fast-srgb8",
            limit(1.2, 1.2),
            twice!(|c: &[f32; 3]| { c.map(fast_srgb8::f32_to_srgb8) }),
        )
        .against(
            "palette",
            limit(1.0, 1.0),
            twice!(|&c| -> [u8; 3] { Srgb::<u8>::from_linear(LinSrgb::from(c)).into() }),
        )
        .against(
            "powf",
            limit(0.4, 0.4),
            twice!(|c| { c.map(|c| (255.0 * encoded(c) + 0.5) as u8) }),
        )
        .run(&colors)
        + Race::of("from_srgb8", twice!(|&b| Rgb::from_srgb8(b)))
            .against(
                "fast-srgb8",
                limit(1.2, 1.2),
                twice!(|b: &[u8; 3]| { b.map(fast_srgb8::srgb8_to_f32) }),
            )
            .run(&bytes)
        + Race::of("to_rgb565", twice!(|&c| Rgb::from(c).to_rgb565()))
            .against(
                "powf",
                limit(0.4, 0.4),
                twice!(|c: &[f32; 3]| { packed(c.map(encoded)) }),
            )
            .run(&colors)
        + Race::of("clamped", twice!(|&c| Rgb::from(c).clamped()))
            .against(
                "by hand",
                limit(1.2, 1.2),
                twice!(|c: &[f32; 3]| { c.map(|c| c.clamp(0.0, 1.0)) }),
            )
            .run(&colors)
}
