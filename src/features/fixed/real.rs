//! [`Real`] and [`Elementary`], with the reciprocal root on which directions, attenuations and
//! highlights rest.

use super::{Fixed, ONE, rounded};
use crate::elementary::Elementary;
use crate::real::{Dimmed, LightSum, Lobe, Measured, Real, Toward, falloff};
use crate::rgb::Rgb;
use crate::vector::Vec3;

/// A Cortex-M0 multiplies 32 bits, and the compiler would call a routine for 64.
const HALVES: bool = cfg!(all(target_arch = "arm", not(target_has_atomic = "32")));

/// The whole product of two numbers of steps.
#[inline]
pub(super) const fn product(a: i32, b: i32) -> i64 {
    if HALVES {
        (upper(a, b) as i64) << 32 | a.wrapping_mul(b) as u32 as i64
    } else {
        a as i64 * b as i64
    }
}

/// The upper half of a product.
#[inline]
const fn upper(a: i32, b: i32) -> i32 {
    if HALVES {
        let (a_1, a_0, b_1, b_0) = (a >> 16, a & 0xFFFF, b >> 16, b & 0xFFFF);
        let low = (a_0 as u32).wrapping_mul(b_0 as u32) >> 16;
        let middle = a_1.wrapping_mul(b_0).wrapping_add(low as i32);
        let other = a_0.wrapping_mul(b_1).wrapping_add(middle & 0xFFFF);
        a_1.wrapping_mul(b_1)
            .wrapping_add(middle >> 16)
            .wrapping_add(other >> 16)
    } else {
        ((a as i64 * b as i64) >> 32) as i32
    }
}

/// The upper half of an unsigned product, rounded.
#[inline]
const fn upper_rounded(a: u32, b: u32) -> u32 {
    if HALVES {
        let (a_1, a_0, b_1, b_0) = (a >> 16, a & 0xFFFF, b >> 16, b & 0xFFFF);
        let middle = (a_1 * b_0).wrapping_add(a_0 * b_0 >> 16);
        let other = (a_0 * b_1).wrapping_add((middle & 0xFFFF) + (1 << 15));
        let carry = (other < (middle & 0xFFFF) + (1 << 15)) as u32;
        (a_1 * b_1).wrapping_add((middle >> 16) + (other >> 16) + (carry << 16))
    } else {
        ((a as u64 * b as u64 + (1 << 31)) >> 32) as u32
    }
}

/// The upper half of a product whose factors are below 2³¹, but for the first.
#[inline]
const fn upper_unsigned(a: u32, b: u32) -> u32 {
    if HALVES {
        // the sign of a stands for 2³², which b takes part in
        (upper(a as i32, b as i32) as u32).wrapping_add(if a >> 31 == 1 { b } else { 0 })
    } else {
        ((a as u64 * b as u64) >> 32) as u32
    }
}

