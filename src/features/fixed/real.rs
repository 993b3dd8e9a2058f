//! [`Real`] and [`Elementary`].

use super::{Fixed, ONE, triple};
use crate::elementary::Elementary;
use crate::real::Real;

#[diagnostic::do_not_recommend] // the trait's own message names the types
impl Real for Fixed {
    const ZERO: Self = Self(0);
    const ONE: Self = Self(ONE);
    const NEG_ONE: Self = Self(-ONE);
    const MAX: Self = Self::MAX;
    const EXTREME: Self = Self(ONE << 9);
    const IS_FIXED: bool = true;

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
        triple::dot(&a, &b)
    }

    #[inline]
    fn scaled(v: [Self; 3], factor: Self) -> [Self; 3] {
        triple::scaled(&v, factor)
    }

    #[inline]
    fn quotients(v: [Self; 3], divisor: Self) -> [Self; 3] {
        triple::quotients(&v, divisor)
    }

    #[inline]
    fn tamed<const N: usize>(vectors: [[Self; 3]; N]) -> [[Self; 3]; N] {
        triple::tamed(vectors)
    }

    #[inline]
    fn unit_and_length(v: [Self; 3]) -> ([Self; 3], Self) {
        triple::unit_and_length(&v)
    }

    #[inline]
    fn half_cosine(n: [Self; 3], l: [Self; 3], v: [Self; 3]) -> Self {
        triple::half_cosine(&n, &l, &v)
    }

    #[inline]
    fn reflected_cosine(n: [Self; 3], l: [Self; 3], v: [Self; 3]) -> Self {
        triple::reflected_cosine(&n, &l, &v)
    }

    #[inline]
    fn power_of_cosine(self, m: u32) -> Option<Self> {
        Some(self.cosine_power(m))
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
