//! [`Real`] and [`Elementary`].

use super::cosine::cosine;
use super::falloff::{Factor, beam, times, window};
use super::product::{product, product_by_fraction, product_unsigned, zeros};
use super::reciprocal::reciprocal;
use super::root::{Scaled, halfway_cosine, root, unit_and_length};
use super::{Fixed, ONE, rounded, saturated, triangle};
use crate::color::Rgb;
use crate::number::{Dimmed, Elementary, LightSum, Lobe, Measured, Real, Toward};
use crate::vector::Vec3;

/// A dot product. It is rounded once, and above 0 if the exact sum is.
#[inline]
pub(super) const fn dot(a: Vec3<Fixed>, b: Vec3<Fixed>) -> Fixed {
    // halves, whose sum cannot overflow
    let sum =
        (product(a.x.0, b.x.0) >> 1) + (product(a.y.0, b.y.0) >> 1) + (product(a.z.0, b.z.0) >> 1);
    let rounded = rounded(sum, 15, (sum >> 32) as i32);
    if rounded.0 == 0 && sum > 0 {
        Fixed(1)
    } else {
        rounded
    }
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
        root(self)
    }

    #[inline]
    fn above(self, other: Self) -> bool {
        self > other
    }

    #[inline]
    fn dot(a: Vec3<Self>, b: Vec3<Self>) -> Self {
        dot(a, b)
    }

    #[inline]
    fn measured(v: Vec3<Self>) -> Measured<Self> {
        let (unit, length) = unit_and_length(v.into());
        let mut measured = Measured::along(unit.into(), length);
        if length.0 == 0 {
            measured.w_length = Self(0);
        }
        measured
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
        let measured = Measured::along(unit.into(), length);
        Toward { measured, n_dot_w }
    }

    #[inline]
    fn between(origin: Vec3<Self>, v: Vec3<Self>) -> Vec3<Self> {
        triangle::between(origin.into(), v.into()).into()
    }

    #[inline]
    fn crossed(origin: Vec3<Self>, a: Vec3<Self>, b: Vec3<Self>) -> Vec3<Self> {
        triangle::crossed(origin.into(), a.into(), b.into()).into()
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
    fn halfway_power(n: Vec3<Self>, w: Measured<Self>, v: Vec3<Self>, m: impl Lobe<Self>) -> Self {
        let cosine = halfway_cosine(n, w.w, v);
        let cosine = Self((cosine + (1 << 8)) >> 9);
        if cosine.0 > 0 {
            m.raise(cosine.at_most(Self(ONE)))
        } else {
            Self(0)
        }
    }

    #[inline]
    fn attenuated(color: Rgb<Self>, [a, b, c]: [Self; 3], q: Self, limit: Self) -> Dimmed<Self> {
        // A number too large for 31 bits, as a negative one is, leaves bits above them.
        let product = product_unsigned(c.0 as u32, q.0 as u32);
        let product = product.wrapping_add((b.0 as u32 as u64) << 16 | 1 << 15);
        let (slope, slope_above) = ((product >> 16) as u32, (product >> 47) as u32);
        let product = product_unsigned(slope, q.0 as u32);
        let d = ((product >> 16) as u32).wrapping_add(a.0 as u32);
        let d_above = (product >> 47) as u32 | a.0 as u32 >> 31;
        let is_negative_or_limited = (c.0 | limit.0.wrapping_sub(ONE)) < 0;
        if is_negative_or_limited || slope_above | d_above != 0 || d < ONE as u32 {
            let is_near = slope_above | d_above == 0 && d < ONE as u32;
            let factor = Factor::attenuating(a, b, c, q, limit, is_near);
            let Rgb { r, g, b } = color;
            // `map` would be a call
            return Dimmed::full(Rgb::new(factor.times(r), factor.times(g), factor.times(b)));
        }
        if d == ONE as u32 {
            return Dimmed::full(color);
        }
        let zeros = zeros(d);
        let factor = reciprocal(d << zeros) << 3 >> (15 - zeros);
        times(Dimmed::full(color), factor)
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

    /// Within 0.5001 of a step.
    fn half_angle_cosine(self) -> Self {
        cosine(self)
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
        let factor = factor.0.clamp(0, ONE) as u32;
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
        self.0.map(|sum| saturated((sum + (1 << 15)) >> 16))
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
