//! Four `f32` in a register of WebAssembly. A comparison with a choice is one instruction here, and four for
//! `wide`.
#![allow(
    unused_unsafe,
    reason = "the whole program is compiled for these instructions"
)]
#![allow(
    clippy::inline_always,
    reason = "as with AVX2, everything is inlined into one loop"
)]

use std::arch::wasm32::{i32x4_shuffle, v128};
use std::array::from_fn;
use std::mem::transmute;

use shading::number::Mask;
use shading::{Lobe, Real, Rgb};

use crate::lanes::{lanes, operators};
use crate::number::Pack;

mod single {
    pub use std::arch::wasm32::{
        f32x4_add as add, f32x4_div as div, f32x4_gt as above, f32x4_mul as mul,
        f32x4_neg as negative, f32x4_sqrt as sqrt, f32x4_sub as sub,
    };
    use std::arch::wasm32::{f32x4_pmax, f32x4_pmin, i32x4_bitmask, v128, v128_bitselect};

    // the instructions give the first operand unless the second is greater or less
    #[inline(always)]
    pub fn max(a: v128, b: v128) -> v128 {
        f32x4_pmax(b, a)
    }

    #[inline(always)]
    pub fn min(a: v128, b: v128) -> v128 {
        f32x4_pmin(b, a)
    }

    #[inline(always)]
    pub fn blend(a: v128, b: v128, of_b: v128) -> v128 {
        v128_bitselect(b, a, of_b)
    }

    #[inline(always)]
    pub fn bits(mask: v128) -> u8 {
        i32x4_bitmask(mask)
    }
}

// JavaScript has no use for them
pub use wide::f64x4 as F64x4;

lanes!(F32x4, Above32: 4 f32 in v128 by single, as f32x4;
    #[inline(always)]
    fn columns(rows: &[[f32; 3]]) -> [Self; 3] {
        let rows: [[f32; 3]; 4] = from_fn(|i| rows[i]);
        let [a, b, c] = unsafe { transmute::<[[f32; 3]; 4], [v128; 3]>(rows) }; // xyzx yzxy zxyz
        let x = i32x4_shuffle::<0, 1, 2, 5>(i32x4_shuffle::<0, 3, 6, 6>(a, b), c);
        let y = i32x4_shuffle::<0, 1, 2, 6>(i32x4_shuffle::<1, 4, 7, 7>(a, b), c);
        let z = i32x4_shuffle::<0, 1, 4, 7>(i32x4_shuffle::<2, 5, 5, 5>(a, b), c);
        [x, y, z].map(Self)
    }

    #[inline(always)]
    fn put([x, y, z]: [Self; 3], rows: &mut [[f32; 3]]) {
        let low = i32x4_shuffle::<0, 4, 1, 5>(x.0, y.0); // xyxy
        let high = i32x4_shuffle::<2, 6, 3, 7>(x.0, y.0);
        let a = i32x4_shuffle::<0, 1, 4, 2>(low, z.0);
        let b = i32x4_shuffle::<0, 1, 4, 5>(i32x4_shuffle::<3, 5, 5, 5>(low, z.0), high);
        let c = i32x4_shuffle::<6, 2, 3, 7>(high, z.0);
        let all = unsafe { transmute::<[v128; 3], [[f32; 3]; 4]>([a, b, c]) };
        rows.copy_from_slice(&all[..rows.len()]);
    }
);
