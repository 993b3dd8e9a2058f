//! Powers by an integer, by repeated squaring.

use super::Real;

/// The bits of 1 in single precision, and the distance from the bits of a power of two to those of
/// the next.
const ONE: u32 = 0x3F80_0000;
const OCTAVE: u32 = 0x0080_0000;

/// The m-th power of a cosine, as a function of the cosine.
///
/// A cosine whose power would be subnormal in single precision counts as 0. Squaring would
/// otherwise pass through subnormal numbers, which cost some processors up to a hundred times as
/// much. Number types with a wider range hardly ever reach their own subnormal numbers, so they
/// keep every power.
#[inline]
pub(super) fn of_cosine<T: Real>(m: u32) -> impl Fn(T) -> T {
    let is_wider = (T::MAX - T::of_f32(f32::MAX)).any_positive();
    let least = if m == 0 || is_wider {
        T::ZERO
    } else {
        T::of_f32(least_normal_base(m))
    };
    // the zeroth power is the first power of a cosine, where every cosine above 0 counts as 1
    let (top, power) = if m == 0 { (T::ZERO, 1) } else { (T::ONE, m) };
    move |cosine: T| {
        let capped = if cfg!(target_os = "none") {
            // without a branch, which takes stack
            cosine.if_above(top, T::ONE, cosine)
        } else if m == 0 {
            return cosine.if_positive(T::ONE, T::ZERO);
        } else {
            // in SIMD lanes a minimum takes less time than a choice
            cosine.at_most(T::ONE)
        };
        by_squaring(capped.if_above(least, capped, T::ZERO), power)
    }
}

/// 2^(−126/m), whose m-th power is the least normal number, for m ≥ 1. The result never exceeds
/// this value, and its power is at least 2⁻¹³⁰ for m up to 10⁴.
#[inline]
fn least_normal_base(m: u32) -> f32 {
    // The bits of a float are its logarithm, except that the significand 1 + x stands for
    // log₂(1 + x), which is about x + 0.39 (¼ − (x − ½)²).
    let linear = ONE - 126 * OCTAVE / m;
    let from_half = (linear >> 12 & 0x7FF).wrapping_sub(0x400);
    let bend = 0x10_0000 - from_half.wrapping_mul(from_half);
    f32::from_bits(linear - bend / 32 * 25 - 1600)
}

/// baseᵐ by repeated squaring, from the highest bit of m down. The trailing zeros of m square the
/// base first.
#[inline]
pub(crate) fn by_squaring<T: Real>(mut base: T, m: u32) -> T {
    if m == 0 {
        return T::ONE;
    }
    // A single bit is shifted down past the trailing zeros. Compilers would unroll a loop over
    // their count, and small chips lack the registers for that.
    let mut bit = (m & m.wrapping_neg()) >> 1;
    while bit != 0 {
        base = base * base;
        bit >>= 1;
    }
    let mut power = base;
    // the bits of m below its highest 1 and down to its lowest 1, left-aligned
    let mut bits = m << m.leading_zeros() << 1;
    while bits != 0 {
        power = power * power;
        if bits >> 31 == 1 {
            power = power * base;
        }
        bits <<= 1;
    }
    power
}
