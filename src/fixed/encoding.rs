//! The encodings of colors, by whole numbers alone.

use super::Fixed;
use crate::color::{FIXED_EIGHT_BITS, FIXED_FIVE_BITS, FIXED_SIX_BITS, Rgb};

/// The channel within [0, 1), in steps. At the greatest that it returns, every encoding has its highest level.
#[inline]
const fn within_16_bits(channel: Fixed) -> u16 {
    const HIGHEST: i32 = u16::MAX as i32 - 1;
    let steps = channel.0 & !(channel.0 >> 31);
    (if steps > HIGHEST { HIGHEST } else { steps }) as u16
}

/// As for `f32`, with whole numbers alone: each `Fixed` from 0 to 1 is an `f32`.
impl Rgb<Fixed> {
    /// Encodes linear light as sRGB bytes, correctly rounded; see [`Rgb::<f32>::to_srgb8`].
    #[inline]
    #[must_use]
    pub const fn to_srgb8(self) -> [u8; 3] {
        let [r, g, b] = self.levels();
        [
            FIXED_EIGHT_BITS.level(r) as u8,
            FIXED_EIGHT_BITS.level(g) as u8,
            FIXED_EIGHT_BITS.level(b) as u8,
        ]
    }

    /// Encodes linear light as sRGB with five, six and five bits; see [`Rgb::<f32>::to_rgb565`].
    #[inline]
    #[must_use]
    pub const fn to_rgb565(self) -> u16 {
        let [r, g, b] = self.levels();
        (FIXED_FIVE_BITS.level(r) << 11 | FIXED_SIX_BITS.level(g) << 5 | FIXED_FIVE_BITS.level(b))
            as u16
    }

    /// Rounds linear light to bytes without encoding it; see [`Rgb::<f32>::to_linear8`].
    #[inline]
    #[must_use]
    pub const fn to_linear8(self) -> [u8; 3] {
        let [r, g, b] = self.levels();
        [
            ((r as u32 * 255 + (1 << 15)) >> 16) as u8,
            ((g as u32 * 255 + (1 << 15)) >> 16) as u8,
            ((b as u32 * 255 + (1 << 15)) >> 16) as u8,
        ]
    }

    #[inline]
    const fn levels(self) -> [u16; 3] {
        [
            within_16_bits(self.r),
            within_16_bits(self.g),
            within_16_bits(self.b),
        ]
    }
}

crate::shade::encoded!(Fixed);
