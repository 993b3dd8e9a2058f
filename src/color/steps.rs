//! Levels by one entry of a table: 8 KB for 8 bits, 3 KB for RGB565. Where flash is scarce, a search
//! among the edges of the levels takes 1 KB and 0.4 KB.
//!
//! The numbers are divided into intervals so short that each has at most one step from a level to the
//! next. An entry is the level at the end of its interval, less the part of the interval before the
//! step. Adding the place within the interval carries into the level from the step on.

use super::levels::next_edges;
#[cfg(feature = "fixed")]
use super::levels::next_fixed_edges;
use crate::target::{FPU, SCARCE_FLASH};

/// The intervals of the levels of an encoding. `SHIFT` low bits of a number are the place within its
/// interval.
struct Steps<const LENGTH: usize, const SHIFT: u32>([u32; LENGTH]);

static EIGHT_BITS: Steps<2048, 16> = Steps::of(next_edges::<256>());
static SIX_BITS: Steps<512, 18> = Steps::of(next_edges::<64>());
static FIVE_BITS: Steps<256, 19> = Steps::of(next_edges::<32>());

/// Levels by one comparison: the level at the beginning of each interval, in which at most one
/// level begins, and where the level after each begins. `SHIFT` low bits of a number are the place
/// within its interval. RGB565 takes 0.9 KB.
struct Near<const N: usize, const LENGTH: usize, const SHIFT: u32> {
    first: [u8; LENGTH],
    next_edges: [u32; N],
}

impl<const N: usize, const LENGTH: usize, const SHIFT: u32> Near<N, LENGTH, SHIFT> {
    /// Where the intervals begin, in the octave of the first level or above it.
    const BEGIN: u32 = 1.0_f32.to_bits() - ((LENGTH as u32) << SHIFT);

    const fn new() -> Self {
        let next_edges = next_edges::<N>();
        assert!(Self::BEGIN < next_edges[0], "level 1 begins before");
        let (mut first, mut level, mut i) = ([0; LENGTH], 0, 0);
        while i < LENGTH {
            let begin = Self::BEGIN + ((i as u32) << SHIFT);
            while next_edges[level] <= begin {
                level += 1;
            }
            first[i] = level as u8;
            assert!(
                level + 1 >= N || next_edges[level + 1] >= begin + (1 << SHIFT),
                "two levels in an interval"
            );
            i += 1;
        }
        Self { first, next_edges }
    }

    #[inline]
    const fn level(&self, channel: f32) -> u32 {
        let bits = clamped(channel, f32::from_bits(Self::BEGIN), BRIGHTEST);
        let level = self.first[((bits - Self::BEGIN) >> SHIFT) as usize % LENGTH] as usize;
        (level + (bits >= self.next_edges[level % N]) as usize) as u32
    }
}

/// The last level that begins at or below a number, by where the level after each begins: one bit
/// of it after the other. It takes no room beside the edges.
// one copy for all encodings
#[inline(never)]
const fn found(next_edges: &[u32], bits: u32) -> u32 {
    let (mut level, mut step) = (0, next_edges.len() / 2);
    while step > 0 {
        let next = level + step - 1;
        if next < next_edges.len() && bits >= next_edges[next] {
            level += step;
        }
        step /= 2;
    }
    level as u32
}

/// The levels of fixed-point numbers below 1 with 16 bits after the point: the level at the
/// beginning of each 64th, from which a few comparisons lead to that of the number.
#[cfg(feature = "fixed")]
pub(crate) struct Climb<const N: usize> {
    first: [u8; 64],
    next_edges: [u16; N],
}

#[cfg(feature = "fixed")]
impl<const N: usize> Climb<N> {
    const fn new() -> Self {
        let next_edges = next_fixed_edges::<N>();
        let (mut first, mut level, mut i) = ([0; 64], 0, 0);
        while i < 64 {
            while next_edges[level] <= (i as u16) << 10 {
                level += 1;
            }
            first[i] = level as u8;
            i += 1;
        }
        Self { first, next_edges }
    }

