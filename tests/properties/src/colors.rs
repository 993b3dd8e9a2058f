//! Colors as a screen takes them: bytes of sRGB, 16 bits, and back.

use proptest::prelude::*;
use shading::Rgb;

use crate::given::{Numbers, Triangle};
use crate::{Number, Outcome};

/// The curve of sRGB (IEC 61966-2-1).
fn encoded(c: f64) -> f64 {
    if c <= 0.003_130_8 {
        12.92 * c
    } else {
        1.055 * c.powf(1.0 / 2.4) - 0.055
    }
}

#[allow(clippy::cast_possible_truncation)] // encodings are of the nearest f32
fn single<T: Number>(x: T) -> f32 {
    x.exact() as f32
}

/// Colors are clamped to [0, 1] channel by channel, and those within it stay.
pub fn a_clamped_color_is_within_0_and_1<T: Number>(t: &Triangle<T>) -> Outcome {
    let color = Rgb::from(<[T; 3]>::from(t.a));
    let [is, was] = [color.clamped(), color].map(|c| [c.r, c.g, c.b].map(T::exact));
    prop_assert_eq!(is, was.map(|x| x.clamp(0.0, 1.0)));
    Ok(())
}

/// A byte of sRGB is 255 times the curve, rounded; the curve itself may round a number that is next
/// to a half.
pub fn srgb_is_its_formula<T: Number>(n: &Numbers<T>) -> Outcome {
    let color = Rgb::new(single(n.x), single(n.y), 0.0);
    let [r, g, b] = color.to_srgb8();
    prop_assert_eq!(b, 0);
    for (byte, c) in [(r, color.r), (g, color.g)] {
        let exact = 255.0 * encoded(c.into());
        let off = (f64::from(byte) - exact).abs();
        prop_assert!(off <= 0.5 + 1e-4, "{byte} instead of {exact}");
    }
    Ok(())
}

/// A byte that is decoded has the light of the curve, and its encoding is the byte.
pub fn srgb_survives_the_round_trip<T: Number>(n: &Numbers<T>) -> Outcome {
    let bytes = Rgb::new(single(n.x), single(n.y), 1.0).to_linear8();
    let decoded = Rgb::<f32>::from_srgb8(bytes);
    prop_assert_eq!(decoded.to_srgb8(), bytes);
    for (byte, c) in bytes.into_iter().zip([decoded.r, decoded.g, decoded.b]) {
        let off = (f64::from(byte) / 255.0 - encoded(c.into())).abs();
        prop_assert!(off <= 1e-6, "{c} of {byte}");
    }
    Ok(())
}

/// 5, 6 and 5 bits are the curve times 31, 63 and 31, rounded, with red at the top; decoded and
/// encoded, they stay.
pub fn rgb565_is_its_formula<T: Number>(n: &Numbers<T>) -> Outcome {
    let color = Rgb::new(single(n.x), single(n.y), 1.0);
    let bits = color.to_rgb565();
    let levels = [bits >> 11, bits >> 5 & 63, bits & 31];
    for ((level, most), c) in levels
        .into_iter()
        .zip([31.0, 63.0, 31.0])
        .zip([color.r, color.g, color.b])
    {
        let exact = most * encoded(c.into());
        let off = (f64::from(level) - exact).abs();
        prop_assert!(off <= 0.5 + 1e-4, "{level} instead of {exact}");
    }
    prop_assert_eq!(Rgb::<f32>::from_rgb565(bits).to_rgb565(), bits);
    Ok(())
}

/// A linear byte is 255 times the channel, rounded.
pub fn linear_bytes_are_proportional<T: Number>(n: &Numbers<T>) -> Outcome {
    let color = Rgb::new(single(n.x), single(n.y), 1.0);
    for (byte, c) in color
        .to_linear8()
        .into_iter()
        .zip([color.r, color.g, color.b])
    {
        let exact = 255.0 * f64::from(c);
        let off = (f64::from(byte) - exact).abs();
        prop_assert!(off <= 0.5 + 1e-4, "{byte} instead of {exact}");
    }
    Ok(())
}
