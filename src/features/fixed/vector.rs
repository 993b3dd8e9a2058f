//! What is computed of three numbers at once: dot products, directions, colors.
//!
//! Each result is rounded to steps once, at the end. On a Cortex-M0, whose flash and stack are small,
//! a function has one copy that is called; elsewhere, it becomes a part of the caller.

use super::falloff::{FINE, in_steps};
use super::product::{
    COUNTS_ZEROS, LONG_MULTIPLY, product64, short_part, upper, upper_of_part, upper_of_square,
    upper_signed,
};
use super::reciprocal::{pairs_of_zeros, reciprocal_root};
use super::{Fixed, ONE};

/// Σ ab.
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
#[cfg_attr(not(all(target_arch = "arm", not(target_has_atomic = "32"))), inline)]
pub(super) const fn dot(a: &[Fixed; 3], b: &[Fixed; 3]) -> Fixed {
    if !LONG_MULTIPLY && is_short(a) && is_short(b) {
        return dot_of_short(a, b);
    }
    let (mut sum, mut quarter, mut i) = (0x8000_i64, 0, 0);
    while i < 3 {
        let product = product64(a[i].0, b[i].0);
        sum = sum.wrapping_add(product);
        quarter += (product >> 34) as i32;
        i += 1;
    }
    let steps = sum >> 16;
    Fixed(if steps as i32 as i64 == steps {
        steps as i32
    } else {
        // the sum may have wrapped, but a quarter of it has not
        quarter >> 31 ^ i32::MAX
    })
}

/// Σ ab of numbers from −4 to 4, by halves.
#[inline]
const fn dot_of_short(a: &[Fixed; 3], b: &[Fixed; 3]) -> Fixed {
    let (mut sum, mut rest, mut i) = (0, 0x8000, 0);
    while i < 3 {
        let [a1, a0] = [a[i].0 >> 16, a[i].0 & 0xFFFF];
        let [b1, b0] = [b[i].0 >> 16, b[i].0 & 0xFFFF];
        let low = a0 as u32 * b0 as u32;
        sum += ((a1 * b1) << 16) + a1 * b0 + a0 * b1 + (low >> 16) as i32;
        rest += low & 0xFFFF;
        i += 1;
    }
    Fixed(sum + (rest >> 16) as i32)
}

/// Whether each component is from −4 to 4.
#[inline]
const fn is_short([x, y, z]: &[Fixed; 3]) -> bool {
    let [x, y, z] = [
        x.0.wrapping_add(4 * ONE),
        y.0.wrapping_add(4 * ONE),
        z.0.wrapping_add(4 * ONE),
    ];
    ((x | y | z) as u32) < 8 * ONE as u32
}

/// Each number times a factor, as by `*`.
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
#[cfg_attr(not(all(target_arch = "arm", not(target_has_atomic = "32"))), inline)]
pub(super) fn scaled(&[x, y, z]: &[Fixed; 3], factor: Fixed) -> [Fixed; 3] {
    if (factor.0 as u32) < ONE as u32 {
        let part = |c: Fixed| Fixed(short_part(c.0, factor.0 as u16)); // a loop would take more stack
        [part(x), part(y), part(z)]
    } else {
        [x * factor, y * factor, z * factor]
    }
}

/// The cosine of the angle between n and the half vector of l and v, N·H; 0 if they are
/// opposite. It takes two functions, for the stack of a Cortex-M0.
#[inline]
pub(super) fn half_cosine(n: &[Fixed; 3], l: &[Fixed; 3], v: &[Fixed; 3]) -> Fixed {
    let (dot, square) = with_half_vector(n, l, v);
    over_root(dot, square)
}

/// N·h and the upper half of |h|², where h = L + V.
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
#[cfg_attr(not(all(target_arch = "arm", not(target_has_atomic = "32"))), inline)]
fn with_half_vector(n: &[Fixed; 3], l: &[Fixed; 3], v: &[Fixed; 3]) -> (i32, u32) {
    let (mut square, mut dot, mut i) = (0_u32, 0_i32, 0);
    while i < 3 {
        let h = l[i].0.wrapping_add(v[i].0) << 13;
        square += upper_of_square(h);
        dot = dot.wrapping_add(upper_signed(n[i].0 << 12, h));
        i += 1;
    }
    (dot, square)
}

/// N·h/|h|.
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
#[cfg_attr(not(all(target_arch = "arm", not(target_has_atomic = "32"))), inline)]
fn over_root(dot: i32, square: u32) -> Fixed {
    let pairs = pairs_of_zeros(square);
    let root = reciprocal_root(square << (2 * pairs));
    let cosine = upper_of_part(dot << pairs, root); // 23 bits after the point
    Fixed((cosine + (1 << 6)) >> 7)
}

/// The cosine of the angle between v and the reflection of l in n, R·V = 2(n·l)(n·v) − l·v.
#[inline]
pub(super) fn reflected_cosine(n: &[Fixed; 3], l: &[Fixed; 3], v: &[Fixed; 3]) -> Fixed {
    let product = upper_signed(fine_dot(n, l) << 5, fine_dot(n, v) << 5);
    let cosine = (product << 1).wrapping_sub(fine_dot(l, v)); // 22 bits after the point
    Fixed(((cosine >> 5) + 1) >> 1)
}

