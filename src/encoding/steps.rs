//! Levels by one entry of a table: 8 KB for 8 bits, 3 KB for RGB565. Where flash is scarce, a search
//! among the edges of the levels takes 1 KB and 0.4 KB.
//!
//! The numbers are divided into intervals so short that each has at most one step from a level to the
//! next. An entry is the level at the end of its interval, less the part of the interval before the
//! step. Adding the place within the interval carries into the level from the step on.

use super::edges::next_edges;

/// The intervals of the levels of an encoding. `SHIFT` low bits of a number are the place within its
/// interval.
struct Steps<const LENGTH: usize, const SHIFT: u32>([u32; LENGTH]);

static EIGHT_BITS: Steps<2048, 16> = Steps::of(next_edges::<256>());
static SIX_BITS: Steps<512, 18> = Steps::of(next_edges::<64>());
static FIVE_BITS: Steps<256, 19> = Steps::of(next_edges::<32>());

/// Whether flash is scarce: on the processors of microcontrollers.
const CHIP: bool = cfg!(any(target_arch = "arm", target_arch = "riscv32"));

/// Where the level after each begins.
pub(crate) struct Edges<T, const N: usize>([T; N]);

macro_rules! edges {
    ($bits:ident) => {
        impl<const N: usize> Edges<$bits, N> {
            /// The last level that begins at or below a number, one bit of it after the other.
            #[inline(never)]
            pub(crate) const fn level(&self, bits: $bits) -> u32 {
                let (mut level, mut step) = (0, N / 2);
                while step > 0 {
                    if bits >= self.0[(level + step - 1) % N] {
                        level += step;
                    }
                    step /= 2;
                }
                level as u32
            }
        }
    };
}

edges!(u32);
#[cfg(feature = "fixed")]
edges!(u16);

macro_rules! levels {
    ($($name:ident $steps:ident $levels:literal $fixed:ident)*) => {$(
        /// The level of a channel.
        #[inline]
        pub(super) const fn $name(channel: f32) -> u32 {
            static EDGES: Edges<u32, $levels> = Edges(next_edges());
            if CHIP { EDGES.level(clamped(channel, DARKEST, BRIGHTEST)) } else { $steps.level(channel) }
        }

        /// For a fixed-point number with 16 bits after the point.
        #[cfg(feature = "fixed")]
        pub(crate) static $fixed: Edges<u16, $levels> = Edges(super::edges::next_fixed_edges());
    )*};
}

levels! {
    eight_bits EIGHT_BITS 256 FIXED_EIGHT_BITS
    six_bits SIX_BITS 64 FIXED_SIX_BITS
    five_bits FIVE_BITS 32 FIXED_FIVE_BITS
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
    // The second comparison is one of integers, because the compiler would make a branch of two of
    // floats: it sees that the result has only one level then.
    let bits = if x > low { x } else { low }.to_bits();
    if bits > high.to_bits() {
        high.to_bits()
    } else {
        bits
    }
}
