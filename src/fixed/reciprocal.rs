//! The reciprocal root and the reciprocal, by a table and Newton's method.
//!
//! A test tries every value that they tell apart, so this file uses nothing of the crate but products.

use super::product::upper_unsigned;

/// 2⁸/√x for the middle x of each 128th, from ¼ to 1. The numbers are signed, so that the compiler
/// does not know that the roots are not negative: a product of a signed number with one that it
/// knows takes an Arm core three instructions for one.
static ROOTS: [i16; 128] = {
    let mut table = [0; 128];
    let mut i = 32;
    while i < 128 {
        // the largest root below 2⁹ with root² x ≤ 2¹⁶, where x = (2i + 1)/2⁸
        let mut root = 511_i16;
        while (root as u32).pow(2) * (2 * i as u32 + 1) > 1 << 24 {
            root -= 1;
        }
        table[i] = root;
        i += 1;
    }
    table
};

/// 2²⁷/√x for x = `bits`/2³² from ¼ on.
#[inline]
pub(super) const fn reciprocal_root(bits: u32) -> i32 {
    let first = ROOTS[(bits >> 25) as usize] as i32; // 8 bits after the point
    // y(1 − e/2), where e = xy² − 1 has 32 bits after the point
    let e = ((first * first) as u32).wrapping_mul(bits >> 16) as i32;
    let second = (first << 6) - ((first * (e >> 12)) >> 15); // 14 bits
    // once more
    let e = (1 << 28) - upper_unsigned(bits, (second * second) as u32) as i32;
    (second << 13) + (second.wrapping_mul(e >> 1) >> 15)
}

/// 2²⁸/x for x = `bits`/2³² from ½ on. It never rises with x, so that light never rises with distance.
/// With all bits of x, its rounding would take it up by a few units.
#[inline]
pub(super) const fn reciprocal(bits: u32) -> u32 {
    let bits = bits >> 6 << 6;
    let root = ROOTS[(bits >> 25) as usize] as i32;
    // y(1 − e), where e = xy² − 1 has 32 bits after the point
    let first = root * root; // 16 bits
    let e = (first as u32).wrapping_mul(bits >> 16) as i32;
    let second = first - ((first * (e >> 12)) >> 20);
    // once more
    let e = (1 << 30) - upper_unsigned(bits, (second as u32) << 14) as i32;
    ((second << 12) + (second.wrapping_mul(e >> 4) >> 14)) as u32
}
