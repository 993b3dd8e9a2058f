//! sRGB and RGB565. `tests/encoding.rs` checks where each level begins, for every number type.

use proptest::prelude::*;
use shading::f32::Rgb;
use shading_laws::number::check::{check, within};

/// A number of arbitrary bits, or one that a display can show.
fn any_number() -> impl Strategy<Value = f32> {
    prop_oneof![any::<u32>().prop_map(f32::from_bits), 0.0..=1.0_f32]
}

/// A color that a display can show.
fn displayed() -> impl Strategy<Value = Rgb> {
    let channel = || prop_oneof![3 => 0.0..=1.0_f32, 1 => 0.0..=0.01_f32];
    [channel(), channel(), channel()].prop_map(Rgb::from)
}

/// The levels of red, green and blue.
fn levels(color: Rgb) -> [u16; 3] {
    let bits = color.to_rgb565();
    [bits >> 11, bits >> 5 & 63, bits & 31]
}

/// (60) More light never gets a lower level. NaN is darkest.
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

/// (60) Decoding a byte and encoding the result gives the byte back.
#[test]
fn every_byte_survives_the_round_trip() {
    for byte in 0..=255 {
        let bytes = [byte, 255 - byte, byte / 3];
        assert_eq!(Rgb::from_srgb8(bytes).to_srgb8(), bytes);
    }
}

/// (60) Black and white are exact in both directions.
#[test]
fn ends_are_exact() {
    for (light, byte, bits) in [(0.0, 0, 0), (-0.0, 0, 0), (1.0, 255, u16::MAX)] {
        assert_eq!(Rgb::gray(light).to_srgb8(), [byte; 3]);
        assert_eq!(Rgb::gray(light).to_rgb565(), bits);
        assert_eq!(Rgb::from_srgb8([byte; 3]), Rgb::gray(light));
    }
}

/// (60) All bits survive the round trip.
#[test]
fn all_of_rgb565_survives_the_round_trip() {
    for bits in 0..=u16::MAX {
        assert_eq!(Rgb::from_rgb565(bits).to_rgb565(), bits);
    }
}

/// (64) A row of pixels encodes to the bytes of its pixels one by one, so the compiler may vectorize it.
#[test]
fn a_row_encodes_as_its_pixels_do() {
    check(proptest::collection::vec(displayed(), 0..40), |row| {
        let bytes: Vec<_> = row.iter().map(|color| color.to_srgb8()).collect();
        let bits: Vec<_> = row.iter().map(|color| color.to_rgb565()).collect();
        for (i, color) in row.into_iter().enumerate() {
            prop_assert_eq!(bytes[i], std::hint::black_box(color).to_srgb8());
            prop_assert_eq!(bits[i], std::hint::black_box(color).to_rgb565());
        }
        Ok(())
    });
}

/// (60) The levels of RGB565 agree with the bytes to half a level of each, so no rounding is added
/// to that of the bytes.
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
