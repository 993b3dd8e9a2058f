//! Levels by a straight line and a comparison, for chips: 1,280 bytes for 8 bits, 640 for RGB565.
//!
//! A line for each quarter of an octave guesses the level, in the numbers' bits. The guess is the level
//! or the one below, which a comparison with the beginning of the next level decides.

use super::edges::{edges, next_edges};

/// The first place is level 0, the last is the highest level; a mask finds the lines from one to the other.
const FIRST: i32 = order(1.0 / 8192.0) + 1;
const LAST: i32 = order(1.0) - 1;

/// The most by which the bits of a NaN exceed those of infinity.
const NAN: u32 = 0x007F_FFFF;

/// The place of a number in the order of all numbers. As signed integers, the bits of positive floats are
/// in order, and those of negative floats are below them. The sum wraps every NaN around to below all.
const fn order(x: f32) -> i32 {
    x.to_bits().wrapping_add(NAN) as i32
}

#[inline]
const fn between(x: f32, first: i32, last: i32) -> i32 {
    let place = order(x);
    let place = if place < first { first } else { place };
    if place > last { last } else { place }
}

/// The bits of a number, brought into a range in this order; NaN counts as dark.
#[inline]
pub(super) const fn clamped(x: f32, low: f32, high: f32) -> u32 {
    between(x, order(low), order(high)) as u32 - NAN
}

/// Where a number stands among the edges of the levels.
#[inline]
const fn place(x: f32) -> u32 {
    between(x, FIRST, LAST) as u32
}

static EIGHT_BITS: [u32; 256] = next_places();
static SIX_BITS: [u32; 64] = next_places();
static FIVE_BITS: [u32; 32] = next_places();

/// The first place of the next level, and none above the highest.
const fn next_places<const N: usize>() -> [u32; N] {
    let (mut next, mut level) = (next_edges::<N>(), 0);
    while level < N - 1 {
        next[level] += NAN;
        level += 1;
    }
    next
}

/// The number of low bits of a quarter of an octave.
const QUARTER: u32 = 21;

/// The slope of each line is in the low byte; the rest is the level, in units of 2⁻²⁴, of the place 0.
static LINES: [u32; 64] = {
    let (mut lines, mut begin) = ([0; 64], FIRST as u32);
    while begin <= LAST as u32 {
        let end = begin + (1 << QUARTER);
        let (low, high) = (at(begin), at(end));
        let sag = at(begin + (1 << (QUARTER - 1))) - f64::midpoint(low, high);
        let slope = ((high - low) * 8.0 + 0.5) as u32; // 2²⁴/2²¹
        assert!(slope < 256);
        // the curve lies between the line and 1 above it: half of what is left goes to either side
        let missed = (high - low) - slope as f64 / 8.0;
        let level = low - (1.0 - sag) / 2.0 + missed / 2.0;
        let level = (level * 16_777_216.0) as u32;
        let level = level.wrapping_sub(slope.wrapping_mul(begin));
        lines[(begin >> QUARTER) as usize % 64] = level & !0xFF | slope;
        begin = end;
    }
    lines
};

const fn at(place: u32) -> f64 {
    encoded(f32::from_bits(place - NAN) as f64)
}

/// 255 E + ½, by a straight line between two edges, from which the curve is 0.004 away at most.
const fn encoded(light: f64) -> f64 {
    const EDGES: [f64; 256] = edges();
    let mut level = 1;
    while level < 255 && EDGES[level] <= light {
        level += 1;
    }
    // in the straight part of the curve, one level below level 1 is −L
    let below = if level == 1 {
        -EDGES[1]
    } else {
        EDGES[level - 1]
    };
    (level - 1) as f64 + (light - below) / (EDGES[level] - below)
}

/// 255 E + ½ in units of 2⁻²⁴, up to 1 too low.
#[inline]
const fn guess(place: u32) -> u32 {
    let line = LINES[(place >> QUARTER) as usize % 64];
    place.wrapping_mul(line & 0xFF).wrapping_add(line)
}

/// The level of a channel, of 256.
#[inline]
pub(super) const fn eight_bits(channel: f32) -> u32 {
    eight_bits_at(place(channel))
}

#[inline]
const fn eight_bits_at(place: u32) -> u32 {
    let level = guess(place) >> 24;
    level + (place >= EIGHT_BITS[level as usize % 256]) as u32
}

/// Of 64.
#[inline]
pub(super) const fn six_bits(channel: f32) -> u32 {
    six_bits_at(place(channel))
}

#[inline]
const fn six_bits_at(place: u32) -> u32 {
    let level = ((guess(place) >> 16) * 63 + 0x6000) >> 16;
    level + (place >= SIX_BITS[level as usize % 64]) as u32
}

/// Of 32.
#[inline]
pub(super) const fn five_bits(channel: f32) -> u32 {
    five_bits_at(place(channel))
}

#[inline]
const fn five_bits_at(place: u32) -> u32 {
    let level = ((guess(place) >> 16) * 31 + 0x6000) >> 16;
    level + (place >= FIVE_BITS[level as usize % 32]) as u32
}

// The levels are right: a guess rises within a line, so it suffices to try both ends of each stretch that
// has one line and one level.
macro_rules! assert_right {
    ($level:ident: $n:literal) => {
        const _: () = {
            const NEXT: [u32; $n] = next_places();
            let (mut begin, mut level) = (FIRST as u32, 0);
            while begin <= LAST as u32 {
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

assert_right!(eight_bits_at: 256);
assert_right!(six_bits_at: 64);
assert_right!(five_bits_at: 32);
