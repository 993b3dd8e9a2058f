//! The elementary functions and their slopes.

use super::Dual;
use crate::number::{Elementary, Mask, Real, by_squaring, magnitude, whole};
use crate::vector::Vec3;

impl<T: Elementary> Elementary for Dual<T> {
    #[inline]
    fn sin(self) -> Self {
        self.chain(self.value.sin(), self.value.cos())
    }

    #[inline]
    fn cos(self) -> Self {
        self.chain(self.value.cos(), -self.value.sin())
    }

    #[inline]
    fn exp(self) -> Self {
        let power = self.value.exp();
        self.chain(power, power)
    }

    #[inline]
    fn ln(self) -> Self {
        let ln = self.value.ln();
        // below 0, 1/x has a value, but the logarithm does not
        let slope = T::ZERO.above(self.value).select(ln, T::ONE / self.value);
        self.chain(ln, slope)
    }

    #[inline]
    fn tan(self) -> Self {
        let tan = self.value.tan();
        self.chain(tan, T::ONE + tan * tan)
    }

    #[inline]
    fn atan2(self, x: Self) -> Self {
        let (sine, cosine) = (self.value, x.value);
        let length = Vec3::new(cosine, sine, T::ZERO).length();
        let slopes = self.gradient * (cosine / length) - x.gradient * (sine / length);
        Self::new(sine.atan2(cosine), slopes / length)
    }

    #[inline]
    fn powf(self, exponent: Self) -> Self {
        let power = self.value.powf(exponent.value);
        let slope = times(exponent.value, self.value.powf(exponent.value - T::ONE));
        let growth = power * self.value.ln();
        let by_base = self.gradient.map(|x| times(x, slope));
        let by_exponent = exponent.gradient.map(|x| times(x, growth));
        Self::new(power, by_base + by_exponent)
    }

    /// Its slope is nxⁿ⁻¹, which for a negative n is n/x⁻ⁿ⁺¹.
    #[inline]
    fn powi(self, exponent: i32) -> Self {
        let n = exponent.unsigned_abs();
        let slope = match exponent {
            0 => T::ZERO,
            1.. => whole::<T>(n) * by_squaring(self.value, n - 1),
            _ => -whole::<T>(n) / by_squaring(self.value, n + 1),
        };
        self.chain(self.value.powi(exponent), slope)
    }
}

/// x times a slope. What does not vary adds nothing, even where the slope is infinite or NaN. Where the slope
/// is finite, a 0 may still have derivatives of its own.
#[inline]
fn times<T: Real>(x: T, slope: T) -> T {
    let product = x * slope;
    let is_zero_or = magnitude(x).above(T::ZERO).select(product, x);
    T::MAX.above(magnitude(slope)).select(product, is_zero_or)
}
