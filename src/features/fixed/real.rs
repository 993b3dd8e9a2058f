//! [`Real`] and [`Elementary`].

use super::falloff::{self, Factor};
use super::{Fixed, ONE, vector};
use crate::cone::Cone;
use crate::elementary::Elementary;
use crate::real::Real;

#[diagnostic::do_not_recommend] // the trait's own message names the types
impl Real for Fixed {
    const ZERO: Self = Self(0);
    const ONE: Self = Self(ONE);
    const NEG_ONE: Self = Self(-ONE);
    const MAX: Self = Self::MAX;
    const EXTREME: Self = Self(ONE << 9);

    #[inline]
    fn of(literal: f64) -> Self {
        Self::new(literal)
    }

    #[inline]
    fn of_f32(literal: f32) -> Self {
        Self::from_f32(literal)
    }

    #[inline]
    fn sqrt(self) -> Self {
        self.root()
    }

    #[inline]
    fn epsilon() -> Self {
        Self::STEP
    }

    fn cosine_of_half_angle(self) -> Option<Self> {
        Cone::<Self>::from_half_angle(self).map(|cone| cone.cosine)
    }

    #[inline]
    fn if_positive(self, then: Self, otherwise: Self) -> Self {
        if self.0 > 0 { then } else { otherwise }
    }

    #[inline]
    fn any_positive(self) -> bool {
        self.0 > 0
    }

    #[inline]
    fn if_above(self, threshold: Self, then: Self, otherwise: Self) -> Self {
        if self > threshold { then } else { otherwise }
    }

    #[inline]
    fn abs(self) -> Self {
        Self(self.0.saturating_abs())
    }

    #[inline]
    fn any_outside(self, low: Self, high: Self) -> bool {
        self < low || self > high
    }

    #[inline]
    fn dot(a: [Self; 3], b: [Self; 3]) -> Self {
        vector::dot(&a, &b)
    }

    #[inline]
    fn scaled(v: [Self; 3], factor: Self) -> [Self; 3] {
        vector::scaled(&v, factor)
    }

    #[inline]
    fn ratio(self, whole: Self) -> Self {
        if whole == Self::MAX {
            Self(0)
        } else {
            self / whole
        }
    }

    #[inline]
    fn window(q: Self, r: Self, is_squared: bool) -> Self {
        if r == Self::MAX {
            return Self(ONE);
        }
        let share = falloff::window(&[q, Self(0), Self(0)], r, is_squared);
        let mut window = [Self(ONE); 3];
        Factor::ONE.within(share).scale(&mut window);
        window[0]
    }

    #[inline]
    fn attenuated(
        mut v: [Self; 3],
        [a, b, c]: [Self; 3],
        [_, q]: [Self; 2],
        limit: impl FnOnce() -> Self,
    ) -> [Self; 3] {
        let factor = Factor::of(a, b, c, q);
        factor.clamped(limit() == Self(ONE)).scale(&mut v);
        v
    }

    #[inline]
    fn attenuated_within(
        (r, is_squared): (Self, bool),
        mut v: [Self; 3],
        [a, b, c]: [Self; 3],
        [_, q]: [Self; 2],
        to_light: impl FnOnce() -> [Self; 3],
        limit: impl FnOnce() -> Self,
    ) -> [Self; 3] {
        let mut factor = Factor::of(a, b, c, q).clamped(limit() == Self(ONE));
        if r != Self::MAX {
            factor = factor.within(falloff::window(&to_light(), r, is_squared));
        }
        factor.scale(&mut v);
        v
    }

    #[inline]
    fn length(v: [Self; 3]) -> Self {
        vector::unit_and_length(&v).1
    }

    #[inline]
    fn unit(v: [Self; 3]) -> ([Self; 3], Self) {
        vector::unit_and_length(&v)
    }

    // the power of two is given by its exponent, in steps, because it may be beyond the range

    #[inline]
    fn rescaled_difference([x, y, z]: [Self; 3], [a, b, c]: [Self; 3]) -> ([Self; 3], Self) {
        let ([rescaled], power) = vector::rescaled([[x - a, y - b, z - c]]);
        (rescaled, power)
    }

    #[inline]
    fn is_any_extreme(_: [Self; 2]) -> bool {
        true
    }

    #[inline]
    fn rescaled_together(vectors: [[Self; 3]; 3]) -> Option<([[Self; 3]; 3], Self)> {
        Some(vector::rescaled(vectors))
    }

    #[inline]
    fn rescaled_by(v: [Self; 3], power: Self) -> [Self; 3] {
        vector::rescaled_by(v, power)
    }

    #[inline(always)]
    fn direction_and_distance(
        _: impl FnOnce() -> [[Self; 3]; 2],
        to_light: [Self; 3],
    ) -> ([Self; 3], [Self; 2], Self) {
        let (l, finer) = vector::unit_and_fine_length(&to_light);
        let q = falloff::in_steps(finer);
        (l, [q, finer], if finer.0 == 0 { Self::MAX } else { q })
    }

    #[inline(always)]
    fn is_lit(q: Self) -> bool {
        q.0 != 0
    }

    #[inline]
    fn half_cosine(n: [Self; 3], l: [Self; 3], v: [Self; 3], squared: bool) -> Self {
        let cosine = vector::half_cosine(&n, &l, &v);
        if squared {
            cosine * cosine.abs()
        } else {
            cosine
        }
    }

    // N·H needs no root
    #[inline]
    fn half_of(_m: u32) -> Option<u32> {
        None
    }

    #[inline]
    fn reflected_cosine(n: [Self; 3], l: [Self; 3], v: [Self; 3]) -> Self {
        vector::reflected_cosine(&n, &l, &v)
    }

    #[inline]
    fn cosine_power(m: u32) -> impl Fn(Self) -> Self {
        move |cosine: Self| cosine.cosine_power(m)
    }
}

/// By way of `f32`, with `libm`.
impl Elementary for Fixed {
    #[inline]
    fn sin(self) -> Self {
        Self::from_f32(Elementary::sin(self.to_f32()))
    }

    #[inline]
    fn cos(self) -> Self {
        Self::from_f32(Elementary::cos(self.to_f32()))
    }

    #[inline]
    fn exp(self) -> Self {
        Self::from_f32(Elementary::exp(self.to_f32()))
    }

    /// The logarithm of 0 is the smallest number, and that of a negative number is 0.
    #[inline]
    fn ln(self) -> Self {
        Self::from_f32(Elementary::ln(self.to_f32()))
    }
}
