//! The levels of a display, checked against the standard's formula in 60 digits. `exhaustive.rs`
//! tries every `f32` between the edges found here.

#[path = "support/srgb.rs"]
mod srgb;

use std::hint::black_box;

use shading::f32::Rgb;
use srgb::{decoded, edges, edges_f64, linear_edges, number};

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

/// Every number in double precision, too: one that `f32` cannot tell from an edge has its own level.
#[test]
fn levels_of_doubles_begin_where_the_standard_says() {
    use shading::f64::Rgb;

    for (byte, edge) in (1..=255).zip(edges_f64(255)) {
        assert_eq!(Rgb::gray(edge).to_srgb8(), [byte; 3], "{edge:e}");
        assert_eq!(
            Rgb::gray(edge.next_down()).to_srgb8(),
            [byte - 1; 3],
            "{edge:e}"
        );
    }
    for (level, edge) in (1..).zip(edges_f64(31)) {
        assert_eq!(
            Rgb::new(edge, 0.0, edge).to_rgb565(),
            rgb565(level, 0, level)
        );
        let below = edge.next_down();
        assert_eq!(
            Rgb::new(below, 0.0, below).to_rgb565(),
            rgb565(level - 1, 0, level - 1)
        );
    }
    for (level, edge) in (1..).zip(edges_f64(63)) {
        assert_eq!(Rgb::new(0.0, edge, 0.0).to_rgb565(), level << 5);
        assert_eq!(
            Rgb::new(0.0, edge.next_down(), 0.0).to_rgb565(),
            (level - 1) << 5
        );
    }
    for (x, byte) in [
        (-1.0, 0),
        (f64::NAN, 0),
        (-0.0, 0),
        (f64::MIN_POSITIVE, 0),
        (2.0, 255),
        (f64::INFINITY, 255),
    ] {
        assert_eq!(Rgb::gray(x).to_srgb8(), [byte; 3]);
        assert_eq!(Rgb::gray(x).to_linear8(), [byte; 3]);
        assert_eq!(Rgb::gray(x).to_rgb565() & 31, u16::from(byte) / 8);
        assert_eq!(Rgb::gray(x).to_linear565() & 31, u16::from(byte) / 8);
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
            let packed = black_box((color.to_rgb565(), color.to_linear565()));
            assert_eq!((levels, packed), (([0; 3], [0; 3]), (0, 0)));
        }
    }
    for infinity in [0x7FF0_0000_0000_0000, 0xFFF0_0000_0000_0000_u64] {
        for payload in [1, (1 << 51) - 1, 1 << 51, (1 << 52) - 1] {
            let color = shading::Rgb::gray(f64::from_bits(infinity | payload));
            let color = black_box(color);
            let levels = black_box((color.to_srgb8(), color.to_linear8()));
            let packed = black_box((color.to_rgb565(), color.to_linear565()));
            assert_eq!((levels, packed), (([0; 3], [0; 3]), (0, 0)));
        }
    }
}

/// An `f32` is a double, so both have one level.
#[test]
fn doubles_have_the_levels_of_singles() {
    use shading::f64;

    for bits in (0..1.01_f32.to_bits()).step_by(4099) {
        let single = Rgb::new(
            f32::from_bits(bits),
            f32::from_bits(bits + 1),
            f32::from_bits(bits + 2),
        );
        let double: f64::Rgb = single.map(core::primitive::f64::from);
        assert_eq!(single.to_srgb8(), double.to_srgb8());
        assert_eq!(single.to_rgb565(), double.to_rgb565());
        assert_eq!(single.to_linear8(), double.to_linear8());
        assert_eq!(single.to_linear565(), double.to_linear565());
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
    for (level, edge) in (1..).zip(linear_edges(31)) {
        assert_eq!(
            Rgb::new(edge, 0.0, below(edge)).to_linear565(),
            rgb565(level, 0, level - 1)
        );
        assert_eq!(
            Rgb::new(below(edge), 0.0, edge).to_linear565(),
            rgb565(level - 1, 0, level)
        );
    }
    for (level, edge) in (1..).zip(linear_edges(63)) {
        assert_eq!(Rgb::new(0.0, edge, 0.0).to_linear565(), level << 5);
        assert_eq!(
            Rgb::new(0.0, below(edge), 0.0).to_linear565(),
            (level - 1) << 5
        );
    }
    // half a level in doubles: 2n x = 2l − 1 is decided in quadruple precision by u128
    for highest in [255_u64, 63, 31] {
        for level in 1..=highest {
            let reaches = |x: f64| {
                let (m, k) = (
                    x.to_bits() << 12 >> 12 | 1 << 52,
                    1075 - (x.to_bits() >> 52),
                );
                u128::from(m * 2 * highest) >= u128::from(2 * level - 1) << k
            };
            #[allow(clippy::cast_precision_loss)]
            let middle = (level as f64 - 0.5) / highest as f64;
            for x in [middle.next_down(), middle, middle.next_up()] {
                let color = shading::Rgb::gray(x);
                let got = match highest {
                    255 => u64::from(color.to_linear8()[1]),
                    63 => u64::from(color.to_linear565() >> 5 & 63),
                    _ => u64::from(color.to_linear565() >> 11),
                };
                assert_eq!(got, level - 1 + u64::from(reaches(x)), "{x:e} of {highest}");
            }
        }
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
    static BRASS: Rgb = Rgb::from_srgb8([0xB5, 0xA6, 0x42]);
    assert_eq!(BACKGROUND, rgb565(23, 46, 23));
    assert_eq!(BYTES, [255; 3]);
    assert_eq!(BRASS.to_srgb8(), [0xB5, 0xA6, 0x42]);
}

/// Each step from 0 to 1 is an `f32`, whose level is that of the standard.
#[cfg(feature = "fixed")]
#[test]
fn every_fixed_point_number_has_its_level() {
    use shading::fixed::{Fixed, Rgb};

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

        // round(n · steps/2¹⁶), ½ up
        let linear =
            |highest: i32| u16::try_from((2 * highest * steps + 65_536) / 131_072).unwrap();
        assert_eq!(color.to_linear8().map(u16::from), [linear(255); 3]);
        assert_eq!(
            color.to_linear565(),
            rgb565(linear(31), linear(63), linear(31))
        );
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
        assert_eq!(color.to_linear8(), color.to_srgb8());
        assert_eq!(color.to_linear565(), color.to_rgb565());
    }
}

#[cfg(feature = "fixed")]
#[test]
fn each_fixed_point_channel_has_its_own_level() {
    use shading::fixed::{Fixed, Rgb};

    const BYTES: [u8; 3] = Rgb::new(Fixed::new(0.5), Fixed::new(0.001), Fixed::new(1.0)).to_srgb8();
    const BITS: u16 = Rgb::new(Fixed::new(0.5), Fixed::new(0.001), Fixed::new(1.0)).to_rgb565();
    // as in `each_channel_has_its_own_level`
    assert_eq!(BYTES, [188, 3, 255]);
    assert_eq!(BITS, rgb565(23, 1, 31));
}
