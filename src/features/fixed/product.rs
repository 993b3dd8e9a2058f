//! Products of integers, with a long multiply and without.
//!
//! Both ways give the same bits.

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
pub(super) fn product(a: i32, b: i32) -> i32 {
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
