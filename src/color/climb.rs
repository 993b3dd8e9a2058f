//! Levels by a climb that begins close below: the level at the beginning of each of some intervals, from
//! which a few comparisons lead to that of the number. The edges of 256 levels take 1 KB, and those of
//! RGB565 0.4 KB; its intervals take 0.1 KB more.

macro_rules! climb {
    ($(#[$doc:meta])* $name:ident $bits:ident) => {
        $(#[$doc])*
        pub(crate) struct $name<const N: usize, const LENGTH: usize, const SHIFT: u32> {
            first: [u8; LENGTH],
            next_edges: [$bits; N],
        }

        impl<const N: usize, const LENGTH: usize, const SHIFT: u32> $name<N, LENGTH, SHIFT> {
            /// Numbers from `begin` on, divided into intervals of 2^`SHIFT`. A mask finds the interval.
            pub(super) const fn new(begin: $bits, next_edges: [$bits; N]) -> Self {
                assert!(LENGTH.is_power_of_two());
                let (mut first, mut level, mut i) = ([0; LENGTH], 0, 0);
                while i < LENGTH {
                    let start = begin + ((i as $bits) << SHIFT);
                    while next_edges[level] <= start {
                        level += 1;
                    }
                    first[Self::interval(start)] = level as u8;
                    i += 1;
                }
                Self { first, next_edges }
            }

            #[inline]
            const fn interval(bits: $bits) -> usize {
                (bits >> SHIFT) as usize % LENGTH
            }

            /// The level of a number, which is below the largest of its type: the last edge ends the climb.
            #[inline]
            pub(crate) const fn level(&self, bits: $bits) -> u32 {
                let mut level = self.first[Self::interval(bits)] as usize;
                while bits >= self.next_edges[level % N] {
                    level += 1;
                }
                level as u32
            }
        }
    };
}

climb! {
    /// The levels of an `f32`, by its bits.
    Climb u32
}

#[cfg(feature = "fixed")]
climb! {
    /// The levels of a fixed-point number below 1 with 16 bits after the point.
    FixedClimb u16
}
