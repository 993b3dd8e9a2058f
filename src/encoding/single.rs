//! The levels of a channel in single precision.

use super::levels::{self, clamped, place};

#[inline]
pub(super) const fn eight_bits(channel: f32) -> u32 {
    levels::eight_bits(place(channel))
}

#[inline]
pub(super) const fn six_bits(channel: f32) -> u32 {
    levels::six_bits(place(channel))
}

#[inline]
pub(super) const fn five_bits(channel: f32) -> u32 {
    levels::five_bits(place(channel))
}

/// round(highest · channel) for a highest level of at most 255, in whole numbers, which are exact.
#[inline]
pub(super) const fn linear(channel: f32, highest: u32) -> u32 {
    // 2⁻⁹ is dark for every highest level
    let bits = clamped(channel, 1.0 / 512.0, 1.0);
    let significand = bits & 0x007F_FFFF | 0x0080_0000;
    let shift = 150 - (bits >> 23); // 23 to 32
    (((significand * highest) >> (shift - 1)) + 1) >> 1
}
