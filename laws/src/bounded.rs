//! Running error analysis: a number that knows how far a renderer's may be from it.
//!
//! The tolerance of every comparison follows from these bounds: from the operations, the roundoff
//! of the renderer and the conditioning of the scene. The renderer may round each operation as
//! loosely as Vulkan permits, and may fuse or reorder sums.
//!
//! Sources: Higham, *Accuracy and Stability of Numerical Algorithms*, §3.3; *The Vulkan
//! Specification*, "Precision and Operation of SPIR-V Instructions".

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::scene::{Number, Triple};

/// How a renderer computes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Arithmetic {
    /// The unit roundoff. An exact constant has 0.
    pub u: f64,
    /// Each value is rounded, as in the renderer itself. Otherwise values are those of `f64`.
    pub rounds: bool,
}

impl Arithmetic {
    const EXACT: Self = Self {
        u: 0.0,
        rounds: false,
    };

    fn and(self, other: Self) -> Self {
        Self {
            u: self.u.max(other.u),
            rounds: self.rounds || other.rounds,
        }
    }

    /// A number as the renderer holds it.
    fn holds(self, value: f64) -> f64 {
        if self.rounds && value.is_finite() {
            rounded(value, self.u)
        } else {
            value
        }
    }
}

/// A value, and how far the renderer's may be from it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Bounded {
    pub value: f64,
    pub error: f64,
    how: Arithmetic,
}

/// A vector or a color.
pub type Bounded3 = [Bounded; 3];

/// Units of u that an operation may lose: 1 for its rounding, 1 for fusing and reordering.
const SUM_OR_PRODUCT: f64 = 2.0;
/// A division, square root or cosine may lose 2.5 units in the last place, each 2u at most.
const FUNCTION: f64 = 5.0;

impl Bounded {
    pub const ZERO: Self = Self::exact(0.0);
    /// The formula has no answer, so any is right.
    pub const UNKNOWN: Self = Self {
        value: 0.0,
        error: f64::INFINITY,
        how: Arithmetic::EXACT,
    };

    pub const fn exact(value: f64) -> Self {
        Self {
            value,
            error: 0.0,
            how: Arithmetic::EXACT,
        }
    }

    /// A number that the renderer is given. Its type may not hold the number exactly.
    pub fn given(value: f64, how: Arithmetic) -> Self {
        let is_exact = rounded(value, how.u) == value;
        Self {
            value: how.holds(value),
            error: if is_exact { 0.0 } else { how.u * value.abs() },
            how,
        }
    }

    /// The result of an operation that loses `units` of u. The errors of its operands alone would
    /// make it wrong by `error`.
    fn rounded(value: f64, error: f64, units: f64, how: Arithmetic) -> Self {
        let (value, u) = (how.holds(value), how.u);
        let error = error + units * u * value.abs();
        // beyond the largest f32 there is infinity, and 0 times that is NaN
        let largest = if u > f64::EPSILON {
            f64::from(f32::MAX)
        } else {
            f64::MAX
        };
        let is_known = value.abs() + error < largest;
        let error = if is_known { error } else { f64::INFINITY };
        Self { value, error, how }
    }

    /// The most that underflow takes away: all below the smallest normal number of `f32`, or of a
    /// 16-bit float.
    fn underflow(u: f64) -> f64 {
        match u {
            0.0 => 0.0,
            u if u <= f64::EPSILON / 2.0 => f64::MIN_POSITIVE,
            // with more digits than half precision, there is a larger exponent, too
            u if u < (-11_f64).exp2() => f64::from(f32::MIN_POSITIVE),
            _ => (-14_f64).exp2(),
        }
    }

    pub fn cos(self) -> Self {
        let error = self.error + FUNCTION * self.how.u; // absolute
        Self::rounded(self.value.cos(), error, 0.0, self.how)
    }

    /// Another value with the same error.
    fn with(self, value: f64) -> Self {
        Self { value, ..self }
    }

    pub fn abs(self) -> Self {
        self.with(self.value.abs())
    }

    pub fn at_least_zero(self) -> Self {
        self.if_positive(self, Self::ZERO)
    }

    /// A number that a renderer may compute with an error of some units of u.
    pub fn computed(value: f64, units: f64, how: Arithmetic) -> Self {
        Self::rounded(value, 0.0, units, how)
    }

    /// A number between two.
    pub fn between(low: f64, high: f64, how: Arithmetic) -> Self {
        Self {
            value: f64::midpoint(low, high),
            error: (high - low) / 2.0,
            how,
        }
    }

