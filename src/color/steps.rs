//! Levels by one entry of a table: 8 KB for 8 bits, 3 KB for RGB565.
//!
//! The numbers are divided into intervals so short that each has at most one step from a level to the
//! next. An entry is the level at the end of its interval, less the part of the interval before the
//! step. Adding the place within the interval carries into the level from the step on.

use super::clamp::{BRIGHTEST, DARKEST};

/// The intervals of the levels of an encoding. `SHIFT` low bits of a number are the place within its
/// interval.
pub(super) struct Steps<const LENGTH: usize, const SHIFT: u32>([u32; LENGTH]);

impl<const LENGTH: usize, const SHIFT: u32> Steps<LENGTH, SHIFT> {
    pub(super) const fn of<const N: usize>(next_edges: [u32; N]) -> Self {
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

    /// The level of a number, by its bits.
    #[inline]
    pub(super) const fn level(&self, bits: u32) -> u32 {
        let step = self.0[(bits >> SHIFT) as usize % LENGTH];
        (step + bits % (1 << SHIFT)) >> SHIFT
    }
}
