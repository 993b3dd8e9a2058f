//! Sixteen numbers, which the compiler puts into the registers of the function that computes with them.
#![allow(clippy::inline_always)] // a function that is not inlined is compiled for SSE2

use std::array::from_fn;
use std::ops::{Add, Div, Mul, Neg, Sub};

use shading::Real;

const COUNT: usize = 16;

/// Only functions for AVX2 compute with this type. So the compiler inlines what they call into them, and compiles it
/// for AVX2. If a function for SSE2 used the type too, both would share copies compiled for SSE2. For another set of
/// features, such as AVX-512, take another type.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Lanes(pub [f32; COUNT]);

impl Lanes {
    #[inline(always)]
    fn each(f: impl Fn(usize) -> f32) -> Self {
        Self(from_fn(f))
    }
}

macro_rules! operators {
    ($($trait:ident $function:ident $operator:tt)*) => {
        $(impl $trait for Lanes {
            type Output = Self;

            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                Self::each(|i| self.0[i] $operator other.0[i])
            }
        })*
    };
}

operators! { Add add + Sub sub - Mul mul * Div div / }

impl Neg for Lanes {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self::each(|i| -self.0[i])
    }
}

/// Each operation as the scalar computes it, so each lane has the bits of the scalar.
impl Real for Lanes {
    const ZERO: Self = Self([0.0; COUNT]);
    const ONE: Self = Self([1.0; COUNT]);
    const NEG_ONE: Self = Self([-1.0; COUNT]);
    const MAX: Self = Self([f32::MAX; COUNT]);
    const EXTREME: Self = Self([<f32 as Real>::EXTREME; COUNT]);

    #[inline(always)]
    fn of(literal: f64) -> Self {
        Self([f32::of(literal); COUNT])
    }

    #[inline(always)]
    fn of_f32(literal: f32) -> Self {
        Self([literal; COUNT])
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self::each(|i| self.0[i].sqrt())
    }

    #[inline(always)]
    fn if_positive(self, then: Self, otherwise: Self) -> Self {
        self.if_above(Self::ZERO, then, otherwise)
    }

    #[inline(always)]
    #[allow(clippy::needless_bitwise_bool)] // a lazy operator would be a branch for each lane
    fn any_positive(self) -> bool {
        self.0.iter().fold(false, |any, &x| any | (x > 0.0))
    }

    #[inline(always)]
    fn if_above(self, threshold: Self, then: Self, otherwise: Self) -> Self {
        let above = |i: usize| self.0[i] > threshold.0[i];
        Self::each(|i| if above(i) { then.0[i] } else { otherwise.0[i] })
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self::each(|i| self.0[i].abs())
    }
}
