//! The bits of a number, brought into a range.

use crate::target::{FPU, KEEPS_SIGNALING_NAN};

/// Level 1 of 256 begins above 2⁻¹³.
pub(super) const DARKEST: f32 = 1.0 / 8192.0;
pub(super) const BRIGHTEST: f32 = f32::from_bits(1.0_f32.to_bits() - 1);

/// The bits of a number, brought into a range of positive numbers; NaN counts as dark.
#[inline]
pub(super) const fn clamped(x: f32, low: f32, high: f32) -> u32 {
    let x = if KEEPS_SIGNALING_NAN && x.is_nan() {
        low
    } else {
        x
    };
    let bits = if FPU {
        at_least(x, low)
    } else {
        at_least_by_bits(x, low)
    };
    // The second comparison is one of integers, because the compiler would make a branch of two of
    // floats: it sees that the result has only one level then.
    if bits > high.to_bits() {
        high.to_bits()
    } else {
        bits
    }
}

/// The bits of the greater number, of which the second is positive; NaN counts as 0.
#[inline]
pub(super) const fn at_least(x: f32, low: f32) -> u32 {
    if x > low { x } else { low }.to_bits()
}

/// The same where a comparison of floats is a call: the order of positive numbers is that of their bits.
#[inline]
pub(super) const fn at_least_by_bits(x: f32, low: f32) -> u32 {
    let (bits, least) = (x.to_bits() as i32, low.to_bits() as i32);
    if bits > least && bits <= f32::INFINITY.to_bits() as i32 {
        bits as u32
    } else {
        least as u32
    }
}
