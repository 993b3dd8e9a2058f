//! Eight `f32` or four `f64` in a register of AVX2, for the one program that runs on every x86-64 processor.
//! They are inlined into `kernel::for_avx2` alone, which runs only where the processor has AVX2.
#![allow(
    clippy::inline_always,
    reason = "a function that is not inlined is compiled for SSE2"
)]

use std::arch::x86_64::{__m256, __m256d};

use shading::number::Mask;
use shading::{Lobe, Real, Rgb};

use crate::lanes::{lanes, operators};
use crate::number::Pack;

mod single {
    use std::arch::x86_64::{__m256, _CMP_GT_OQ, _mm256_cmp_ps, _mm256_set1_ps, _mm256_xor_ps};
    pub use std::arch::x86_64::{
        _mm256_add_ps as add, _mm256_blendv_ps as blend, _mm256_div_ps as div,
        _mm256_max_ps as max, _mm256_min_ps as min, _mm256_movemask_ps as bits,
        _mm256_mul_ps as mul, _mm256_sqrt_ps as sqrt, _mm256_sub_ps as sub,
    };

    #[inline(always)]
    pub unsafe fn negative(x: __m256) -> __m256 {
        unsafe { _mm256_xor_ps(x, _mm256_set1_ps(-0.0)) }
    }

    #[inline(always)]
    pub unsafe fn above(a: __m256, b: __m256) -> __m256 {
        unsafe { _mm256_cmp_ps::<_CMP_GT_OQ>(a, b) }
    }
}

mod double {
    use std::arch::x86_64::{__m256d, _CMP_GT_OQ, _mm256_cmp_pd, _mm256_set1_pd, _mm256_xor_pd};
    pub use std::arch::x86_64::{
        _mm256_add_pd as add, _mm256_blendv_pd as blend, _mm256_div_pd as div,
        _mm256_max_pd as max, _mm256_min_pd as min, _mm256_movemask_pd as bits,
        _mm256_mul_pd as mul, _mm256_sqrt_pd as sqrt, _mm256_sub_pd as sub,
    };

    #[inline(always)]
    pub unsafe fn negative(x: __m256d) -> __m256d {
        unsafe { _mm256_xor_pd(x, _mm256_set1_pd(-0.0)) }
    }

    #[inline(always)]
    pub unsafe fn above(a: __m256d, b: __m256d) -> __m256d {
        unsafe { _mm256_cmp_pd::<_CMP_GT_OQ>(a, b) }
    }
}

lanes!(F32x8, Above32: 8 f32 in __m256 by single, as f32x8);
lanes!(F64x4, Above64: 4 f64 in __m256d by double, as f64x4);
