//! The operators, the square root and powers.
//!
//! Sums saturate. Products are rounded once, to the nearest step, and a tie goes up.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::{Fixed, ONE};
use crate::rgb::Rgb;
use crate::vector::Vec3;

/// Whether the processor multiplies 32 bits by 32 bits to 64. Of Arm's cores without atomic
/// operations, the Cortex-M0 is the one in use, and it has no such instruction.
pub(super) const LONG_MULTIPLY: bool =
    !cfg!(all(target_arch = "arm", not(target_has_atomic = "32")));

/// Whether the processor counts leading zeros.
pub(super) const COUNTS_ZEROS: bool = LONG_MULTIPLY && !cfg!(target_arch = "riscv32");

/// The upper half of a product.
#[inline]
pub(super) const fn upper(a: u32, b: u32) -> u32 {
    if LONG_MULTIPLY {
        ((a as u64 * b as u64) >> 32) as u32
    } else {
        by_halves::upper(a, b)
    }
}

/// The upper half of a product with sign.
#[inline]
pub(super) const fn upper_signed(a: i32, b: i32) -> i32 {
    if LONG_MULTIPLY {
        ((a as i64 * b as i64) >> 32) as i32
    } else {
        // read without signs, a negative number is too large by 2³²
        (by_halves::upper(a as u32, b as u32) as i32)
            .wrapping_sub(a >> 31 & b)
            .wrapping_sub(b >> 31 & a)
    }
}

/// The upper half of a product with a number of at least 0.
#[inline]
pub(super) const fn upper_of_part(a: i32, b: i32) -> i32 {
    if LONG_MULTIPLY {
        upper_signed(a, b)
    } else {
        (by_halves::upper(a as u32, b as u32) as i32).wrapping_sub(a >> 31 & b)
    }
}

/// The upper half of a square.
#[inline]
pub(super) const fn upper_of_square(a: i32) -> u32 {
    if LONG_MULTIPLY {
        upper_signed(a, a) as u32
    } else {
        by_halves::upper(a.unsigned_abs(), a.unsigned_abs())
    }
}

/// A number times a share in units of 2⁻³², rounded.
#[inline]
pub(super) const fn part(number: i32, share: u32) -> i32 {
    if LONG_MULTIPLY {
        let product = number as i64 * share as i64;
        (product >> 32) as i32 + (product as u32 >> 31) as i32
    } else {
        by_halves::part(number, share)
    }
}

/// A number times a share in units of 2⁻¹⁶, rounded.
#[inline]
pub(super) const fn short_part(number: i32, share: u16) -> i32 {
    if LONG_MULTIPLY {
        part(number, (share as u32) << 16)
    } else {
        let low = (number as u32 & 0xFFFF) * share as u32;
        (number >> 16) * share as i32 + ((low + 0x8000) >> 16) as i32
    }
}

/// The whole product.
#[inline]
pub(super) const fn product64(a: i32, b: i32) -> i64 {
    if LONG_MULTIPLY {
        a as i64 * b as i64
    } else {
        (upper_signed(a, b) as i64) << 32 | a.wrapping_mul(b) as u32 as i64
    }
}

/// The product of two numbers in steps, rounded and saturated.
#[inline]
fn product(a: i32, b: i32) -> i32 {
    if LONG_MULTIPLY {
        let steps = (a as i64 * b as i64 + 0x8000) >> 16;
        if i64::from(steps as i32) == steps {
            steps as i32
        } else {
            (a ^ b) >> 31 ^ i32::MAX
        }
    } else {
        by_halves::product(a, b)
    }
}

/// The same products of 16-bit halves.
mod by_halves {
    const fn halves(a: u32, b: u32) -> [u32; 4] {
        [a >> 16, a & 0xFFFF, b >> 16, b & 0xFFFF]
    }

    /// The upper half of a product to which `round`·2¹⁶ is added.
    ///
    /// If it were known to be 0, LLVM would see a multiplication of 64 bits and call one from a library.
    #[inline(never)]
    const fn upper_rounded(a: u32, b: u32, round: u32) -> u32 {
        let [a1, a0, b1, b0] = halves(a, b);
        let middle = a1 * b0 + ((a0 * b0) >> 16);
        let other = a0 * b1 + (middle & 0xFFFF) + round;
        a1 * b1 + (middle >> 16) + (other >> 16)
    }

    #[inline]
    pub(super) const fn upper(a: u32, b: u32) -> u32 {
        upper_rounded(a, b, 0)
    }

    #[inline]
    pub(super) const fn part(number: i32, share: u32) -> i32 {
        let upper = upper_rounded(number as u32, share, 0x8000);
        upper.wrapping_sub((number >> 31) as u32 & share) as i32
    }

    #[inline(never)]
    pub(super) fn product(a: i32, b: i32) -> i32 {
        let [a1, b1] = [a >> 16, b >> 16];
        let [a0, b0] = [a & 0xFFFF, b & 0xFFFF];
        // neither sum overflows: (2¹⁵ − 1)(2¹⁶ − 1) + 2¹⁶ < 2³¹
        let low = ((a0 as u32 * b0 as u32 + 0x8000) >> 16) as i32;
        let middle = a1 * b0 + low;
        let other = a0 * b1;
        let low = (middle & 0xFFFF) + (other & 0xFFFF);
        let high = a1 * b1 + (middle >> 16) + (other >> 16) + (low >> 16);
        if i32::from(high as i16) == high {
            high << 16 | low & 0xFFFF
        } else {
            (high >> 31) ^ i32::MAX
        }
    }
}

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
