//! Eight `f32` or four `f64` in a register of AVX2, for the one program that runs on every x86-64 processor.
//!
//! A function is compiled for AVX2 if it says so, or is inlined into one that does. Everything here is
//! inlined, into `kernel::for_avx2` alone, which runs only where the processor has AVX2. Each
//! `unsafe` here relies on that. The lanes of `wide` are chosen when the program is built.
#![allow(
    clippy::inline_always,
    reason = "a function that is not inlined is compiled for SSE2"
)]

use std::arch::x86_64::{
    __m256, __m256d, _CMP_GT_OQ, _mm256_add_pd, _mm256_add_ps, _mm256_blendv_pd, _mm256_blendv_ps,
    _mm256_cmp_pd, _mm256_cmp_ps, _mm256_div_pd, _mm256_div_ps, _mm256_max_pd, _mm256_max_ps,
    _mm256_min_pd, _mm256_min_ps, _mm256_movemask_pd, _mm256_movemask_ps, _mm256_mul_pd,
    _mm256_mul_ps, _mm256_set1_pd, _mm256_set1_ps, _mm256_sqrt_pd, _mm256_sqrt_ps, _mm256_sub_pd,
    _mm256_sub_ps, _mm256_xor_pd, _mm256_xor_ps,
};
use std::mem::transmute;
use std::ops::{Add, Div, Mul, Neg, Sub};

use shading::number::Mask;
use shading::{Lobe, Real, Rgb};

use crate::number::Pack;

macro_rules! operators {
    ($lanes:ident, $($trait:ident $function:ident $intrinsic:ident),*) => {$(
        impl $trait for $lanes {
            type Output = Self;

            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                Self(unsafe { $intrinsic(self.0, other.0) })
            }
        }
    )*};
}

macro_rules! lanes {
    (
        $lanes:ident, $above:ident: $count:literal $float:ident in $register:ident, as $wide:ident,
        $add:ident, $sub:ident, $mul:ident, $div:ident, $xor:ident, $set1:ident, $sqrt:ident,
        $max:ident, $min:ident, $cmp:ident, $blendv:ident, $movemask:ident
    ) => {
        #[derive(Clone, Copy)]
        pub struct $lanes($register);

        /// The lanes in which a comparison holds.
        #[derive(Clone, Copy)]
        pub struct $above($register);

        impl $lanes {
            const fn all(x: $float) -> Self {
                Self(unsafe { transmute::<[$float; $count], $register>([x; $count]) })
            }
        }

        operators!($lanes, Add add $add, Sub sub $sub, Mul mul $mul, Div div $div);

        impl Neg for $lanes {
            type Output = Self;

            #[inline(always)]
            fn neg(self) -> Self {
                Self(unsafe { $xor(self.0, $set1(-0.0)) })
            }
        }

        impl Real for $lanes {
            type Mask = $above;
            type Sum = Rgb<Self>;

            const ZERO: Self = Self::all(0.0);
            const ONE: Self = Self::all(1.0);
            const NEG_ONE: Self = Self::all(-1.0);
            const MAX: Self = Self::all($float::MAX);
            const EXTREME: Self = Self::all(<$float as Real>::EXTREME);

            #[inline(always)]
            fn of(literal: f64) -> Self {
                Self::all($float::of(literal))
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                Self(unsafe { $sqrt(self.0) })
            }

            #[inline(always)]
            fn above(self, other: Self) -> $above {
                $above(unsafe { $cmp::<_CMP_GT_OQ>(self.0, other.0) })
            }

            // the instruction gives the second operand unless the first is greater, which is the
            // comparison of the default
            #[inline(always)]
            fn at_least(self, floor: Self) -> Self {
                Self(unsafe { $max(self.0, floor.0) })
            }

            #[inline(always)]
            fn at_most(self, limit: Self) -> Self {
                Self(unsafe { $min(limit.0, self.0) })
            }

            #[inline(always)]
            fn finite(self) -> Self {
                Self(unsafe { $min(self.0, Self::MAX.0) })
            }
        }

        impl Mask<$lanes> for $above {
            #[inline(always)]
            fn any(self) -> bool {
                unsafe { $movemask(self.0) != 0 }
            }

            #[inline(always)]
            fn all(self) -> bool {
                unsafe { $movemask(self.0) == (1 << $count) - 1 }
            }

            #[inline(always)]
            fn select(self, then: $lanes, otherwise: $lanes) -> $lanes {
                $lanes(unsafe { $blendv(otherwise.0, then.0, self.0) })
            }
        }

        impl Pack for $lanes {
            type Lane = $float;
            const COUNT: usize = $count;

            #[inline(always)]
            fn splat(x: $float) -> Self {
                Self::all(x)
            }

            #[inline(always)]
            fn gather(lane: impl Fn(usize) -> $float) -> Self {
                let lanes: [$float; $count] = std::array::from_fn(lane);
                Self(unsafe { transmute::<[$float; $count], $register>(lanes) })
            }

            #[inline(always)]
            fn scatter(self, mut put: impl FnMut(usize, $float)) {
                let lanes = unsafe { transmute::<$register, [$float; $count]>(self.0) };
                for (i, lane) in lanes.into_iter().enumerate() {
                    put(i, lane);
                }
            }
        }

        impl $lanes {
            #[inline(always)]
            fn wide(self) -> wide::$wide {
                unsafe { transmute::<$register, wide::$wide>(self.0) }
            }

            #[inline(always)]
            fn of_wide(lanes: wide::$wide) -> Self {
                Self(unsafe { transmute::<wide::$wide, $register>(lanes) })
            }
        }

        /// A real power by the crate's lanes, whose integer steps are not public.
        impl Lobe<$lanes> for $float {
            #[inline(always)]
            fn raise(self, cosine: $lanes) -> $lanes {
                $lanes::of_wide(self.raise(cosine.wide()))
            }

            #[inline(always)]
            fn raise_root(self, square: $lanes) -> $lanes {
                $lanes::of_wide(self.raise_root(square.wide()))
            }

            #[inline(always)]
            fn raise_quotient(self, square: $lanes, of: $lanes) -> $lanes {
                $lanes::of_wide(self.raise_quotient(square.wide(), of.wide()))
            }
        }
    };
}

lanes!(
    F32x8, Above32: 8 f32 in __m256, as f32x8,
    _mm256_add_ps, _mm256_sub_ps, _mm256_mul_ps, _mm256_div_ps, _mm256_xor_ps, _mm256_set1_ps, _mm256_sqrt_ps,
    _mm256_max_ps, _mm256_min_ps, _mm256_cmp_ps, _mm256_blendv_ps, _mm256_movemask_ps
);
lanes!(
    F64x4, Above64: 4 f64 in __m256d, as f64x4,
    _mm256_add_pd, _mm256_sub_pd, _mm256_mul_pd, _mm256_div_pd, _mm256_xor_pd, _mm256_set1_pd, _mm256_sqrt_pd,
    _mm256_max_pd, _mm256_min_pd, _mm256_cmp_pd, _mm256_blendv_pd, _mm256_movemask_pd
);
