//! The numbers that points are given in, and the packs that several points are shaded in.
#![allow(
    clippy::inline_always,
    reason = "as in the kernel, which is compiled for several processors"
)]

use std::fmt::{Debug, Display};

use shading::{Elementary, Lobe, Real, Scalar};

/// No pack has more numbers.
const MOST: usize = 8;

/// `f32` or `f64`.
pub trait Number:
    Elementary + Scalar + Lobe<Self> + Debug + Display + Send + Sync + 'static
{
    /// What every processor shades several points in.
    type Lanes: Pack<Lane = Self>;

    /// What a processor with AVX2 shades several points in.
    #[cfg(target_arch = "x86_64")]
    type Avx2: Pack<Lane = Self>;

    const EPSILON: Self;

    /// A whole shininess as an integer, which is faster.
    fn whole(self) -> Option<u32>;

    /// The greatest integer that is not above a positive number; otherwise 0.
    fn floor(self) -> usize;
}

macro_rules! numbers {
    ($($float:ident in $lanes:ident, $avx2:ident or $simd128:ident),*) => {$(
        impl Number for $float {
            #[cfg(not(any(target_arch = "arm", target_feature = "simd128")))]
            type Lanes = wide::$lanes;

            #[cfg(target_feature = "simd128")]
            type Lanes = crate::simd128::$simd128;

            // NEON rounds subnormal numbers to 0 there, so lanes would not have the bits of the scalar
            #[cfg(target_arch = "arm")]
            type Lanes = Self;

            #[cfg(target_arch = "x86_64")]
            type Avx2 = crate::avx2::$avx2;

            const EPSILON: Self = Self::EPSILON;

            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // it is a whole number
            fn whole(self) -> Option<u32> {
                (self.fract() == 0.0 && (0.0..65_536.0).contains(&self)).then_some(self as u32)
            }

            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // as it says
            fn floor(self) -> usize {
                self as usize
            }
        }

        /// One point at a time.
        impl Pack for $float {
            type Lane = Self;
            const COUNT: usize = 1;

            fn splat(x: Self) -> Self {
                x
            }

            #[inline(always)]
            fn gather(lane: impl Fn(usize) -> Self) -> Self {
                lane(0)
            }

            #[inline(always)]
            fn scatter(self, mut put: impl FnMut(usize, Self)) {
                put(0, self);
            }
        }

        #[cfg(not(target_arch = "arm"))]
        impl Pack for wide::$lanes {
            type Lane = $float;
            const COUNT: usize = <Self as shading::Lanes>::COUNT;

            #[inline(always)]
            fn splat(x: $float) -> Self {
                Self::splat(x)
            }

            #[inline(always)]
            fn gather(lane: impl Fn(usize) -> $float) -> Self {
                Self::new(std::array::from_fn(lane))
            }

            #[inline(always)]
            fn scatter(self, mut put: impl FnMut(usize, $float)) {
                for (i, lane) in self.to_array().into_iter().enumerate() {
                    put(i, lane);
                }
            }
        }
    )*};
}
numbers!(f32 in f32x8, F32x8 or F32x4, f64 in f64x4, F64x4 or F64x4);

/// A number for each of several points, which are shaded side by side.
pub trait Pack: Real {
    type Lane: Number + Lobe<Self>;

    /// How many points.
    const COUNT: usize;

    fn splat(x: Self::Lane) -> Self;

    /// The number of each point, by its index.
    fn gather(lane: impl Fn(usize) -> Self::Lane) -> Self;

    /// Hands out the number of each point, with its index.
    fn scatter(self, put: impl FnMut(usize, Self::Lane));

    /// The numbers of a row for each point, column by column.
    #[inline(always)]
    fn columns(rows: &[[Self::Lane; 3]]) -> [Self; 3] {
        [0, 1, 2].map(|c| Self::gather(|lane| rows[lane][c]))
    }

    /// Puts the columns into rows, as many as there is room for.
    #[inline(always)]
    fn put(columns: [Self; 3], rows: &mut [[Self::Lane; 3]]) {
        let mut all = [[Self::Lane::ZERO; 3]; MOST];
        for (c, column) in columns.into_iter().enumerate() {
            column.scatter(|lane, x| all[lane][c] = x);
        }
        rows.copy_from_slice(&all[..rows.len()]);
    }
}
