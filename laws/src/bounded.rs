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

/// A value, and how far the renderer's may be from it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Bounded {
    pub value: f64,
    pub error: f64,
    /// The unit roundoff of the renderer. An exact constant has 0.
    u: f64,
}

/// A vector or a color.
pub type Bounded3 = [Bounded; 3];

/// Units of u that an operation may lose: 1 for its rounding, 1 for fusing and reordering.
const SUM_OR_PRODUCT: f64 = 2.0;
/// A division, square root or cosine may lose 2.5 units in the last place, each 2u at most.
const FUNCTION: f64 = 5.0;

impl Bounded {
    pub const fn exact(value: f64) -> Self {
        let (error, u) = (0.0, 0.0);
        Self { value, error, u }
    }

    /// A number that the renderer is given. Its type may not hold the number exactly.
    pub fn given(value: f64, u: f64) -> Self {
        let [tiny, _] = limits(u);
        let is_exact = value == 0.0 || rounded(value, u) == value && value.abs() > tiny;
        let rounding = u * value.abs() + tiny;
        let error = if is_exact { 0.0 } else { rounding };
        Self { value, error, u }
    }

    /// The result of an operation that loses `units` of u, beside the `error` that its operands bring.
    pub fn rounded(value: f64, error: f64, units: f64, u: f64) -> Self {
        let [tiny, huge] = limits(u);
        let mut error = error + units * u * value.abs();
        if value != 0.0 && value.abs() - error <= tiny {
            error += tiny;
        }
        // beyond the largest number there is infinity, and 0 times that is NaN
        let is_known = value.abs() + error < huge;
        let error = if is_known { error } else { f64::INFINITY };
        Self { value, error, u }
    }

    pub fn cos(self) -> Self {
        let error = self.error + FUNCTION * self.u; // absolute
        Self::rounded(self.value.cos(), error, 0.0, self.u)
    }

    pub fn at_least_zero(self) -> Self {
        self.if_positive(self, Self::exact(0.0))
    }

    /// This with an error larger by `more`.
    pub fn looser(self, more: f64) -> Self {
        let error = self.error + more;
        Self { error, ..self }
    }

    /// `then` where this is positive. Where the error leaves that open, the renderer may have taken either.
    pub fn if_positive(self, then: Self, other: Self) -> Self {
        let is_so = self.value > 0.0;
        let (taken, other) = if is_so { (then, other) } else { (other, then) };
        let gap = if self.value.is_nan() {
            f64::INFINITY
        } else if self.value.abs() <= self.error && self.error > 0.0 {
            (taken.value - other.value).abs() + other.error
        } else {
            0.0
        };
        let error = taken.error.max(gap);
        Self { error, ..taken }
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
        let exponent = (m * self.value.abs().max(f64::MIN_POSITIVE).log2()).abs();
        let units = 2.0 * (3.0 + 2.0 * exponent) + 2.0 * 4.0 * exponent * std::f64::consts::LN_2;
        let error = corner(1.0).max(corner(-1.0));
        Self::rounded(value, error, units, self.u)
    }
}

impl Number for Bounded {
    fn root(self) -> Self {
        let value = self.value.sqrt();
        // √x − √(x − e) = e/(√x + √(x − e))
        let e = self.error;
        let sum = value + (self.value - e).max(0.0).sqrt();
        let error = if e == 0.0 { 0.0 } else { e / sum };
        Self::rounded(value, error, FUNCTION, self.u)
    }
}

impl Neg for Bounded {
    type Output = Self;
    fn neg(self) -> Self {
        let value = -self.value;
        Self { value, ..self }
    }
}

impl Add for Bounded {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (value, u) = (self.value + other.value, self.u.max(other.u));
        // a sum with 0 does not round
        let is_rounded = self.value != 0.0 && other.value != 0.0;
        let units = if is_rounded { SUM_OR_PRODUCT } else { 0.0 };
        Self::rounded(value, self.error + other.error, units, u)
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
        let (value, u) = (self.value * other.value, self.u.max(other.u));
        let mut error = self.value.abs() * other.error + other.value.abs() * self.error;
        error += self.error * other.error;
        Self::rounded(value, error, SUM_OR_PRODUCT, u)
    }
}

impl Div for Bounded {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let least = (other.value.abs() - other.error).max(0.0);
        let error = self.error + value.abs() * other.error;
        let error = if error == 0.0 { 0.0 } else { error / least };
        Self::rounded(value, error, FUNCTION, self.u.max(other.u))
    }
}

/// What underflow may take away, all below the smallest normal number of the type, and what no number reaches.
fn limits(u: f64) -> [f64; 2] {
    match u {
        0.0 => [0.0, f64::MAX],
        u if u <= f64::EPSILON => [f64::MIN_POSITIVE, f64::MAX],
        u if u < HALF => [f32::MIN_POSITIVE, f32::MAX].map(f64::from),
        _ => [1.0 / 16384.0, 65504.0],
    }
}

/// The unit roundoff of half precision. With more digits than that, there is a larger exponent, too.
pub const HALF: f64 = 1.0 / 2048.0;

/// x with so few bits that their unit roundoff is u.
///
/// Source: Dekker 1971, *A Floating-Point Technique for Extending the Available Precision*.
pub fn rounded(x: f64, u: f64) -> f64 {
    // the power of two at or below it: a logarithm would cost a tenth of a run
    let dropped = f64::from_bits((u / (f64::EPSILON / 2.0)).to_bits() >> 52 << 52);
    let away = x * (dropped + 1.0);
    away - (away - x)
}

pub fn given3(v: Triple, u: f64) -> Bounded3 {
    v.map(|c| Bounded::given(c, u))
}
