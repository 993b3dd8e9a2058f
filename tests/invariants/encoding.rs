//! sRGB and RGB565. The encodings are those of `f32` alone.

use proptest::prelude::*;
use shading::Rgb;

use crate::check::{check, within};

/// A number of any bits, or one that is displayed.
fn any_number() -> impl Strategy<Value = f32> {
    prop_oneof![any::<u32>().prop_map(f32::from_bits), 0.0..=1.0_f32]
}

/// A color that is displayed.
fn displayed() -> impl Strategy<Value = Rgb> {
    let channel = || prop_oneof![3 => 0.0..=1.0_f32, 1 => 0.0..=0.01_f32];
    [channel(), channel(), channel()].prop_map(Rgb::from)
}

/// The levels of red, green and blue.
fn levels(color: Rgb) -> [u16; 3] {
    let bits = color.to_rgb565();
    [bits >> 11, bits >> 5 & 63, bits & 31]
}

/// (60) More light never gets a lower level. What is not a number is darkest.
#[test]
fn more_light_never_gets_a_lower_level() {
    check((any_number(), any_number()), |(a, b)| {
        let (dark, bright) = if a > b || b.is_nan() { (b, a) } else { (a, b) };
        let [dark, bright] = [dark, bright].map(Rgb::gray);
        prop_assert!(dark.to_srgb8() <= bright.to_srgb8());
        prop_assert!(dark.to_rgb565() <= bright.to_rgb565());
        Ok(())
    });
}

/// (60) Decoding and encoding gives every byte back.
#[test]
fn every_byte_survives_the_round_trip() {
    for byte in 0..=255 {
        let bytes = [byte, 255 - byte, byte / 3];
        assert_eq!(Rgb::from_srgb8(bytes).to_srgb8(), bytes);
    }
}

/// (60) Black and white are exact, from either side.
#[test]
fn ends_are_exact() {
    for (light, byte, bits) in [(0.0, 0, 0), (-0.0, 0, 0), (1.0, 255, u16::MAX)] {
        assert_eq!(Rgb::gray(light).to_srgb8(), [byte; 3]);
        assert_eq!(Rgb::gray(light).to_rgb565(), bits);
        assert_eq!(Rgb::from_srgb8([byte; 3]), Rgb::gray(light));
    }
}

/// (60) The levels of RGB565 are those of the bytes to half a level of each, so without more rounding than
/// that of the bytes.
#[test]
fn rgb565_agrees_with_the_bytes() {
    check(displayed(), |color| {
        let highest = [31.0, 63.0, 31.0];
        for ((level, byte), highest) in levels(color).into_iter().zip(color.to_srgb8()).zip(highest)
        {
            let difference = f64::from(level) / highest - f64::from(byte) / 255.0;
            within(difference, 0.5 / highest + 0.5 / 255.0)?;
        }
        Ok(())
    });
}