    /// The level of a number, which is below the largest of 16 bits: the last edge ends the climb.
    #[inline]
    pub(crate) const fn level(&self, bits: u16) -> u32 {
        let mut level = self.first[bits as usize >> 10] as usize;
        while bits >= self.next_edges[level % N] {
            level += 1;
        }
        level as u32
    }
}

/// A way to the level of a channel. All give the same; a test compares them, as each processor takes one.
#[derive(Clone, Copy)]
pub(super) enum Way {
    /// On a desktop.
    Steps,
    /// Where flash is scarce.
    Search,
    /// Where it is scarce, for few levels, beside an FPU.
    Near,
}

/// The way for so many levels.
const fn way(levels: usize) -> Way {
    if !SCARCE_FLASH {
        Way::Steps
    } else if FPU && levels <= 64 {
        Way::Near // beside an FPU, a search would take a third of a pixel's time
    } else {
        Way::Search
    }
}

macro_rules! levels {
    ($($name:ident $by:ident $steps:ident $levels:literal $fixed:ident $length:literal $shift:literal)*) => {$(
        /// The level of a channel.
        #[inline]
        pub(super) const fn $name(channel: f32) -> u32 {
            $by(way($levels), channel)
        }

        #[inline]
        pub(super) const fn $by(way: Way, channel: f32) -> u32 {
            static EDGES: [u32; $levels] = next_edges();
            static NEAR: Near<$levels, $length, $shift> = Near::new();
            match way {
                Way::Steps => $steps.level(channel),
                Way::Search => found(&EDGES, clamped(channel, DARKEST, BRIGHTEST)),
                Way::Near => NEAR.level(channel),
            }
        }

        /// For a fixed-point number with 16 bits after the point.
        #[cfg(feature = "fixed")]
        pub(crate) static $fixed: Climb<$levels> = Climb::new();
    )*};
}

levels! {
    eight_bits eight_bits_by EIGHT_BITS 256 FIXED_EIGHT_BITS 1664 16
    six_bits six_bits_by SIX_BITS 64 FIXED_SIX_BITS 352 18
    five_bits five_bits_by FIVE_BITS 32 FIXED_FIVE_BITS 160 19
}

/// Level 1 of 256 begins above 2⁻¹³.
const DARKEST: f32 = 1.0 / 8192.0;
const BRIGHTEST: f32 = f32::from_bits(1.0_f32.to_bits() - 1);

impl<const LENGTH: usize, const SHIFT: u32> Steps<LENGTH, SHIFT> {
    const fn of<const N: usize>(next_edges: [u32; N]) -> Self {
        assert!(LENGTH == 16 << (23 - SHIFT)); // sixteen octaves, found by a mask
        let (mut steps, mut level) = ([0; LENGTH], 0);
        let mut begin = DARKEST.to_bits();
        while begin <= BRIGHTEST.to_bits() {
            let end = begin + (1 << SHIFT);
            let mut step = (level as u32) << SHIFT;
            if next_edges[level] < end {
                step += end - next_edges[level];
                level += 1;
            }
            assert!(next_edges[level] >= end, "two steps in an interval");
            steps[(begin >> SHIFT) as usize % LENGTH] = step;
            begin = end;
        }
        assert!(level == N - 1);
        Self(steps)
    }

    /// The level of a channel.
    #[inline]
    const fn level(&self, channel: f32) -> u32 {
        let bits = clamped(channel, DARKEST, BRIGHTEST);
        let step = self.0[(bits >> SHIFT) as usize % LENGTH];
        (step + bits % (1 << SHIFT)) >> SHIFT
    }
}

/// The bits of a number, brought into a range of positive numbers; NaN counts as dark.
#[inline]
pub(super) const fn clamped(x: f32, low: f32, high: f32) -> u32 {
    // the maximum of AArch64 makes a number of a signaling NaN
    let x = if cfg!(target_arch = "aarch64") && x.is_nan() {
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
