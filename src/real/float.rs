//! The floats, whose operations the processor or `libm` has.

use super::{Real, root};

macro_rules! float {
    ($float:ident, $extreme:expr, $sqrt:path, $divided:path) => {
        #[diagnostic::do_not_recommend] // the trait's own message names the types
        impl Real for $float {
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

            #[inline(always)]
            fn divided(numbers: [Self; 3], divisor: Self) -> [Self; 3] {
                $divided(numbers, divisor)
            }

            #[inline]
            fn epsilon() -> Self {
                $float::EPSILON
            }

            #[inline]
            fn if_positive(self, then: Self, otherwise: Self) -> Self {
                if self > 0.0 { then } else { otherwise }
            }

            #[inline]
            fn any_positive(self) -> bool {
                self > 0.0
            }

            // Positive floats are ordered as their bits are, so one integer comparison replaces two
            // subtractions. If `high` itself counts as outside, both constants of that comparison
            // fit into Arm's instructions.
            #[inline]
            fn any_outside(self, low: Self, high: Self) -> bool {
                let above_low = self.to_bits().wrapping_sub(low.to_bits());
                let range = high.to_bits().wrapping_sub(low.to_bits());
                if low > 0.0 {
                    above_low >= range
                } else {
                    above_low > range
                }
            }

            #[inline]
            fn abs(self) -> Self {
                $float::abs(self)
            }

            // The compiler can turn this comparison into the processor's minimum or maximum.
            // `f32::min` is a library call on Arm.
            #[inline]
            fn if_above(self, threshold: Self, then: Self, otherwise: Self) -> Self {
                if self > threshold { then } else { otherwise }
            }
        }
    };
}

// 2^100 and 2^720, as their bits
float!(
    f32,
    f32::from_bits((127 + 100) << 23),
    root::sqrtf,
    root::dividedf
);
float!(
    f64,
    f64::from_bits((1023 + 720) << 52),
    root::sqrt,
    root::divided
);
