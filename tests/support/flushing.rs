//! A processor that treats subnormal operands as 0 and never returns subnormal results, simulated
//! in software.

use std::ops::{Add, Div, Mul, Neg, Sub};

use shading::Real;

use crate::number::Float;

/// A float whose operations flush subnormal operands and results to 0.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Flushing<T>(pub T);

impl<T: Float> Flushing<T> {
    fn flushed(self) -> T {
        let is_subnormal = self.0.to_f64().abs() < T::MIN_POSITIVE;
        if is_subnormal { T::ZERO } else { self.0 }
    }

    fn rounded(result: T) -> Self {
        Self(Self(result).flushed())
    }
}

macro_rules! operator {
    ($($trait:ident $method:ident),*) => {
        $(impl<T: Float> $trait for Flushing<T> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self::rounded(self.flushed().$method(other.flushed()))
            }
        })*
    };
}

operator!(Add add, Sub sub, Mul mul, Div div);

impl<T: Float> Neg for Flushing<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<T: Float> Real for Flushing<T> {
    const ZERO: Self = Self(T::ZERO);
    const ONE: Self = Self(T::ONE);
    const NEG_ONE: Self = Self(T::NEG_ONE);
    const MAX: Self = Self(T::MAX);
    const EXTREME: Self = Self(T::EXTREME);

    fn of(literal: f64) -> Self {
        Self(T::of(literal))
    }

    fn sqrt(self) -> Self {
        Self::rounded(self.flushed().sqrt())
    }

    fn if_positive(self, then: Self, otherwise: Self) -> Self {
        if self.flushed() > T::ZERO {
            then
        } else {
            otherwise
        }
    }

    fn any_positive(self) -> bool {
        self.flushed() > T::ZERO
    }
}
