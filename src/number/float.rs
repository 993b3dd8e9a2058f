//! The floats.

use super::root::{sqrt, sqrtf};
use super::triple::{Rgb, Vec3};
use super::{Mask, Real, Toward, length};
use crate::target::{SCARCE_FLASH, SSE2};

macro_rules! float {
    ($float:ident, $extreme:expr, $sqrt:path) => {
        #[diagnostic::do_not_recommend] // the trait's own message names the types
        impl Real for $float {
            type Mask = bool;
            type Sum = Rgb<Self>;

            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const NEG_ONE: Self = -1.0;
            const MAX: Self = $float::MAX;
            const EXTREME: Self = $extreme;

            #[inline]
            #[allow(clippy::cast_possible_truncation, clippy::cast_lossless)]
            fn of(literal: f64) -> Self {
                literal as Self
            }

            #[inline]
            #[allow(clippy::useless_conversion)]
            fn of_f32(literal: f32) -> Self {
                literal.into()
            }

            #[inline]
            fn sqrt(self) -> Self {
                $sqrt(self)
            }

            #[inline]
            fn above(self, other: Self) -> bool {
                self > other
            }

            // Positive floats are ordered as their bits are, so one integer comparison replaces two
            // (measured: `sphere` −9 % of instructions, `transformed` −6 %, `shade::blinn_phong` 0 to −1 %;
            // but `triangle` +10 %, `shade::lambert` +1 %).
            #[inline]
            fn any_outside(self, low: Self, high: Self) -> bool {
                let range = high.to_bits().wrapping_sub(low.to_bits());
                self.to_bits().wrapping_sub(low.to_bits()) >= range
            }

            // A desktop computes n·w anew, after the root: that is faster than keeping n·v meanwhile.
            #[inline(always)]
            fn cosine(n: Vec3<Self>, toward: &Toward<Self>) -> Self {
                let Toward { measured, n_dot_w } = toward;
                if SCARCE_FLASH {
                    return length::cosine(*n_dot_w, measured.w_length);
                }
                // limited from below before the division, which is also shorter
                let cosine = Self::dot(n, measured.w).at_least(0.0) / measured.w_length;
                // 0/0, of a w that overflowed, counts as 1: its light is black. `min` keeps the compiler
                // from comparing in vectors and choosing by branches (a sum −2 to −4 % of instructions);
                // elsewhere it may be a call.
                if SSE2 {
                    cosine.min(1.0)
                } else {
                    Self::ONE.above(cosine).select(cosine, 1.0)
                }
            }
        }
    };
}

// 2^100 and 2^720, as their bits
float!(f32, f32::from_bits((127 + 100) << 23), sqrtf);
float!(f64, f64::from_bits((1023 + 720) << 52), sqrt);
