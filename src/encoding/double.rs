//! The levels of a channel in double precision.

use super::edges::next_edges_f64;
use super::levels::{self, place};

/// The bits of the least `f64` of the next level.
static EIGHT_BITS: [u64; 256] = next_edges_f64();
static SIX_BITS: [u64; 64] = next_edges_f64();
static FIVE_BITS: [u64; 32] = next_edges_f64();

/// The place of a number in the order of all numbers, with every NaN below all.
const fn order(x: f64) -> i64 {
    const NAN: u64 = (1 << 52) - 1; // the most by which the bits of a NaN exceed those of infinity
    x.to_bits().wrapping_add(NAN) as i64
}

/// The bits of a number, brought into a range; NaN counts as dark. Integers are compared, because
/// AArch64's maximum makes a number of a signaling NaN.
#[inline]
const fn clamped(channel: f64, low: f64, high: f64) -> u64 {
    let channel = if order(channel) > order(low) {
        channel
    } else {
        low
    };
    let channel = if order(channel) > order(high) {
        high
    } else {
        channel
    };
    channel.to_bits()
}

/// The bits of a channel, and the place of the largest `f32` that does not exceed it. Its level is that of
/// the `f32` or the next.
#[inline]
const fn rounded_down(channel: f64) -> (u64, u32) {
    const BRIGHTEST: f64 = f64::from_bits(1.0_f64.to_bits() - 1);
    const DARKEST: f64 = 1.0 / 8192.0;
    const EXPONENT: u64 = (1023 - 127) << 23;
    let bits = clamped(channel, DARKEST, BRIGHTEST);
    let below = f32::from_bits(((bits >> 29) - EXPONENT) as u32);
    (bits, place(below))
}

#[inline]
pub(super) const fn eight_bits(channel: f64) -> u32 {
    let (bits, below) = rounded_down(channel);
    let level = levels::eight_bits(below);
    level + (bits >= EIGHT_BITS[level as usize % 256]) as u32
}

#[inline]
pub(super) const fn six_bits(channel: f64) -> u32 {
    let (bits, below) = rounded_down(channel);
    let level = levels::six_bits(below);
    level + (bits >= SIX_BITS[level as usize % 64]) as u32
}

#[inline]
pub(super) const fn five_bits(channel: f64) -> u32 {
    let (bits, below) = rounded_down(channel);
    let level = levels::five_bits(below);
    level + (bits >= FIVE_BITS[level as usize % 32]) as u32
}

/// round(highest · channel) for a highest level of at most 255, in whole numbers, which are exact.
#[inline]
pub(super) const fn linear(channel: f64, highest: u64) -> u32 {
    // 2⁻⁹ is dark for every highest level
    let bits = clamped(channel, 1.0 / 512.0, 1.0);
    let significand = bits & ((1 << 52) - 1) | 1 << 52;
    let shift = 1075 - (bits >> 52);
    ((((significand * highest) >> (shift - 1)) + 1) >> 1) as u32
}
