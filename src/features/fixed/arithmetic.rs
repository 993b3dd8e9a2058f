//! The operators, the square root and powers.
//!
//! Sums saturate. Products are rounded once, to the nearest step, and a tie goes up.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::product::{LONG_MULTIPLY, product, upper};
use super::{Fixed, ONE};
use crate::rgb::Rgb;
use crate::vector::Vec3;

/// The quotient of two numbers in steps, rounded and saturated. 0/0 is 0.
#[inline(never)]
fn quotient(dividend: i32, divisor: i32) -> i32 {
    let magnitude = quotient_of_magnitudes(dividend.unsigned_abs(), divisor.unsigned_abs());
    if (dividend ^ divisor) < 0 {
        0_i32.saturating_sub_unsigned(magnitude)
    } else {
        0_i32.saturating_add_unsigned(magnitude)
    }
}

#[inline]
fn quotient_of_magnitudes(dividend: u32, divisor: u32) -> u32 {
    if dividend == 0 {
        return 0;
    }
    let (mut quotient, mut rest, mut bits, mut count) = (0, 0, dividend, 48);
    if LONG_MULTIPLY {
        // a processor that has a long multiply has a divider too
        quotient = dividend.checked_div(divisor).unwrap_or(u32::MAX);
        rest = dividend.wrapping_sub(quotient.wrapping_mul(divisor));
        (bits, count) = (0, 16);
    }
    // bit by bit, down to 16 beyond the lowest of the dividend
    while count > 0 {
        if quotient >> 31 == 1 {
            return u32::MAX;
        }
        quotient <<= 1;
        // the rest is below the divisor, which is at most 2³¹
        rest = rest << 1 | bits >> 31;
        bits <<= 1;
        if rest >= divisor {
            rest -= divisor;
            quotient |= 1;
        }
        count -= 1;
    }
    quotient.saturating_add(u32::from(rest >= divisor - rest))
}

/// √(`steps`·2¹⁶), rounded to the nearest.
#[inline(never)]
fn root(steps: u32) -> u32 {
    let (mut root, mut rest, mut bits) = (0_u32, 0_u32, steps);
    let mut digit = 0;
    while digit < 24 {
        rest = rest << 2 | bits >> 30;
        bits <<= 2;
        root <<= 1;
        let next = root << 1 | 1;
        if rest >= next {
            rest -= next;
            root |= 1;
        }
        digit += 1;
    }
    // (root + ½)² = root² + root + ¼
    root + u32::from(rest > root)
}

impl Fixed {
    pub(super) fn root(self) -> Self {
        Self(root(self.0.max(0) as u32) as i32)
    }

    /// The m-th power of a cosine, computed with 32 bits after the point.
    #[inline]
    pub(super) fn cosine_power(self, m: u32) -> Self {
        if self.0 <= 0 {
            return Self(0);
        }
        if self.0 >= ONE || m == 0 {
            return Self(ONE);
        }
        let (mut base, mut m) = ((self.0 as u32) << 16, m);
        while m & 1 == 0 {
            base = upper(base, base);
            m >>= 1;
        }
        let mut power = base;
        while m > 1 {
            base = upper(base, base);
            m >>= 1;
            if m & 1 == 1 {
                power = upper(power, base);
            }
        }
        Self((((power >> 15) + 1) >> 1) as i32)
    }
}

impl Add for Fixed {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self(self.0.saturating_add(other.0))
    }
}

impl Sub for Fixed {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self(self.0.saturating_sub(other.0))
    }
}

impl Neg for Fixed {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self(self.0.saturating_neg())
    }
}

impl Mul for Fixed {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self(product(self.0, other.0))
    }
}

impl Div for Fixed {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        Self(quotient(self.0, other.0))
    }
}

macro_rules! number_first {
    ($($type:ident),*) => {
        $(impl Mul<$type<Fixed>> for Fixed {
            type Output = $type<Fixed>;
            #[inline]
            fn mul(self, value: $type<Fixed>) -> $type<Fixed> {
                value * self
            }
        })*
    };
}

number_first!(Vec3, Rgb);
