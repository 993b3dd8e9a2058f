//! [`Real`] and [`Elementary`].

use super::root::{Scaled, reciprocal, root, unit_and_length};
use super::wide::{product, product_by_share, product_unsigned, upper_rounded, upper_unsigned};
use super::{Fixed, ONE, rounded};
use crate::elementary::Elementary;
use crate::real::{Exponent, LightSum, Measured, Real, Toward};
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
        let n_dot_v = Self((scaled.cosine(n) + (1 << 8)) >> 9);
        let (unit, length) = scaled.unit_and_length();
        let way = Measured {
            w: unit.into(),
            w_length: Self(ONE),
            length,
        };
        Toward { way, n_dot_v }
    }

    #[inline]
    fn cosine(_: Vec3<Self>, toward: &Toward<Self>) -> Self {
        Self(toward.n_dot_v.0.clamp(0, ONE))
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
        m: impl Exponent<Self>,
    ) -> Self {
        // both are directions
        let sum = |w: Self, v: Self| Self(w.0.wrapping_add(v.0));
        let h = Vec3::new(sum(w.x, v.x), sum(w.y, v.y), sum(w.z, v.z));
        Self::cosine_power(n, h, m)
    }

    #[inline]
    fn cosine_power(n: Vec3<Self>, v: Vec3<Self>, m: impl Exponent<Self>) -> Self {
        let cosine = Scaled::of(v.into()).cosine(n);
        let cosine = Self((cosine + (1 << 8)) >> 9);
        if cosine.0 > 0 {
            m.raise(cosine.at_most(Self(ONE)))
        } else {
            Self(0)
        }
    }

    #[inline]
    fn attenuated(color: Rgb<Self>, [a, b, c]: [Self; 3], q: Self, limit: Self) -> (Rgb<Self>, Self) {
        // a sum of more than 31 bits tells so in the second number
        let plus_product = |a: Self, b: u32, q: Self| {
            let sum = product_unsigned(b, q.0 as u32);
            let sum = sum.wrapping_add((a.0 as u32 as u64) << 16 | 1 << 15);
            ((sum >> 16) as u32, (sum >> 47) as u32)
        };
        let (slope, slope_above) = plus_product(b, c.0 as u32, q);
        let (d, d_above) = plus_product(a, slope, q);
        let is_negative = (a.0 | b.0 | c.0 | q.0) < 0;
        if is_negative || slope_above | d_above != 0 || d < ONE as u32 || limit.0 < ONE {
            let factor = Factor::attenuating([a, b, c], q, limit);
            let Rgb { r, g, b } = color;
            let color = Rgb::new(factor.times(r), factor.times(g), factor.times(b)); // as `map` would be a call
            return (color, Self(ONE));
        }
        if d == ONE as u32 {
            return (color, Self(ONE));
        }
        let zeros = d.leading_zeros();
        // 32 bits after the point
        let share = reciprocal(d << zeros) << 3 >> (15 - zeros);
        let color = color.map(|x| Self(upper_rounded(x.0.max(0) as u32, share) as i32));
        (color, Self(ONE))
    }

    #[inline]
    fn windowed(
        (color, factor): (Rgb<Self>, Self),
        q: Self,
        range: Self,
        squared: Self,
    ) -> (Rgb<Self>, Self) {
        if q >= range {
            return (color.map(|_| Self(0)), factor);
        }
        let zeros = range.0.leading_zeros();
        let share = upper_unsigned((q.0 << zeros) as u32, reciprocal((range.0 as u32) << zeros)); // 28 bits
        let share = if share >> 28 == 0 { share << 3 } else { u32::MAX >> 1 };
        let square = upper_unsigned(share, share) << 1; // 31 bits
        let root = (1 << 31) - 1 - (upper_unsigned(square, square) << 1);
        let window = if squared.0 > 0 { upper_unsigned(root, root) << 1 } else { root };
        let color = color.map(|x| Self(upper_rounded(x.0.max(0) as u32, window << 1) as i32));
        (color, factor)
    }

    #[inline]
    fn dimmed(factor: Self, share: Self) -> Self {
        // the factor is 1, or 0 where there is no direction
        if factor.0 == ONE { share } else { factor * share }
    }

    #[inline]
    fn within((color, factor): (Rgb<Self>, Self), share: Self) -> (Rgb<Self>, Self) {
        (color * share, factor)
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
        let product = product_unsigned(x.0.max(0) as u32, self.significand);
        let steps = (product + (1 << self.shift >> 1)) >> self.shift;
        Fixed(if steps >> 31 == 0 { steps as i32 } else { i32::MAX })
    }

    /// The factor of [`Real::attenuated`], whatever the denominator and the limit are.
    #[cold]
    #[inline(never)]
    fn attenuating([mut a, mut b, mut c]: [Fixed; 3], q: Fixed, limit: Fixed) -> Self {
        if (a.0 | b.0 | c.0) < 0 {
            (a, b, c) = (a + q * (b + c * q), Fixed(0), Fixed(0));
        }
        let steps = |x: Fixed| x.0.max(0) as u32;
        // the slope b + cq, with 32 bits after the point
        let slope = product_unsigned(steps(c), steps(q)) + ((steps(b) as u64) << 16);
        let zeros = (slope | 1).leading_zeros();
        let product = product_unsigned((slope << zeros >> 32) as u32, steps(q));
        // the denominator, with 16 bits after the point and as many more as there is room for
        let more = zeros.min(32);
        let denominator = ((product >> (zeros - more)) + ((steps(a) as u64) << more)) | 1;
        let zeros = denominator.leading_zeros();
        let significand = reciprocal((denominator << zeros >> 32) as u32);
        let exponent = more + zeros;
        let (significand, shift) = (
            significand << exponent.saturating_sub(76).min(3),
            76_u32.saturating_sub(exponent).min(62),
        );
        let is_above = ((significand as u64) << 16) >> shift >= limit.0 as u64;
        if a.0 < 0 {
            Self { significand: 0, shift: 0 }
        } else if limit != Fixed::MAX && is_above {
            Self { significand: steps(limit), shift: 16 }
        } else {
            Self { significand, shift }
        }
    }
}

/// A sum with 32 bits after the point, of products that are not rounded.
#[derive(Clone, Copy)]
pub struct Exact(u64);

impl LightSum<Fixed> for Exact {
    const DARK: Self = Self(0);

    #[inline(always)]
    fn add(self, light: Fixed, factor: Fixed) -> Self {
        let (light, factor) = (light.0.max(0) as u32, factor.0.clamp(0, ONE) as u32);
        Self(self.0.wrapping_add(product_by_share(light, factor)))
    }

    #[inline]
    fn total(self) -> Fixed {
        let steps = (self.0 + (1 << 15)) >> 16;
        Fixed(if steps >> 31 == 0 { steps as i32 } else { i32::MAX })
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
