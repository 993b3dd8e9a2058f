//! [`Real`] and [`Elementary`].

use super::root::{Scaled, halfway_cosine, reciprocal, root, unit_and_length};
use super::wide::{product, product_by_fraction, product_unsigned, upper_rounded, upper_unsigned};
use super::{Fixed, ONE, edges, rounded};
use crate::elementary::Elementary;
use crate::real::{Dimmed, LightSum, Lobe, Measured, Real, Toward};
use crate::rgb::Rgb;
use crate::vector::Vec3;

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
        root(self)
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
        let scaled = Scaled::of(v.into());
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
    fn between(origin: Vec3<Self>, v: Vec3<Self>) -> Vec3<Self> {
        edges::between(origin.into(), v.into()).into()
    }

    #[inline]
    fn crossed(origin: Vec3<Self>, a: Vec3<Self>, b: Vec3<Self>) -> Vec3<Self> {
        edges::crossed(origin.into(), a.into(), b.into()).into()
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
        let cosine = halfway_cosine(n, w, v);
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
        // A number too large for 31 bits, as a negative one is, leaves bits above them.
        let product = product_unsigned(c.0 as u32, q.0 as u32);
        let product = product.wrapping_add((b.0 as u32 as u64) << 16 | 1 << 15);
        let (slope, slope_above) = ((product >> 16) as u32, (product >> 47) as u32);
        let product = product_unsigned(slope, q.0 as u32);
        let d = ((product >> 16) as u32).wrapping_add(a.0 as u32);
        let d_above = (product >> 47) as u32 | a.0 as u32 >> 31;
        let is_negative_or_limited = (c.0 | limit.0.wrapping_sub(ONE)) < 0;
        if is_negative_or_limited || slope_above | d_above != 0 || d < ONE as u32 {
            let factor = Factor::attenuating([a, b, c], q, limit);
            let Rgb { r, g, b } = color;
            return light(Rgb::new(factor.times(r), factor.times(g), factor.times(b))); // `map` would be a call
        }
        if d == ONE as u32 {
            return light(color);
        }
        let zeros = d.leading_zeros();
        times(light(color), reciprocal(d << zeros) << 3 >> (15 - zeros))
    }

    /// From the squares of q and r, which are exact, so that a bright light has its digits where it ends.
    #[inline]
    fn windowed(
        light: Dimmed<Self>,
        v: Vec3<Self>,
        _: Self,
        range: Self,
        is_squared: bool,
    ) -> Dimmed<Self> {
        times(light, window(v, range, is_squared))
    }

    /// With all digits of the cosine.
    #[inline]
    fn beamed(
        light: Dimmed<Self>,
        axis: Vec3<Self>,
        inner_and_outer: [Self; 2],
        is_smooth: bool,
        v: Vec3<Self>,
        _: &Measured<Self>,
    ) -> Dimmed<Self> {
        times(light, beam(axis, inner_and_outer, is_smooth, v))
    }
}

/// A light times a factor with 32 bits after the point.
#[inline]
fn times(Dimmed { color, factor }: Dimmed<Fixed>, by: u32) -> Dimmed<Fixed> {
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
fn window(v: Vec3<Fixed>, range: Fixed, is_squared: bool) -> u32 {
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
fn beam(axis: Vec3<Fixed>, [inner, outer]: [Fixed; 2], is_smooth: bool, v: Vec3<Fixed>) -> u32 {
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
struct Factor {
    significand: u32,
    shift: u32,
}

impl Factor {
    #[cold]
    #[inline(never)]
    fn times(self, x: Fixed) -> Fixed {
        let product = product_unsigned(self.significand, x.0.max(0) as u32);
        let steps = ((product << 1 >> self.shift) + 1) >> 1; // rounded
        Fixed(if steps >> 31 == 0 {
            steps as i32
        } else {
            i32::MAX
        })
    }

    /// The factor of [`Real::attenuated`], whatever the denominator and the limit are.
    // With loops, because without an instruction for it a count of zeros takes 80 bytes.
    #[cold]
    #[inline(never)]
    fn attenuating([a, b, c]: [Fixed; 3], q: Fixed, limit: Fixed) -> Self {
        let q = q.0.max(0);
        // the slope b + cq with 32 bits after the point, and then as many as leave 31 in all
        let mut slope = product(c.0, q) + ((b.0 as i64) << 16);
        let (mut constant, mut shift) = ((a.0 as i64) << 32, 44);
        let mut excess = (slope.unsigned_abs() >> 31 | constant.unsigned_abs() >> 62) as u32;
        while excess != 0 {
            (slope, constant, excess) = (slope >> 1, constant >> 1, excess >> 1);
            shift += 1;
        }
        let denominator = slope * q as i64 + constant;
        let mut bits = denominator as u64 | 1;
        while bits >> 63 == 0 {
            (bits, shift) = (bits << 1, shift - 1);
        }
        let significand = reciprocal((bits >> 32) as u32) << (-shift).clamp(0, 3);
        let shift = shift.clamp(0, 62) as u32;
        let is_above = ((significand as u64) << 16) >> shift >= limit.0 as u64;
        if denominator < 0 {
            Self {
                significand: 0,
                shift: 0,
            }
        } else if limit != Fixed::MAX && is_above {
            Self {
                significand: limit.0.max(0) as u32,
                shift: 16,
            }
        } else {
            Self { significand, shift }
        }
    }
}

/// For a lobe that gives a number outside of [0, 1]. A branch that no other takes is shorter than two selections.
#[cold]
#[inline(never)]
fn within_1(factor: Fixed) -> u32 {
    factor.0.clamp(0, ONE) as u32
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
        let factor = if factor.0 as u32 <= ONE as u32 {
            factor.0 as u32
        } else {
            within_1(factor).min(ONE as u32) // which the compiler knows then
        };
        let plus = |sum: u64, light: Fixed| {
            sum.wrapping_add(product_by_fraction(light.0.max(0) as u32, factor))
        };
        let Self(Rgb { r, g, b }) = self;
        let color = light.color;
        Self(Rgb::new(
            plus(r, color.r),
            plus(g, color.g),
            plus(b, color.b),
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
