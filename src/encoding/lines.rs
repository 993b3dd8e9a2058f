//! Levels by a straight line and a comparison, for chips: 1,280 bytes for 8 bits, 640 for RGB565.
//!
//! A line for each quarter of an octave guesses the level, in the numbers' bits. The guess is the level
//! or the one below, which a comparison with the beginning of the next level decides.

use super::edges::{encoded, next_edges};

/// Level 1 of 256 begins above 2⁻¹³.
pub(crate) const DARKEST: f32 = 1.0 / 8192.0;
pub(crate) const BRIGHTEST: f32 = f32::from_bits(1.0_f32.to_bits() - 1);

static EIGHT_BITS: [u32; 256] = next_edges();
static SIX_BITS: [u32; 64] = next_edges();
static FIVE_BITS: [u32; 32] = next_edges();

/// The number of low bits of a quarter of an octave.
const QUARTER: u32 = 21;

/// The lines, from 2⁻¹³ to 1, at an index that a mask gives. The slope is in the low byte; the rest is
/// the level, in units of 2⁻²⁴, of the bits 0.
static LINES: [u32; 64] = {
    let (mut lines, mut begin) = ([0; 64], DARKEST.to_bits());
    while begin <= BRIGHTEST.to_bits() {
        let end = begin + (1 << QUARTER);
        let (low, high) = (at(begin), at(end));
        let sag = at(begin + (1 << (QUARTER - 1))) - (low + high) / 2.0;
        let slope = ((high - low) * 8.0 + 0.5) as u32; // 2²⁴/2²¹
        assert!(slope < 256);
        // the curve lies between the line and 1 above it: half of what is left goes to either side
        let missed = (high - low) - slope as f64 / 8.0;
        let level = low - (1.0 - sag) / 2.0 + missed / 2.0;
        let level = (level * 16_777_216.0) as i64 as u32;
        let level = level.wrapping_sub(slope.wrapping_mul(begin));
        lines[(begin >> QUARTER) as usize % 64] = level & !0xFF | slope;
        begin = end;
    }
    lines
};

const fn at(bits: u32) -> f64 {
    encoded(f32::from_bits(bits) as f64)
}

/// 255 E + ½ in units of 2⁻²⁴, up to 1 too low.
#[inline]
const fn guess(bits: u32) -> u32 {
    let line = LINES[(bits >> QUARTER) as usize % 64];
    bits.wrapping_mul(line & 0xFF).wrapping_add(line)
}

/// The bits of a number, brought into a range; NaN counts as dark.
#[inline]
pub(crate) const fn clamped(x: f32, low: f32, high: f32) -> u32 {
    // the most by which the bits of a NaN exceed those of infinity: the sum wraps every NaN around to
    // below all numbers, and the others are ordered as their bits
    const NAN: i32 = 0x007F_FFFF;
    let (low, high) = (low.to_bits() as i32 + NAN, high.to_bits() as i32 + NAN);
    let place = (x.to_bits() as i32).wrapping_add(NAN);
    let place = if place < low { low } else { place };
    let place = if place > high { high } else { place };
    (place - NAN) as u32
}

/// The level of clamped bits, of 256.
#[inline]
pub(crate) const fn eight_bits(bits: u32) -> u32 {
    let level = guess(bits) >> 24;
    level + (bits >= EIGHT_BITS[level as usize % 256]) as u32
}

/// Of 64.
#[inline]
pub(crate) const fn six_bits(bits: u32) -> u32 {
    let level = ((guess(bits) >> 16) * 63 + 0x6000) >> 16;
    level + (bits >= SIX_BITS[level as usize % 64]) as u32
}

/// Of 32.
#[inline]
pub(crate) const fn five_bits(bits: u32) -> u32 {
    let level = ((guess(bits) >> 16) * 31 + 0x6000) >> 16;
    level + (bits >= FIVE_BITS[level as usize % 32]) as u32
}

// The levels are right: a guess rises within a line, so it suffices to try both ends of each stretch that
// has one line and one level.
macro_rules! assert_right {
    ($level:ident: $n:literal) => {
        const _: () = {
            const NEXT: [u32; $n] = next_edges();
            let (mut begin, mut level) = (DARKEST.to_bits(), 0);
            while begin <= BRIGHTEST.to_bits() {
                while level < $n - 1 && NEXT[level] <= begin {
                    level += 1;
                }
                let mut end = (begin >> QUARTER << QUARTER) + (1 << QUARTER);
                if end > NEXT[level] {
                    end = NEXT[level];
                }
                assert!($level(begin) == level as u32 && $level(end - 1) == level as u32);
                begin = end;
            }
        };
    };
}

assert_right!(eight_bits: 256);
assert_right!(six_bits: 64);
assert_right!(five_bits: 32);
