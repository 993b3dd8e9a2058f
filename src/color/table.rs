//! The levels of each encoding, by the way that fits the processor.

use super::clamp::{BRIGHTEST, DARKEST, clamped};
use super::climb::Climb;
#[cfg(feature = "fixed")]
use super::climb::FixedClimb;
use super::levels::Levels;
#[cfg(feature = "fixed")]
use super::levels::next_fixed_edges;
use super::steps::Steps;
use crate::target::SCARCE_FLASH;

/// A way to the level of a channel. Both give the same; a test compares them, as each processor takes one.
#[derive(Clone, Copy)]
pub(super) enum Way {
    Steps,
    Climb,
}

const WAY: Way = if SCARCE_FLASH { Way::Climb } else { Way::Steps };

macro_rules! levels {
    ($($name:ident $by:ident $levels:literal: $length:literal $shift:literal, $few:literal $wide:literal, $fixed:ident)*) => {$(
        /// The level of a channel.
        #[inline]
        pub(super) const fn $name(channel: f32) -> u32 {
            $by(WAY, channel)
        }

        #[inline]
        pub(super) const fn $by(way: Way, channel: f32) -> u32 {
            static STEPS: Steps<$length, $shift> = Steps::of(Levels::<$levels>::NEXT);
            static CLIMB: Climb<$levels, $few, $wide> = Climb::new(DARKEST.to_bits(), Levels::<$levels>::NEXT);
            let bits = clamped(channel, DARKEST, BRIGHTEST);
            match way {
                Way::Steps => STEPS.level(bits),
                Way::Climb => CLIMB.level(bits),
            }
        }

        /// For a fixed-point number with 16 bits after the point.
        #[cfg(feature = "fixed")]
        pub(crate) static $fixed: FixedClimb<$levels, 64, 10> = FixedClimb::new(0, next_fixed_edges());
    )*};
}

levels! {
    eight_bits eight_bits_by 256: 2048 16, 128 20, FIXED_EIGHT_BITS
    six_bits six_bits_by 64: 512 18, 64 21, FIXED_SIX_BITS
    five_bits five_bits_by 32: 256 19, 32 22, FIXED_FIVE_BITS
}
