//! The levels of a display, checked against the standard's formula in 60 digits. `exhaustive.rs`
//! tries every `f32` between the edges found here.

#[path = "support/srgb.rs"]
mod srgb;

use shading::Rgb;
use srgb::{decoded, edges, number};

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
    const BYTES: [u8; 3] = Rgb::<f32>::WHITE.to_srgb8();
    static BRASS: Rgb = Rgb::from_srgb8([0xB5, 0xA6, 0x42]);
    assert_eq!(BACKGROUND, rgb565(23, 46, 23));
    assert_eq!(BYTES, [255; 3]);
    assert_eq!(BRASS.to_srgb8(), [0xB5, 0xA6, 0x42]);
}

/// Each step from 0 to 1 is an `f32`, whose level is that of the standard.
#[cfg(feature = "fixed")]
#[test]
fn every_fixed_point_number_has_its_level() {
    use shading::fixed::Fixed;

    let [mut bytes, mut fives, mut sixes] = [255, 31, 63].map(|highest| {
        let edges = edges(highest).into_iter().map(f64::from);
        edges.chain([f64::INFINITY]).peekable()
    });
    let (mut byte, mut five, mut six) = (0_u8, 0_u16, 0_u16);
    for steps in 0..=65_536 {
        let light = f64::from(steps) / 65_536.0;
        byte += u8::from(bytes.next_if(|&edge| edge <= light).is_some());
        five += u16::from(fives.next_if(|&edge| edge <= light).is_some());
        six += u16::from(sixes.next_if(|&edge| edge <= light).is_some());
        let color = Rgb::gray(Fixed::from_bits(steps));
        assert_eq!(color.to_srgb8(), [byte; 3], "{steps} steps");
        assert_eq!(color.to_rgb565(), rgb565(five, six, five), "{steps} steps");
    }
    assert_eq!([u16::from(byte), five, six], [255, 31, 63]);

    let outside = (-32_768..32_767).map(|whole| whole * 65_536);
    for steps in outside
        .filter(|&steps| steps != 0)
        .chain([-1, 65_537, i32::MAX])
    {
        let is_light = steps > 0;
        let color = Rgb::gray(Fixed::from_bits(steps));
        assert_eq!(color.to_srgb8(), [if is_light { 255 } else { 0 }; 3]);
        assert_eq!(color.to_rgb565(), if is_light { u16::MAX } else { 0 });
    }
}

#[cfg(feature = "fixed")]
#[test]
fn each_fixed_point_channel_has_its_own_level() {
    use shading::fixed::Fixed;

    const BYTES: [u8; 3] = Rgb::new(Fixed::new(0.5), Fixed::new(0.001), Fixed::new(1.0)).to_srgb8();
    const BITS: u16 = Rgb::new(Fixed::new(0.5), Fixed::new(0.001), Fixed::new(1.0)).to_rgb565();
    // as in `each_channel_has_its_own_level`
    assert_eq!(BYTES, [188, 3, 255]);
    assert_eq!(BITS, rgb565(23, 1, 31));
}
