//! Reciprocals and reciprocal roots, by Newton's method.
//!
//! The numbers are integers with the binary point wherever all their bits count.

use super::product::{COUNTS_ZEROS, LONG_MULTIPLY, upper};

/// 2²⁷/√x for x = `bits`/2³² from ¼ on.
#[inline]
pub(super) const fn reciprocal_root(bits: u32) -> i32 {
    let first = 256 + ROOTS[(bits >> 25) as usize] as i32; // 8 bits after the point
    // Newton's method, y(1 − e/2), where e = xy² − 1 has 32 bits after the point
    let e = ((first * first) as u32).wrapping_mul(bits >> 16) as i32;
    let second = (first << 6) - ((first * (e >> 12)) >> 15); // 14 bits
    // once more
    let e = (1 << 28) - upper(bits, (second * second) as u32) as i32;
    (second << 13) + (second.wrapping_mul(e >> 1) >> 15)
}

/// How many pairs of zeros are above the highest bit; 15 for 0.
#[inline]
pub(super) const fn pairs_of_zeros(bits: u32) -> u32 {
    let mut bits = bits | 1;
    if COUNTS_ZEROS {
        return bits.leading_zeros() >> 1;
    }
    let mut pairs = 0;
    while bits >> 30 == 0 {
        bits <<= 2;
        pairs += 1;
    }
    pairs
}

/// 2³² times the reciprocal of a number above 1.
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
#[cfg_attr(not(all(target_arch = "arm", not(target_has_atomic = "32"))), inline)]
pub(super) fn reciprocal(mut steps: u32) -> u32 {
    let mut excess = 0;
    while steps >> 22 != 0 {
        steps = (steps + 8) >> 4;
        excess += 4;
    }
    // 2³² = quotient·steps + rest, nearly; Newton's method adds quotient·rest/2³²
    let (quotient, rest) = reciprocal_quotient(steps);
    ((quotient << 16) + ((quotient * rest) >> 16)) >> excess
}

/// The quotient of 2³² − 1 and a divisor from 2¹⁶ to 2²², and the rest.
#[inline]
fn reciprocal_quotient(divisor: u32) -> (u32, u32) {
    if LONG_MULTIPLY {
        // a processor that has a long multiply has a divider too
        let quotient = u32::MAX.checked_div(divisor).unwrap_or(0);
        return (quotient, u32::MAX - quotient * divisor);
    }
    let (mut x, mut shift) = (divisor, 0);
    while x >> 16 != 0 {
        x >>= 1;
        shift += 1;
    }
    // Newton's method, from the square of a reciprocal root; 32 bits of e = xy − 1 are after the point
    let root = 256 + i32::from(ROOTS[(x >> 9) as usize & 127]);
    let y = root * root;
    let e = (x as i32).wrapping_mul(y);
    let y = y - ((y * (e >> 16)) >> 16);
    let e = (x as i32).wrapping_mul(y);
    let y = y - ((y * (e >> 8)) >> 24);
    // and once more with the whole divisor
    let y = y >> shift;
    let e = (divisor as i32).wrapping_mul(y);
    let y = (y - ((y * (e >> 8)) >> 24) - 1) as u32;
    // it is off by one at most
    let rest = u32::MAX.wrapping_sub(divisor.wrapping_mul(y));
    if rest as i32 >= divisor as i32 {
        (y + 1, rest - divisor)
    } else if (rest as i32) < 0 {
        (y - 1, rest.wrapping_add(divisor))
    } else {
        (y, rest)
    }
}

/// 2⁸(1/√x − 1) for the middle x of each 128th, from ¼ to 1.
static ROOTS: [u8; 128] = {
    let mut table = [0; 128];
    let mut i = 32;
    while i < 128 {
        // the largest r with (2⁸ + r)² x ≤ 2¹⁶, where x = (2i + 1)/2⁸
        let mut r = 255_u32;
        while (256 + r) * (256 + r) * (2 * i as u32 + 1) > 1 << 24 {
            r -= 1;
        }
        table[i] = r as u8;
        i += 1;
    }
    table
};
