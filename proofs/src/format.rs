//! The floats that a proof is about.

use shading::Real;

/// The floats that a proof is about.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Format {
    /// Single precision.
    #[default]
    F32,
    /// Double precision.
    F64,
}

impl Format {
    /// The nearest number. For + − × ÷ √ of two `f32`, rounding the result of `f64` once more is
    /// correct, because 53 ≥ 2·24 + 2.
    #[allow(clippy::cast_possible_truncation)] // it is what rounds
    #[must_use]
    pub fn round(self, x: f64) -> f64 {
        match self {
            Self::F32 => f64::from(x as f32),
            Self::F64 => x,
        }
    }

    /// The largest finite number.
    #[must_use]
    pub fn max(self) -> f64 {
        match self {
            Self::F32 => f32::MAX.into(),
            Self::F64 => f64::MAX,
        }
    }

    /// `Real::EXTREME`.
    #[must_use]
    pub fn extreme(self) -> f64 {
        match self {
            Self::F32 => f32::EXTREME.into(),
            Self::F64 => f64::EXTREME,
        }
    }

    /// The smallest number above 0.
    #[must_use]
    pub fn tiny(self) -> f64 {
        match self {
            Self::F32 => f32::from_bits(1).into(),
            Self::F64 => f64::from_bits(1),
        }
    }

    /// The unit roundoff.
    #[must_use]
    pub fn u(self) -> f64 {
        match self {
            Self::F32 => f64::from(f32::EPSILON) / 2.0,
            Self::F64 => f64::EPSILON / 2.0,
        }
    }

    /// The next number.
    #[allow(clippy::cast_possible_truncation)] // it is one of these numbers
    #[must_use]
    pub fn next_up(self, x: f64) -> f64 {
        if x.is_nan() || x == f64::INFINITY {
            return x;
        }
        if x == 0.0 {
            return self.tiny();
        }
        match self {
            Self::F32 => {
                let bits = (x as f32).to_bits();
                f32::from_bits(if x > 0.0 { bits + 1 } else { bits - 1 }).into()
            }
            Self::F64 => {
                let bits = x.to_bits();
                f64::from_bits(if x > 0.0 { bits + 1 } else { bits - 1 })
            }
        }
    }

    /// The number before it.
    #[must_use]
    pub fn next_down(self, x: f64) -> f64 {
        -self.next_up(-x)
    }
}
