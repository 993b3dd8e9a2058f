//! [`Real`] and [`Elementary`].

use super::Dual;
use crate::elementary::Elementary;
use crate::real::Real;
use crate::vector::Vec3;

#[diagnostic::do_not_recommend] // the trait's own message names the types
impl<T: Real> Real for Dual<T> {
    const ZERO: Self = Self::constant(T::ZERO);
    const ONE: Self = Self::constant(T::ONE);
    const NEG_ONE: Self = Self::constant(T::NEG_ONE);
    const MAX: Self = Self::constant(T::MAX);
    const EXTREME: Self = Self::constant(T::EXTREME);

    #[inline]
    fn of(literal: f64) -> Self {
        Self::constant(T::of(literal))
    }

    #[inline]
    fn of_f32(literal: f32) -> Self {
        Self::constant(T::of_f32(literal))
    }

    #[inline]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, T::ONE / (root + root))
    }

    #[inline]
    fn epsilon() -> Self {
        Self::constant(T::epsilon())
    }

    #[inline]
    fn if_positive(self, then: Self, otherwise: Self) -> Self {
        let select = |a, b| self.value.if_positive(a, b);
        Self {
            value: select(then.value, otherwise.value),
            gradient: Vec3::new(
                select(then.gradient.x, otherwise.gradient.x),
                select(then.gradient.y, otherwise.gradient.y),
                select(then.gradient.z, otherwise.gradient.z),
            ),
        }
    }

    #[inline]
    fn any_positive(self) -> bool {
        self.value.any_positive()
    }
}

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
        let slope = (-self.value).if_positive(ln, T::ONE / self.value);
        self.chain(ln, slope)
    }
}