/// Σ ab of directions, with 22 bits after the point.
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
#[cfg_attr(not(all(target_arch = "arm", not(target_has_atomic = "32"))), inline)]
fn fine_dot(a: &[Fixed; 3], b: &[Fixed; 3]) -> i32 {
    let (mut sum, mut i) = (0_i32, 0);
    while i < 3 {
        sum = sum.wrapping_add(upper_signed(a[i].0 << 12, b[i].0 << 13));
        i += 1;
    }
    sum >> 3
}

/// The direction and the length of a vector; for the zero vector, the z axis and 0.
///
/// The direction is right even if the length saturates.
#[inline]
pub(super) const fn unit_and_length(v: &[Fixed; 3]) -> ([Fixed; 3], Fixed) {
    let (unit, length) = unit_and_fine_length(v);
    (unit, in_steps(length))
}

/// The same, but a length below 1 is negative, and [`FINE`] bits finer.
///
/// It takes two functions: together they would keep more on the stack of a Cortex-M0.
#[inline]
pub(super) const fn unit_and_fine_length(v: &[Fixed; 3]) -> ([Fixed; 3], Fixed) {
    let mut unit = *v;
    let shift = headroom(magnitude(&unit));
    let (length, reciprocal) = length_and_reciprocal(&unit, shift);
    normalize(&mut unit, shift, reciprocal);
    if length.0 == 0 {
        unit[2] = Fixed(ONE);
    }
    (unit, length)
}

/// The length of a vector with so much headroom, as [`unit_and_fine_length`] returns it, and the reciprocal
/// for [`normalize`].
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
#[cfg_attr(not(all(target_arch = "arm", not(target_has_atomic = "32"))), inline)]
const fn length_and_reciprocal(v: &[Fixed; 3], shift: u32) -> (Fixed, i32) {
    let square = upper_of_square(v[0].0 << shift)
        + upper_of_square(v[1].0 << shift)
        + upper_of_square(v[2].0 << shift);
    let pairs = pairs_of_zeros(square);
    let reciprocal = reciprocal_root(square << (2 * pairs)) << pairs;
    let length = upper(square, reciprocal as u32); // in units of 2^(5 − shift) steps
    let is_short = length >> 11 >> shift == 0;
    let shift = shift as i32 - if is_short { FINE as i32 } else { 0 };
    let length = if shift > 5 {
        ((length >> (shift - 6)) + 1) >> 1
    } else {
        let up = 5 - shift;
        let most = (i32::MAX as u32) >> up;
        (if length < most { length } else { most }) << up
    } as i32;
    (Fixed(if is_short { -length } else { length }), reciprocal)
}

/// Makes a direction of a vector, given its headroom and the reciprocal of its length.
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
#[cfg_attr(not(all(target_arch = "arm", not(target_has_atomic = "32"))), inline)]
const fn normalize(v: &mut [Fixed; 3], shift: u32, reciprocal: i32) {
    v[0] = share_of(v[0].0 << shift, reciprocal);
    v[1] = share_of(v[1].0 << shift, reciprocal);
    v[2] = share_of(v[2].0 << shift, reciprocal);
}

/// A component times the reciprocal of the length, rounded.
#[inline]
const fn share_of(component: i32, reciprocal: i32) -> Fixed {
    Fixed((upper_of_part(component, reciprocal) + (1 << 10)) >> 11)
}

/// The vectors times one power of two, so that the largest component is from 16 to 64, and its exponent plus
/// 9, in steps.
#[inline]
pub(super) fn rescaled<const N: usize>(vectors: [[Fixed; 3]; N]) -> ([[Fixed; 3]; N], Fixed) {
    let largest = vectors.iter().fold(0, |bits, v| bits | magnitude(v));
    let shift = headroom(largest);
    let vectors = vectors.map(|v| v.map(|c| Fixed(c.0 << shift >> 9)));
    (vectors, Fixed(shift as i32))
}

/// A vector times the power of two that rescaled another.
#[inline]
pub(super) fn rescaled_by(v: [Fixed; 3], Fixed(shift): Fixed) -> [Fixed; 3] {
    let most = i32::MAX as i64;
    v.map(|c| Fixed(((c.0 as i64) << shift >> 9).clamp(-most, most) as i32))
}

/// The highest bits of a vector's components.
#[inline]
const fn magnitude([x, y, z]: &[Fixed; 3]) -> u32 {
    ((x.0 ^ x.0 >> 31) | (y.0 ^ y.0 >> 31) | (z.0 ^ z.0 >> 31)) as u32
}

/// By how many bits a vector of a magnitude can be shifted up, or one bit less. It is 30 for 0.
#[inline]
const fn headroom(magnitude: u32) -> u32 {
    let mut bits = magnitude | 1;
    if COUNTS_ZEROS {
        return (bits.leading_zeros() - 1) & !1;
    }
    let mut shift = 0;
    while bits >> 23 == 0 {
        bits <<= 8;
        shift += 8;
    }
    while bits >> 29 == 0 {
        bits <<= 2;
        shift += 2;
    }
    shift
}
