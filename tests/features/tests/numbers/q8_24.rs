//! A fixed-point number with 8 bits before the point and 24 after it: steps of 2⁻²⁴ from −128 to 128.

use std::ops::{Add, Div, Mul, Neg, Sub};

use shading::{Elementary, Real};
use shading_laws::Number;

/// A count of steps. What is out of range saturates.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Q8_24(i32);

const ONE: i32 = 1 << 24;

/// Rounds products, whose steps are 2⁻⁴⁸.
fn rounded(products: i128) -> Q8_24 {
    let steps = (products + i128::from(ONE / 2)) >> 24;
    Q8_24(steps.clamp(i32::MIN.into(), i32::MAX.into()) as i32)
}

/// Rounds to the nearest step; `as` saturates.
fn round(x: f64) -> Q8_24 {
    Q8_24((x * f64::from(ONE)).round() as i32)
}

impl Add for Q8_24 {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0.saturating_add(other.0))
    }
}

impl Sub for Q8_24 {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0.saturating_sub(other.0))
    }
}

impl Mul for Q8_24 {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        rounded(i128::from(self.0) * i128::from(other.0))
    }
}

impl Div for Q8_24 {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        round(self.to_f64() / other.to_f64())
    }
}

impl Neg for Q8_24 {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.saturating_neg())
    }
}

impl Real for Q8_24 {
    const ZERO: Self = Self(0);
    const ONE: Self = Self(ONE);
    const NEG_ONE: Self = Self(-ONE);
    const MAX: Self = Self(i32::MAX);
    const EXTREME: Self = Self(64 * ONE);

    fn of(literal: f64) -> Self {
        round(literal)
    }
    fn sqrt(self) -> Self {
        round(self.to_f64().sqrt())
    }
    fn if_positive(self, then: Self, otherwise: Self) -> Self {
        if self.0 > 0 { then } else { otherwise }
    }
    fn any_positive(self) -> bool {
        self.0 > 0
    }

    // What the formulas compute of several numbers at once is rounded once, too. The defaults are for floats: they round
    // each product, and scale vectors by powers of two that are out of range here.