/// 2²⁷/√x for x = `bits`/2³² from ¼ on, by Newton's method.
#[inline]
const fn reciprocal_root(bits: u32) -> u32 {
    let first = 256 + ROOTS[(bits >> 25) as usize] as i32; // 8 bits after the point
    // y(1 − e/2), where e = xy² − 1 has 32 bits after the point
    let e = ((first * first) as u32).wrapping_mul(bits >> 16) as i32;
    let second = (first << 6) - ((first * (e >> 12)) >> 15); // 14 bits
    // once more
    let e = (1 << 28) - upper_unsigned(bits, (second * second) as u32) as i32;
    ((second << 13) + (second.wrapping_mul(e >> 1) >> 15)) as u32
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

/// 2²⁸/x for x = `bits`/2³² from ½ on, by Newton's method, too.
#[inline]
const fn reciprocal(bits: u32) -> u32 {
    let root = 256 + ROOTS[(bits >> 25) as usize] as i32;
    // y(1 − e), where e = xy² − 1 has 32 bits after the point
    let first = root * root; // 16 bits
    let e = (first as u32).wrapping_mul(bits >> 16) as i32;
    let second = first - ((first * (e >> 12)) >> 20);
    // once more
    let e = (1 << 30) - upper_unsigned(bits, (second as u32) << 14) as i32;
    ((second << 12) + (second.wrapping_mul(e >> 4) >> 14)) as u32
}

/// A vector times a power of two, with a component from 2³⁰ to 2³¹ unless it is 0.
struct Scaled {
    v: [i32; 3],
    shift: u32,
    /// |v|²/2³²
    square: u32,
    /// 2⁵⁹/|v|
    root: i32,
}

#[inline]
const fn scaled([x, y, z]: [i32; 3]) -> Scaled {
    let bits = (x ^ x >> 31) | (y ^ y >> 31) | (z ^ z >> 31);
    let shift = (2 * bits as u32 | 1).leading_zeros();
    let v = [x << shift, y << shift, z << shift];
    let [x, y, z] = v;
    let square = (upper(x, x) as u32 + upper(y, y) as u32 + upper(z, z) as u32) | 1;
    let pairs = square.leading_zeros() >> 1;
    let root = (reciprocal_root(square << (2 * pairs)) << pairs) as i32;
    Scaled {
        v,
        shift,
        square,
        root,
    }
}

/// The direction and the length of a vector; for the zero vector, 0.
#[inline]
pub(super) const fn unit_and_length(v: [Fixed; 3]) -> ([Fixed; 3], Fixed) {
    let [x, y, z] = v;
    if (x.0 | y.0 | z.0) == 0 {
        return (v, Fixed(0));
    }
    scaled([x.0, y.0, z.0]).unit_and_length()
}

impl Scaled {
    #[inline]
    const fn unit_and_length(self) -> ([Fixed; 3], Fixed) {
        let Self {
            v: [x, y, z],
            shift,
            square,
            root,
        } = self;
        let unit = [
            Fixed((upper(x, root) + (1 << 10)) >> 11),
            Fixed((upper(y, root) + (1 << 10)) >> 11),
            Fixed((upper(z, root) + (1 << 10)) >> 11),
        ];
        let length = upper_unsigned(square, root as u32); // in units of 2^(5 − shift) steps
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
    fn cosine(&self, n: Vec3<Fixed>) -> i32 {
        let ([a, b, c], [x, y, z]) = (n.map(|x| x.0 << 12).into(), self.v);
        let dot = upper(a, x)
            .wrapping_add(upper(b, y))
            .wrapping_add(upper(c, z));
        upper(dot << 2, self.root)
    }
}

/// 1/(a + bq + cq²) as x/2^s where the denominator is at most 1, or beyond the range: (x, s).
fn reciprocal_beyond([a, b, c, q]: [Fixed; 4], is_large: bool) -> (u32, u32) {
    let steps = |x: Fixed| x.0.max(0) as u64;
    let q = steps(q);
    let slope = (steps(b) << 16) + steps(c) * q; // 32 bits after the point
    let (d, shift) = if is_large {
        let d = (slope >> 24)
            .saturating_mul(q)
            .saturating_add(steps(a) << 8);
        (d | 1, 68)
    } else {
        let d = (steps(a) << 32).wrapping_add(slope.wrapping_mul(q));
        (d | 1, 44)
    };
    let zeros = d.leading_zeros();
    let share = reciprocal((d << zeros >> 32) as u32);
    (share, (shift.max(zeros) - zeros).clamp(1, 62))
}

#[diagnostic::do_not_recommend] // the trait's own message names the types
impl Real for Fixed {
    type Mask = bool;
    type Sum = Exact;

    const ZERO: Self = Self(0);
    const ONE: Self = Self(ONE);
    const NEG_ONE: Self = Self(-ONE);
    const MAX: Self = Self::MAX;
    const EXTREME: Self = Self(ONE << 9);

    fn of(literal: f64) -> Self {
        Self::new(literal)
    }

    #[inline]
    fn of_f32(literal: f32) -> Self {
        Self::from_f32(literal)
    }

    fn sqrt(self) -> Self {
        Self((((self.0.max(0) as u64) << 18).isqrt() as i32 + 1) >> 1)
    }

    #[inline]
    fn above(self, other: Self) -> bool {
        self > other
    }

    /// It is rounded once, and above 0 if the exact sum is.
    #[inline]
    fn dot(Vec3 { x: a, y: b, z: c }: Vec3<Self>, Vec3 { x, y, z }: Vec3<Self>) -> Self {
        // halves, whose sum cannot overflow
        let sum = (product(a.0, x.0) >> 1) + (product(b.0, y.0) >> 1) + (product(c.0, z.0) >> 1);
        let Self(steps) = rounded(sum, 15, (sum >> 32) as i32);
        Self(if steps == 0 && sum > 0 { 1 } else { steps })
    }

    #[inline]
    fn measured(v: Vec3<Self>) -> Measured<Self> {
        let (unit, length) = unit_and_length(v.into());
        let w_length = Self(if length.0 == 0 { 0 } else { ONE });
        Measured {
            w: unit.into(),
            w_length,
            length,
        }
    }

    #[inline]
    fn faces(n: Vec3<Self>, v: Vec3<Self>) -> bool {
        // n has 17 bits, so the sum has 50
        let sum = product(n.x.0, v.x.0).wrapping_add(product(n.y.0, v.y.0));
        sum.wrapping_add(product(n.z.0, v.z.0)) > 0
    }

    /// With the cosine by the root of the length, which has more bits than the direction has.
    #[inline(always)]
    fn toward(n: Vec3<Self>, v: Vec3<Self>) -> Toward<Self> {
        let scaled = scaled(v.map(|x| x.0).into());
        let n_dot_w = Self((scaled.cosine(n) + (1 << 8)) >> 9);
        let (unit, length) = scaled.unit_and_length();
        let measured = Measured {
            w: unit.into(),
            w_length: Self(ONE),
            length,
        };
        Toward { measured, n_dot_w }
    }

    #[inline]
    fn cosine(_: Vec3<Self>, toward: &Toward<Self>) -> Self {
        Self(toward.n_dot_w.0.clamp(0, ONE))
    }

    #[inline]
    fn whole_power(self, m: u32) -> Self {
        // 32 bits hold the products of numbers below 1
        let times = |a: u32, b: u32| a.wrapping_mul(b).wrapping_add(1 << 15) >> 16;
        let (mut base, mut m) = (self.0 as u32, m);
        if self.0 >= ONE || m == 0 {
            return Self(ONE);
        }
        while m & 1 == 0 {
            base = times(base, base);
            m >>= 1;
        }
        let mut power = base;
        while m > 1 {
            base = times(base, base);
            m >>= 1;
            if m & 1 == 1 {
                power = times(power, base);
            }
        }
        Self(power as i32)
    }

    #[inline]
    fn halfway_power(
        n: Vec3<Self>,
        Measured { w, .. }: Measured<Self>,
        v: Vec3<Self>,
        m: impl Lobe<Self>,
    ) -> Self {
        // both are directions
        let sum = |w: Self, v: Self| Self(w.0.wrapping_add(v.0));
        let h = Vec3::new(sum(w.x, v.x), sum(w.y, v.y), sum(w.z, v.z));
        let cosine = scaled(h.map(|x| x.0).into()).cosine(n);
        let cosine = Self((cosine + (1 << 8)) >> 9);
        if cosine.0 > 0 {
            m.raise(cosine.at_most(Self(ONE)))
        } else {
            Self(0)
        }
    }

    #[inline]
    fn attenuated(color: Rgb<Self>, [a, b, c]: [Self; 3], q: Self, limit: Self) -> Dimmed<Self> {
        let light = |color| Dimmed {
            color,
            factor: Self(ONE),
        };
        // a sum of more than 31 bits tells so in the second number
        let plus_product = |a: Self, b: u32, q: Self| {
            let sum = if HALVES {
                product(b as i32, q.0) as u64
            } else {
                b as u64 * q.0 as u32 as u64
            };
            let sum = sum.wrapping_add((a.0 as u32 as u64) << 16 | 1 << 15);
            ((sum >> 16) as u32, (sum >> 47) as u32)
        };
        let (slope, slope_above) = plus_product(b, c.0 as u32, q);
        let (d, d_above) = plus_product(a, slope, q);
        let is_negative = (a.0 | b.0 | c.0 | q.0) < 0;
        if is_negative || slope_above | d_above != 0 || d < ONE as u32 || limit.0 < ONE {
            return light(attenuated_beyond(color, [a, b, c], q, limit));
        }
        if d == ONE as u32 {
            return light(color);
        }
        let zeros = d.leading_zeros();
        // 32 bits after the point
        let share = reciprocal(d << zeros) << 3 >> (15 - zeros);
        light(color.map(|x| Self(upper_rounded(x.0.max(0) as u32, share) as i32)))
    }

    #[inline]
    fn windowed(
        Dimmed { color, factor }: Dimmed<Self>,
        q: Self,
        range: Self,
        is_squared: bool,
    ) -> Dimmed<Self> {
        if q >= range {
            return Dimmed {
                color: Rgb::BLACK,
                factor,
            };
        }
        let zeros = range.0.leading_zeros();
        let share = upper_unsigned((q.0 << zeros) as u32, reciprocal((range.0 as u32) << zeros)); // 28 bits
        let share = if share >> 28 == 0 {
            share << 3
        } else {
            u32::MAX >> 1
        };
        let square = upper_unsigned(share, share) << 1; // 31 bits
        let root = (1 << 31) - 1 - (upper_unsigned(square, square) << 1);
        let window = if is_squared {
            upper_unsigned(root, root) << 1
        } else {
            root
        };
        let color = color.map(|x| Self(upper_rounded(x.0.max(0) as u32, window << 1) as i32));
        Dimmed { color, factor }
    }

    #[inline]
    fn beamed(
        Dimmed { color, factor }: Dimmed<Self>,
        cosine: Self,
        inner_and_outer: [Self; 2],
        is_smooth: bool,
    ) -> Dimmed<Self> {
        let color = color * falloff::beam(cosine, inner_and_outer, is_smooth);
        Dimmed { color, factor }
    }
}

/// [`Real::attenuated`] where the denominator is below 1 or beyond the range, and with another limit.
#[cold]
#[inline(never)]
fn attenuated_beyond(
    color: Rgb<Fixed>,
    [a, b, c]: [Fixed; 3],
    q: Fixed,
    limit: Fixed,
) -> Rgb<Fixed> {
    let slope = rounded(product(c.0, q.0) + ((b.0 as i64) << 16), 16, 0);
    let d = rounded(product(slope.0, q.0) + ((a.0 as i64) << 16), 16, 0);
    if d.0 < 0 {
        return Rgb::new(Fixed(0), Fixed(0), Fixed(0));
    }
    let (share, shift) = reciprocal_beyond([a, b, c, q], d.0 > ONE);
    let times = |x: Fixed| {
        let steps = (x.0 as i64 * share as i64 + (1_i64 << shift >> 1)) >> shift;
        Fixed(steps.clamp(i32::MIN as i64, i32::MAX as i64) as i32)
    };
    if limit == Fixed::MAX {
        color.map(times)
    } else {
        color * times(Fixed(ONE)).at_most(limit)
    }
}

/// A sum with 32 bits after the point in each channel, of products that are not rounded.
#[derive(Clone, Copy)]
pub struct Exact(Rgb<u64>);

impl LightSum<Fixed> for Exact {
    const DARK: Self = Self(Rgb::new(0, 0, 0));

    #[inline(always)]
    fn add(self, light: Dimmed<Fixed>, cosine: Fixed) -> Self {
        // the factor is 1, or 0 where there is no direction
        let factor = if light.factor.0 == ONE {
            cosine
        } else {
            light.factor * cosine
        };
        let Self(Rgb { r, g, b }) = self;
        let color = light.color;
        Self(Rgb::new(
            plus_product(r, color.r, factor),
            plus_product(g, color.g, factor),
            plus_product(b, color.b, factor),
        ))
    }

    #[inline]
    fn total(self) -> Rgb<Fixed> {
        self.0.map(|sum| {
            let steps = (sum + (1 << 15)) >> 16;
            Fixed(if steps >> 31 == 0 {
                steps as i32
            } else {
                i32::MAX
            })
        })
    }
}

#[inline(always)]
fn plus_product(sum: u64, light: Fixed, factor: Fixed) -> u64 {
    let (light, factor) = (light.0.max(0) as u32, factor.0.clamp(0, ONE) as u32);
    let product = if HALVES {
        // a factor has 17 bits
        (((light >> 16) * factor) as u64) << 16
    } else {
        light as u64 * factor as u64
    };
    let low = if HALVES {
        (light & 0xFFFF).wrapping_mul(factor) as u64
    } else {
        0
    };
    sum.wrapping_add(product).wrapping_add(low)
}

macro_rules! by_way_of_f32 {
    ($($function:ident),*) => {
        /// By way of `f32`, with `libm`.
        impl Elementary for Fixed {
            $(#[inline]
            fn $function(self) -> Self {
                Self::from_f32(Elementary::$function(self.to_f32()))
            })*
        }
    };
}

by_way_of_f32!(sin, cos, exp, ln);
