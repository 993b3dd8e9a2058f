//! What is computed of three numbers at once: dot products, directions, colors.
//!
//! Each result is rounded to steps once, at the end.

use super::arithmetic::{
    LONG_MULTIPLY, leading_zeros, part, product64, short_part, upper, upper_of_square, upper_signed,
};
use super::{Fixed, ONE};

/// Σ ab.
#[inline]
pub(super) const fn dot([ax, ay, az]: [Fixed; 3], [bx, by, bz]: [Fixed; 3]) -> Fixed {
    let (x, y, z) = (
        product64(ax.0, bx.0),
        product64(ay.0, by.0),
        product64(az.0, bz.0),
    );
    let steps = (x.wrapping_add(y).wrapping_add(z).wrapping_add(0x8000)) >> 16;
    Fixed(if steps as i32 as i64 == steps {
        steps as i32
    } else {
        // the sum of the products may itself have wrapped
        let quarter = (x >> 2) + (y >> 2) + (z >> 2);
        (quarter >> 63) as i32 ^ i32::MAX
    })
}

/// Each number times a factor, as by `*`.
#[inline]
pub(super) fn scaled(v: [Fixed; 3], factor: Fixed) -> [Fixed; 3] {
    if (factor.0 as u32) < ONE as u32 {
        v.map(|c| Fixed(short_part(c.0, factor.0 as u16)))
    } else {
        v.map(|c| c * factor)
    }
}

/// Each number divided by a divisor.
///
/// The error is below 0.51 steps, or 2⁻²⁷ of a result of many steps. A divisor of up to 1 gives what `/` gives.
#[inline]
pub(super) fn quotients(v: [Fixed; 3], divisor: Fixed) -> [Fixed; 3] {
    if divisor.0 > ONE {
        let share = reciprocal(divisor.0 as u32);
        v.map(|c| Fixed(part(c.0, share)))
    } else {
        v.map(|c| c / divisor)
    }
}

/// 2³² times the reciprocal of a number above 1, with a relative error below 2⁻²⁷.
#[inline]
fn reciprocal(steps: u32) -> u32 {
    let zeros = leading_zeros(steps);
    let x = steps << zeros; // x/2³² is from ½ to 1
    let first = short_reciprocal(x >> 16); // 16 bits after the point
    // Newton's method: y + y(1 − xy)
    let e = (1_u32 << 31).wrapping_sub(upper(x, first << 15)) as i32;
    let second = (first << 13).wrapping_add(((first as i32 * (e >> 4)) >> 14) as u32); // 29 bits
    second << 2 >> (15 - zeros)
}

/// (2³² − 1) / x, rounded down, for x from 2¹⁵ to 2¹⁶ − 1.
#[inline]
fn short_reciprocal(x: u32) -> u32 {
    // a processor with a long multiply has a divider too
    if LONG_MULTIPLY {
        return u32::MAX / x;
    }
    let first = 256 + u32::from(ROOTS[(x >> 10) as usize & 63]);
    // Newton's method, whose e = xy − 1 has 32 bits after the point
    let y = (first * first) as i32;
    let e = (x as i32).wrapping_mul(y);
    let y = y - (y * (e >> 16) >> 16);
    let e = (x as i32).wrapping_mul(y);
    let y = (y - (y * (e >> 8) >> 24) - 1) as u32;
    // what is left is off by one at most
    let rest = u32::MAX.wrapping_sub(x * y);
    y.wrapping_add(u32::from(rest as i32 >= x as i32))
        .wrapping_sub(rest >> 31)
}

/// The direction and the length of a vector; both are 0 for the zero vector.
///
/// The direction does not depend on the length, even if that saturates.
#[inline]
pub(super) const fn unit_and_length(v: [Fixed; 3]) -> ([Fixed; 3], Fixed) {
    let shift = headroom(v);
    let [x, y, z] = [v[0].0 << shift, v[1].0 << shift, v[2].0 << shift];
    let sum = upper_of_square(x) + upper_of_square(y) + upper_of_square(z);
    if sum == 0 {
        return ([Fixed(0); 3], Fixed(0));
    }
    // by an even number of bits, so that the leading one is among the first two
    let odd = (sum < 1 << 30) as u32;
    let sum = sum << (2 * odd);
    let reciprocal = reciprocal_root(sum);
    let length = upper(sum, reciprocal); // in units of 2^(3 − shift − odd) steps
    let down = shift + odd;
    let length = if down > 3 {
        ((length >> (down - 4)) + 1) >> 1
    } else {
        let up = 3 - down;
        let most = (i32::MAX as u32) >> up;
        (if length < most { length } else { most }) << up
    };
    let unit = [
        share_of(x, reciprocal, odd),
        share_of(y, reciprocal, odd),
        share_of(z, reciprocal, odd),
    ];
    (unit, Fixed(length as i32))
}

/// A component times the reciprocal of the length, rounded.
#[inline]
const fn share_of(component: i32, reciprocal: u32, odd: u32) -> Fixed {
    Fixed(((upper_signed(component, reciprocal as i32) >> (12 - odd)) + 1) >> 1)
}

/// The vector times a power of two, so that its largest component is from 32 to 64.
#[inline]
pub(super) fn tamed(v: [Fixed; 3]) -> [Fixed; 3] {
    let shift = headroom(v);
    v.map(|c| Fixed(c.0 << shift >> 9))
}

/// By how many bits the vector can be shifted up. It is 31 for the zero vector.
#[inline]
const fn headroom([x, y, z]: [Fixed; 3]) -> u32 {
    let magnitude = (x.0 ^ x.0 >> 31) | (y.0 ^ y.0 >> 31) | (z.0 ^ z.0 >> 31);
    leading_zeros((magnitude << 1 | 1) as u32)
}

/// 2⁸(1/√x − 1) for the middle x of each 64th, from ¼ to 1.
static ROOTS: [u8; 64] = {
    let mut table = [0; 64];
    let mut i = 16;
    while i < 64 {
        // the largest r with (2⁸ + r)² x ≤ 2¹⁶, where x = (2i + 1)/2⁷
        let mut r = 255_u32;
        while (256 + r) * (256 + r) * (2 * i as u32 + 1) > 1 << 23 {
            r -= 1;
        }
        table[i] = r as u8;
        i += 1;
    }
    table
};

/// 2²⁹/√x for x = `bits`/2³² from ¼ on, with a relative error below 2⁻²⁷.
#[inline]
const fn reciprocal_root(bits: u32) -> u32 {
    let first = 256 + ROOTS[(bits >> 26) as usize] as i32; // 8 bits after the point
    // e = xy² − 1, with 32 bits after the point; y(1 − e/2 + 3e²/8) leaves 5e³/16
    let e = ((first * first) as u32).wrapping_mul(bits >> 16) as i32;
    let short = e >> 16;
    let twice = (e >> 12) - ((3 * short * short) >> 14);
    let second = (first << 6) - ((first * twice) >> 15); // 14 bits
    // y(1 − e/2) leaves 3e²/8
    let e = (1 << 28) - upper(bits, (second * second) as u32) as i32;
    ((second << 15) + ((second * e) >> 14)) as u32
}
