//! What dims a light: the attenuation, the window of a range and the beam of a cone.

use super::product::{product, product_unsigned, upper_rounded, upper_unsigned};
use super::reciprocal::reciprocal;
use super::root::Scaled;
use super::{Fixed, ONE, saturated};
use crate::number::Dimmed;
use crate::vector::Vec3;

/// A light times a factor with 32 bits after the point.
#[inline]
pub(super) fn times(Dimmed { color, factor }: Dimmed<Fixed>, by: u32) -> Dimmed<Fixed> {
    let color = color.map(|x| Fixed(upper_rounded(by, x.0.max(0) as u32) as i32));
    Dimmed { color, factor }
}

/// The window of a range r as [`times`] takes it, for a light at the end of the vector v.
///
/// ```text
/// 1 − (q/r)⁴ = rest (2 − rest),  rest = (r² − q²)/r²
/// ```
// a call, so that the sum over lights without a range has the registers to itself
#[inline(never)]
pub(super) fn window(v: Vec3<Fixed>, range: Fixed, is_squared: bool) -> u32 {
    let square = |x: Fixed| product(x.0, x.0) as u64;
    let (q_squared, r_squared) = (square(v.x) + square(v.y) + square(v.z), square(range));
    if q_squared >= r_squared {
        return 0;
    }
    let zeros = r_squared.leading_zeros();
    let upper = |x: u64| (x << zeros >> 32) as u32;
    let rest = upper_unsigned(upper(r_squared - q_squared), reciprocal(upper(r_squared)));
    let rest = (rest << 3).min(u32::MAX >> 1); // 31 bits after the point, where 2 is 2³²
    let root = upper_unsigned(rest.wrapping_neg(), rest); // below 2³⁰, as rest is below 2³¹
    let window = if is_squared {
        upper_unsigned(2 * root, 2 * root)
    } else {
        root
    };
    window << 2
}

/// The factor of a cone as [`times`] takes it, for a light at the end of the vector v.
#[inline(never)]
pub(super) fn beam(
    axis: Vec3<Fixed>,
    [inner, outer]: [Fixed; 2],
    is_smooth: bool,
    v: Vec3<Fixed>,
) -> u32 {
    let cosine = Scaled::of(v.into()).cosine(-axis); // 25 bits after the point
    let [at_inner, at_outer] = [inner, outer].map(|edge| edge.0 << 9);
    if cosine >= at_inner {
        return u32::MAX; // which rounds to 1
    }
    if cosine <= at_outer {
        return 0;
    }
    // wrapping and limited, for edges that no cone has
    let width = (inner.0.wrapping_sub(outer.0) as u32).clamp(1, 1 << 22);
    let zeros = width.leading_zeros();
    let beyond = (cosine.wrapping_sub(at_outer) as u32) << (zeros - 9);
    let t = upper_unsigned(beyond, reciprocal(width << zeros));
    let t = t.min(u32::MAX >> 4) << 3; // 31 bits after the point
    let square = upper_unsigned(t, t); // below 2³⁰, as t is below 2³¹
    if is_smooth {
        let three_less_2_t = (3 << 30) - t; // 30 bits
        upper_unsigned(three_less_2_t, square) << 4
    } else {
        square << 2
    }
}

/// A factor of any size, `significand`/2^`shift`.
#[derive(Clone, Copy)]
pub(super) struct Factor {
    significand: u32,
    shift: u32,
}

impl Factor {
    #[cold]
    #[inline(never)]
    pub(super) fn times(self, x: Fixed) -> Fixed {
        let product = product_unsigned(self.significand, x.0.max(0) as u32);
        saturated(((product << 1 >> self.shift) + 1) >> 1) // rounded
    }

    /// The factor of [`Real::attenuated`](crate::Real::attenuated), whatever the denominator and the limit are.
    /// `is_near` says that the denominator d is below 1 where it is computed by short products.
    ///
    /// It never rises as a coefficient or q does. From 1 on, d has the slope that short products have, rounded to
    /// a step, and the factor has the bits that it has there. Below 1, d has all the digits of the slope, and is
    /// limited to 1, because the two slopes differ.
    // With loops, because without an instruction for it a count of zeros takes 80 bytes.
    #[cold]
    #[inline(never)]
    pub(super) fn attenuating(
        [a, b, c]: [Fixed; 3],
        q: Fixed,
        limit: Fixed,
        is_near: bool,
    ) -> Self {
        let q = q.0.max(0);
        // the slope b + cq with 32 bits after the point, and then as many as leave 31 in all
        let mut slope = product(c.0, q) + ((b.0 as i64) << 16);
        if !is_near {
            slope = (slope + (1 << 15)) >> 16 << 16;
        }
        let (mut constant, mut shift) = ((a.0 as i64) << 32, 44);
        let mut excess = (slope.unsigned_abs() >> 31 | constant.unsigned_abs() >> 62) as u32;
        while excess != 0 {
            (slope, constant, excess) = (slope >> 1, constant >> 1, excess >> 1);
            shift += 1;
        }
        let denominator = product(slope as i32, q) + constant;
        let mut bits = denominator as u64 | 1;
        while bits >> 63 == 0 {
            (bits, shift) = (bits << 1, shift - 1);
        }
        let mut significand = reciprocal((bits >> 32) as u32) << (-shift).clamp(0, 3);
        let mut shift = shift.clamp(0, 62) as u32;
        if shift > 32 {
            (significand, shift) = (significand >> (shift - 32), 32);
        }
        let in_steps = ((significand as u64) << 16) >> shift;
        if denominator < 0 {
            (significand, shift) = (0, 0);
        } else if limit != Fixed::MAX && in_steps >= limit.0 as u64 {
            (significand, shift) = (limit.0.max(0) as u32, 16);
        } else if is_near && in_steps < ONE as u64 {
            (significand, shift) = (1, 0);
        }
        Self { significand, shift }
    }
}
