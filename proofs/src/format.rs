//! The floats that a proof is about.

use shading::Real;

/// The floats that a proof is about.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum Format {
    /// Single precision.
    #[default]
    F32,
    /// Double precision.
    F64,
    /// Floats of so many exponent bits and digits: so few that a rule can be tried with all of them.
    Small(i32, i32),
}

impl Format {
    /// The exponent bits, and the digits with the hidden one.
    #[must_use]
    pub fn shape(self) -> (i32, i32) {
        match self {
            Self::F32 => (8, 24),
            Self::F64 => (11, 53),
            Self::Small(exponent, digits) => (exponent, digits),
        }
    }

    /// The exponent of the largest numbers; that of the smallest normal ones is 1 − it.
    fn largest_exponent(self) -> i32 {
        (1 << (self.shape().0 - 1)) - 1
    }

    /// The distance to the next number away from 0.
    fn step(self, x: f64) -> f64 {
        let smallest = 1 - self.largest_exponent();
        let exponent = i32::try_from(x.abs().to_bits() >> 52).expect("11 bits") - 1023;
        two_to(exponent.max(smallest) - self.shape().1 + 1)
    }

    /// The nearest number. For + − × ÷ √ of two numbers of p digits, rounding the result of `f64` once
    /// more is correct if 53 ≥ 2p + 2.
    #[allow(clippy::cast_possible_truncation)] // it is what rounds
    #[must_use]
    pub fn round(self, x: f64) -> f64 {
        match self {
            Self::F32 => f64::from(x as f32),
            Self::Small(..) if x.is_finite() && x != 0.0 => {
                let step = self.step(x);
                let rounded = (x / step).round_ties_even() * step;
                if rounded.abs() > self.max() {
                    f64::INFINITY.copysign(x)
                } else {
                    rounded
                }
            }
            _ => x,
        }
    }

    /// The largest finite number.
    #[must_use]
    pub fn max(self) -> f64 {
        (2.0 - 2.0 * self.u()) * two_to(self.largest_exponent())
    }

    /// `Real::EXTREME`.
    #[must_use]
    pub fn extreme(self) -> f64 {
        match self {
            Self::F32 => f32::EXTREME.into(),
            Self::F64 => f64::EXTREME,
            Self::Small(..) => two_to(self.largest_exponent() * 3 / 4),
        }
    }

    /// The smallest number above 0.
    #[must_use]
    pub fn tiny(self) -> f64 {
        let power = 2 - self.largest_exponent() - self.shape().1;
        two_to(power / 2) * two_to(power - power / 2)
    }

    /// The unit roundoff.
    #[must_use]
    pub fn u(self) -> f64 {
        two_to(-self.shape().1)
    }

    /// The least number above x.
    #[must_use]
    pub fn next_up(self, x: f64) -> f64 {
        let y = self.round(x);
        if y > x || y.is_nan() || y == f64::INFINITY {
            return y;
        }
        match self {
            Self::F64 => y.next_up(),
            _ if y == f64::NEG_INFINITY => -self.max(),
            _ if y >= 0.0 => self.round(y + self.step(y)),
            // below 0, the next number is that towards 0, which may be half a step away
            _ => self.round(y + self.step(self.round(y * (1.0 - self.u()))).min(-y)),
        }
    }

    /// The greatest number that is not above x.
    pub(super) fn round_down(self, x: f64) -> f64 {
        let y = self.round(x);
        if y > x { self.next_down(x) } else { y }
    }

    /// The greatest number below x.
    #[must_use]
    pub fn next_down(self, x: f64) -> f64 {
        -self.next_up(-x)
    }

    /// All numbers, with both zeros and one NaN.
    #[must_use]
    pub fn numbers(self) -> Vec<f64> {
        let above = std::iter::successors(Some(f64::NEG_INFINITY), |x| Some(self.next_up(*x)));
        let numbers = above.take_while(|x| *x < f64::INFINITY);
        numbers.chain([f64::INFINITY, -0.0, f64::NAN]).collect()
    }
}

/// 2ᵖ, a normal number.
fn two_to(power: i32) -> f64 {
    let exponent = u64::try_from(power + 1023).expect("a normal number");
    f64::from_bits(exponent << 52)
}
