//! Roots, directions and lengths.

use super::Fixed;
use super::product::{upper, upper_unsigned, zeros};
use super::reciprocal::reciprocal_root;
use crate::target::NARROW_PRODUCT;
use crate::vector::Vec3;

/// The root of a number, rounded to the nearest step; 0 for a negative number.
#[inline]
pub(super) const fn root(x: Fixed) -> Fixed {
    if x.0 <= 0 {
        return Fixed(0);
    }
    let bits = x.0 as u32;
    let even = zeros(bits) & !1;
    let normal = bits << even;
    // √(2¹⁶ x), or a step less
    let root = (upper_unsigned(normal, reciprocal_root(normal) as u32) >> (3 + even / 2)) as i32;
    // 2¹⁶ x − root², which 32 bits hold
    let rest = (bits << 16).wrapping_sub(root.wrapping_mul(root) as u32) as i32;
    Fixed(if rest > root { root + 1 } else { root })
}

/// |v|²/2³², less up to three roundings down.
#[inline(always)]
const fn square([x, y, z]: [i32; 3]) -> u32 {
    upper(x, x) as u32 + upper(y, y) as u32 + upper(z, z) as u32
}

/// n·v/2²⁰, less up to three roundings down.
#[inline(always)]
pub(super) fn dot(n: Vec3<Fixed>, [x, y, z]: [i32; 3]) -> i32 {
    let [a, b, c] = n.map(|x| x.0 << 12).into();
    upper(a, x)
        .wrapping_add(upper(b, y))
        .wrapping_add(upper(c, z))
}

/// The cosine of the angle between n and the sum of two directions, with 25 bits after the point; 0
/// if there is no sum.
#[inline]
pub(super) fn halfway_cosine(n: Vec3<Fixed>, a: Vec3<Fixed>, b: Vec3<Fixed>) -> i32 {
    // from −2³⁰ to 2³⁰, up to what rounding adds
    let sum = |a: Fixed, b: Fixed| a.0.wrapping_add(b.0) << 12;
    let mut h = [sum(a.x, b.x), sum(a.y, b.y), sum(a.z, b.z)];
    // As a rule, the angle between the two is less than 120°, so that |h| is from 1 to 2.
    let square = loop {
        let square = square(h);
        if square >> 24 != 0 {
            break square;
        }
        let [x, y, z] = h;
        if (x | y | z) == 0 {
            return 0;
        }
        h = [2 * x, 2 * y, 2 * z];
    };
    let root = if square >> 26 == 0 {
        reciprocal_root(square << 6) << 1
    } else {
        reciprocal_root(square << 4)
    };
    upper(dot(n, h) << 4, root)
}

/// A vector times a power of two, with a component from 2³⁰ to 2³¹ unless it is 0.
pub(super) struct Scaled {
    v: [i32; 3],
    shift: u32,
    /// |v|²/2³²
    square: u32,
    /// 2⁵⁹/|v|
    root: i32,
}

impl Scaled {
    #[inline]
    pub(super) const fn of(v: [Fixed; 3]) -> Self {
        #[inline(never)]
        const fn one_copy(v: [Fixed; 3]) -> Scaled {
            Scaled::of_inline(v)
        }
        if NARROW_PRODUCT {
            one_copy(v)
        } else {
            Self::of_inline(v)
        }
    }

    #[inline(always)]
    const fn of_inline([x, y, z]: [Fixed; 3]) -> Self {
        let bits = x.0.unsigned_abs() | y.0.unsigned_abs() | z.0.unsigned_abs();
        let shift = zeros(bits | bits << 1 | 1); // 0 for −2³¹, too
        let [x, y, z] = [x.0 << shift, y.0 << shift, z.0 << shift];
        // from 2²⁸ on
        let square = square([x, y, z]);
        let pair = (square >> 30 == 0) as u32;
        Self {
            v: [x, y, z],
            shift,
            square,
            root: reciprocal_root(square << (2 * pair)) << pair,
        }
    }

    #[inline]
    pub(super) const fn unit_and_length(self) -> ([Fixed; 3], Fixed) {
        let ([x, y, z], shift, root) = (self.v, self.shift, self.root);
        let unit = [
            Fixed((upper(x, root) + (1 << 10)) >> 11),
            Fixed((upper(y, root) + (1 << 10)) >> 11),
            Fixed((upper(z, root) + (1 << 10)) >> 11),
        ];
        let length = upper_unsigned(self.square, root as u32); // in units of 2^(5 − shift) steps
        let length = if shift > 5 {
            ((length >> (shift - 6)) + 1) >> 1
        } else if length >> (26 + shift) != 0 {
            i32::MAX as u32
        } else {
            length << (5 - shift)
        };
        (unit, Fixed(length as i32))
    }

    /// The cosine of the angle to a direction, with 25 bits after the point.
    #[inline]
    pub(super) fn cosine(&self, n: Vec3<Fixed>) -> i32 {
        upper(dot(n, self.v) << 2, self.root)
    }
}

/// The direction and the length of a vector; for the zero vector, 0. A call, because a copy for each use
/// would fill the flash of a chip.
#[inline(never)]
pub(super) const fn unit_and_length(v: [Fixed; 3]) -> ([Fixed; 3], Fixed) {
    let [x, y, z] = v;
    if (x.0 | y.0 | z.0) == 0 {
        return (v, Fixed(0));
    }
    Scaled::of(v).unit_and_length()
}
