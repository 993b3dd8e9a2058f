//! The bits of a number, brought into a range.

use crate::number::cold;
use crate::target::{KEEPS_SIGNALING_NAN, SCARCE_FLASH};

/// Level 1 of 256 begins above 2⁻¹³.
pub(super) const DARKEST: f32 = 1.0 / 8192.0;
pub(super) const BRIGHTEST: f32 = f32::from_bits(1.0_f32.to_bits() - 1);

/// The bits of a number, brought into a range of positive numbers; NaN counts as dark.
#[inline]
pub(super) const fn clamped(x: f32, low: f32, high: f32) -> u32 {
    if SCARCE_FLASH || KEEPS_SIGNALING_NAN && x.is_nan() {
        return clamped_by_bits(x, low, high);
    }
    let bits = if x > low { x } else { low }.to_bits();
    // The second comparison is one of integers, because the compiler would make a branch of two of
    // floats: it sees that the result has only one level then.
    if bits > high.to_bits() {
        high.to_bits()
    } else {
        bits
    }
}

/// The same by one comparison, as a rule: the order of positive numbers is that of their bits. A comparison of
/// floats may be a call.
#[inline]
pub(super) const fn clamped_by_bits(x: f32, low: f32, high: f32) -> u32 {
    let (bits, low, high) = (x.to_bits(), low.to_bits(), high.to_bits());
    let from_low = bits.wrapping_sub(low);
    if from_low < high - low {
        return bits;
    }
    cold();
    let is_above = from_low <= f32::INFINITY.to_bits() - low;
    if is_above { high } else { low }
}
