//! The levels of a display, checked against the standard's formula in 60 digits. `exhaustive.rs`
//! tries every `f32` between the edges found here.

mod srgb;

use std::hint::black_box;

use shading::f32::Rgb;
use srgb::{decoded, edges, linear_edges, number};

/// The next smaller number.
fn below(x: f32) -> f32 {
    f32::from_bits(x.to_bits() - 1)
}

/// Three levels packed into 16 bits.
fn rgb565(r: u16, g: u16, b: u16) -> u16 {
    r << 11 | g << 5 | b
}

#[test]
fn bytes_begin_where_the_standard_says() {
    for (byte, edge) in (1..=255).zip(edges(255)) {
        assert_eq!(Rgb::gray(edge).to_srgb8(), [byte; 3], "{edge:e}");
        assert_eq!(Rgb::gray(below(edge)).to_srgb8(), [byte - 1; 3], "{edge:e}");
    }
}

/// Green has six bits; red and blue have five.
#[test]
fn levels_of_rgb565_begin_where_the_standard_says() {
    let only = |r: f32, g, b| Rgb::new(r, g, b).to_rgb565();
    for (level, edge) in (1..).zip(edges(31)) {
        assert_eq!(only(edge, 0.0, 0.0), level << 11);
        assert_eq!(only(0.0, 0.0, edge), level);
        let edge = below(edge);
        assert_eq!(only(edge, 0.0, edge), rgb565(level - 1, 0, level - 1));
    }
    for (level, edge) in (1..).zip(edges(63)) {
        assert_eq!(only(0.0, edge, 0.0), level << 5);
        assert_eq!(only(0.0, below(edge), 0.0), (level - 1) << 5);
    }
}

/// Also a signaling NaN, which AArch64's maximum takes for a number. What the compiler does not see
/// is computed at run time, as a picture is.
#[test]
fn every_nan_is_dark() {
    for infinity in [0x7F80_0000, 0xFF80_0000_u32] {
        for payload in [1, 0x003F_FFFF, 0x0040_0000, 0x007F_FFFF] {
            let color = shading::Rgb::gray(f32::from_bits(infinity | payload));
            let color = black_box(color);
            let levels = black_box((color.to_srgb8(), color.to_linear8()));
            let packed = black_box(color.to_rgb565());
            assert_eq!((levels, packed), (([0; 3], [0; 3]), 0));
        }
    }
}

/// Without encoding, the level of x is round(n x): l from (l − ½)/n on.
#[test]
fn linear_levels_begin_half_a_level_below() {
    for (byte, edge) in (1..=255).zip(linear_edges(255)) {
        assert_eq!(Rgb::gray(edge).to_linear8(), [byte; 3], "{edge:e}");
        assert_eq!(
            Rgb::gray(below(edge)).to_linear8(),
            [byte - 1; 3],
            "{edge:e}"
        );
    }
}

#[test]
fn every_rgb565_decodes_to_the_nearest_number() {
    let light = |level: u16, highest: f64| {
        let light = decoded(&(number(level.into()) / number(highest)));
        light.to_f32().value()
    };
    for level in 0..32 {
        let color = Rgb::from_rgb565(rgb565(level, 0, 31 - level));
        assert_eq!(
            color,
            Rgb::new(light(level, 31.0), 0.0, light(31 - level, 31.0))
        );
    }
    for level in 0..64 {
        assert_eq!(
            Rgb::from_rgb565(level << 5),
            Rgb::new(0.0, light(level, 63.0), 0.0)
        );
    }
}

#[test]
fn bytes_decode_to_the_nearest_number() {
    for byte in 0..=255 {
        let light = decoded(&(number(f64::from(byte)) / number(255.0)));
        assert_eq!(
            Rgb::from_srgb8([byte; 3]),
            Rgb::gray(light.to_f32().value()),
            "{byte}"
        );
    }
}

/// 255 (1.055 · 0.5^(1/2.4) − 0.055) = 187.52, and 255 · 12.92 · 0.001 = 3.29.
#[test]
fn each_channel_has_its_own_level() {
    let color = Rgb::new(0.5, 0.001, 1.0);
    assert_eq!(color.to_srgb8(), [188, 3, 255]);
    // 31 · 0.735 = 22.8, 63 · 0.0129 = 0.81
    assert_eq!(color.to_rgb565(), rgb565(23, 1, 31));
    assert_eq!(Rgb::from_srgb8([188, 3, 255]).to_srgb8(), [188, 3, 255]);
}

#[test]
fn constants_are_encoded_by_the_compiler() {
    const BACKGROUND: u16 = Rgb::gray(0.5).to_rgb565();
    const BYTES: [u8; 3] = Rgb::WHITE.to_srgb8();
    static BRASS: Rgb = Rgb::const_from_srgb8([0xB5, 0xA6, 0x42]);
    assert_eq!(BACKGROUND, rgb565(23, 46, 23));
    assert_eq!(BYTES, [255; 3]);
    assert_eq!(BRASS.to_srgb8(), [0xB5, 0xA6, 0x42]);
}

/// Every byte and every color of 16 bits survives in double precision, and a number encodes as the nearest one
/// in single precision does.
#[test]
fn doubles_are_encoded_as_the_nearest_single() {
    use shading::f64::Rgb as Double;
    for byte in 0..=255 {
        let decoded = Double::from_srgb8([byte; 3]);
        assert_eq!(decoded.to_srgb8(), [byte; 3]);
        assert_eq!(decoded, Double::const_from_srgb8([byte; 3]));
        assert_eq!(decoded, Rgb::from_srgb8([byte; 3]).map(f64::from));
    }
    for bits in 0..=u16::MAX {
        let decoded = Double::from_rgb565(bits);
        assert_eq!(decoded.to_rgb565(), bits);
        assert_eq!(decoded, Rgb::from_rgb565(bits).map(f64::from));
    }
    for i in -100_i16..1200 {
        let double = Double::gray(f64::from(i) / 1000.0);
        let single = Rgb::gray(f32::from(i) / 1000.0);
        assert_eq!(double.to_srgb8(), single.to_srgb8());
        assert_eq!(double.to_rgb565(), single.to_rgb565());
        assert_eq!(double.to_linear8(), single.to_linear8());
    }
    assert_eq!(Double::new(f64::NAN, 1e300, -1e300).to_srgb8(), [0, 255, 0]);
}
