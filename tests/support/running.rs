//! Running error analysis: a number that carries a bound on its own rounding error.
//!
//! The formulas of the crate are generic over `Real`, so this number runs through the same code as
//! the floats, in the same order, and then reports how far the float may be from the true value.
//! The tolerance of a comparison thus follows from the operations themselves and from the
//! conditioning of each input. Nobody counts operations, and no tolerance is tuned.
//!
//! Source: Higham, *Accuracy and Stability of Numerical Algorithms*, §3.3.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use shading::{Elementary, Exponent, Real};

use crate::number::{self, Number};

/// `f32` or `f64`, together with a number type that bounds its error.
pub trait Float: number::Float {
    type Running: Number + Bounded;
}

impl Float for f32 {
    type Running = Running<24>;
}

impl Float for f64 {
    type Running = Running<53>;
}

/// A number that bounds the error of the float in its place.
pub trait Bounded: Copy {
    fn value(self) -> f64;
    fn error(self) -> f64;
}

/// A value, and how far a float with this many BITS of precision may be from it: 24 for `f32`, 53
/// for `f64`. The value is computed in `f64`, which doubles the error for 53 bits;
/// [`Running::rounded`] accounts for that.
#[derive(Clone, Copy, Debug)]
pub struct Running<const BITS: u32> {
    value: f64,
    error: f64,
}

impl<const BITS: u32> Running<BITS> {
    const IS_F32: bool = BITS == 24;
    /// u for `f32`, and 2u for `f64`: both the float and the value that it is compared with are
    /// rounded.
    const U: f64 = if Self::IS_F32 {
        f32::EPSILON as f64 / 2.0
    } else {
        f64::EPSILON
    };
    /// The most that underflow may lose in one operation.
    const UNDERFLOW: f64 = if Self::IS_F32 {
        f32::from_bits(1) as f64 / 2.0
    } else {
        f64::from_bits(1)
    };
    /// A function of `libm` is right to one unit in the last place, which is 2u. The power of `f32`
    /// has an absolute error of at most 2⁻²² = 4u.
    const FUNCTION: f64 = 2.0 * Self::U;
    const POWER: f64 = if Self::IS_F32 { 4.0 * Self::U } else { 0.0 };

    /// The result of a correctly rounded operation. The errors of its operands alone would make it
    /// wrong by `error`.
    fn rounded(value: f64, error: f64) -> Self {
        let rounding = if value == 0.0 {
            0.0
        } else {
            Self::U * value.abs() + Self::UNDERFLOW
        };
        let error = error + rounding;
        Self {
            value,
            // ∞·0: nothing is known
            error: if error.is_nan() { f64::INFINITY } else { error },
        }
    }

    /// The result of an elementary function.
    fn function(value: f64, error: f64) -> Self {
        Self {
            value,
            error: error + Self::FUNCTION * value.abs() + Self::UNDERFLOW,
        }
    }

    /// base^m over the box that the errors span: it is monotone in both for a base in [0, 1].
    fn power(base: Self, m: Self) -> Self {
        let value = base.value.powf(m.value);
        let corner = |sign: f64| {
            let base = (base.value + sign * base.error).clamp(0.0, 1.0);
            let m = (m.value - sign * m.error).max(0.0);
            (base.powf(m) - value).abs()
        };
        Self::function(value, corner(1.0).max(corner(-1.0)) + Self::POWER)
    }
}

impl<const BITS: u32> Bounded for Running<BITS> {
    fn value(self) -> f64 {
        self.value
    }

    fn error(self) -> f64 {
        self.error
    }
}

impl<const BITS: u32> PartialEq for Running<BITS> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<const BITS: u32> PartialOrd for Running<BITS> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl<const BITS: u32> Neg for Running<BITS> {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            ..self
        }
    }
}

impl<const BITS: u32> Add for Running<BITS> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::rounded(self.value + other.value, self.error + other.error)
    }
}

impl<const BITS: u32> Sub for Running<BITS> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<const BITS: u32> Mul for Running<BITS> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let first = self.value.abs() * other.error + other.value.abs() * self.error;
        Self::rounded(self.value * other.value, first + self.error * other.error)
    }
}

impl<const BITS: u32> Div for Running<BITS> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let least = (other.value.abs() - other.error).max(0.0);
        let error = self.error + value.abs() * other.error;
        Self::rounded(value, if error == 0.0 { 0.0 } else { error / least })
    }
}

impl<const BITS: u32> Real for Running<BITS> {
    const ZERO: Self = Self {
        value: 0.0,
        error: 0.0,
    };
    const ONE: Self = Self {
        value: 1.0,
        error: 0.0,
    };
    const NEG_ONE: Self = Self {
        value: -1.0,
        error: 0.0,
    };
    const MAX: Self = Self {
        value: if Self::IS_F32 {
            f32::MAX as f64
        } else {
            f64::MAX
        },
        error: 0.0,
    };
    const EXTREME: Self = Self {
        value: if Self::IS_F32 {
            <f32 as Real>::EXTREME as f64
        } else {
            <f64 as Real>::EXTREME
        },
        error: 0.0,
    };

    /// The literal, with the error of writing it in fewer bits.
    #[allow(clippy::cast_possible_truncation)]
    fn of(literal: f64) -> Self {
        let float = if Self::IS_F32 {
            f64::from(literal as f32)
        } else {
            literal
        };
        Self {
            value: literal,
            error: (float - literal).abs(),
        }
    }

    fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        // √x − √(x − e) = e/(√x + √(x − e))
        let least = (self.value - self.error).max(0.0).sqrt();
        Self::rounded(
            value,
            if self.error == 0.0 {
                0.0
            } else {
                self.error / (value + least)
            },
        )
    }

    /// If the error leaves the sign undecided, the float may have taken the other side.
    fn if_positive(self, then: Self, otherwise: Self) -> Self {
        let (taken, other) = if self.value > 0.0 {
            (then, otherwise)
        } else {
            (otherwise, then)
        };
        let is_open = self.error > 0.0 && self.value.abs() <= self.error;
        let gap = if is_open {
            (taken.value - other.value).abs() + other.error
        } else {
            0.0
        };
        let error = if gap.is_nan() {
            f64::INFINITY
        } else {
            taken.error.max(gap)
        };
        Self { error, ..taken }
    }

    fn any_positive(self) -> bool {
        self.value > 0.0
    }
}

impl<const BITS: u32> Elementary for Running<BITS> {
    fn sin(self) -> Self {
        Self::function(self.value.sin(), self.error)
    }

    fn cos(self) -> Self {
        Self::function(self.value.cos(), self.error)
    }

    fn exp(self) -> Self {
        let value = self.value.exp();
        Self::function(value, value * self.error.exp_m1())
    }

    fn ln(self) -> Self {
        Self::function(self.value.ln(), -(-self.error / self.value).ln_1p())
    }
}

impl<const BITS: u32> Exponent<Self> for Running<BITS> {
    fn raise(self, cosine: Self) -> Self {
        let power = Self::power(cosine.at_most(Self::ONE), self);
        cosine.if_positive(power, Self::ZERO)
    }
}

impl<const BITS: u32> Number for Running<BITS> {
    /// The float rounds an angle of at most π by 1.6u, and its cosine is off by 3.4u.
    fn soft_cone(degrees: [f64; 2]) -> Option<shading::Cone<Self>> {
        let [inner, outer] = degrees.map(f64::to_radians);
        let cone = shading::Cone::<f64>::from_half_angles(inner, outer)?;
        Some(cone.cast(|value| Self {
            value,
            error: 5.0 * Self::U,
        }))
    }
}