    /// This with an error larger by `more`.
    pub fn looser(self, more: f64) -> Self {
        Self {
            error: self.error + more,
            ..self
        }
    }

    pub fn at_least(self, limit: f64) -> Self {
        self.with(self.value.max(limit))
    }

    /// A monotone function of it.
    pub fn map(self, f: impl Fn(f64) -> f64) -> Self {
        let [low, value, high] = [-self.error, 0.0, self.error].map(|off| f(self.value + off));
        let error = (high - value).abs().max((value - low).abs());
        Self::rounded(value, error, 16.0, self.how)
    }

    pub fn max(self, other: Self) -> Self {
        (self - other).if_positive(self, other)
    }

    pub fn at_most(self, limit: f64) -> Self {
        self.with(self.value.min(limit))
    }

    /// `then` where this is positive. If the error leaves the sign undecided, the renderer may have
    /// taken either.
    pub fn if_positive(self, then: Self, otherwise: Self) -> Self {
        let (taken, other) = if self.value > 0.0 {
            (then, otherwise)
        } else {
            (otherwise, then)
        };
        let gap = if self.value.is_nan() {
            f64::INFINITY
        } else if self.value.abs() <= self.error && self.error > 0.0 {
            (taken.value - other.value).abs() + other.error
        } else {
            0.0
        };
        Self {
            error: taken.error.max(gap),
            ..taken
        }
    }

    /// cosine^m as a renderer may compute it, exp2(m·log2 cosine): the logarithm loses 3 units in
    /// the last place, the product 1, and exp2(x) 3 + 2|x|.
    pub fn power(self, m: f64) -> Self {
        let value = self.value.powf(m);
        let corner = |sign: f64| {
            let base = self.value + sign * self.error;
            // no power of a base on the other side of 0 is off by more than one of 0
            let base = if base * self.value < 0.0 { 0.0 } else { base };
            (base.powf(m) - value).abs()
        };
        let exponent = if self.value == 0.0 {
            0.0
        } else {
            (m * self.value.abs().log2()).abs()
        };
        let units = 2.0 * (3.0 + 2.0 * exponent) + 2.0 * 4.0 * exponent * std::f64::consts::LN_2;
        let error = corner(1.0).max(corner(-1.0)) + Self::underflow(self.how.u);
        Self::rounded(value, error, units, self.how)
    }
}

impl Number for Bounded {
    fn root(self) -> Self {
        let value = self.value.sqrt();
        // √x − √(x − e) = e/(√x + √(x − e))
        let least = (self.value - self.error).max(0.0).sqrt();
        let error = if self.error == 0.0 {
            0.0
        } else {
            self.error / (value + least)
        };
        Self::rounded(value, error, FUNCTION, self.how)
    }
}

impl Neg for Bounded {
    type Output = Self;
    fn neg(self) -> Self {
        self.with(-self.value)
    }
}

impl Add for Bounded {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (value, how) = (self.value + other.value, self.how.and(other.how));
        // a sum with 0 does not round
        let is_rounded = self.value != 0.0 && other.value != 0.0;
        let units = if is_rounded { SUM_OR_PRODUCT } else { 0.0 };
        Self::rounded(value, self.error + other.error, units, how)
    }
}

impl Sub for Bounded {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Bounded {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (value, how) = (self.value * other.value, self.how.and(other.how));
        let mut error = self.value.abs() * other.error + other.value.abs() * self.error;
        error += self.error * other.error;
        if value != 0.0 {
            error += Self::underflow(how.u);
        }
        Self::rounded(value, error, SUM_OR_PRODUCT, how)
    }
}

impl Div for Bounded {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let least = (other.value.abs() - other.error).max(0.0);
        let error = self.error + value.abs() * other.error;
        let error = if error == 0.0 { 0.0 } else { error / least };
        Self::rounded(value, error, FUNCTION, self.how.and(other.how))
    }
}

/// x with so few bits that their unit roundoff is u.
///
/// Source: Dekker 1971, *A Floating-Point Technique for Extending the Available Precision*.
pub fn rounded(x: f64, u: f64) -> f64 {
    // the power of two at or below it: a logarithm would cost a tenth of a run
    let dropped = f64::from_bits((u / (f64::EPSILON / 2.0)).to_bits() >> 52 << 52);
    let away = x * (dropped + 1.0);
    away - (away - x)
}

pub fn given3(v: Triple, how: Arithmetic) -> Bounded3 {
    v.map(|c| Bounded::given(c, how))
}
