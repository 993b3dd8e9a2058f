//! A number of a user's own: the nine items that [`Real`] requires, by way of another number.

use std::ops::{Add, Div, Mul, Neg, Sub};

use shading::Real;

#[derive(Clone, Copy, PartialEq, PartialOrd)]
pub struct Plain<T>(pub T);

impl From<Plain<f32>> for f64 {
    fn from(Plain(number): Plain<f32>) -> f64 {
        number.into()
    }
}

impl From<Plain<f64>> for f64 {
    fn from(Plain(number): Plain<f64>) -> f64 {
        number
    }
}

macro_rules! operators {
    ($($trait:ident $method:ident),+) => {
        $(impl<T: Real> $trait for Plain<T> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        })+
    };
}

operators!(Add add, Sub sub, Mul mul, Div div);

impl<T: Real> Neg for Plain<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<T: Real> Real for Plain<T> {
    const ZERO: Self = Self(T::ZERO);
    const ONE: Self = Self(T::ONE);
    const NEG_ONE: Self = Self(T::NEG_ONE);
    const MAX: Self = Self(T::MAX);
    const EXTREME: Self = Self(T::EXTREME);

    fn of(literal: f64) -> Self {
        Self(T::of(literal))
    }

    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    fn if_positive(self, then: Self, otherwise: Self) -> Self {
        Self(self.0.if_positive(then.0, otherwise.0))
    }

    fn any_positive(self) -> bool {
        self.0.any_positive()
    }
}
