//! What dims a light: the attenuation, the window of a range and the beam of a cone.

use super::product::{product, product_unsigned, upper_rounded, upper_unsigned, zeros};
use super::reciprocal::reciprocal;
use super::root::Scaled;
use super::{Fixed, saturated};
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
    let zeros = zeros(width);
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

/// A factor of any size, significand/2^shift: `Factor(significand, shift)`.
#[derive(Clone, Copy)]
pub(super) struct Factor(u32, i32);

impl Factor {
    #[cold]
    #[inline(never)]
    pub(super) fn times(self, x: Fixed) -> Fixed {
        let Self(significand, shift) = self;
        let product = product_unsigned(significand, x.0.max(0) as u32);
        saturated(((product << 1 >> shift) + 1) >> 1) // rounded
    }

    /// The factor of [`Real::attenuated`](crate::Real::attenuated), whatever the denominator and the limit are.
    /// `is_near` says that the denominator d is below 1 where it is computed by short products.
    ///
    /// It never rises as a coefficient or q does. From 1 on, d has the slope that short products have, rounded to
    /// a step, and the factor has the bits that it has there. Below 1, d has all the digits of the slope, and is
    /// limited to 1, because the two slopes differ.
    // Without a loop: the compiler makes four copies of its body for a Cortex-M4.
    #[cold]
    #[inline(never)]
    pub(super) fn attenuating(
        a: Fixed,
        b: Fixed,
        c: Fixed,
        q: Fixed,
        limit: Fixed,
        is_near: bool,
    ) -> Self {
        let q = q.0.max(0);
        // the slope b + cq with 32 bits after the point, and then as many as leave 31 in all, and 30 of a
        let mut slope = product(c.0, q) + ((b.0 as i64) << 16);
        if !is_near {
            slope = (slope + (1 << 15)) >> 16 << 16;
        }
        let excess = (slope.unsigned_abs() >> 31) as u32 | a.0.unsigned_abs() >> 30;
        // at most 31: a slope of more bits leaves nothing of the light
        let dropped = 31 - zeros(excess.min(u32::MAX >> 1) << 1 | 1);
        let upper = |number: i32| (number as u32) << 1 << (31 - dropped);
        let slope = upper((slope >> 32) as i32) | slope as u32 >> dropped;
        let constant = ((a.0 >> dropped) as i64) << 32 | upper(a.0) as i64;
        let denominator = product(slope as i32, q) + constant;
        if denominator < 0 {
            return Self(0, 0);
        }
        let mut shift = 44 + dropped as i32;
        let (mut bits, mut lower) = ((denominator >> 32) as u32, denominator as u32 | 1);
        if bits == 0 {
            (bits, lower, shift) = (lower, 0, shift - 32);
        }
        let left = zeros(bits);
        let mut significand = reciprocal(bits << left | lower >> 1 >> (31 - left));
        shift -= left as i32;
        if shift > 32 {
            (significand, shift) = (significand >> (shift - 32).min(31), 32);
        } else if shift < 0 {
            (significand, shift) = (significand << (-shift).min(3), 0);
        }
        if limit != Fixed::MAX && ((significand as u64) << 16) >> shift >= limit.0 as u64 {
            Self(limit.0 as u32, 16)
        } else if is_near && significand >> (shift % 32) == 0 {
            Self(1, 0)
        } else {
            Self(significand, shift)
        }
    }
}