    fn dot(a: [Self; 3], b: [Self; 3]) -> Self {
        let products = a.into_iter().zip(b);
        rounded(
            products
                .map(|(a, b)| i128::from(a.0) * i128::from(b.0))
                .sum(),
        )
    }
    fn ratio(self, whole: Self) -> Self {
        if whole == Self::MAX {
            Self::ZERO
        } else {
            self / whole
        }
    }
    fn window(q: Self, r: Self, is_squared: bool) -> Self {
        round(window(q.to_f64(), r, is_squared))
    }
    fn length(v: [Self; 3]) -> Self {
        round(length(v.map(Self::to_f64)))
    }
    fn unit(v: [Self; 3]) -> ([Self; 3], Self) {
        let size = length(v.map(Self::to_f64));
        if size > 0.0 {
            (v.map(|c| round(c.to_f64() / size)), Self::ONE)
        } else {
            (v, Self::ZERO)
        }
    }
    fn attenuated(
        v: [Self; 3],
        coefficients: [Self; 3],
        [q, _]: [Self; 2],
        limit: impl FnOnce() -> Self,
    ) -> [Self; 3] {
        let factor = falloff(coefficients, q.to_f64(), limit());
        v.map(|c| round(c.to_f64() * factor))
    }
    fn attenuated_within(
        (r, is_squared): (Self, bool),
        v: [Self; 3],
        coefficients: [Self; 3],
        [q, _]: [Self; 2],
        _: impl FnOnce() -> [Self; 3],
        limit: impl FnOnce() -> Self,
    ) -> [Self; 3] {
        let factor = falloff(coefficients, q.to_f64(), limit()) * window(q.to_f64(), r, is_squared);
        v.map(|c| round(c.to_f64() * factor))
    }
    fn rescaled_difference(to: [Self; 3], from: [Self; 3]) -> ([Self; 3], Self) {
        let difference = [0, 1, 2].map(|i| i64::from(to[i].0) - i64::from(from[i].0));
        let ([rescaled], power) = rescaled([difference]);
        (rescaled, power)
    }
    fn rescaled_together(vectors: [[Self; 3]; 3]) -> Option<([[Self; 3]; 3], Self)> {
        Some(rescaled(vectors.map(|v| v.map(|c| c.0.into()))))
    }
    fn rescaled_by(v: [Self; 3], power: Self) -> [Self; 3] {
        v.map(|c| shifted(c.0.into(), power.0))
    }
    fn direction_and_distance(
        _: impl FnOnce() -> [[Self; 3]; 2],
        to_light: [Self; 3],
    ) -> ([Self; 3], [Self; 2], Self) {
        let (l, has_direction) = Self::unit(to_light);
        if has_direction == Self::ZERO {
            let up = [Self::ZERO, Self::ZERO, Self::ONE];
            return (up, [Self::ZERO; 2], Self::MAX);
        }
        let q = Self::length(to_light);
        (l, [q, q], q)
    }
    fn is_lit(q: Self) -> bool {
        q.0 != 0
    }
    fn half_cosine(n: [Self; 3], l: [Self; 3], v: [Self; 3], squared: bool) -> Self {
        let sum = [0, 1, 2].map(|i| l[i].to_f64() + v[i].to_f64());
        let size = length(sum);
        if size == 0.0 {
            return Self::ZERO;
        }
        let cosine = round(dot(n.map(Self::to_f64), sum) / size);
        if squared {
            cosine * cosine.abs()
        } else {
            cosine
        }
    }
    fn half_of(_: u32) -> Option<u32> {
        None // N·H needs no root
    }
    fn reflected_cosine(n: [Self; 3], l: [Self; 3], v: [Self; 3]) -> Self {
        let [n, l, v] = [n, l, v].map(|v| v.map(Self::to_f64));
        round(2.0 * dot(n, l) * dot(n, v) - dot(l, v))
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn length(v: [f64; 3]) -> f64 {
    dot(v, v).sqrt()
}

/// 1/(a + bq + cq²), at most 1 if that is the limit.
fn falloff(coefficients: [Q8_24; 3], q: f64, limit: Q8_24) -> f64 {
    let [a, b, c] = coefficients.map(Q8_24::to_f64);
    let factor = 1.0 / (a + q * (b + q * c));
    if limit == Q8_24::ONE {
        factor.min(1.0)
    } else {
        factor
    }
}

/// max(0, 1 − (q/r)⁴), or its square; the largest r is none.
fn window(q: f64, r: Q8_24, is_squared: bool) -> f64 {
    if r == Q8_24::MAX {
        return 1.0;
    }
    let window = (1.0 - (q / r.to_f64()).powi(4)).max(0.0);
    if is_squared { window * window } else { window }
}

/// Vectors in steps times one power of two, so that the largest component is from 2 to 4, and its exponent in steps.
fn rescaled<const N: usize>(vectors: [[i64; 3]; N]) -> ([[Q8_24; 3]; N], Q8_24) {
    let largest = vectors.iter().flatten().map(|c| c.unsigned_abs()).max();
    let bits = 64 - largest.unwrap_or(0).max(1).leading_zeros().cast_signed();
    let power = 26 - bits;
    (vectors.map(|v| v.map(|c| shifted(c, power))), Q8_24(power))
}

/// Steps times 2^power, rounded.
fn shifted(steps: i64, power: i32) -> Q8_24 {
    round(steps as f64 * f64::from(power).exp2() / f64::from(ONE))
}

impl Elementary for Q8_24 {
    fn sin(self) -> Self {
        round(self.to_f64().sin())
    }
    fn cos(self) -> Self {
        round(self.to_f64().cos())
    }
    fn exp(self) -> Self {
        round(self.to_f64().exp())
    }
    fn ln(self) -> Self {
        round(self.to_f64().ln())
    }
}

impl Number for Q8_24 {
    const U: f64 = 1.0 / 33_554_432.0; // half a step
    const EVENLY_SPACED: bool = true;
    const TINY: Self = Self(1);
    const POWER_ERROR: f64 = 0.0;
    type Shininess = u32;

    #[allow(clippy::cast_sign_loss)]
    fn shininess(m: f64) -> u32 {
        m as u32
    }
    fn to_f64(self) -> f64 {
        f64::from(self.0) / f64::from(ONE)
    }
}

shading_laws::number!(Q8_24, integer powers);
