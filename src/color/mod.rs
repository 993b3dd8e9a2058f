//! Colors: their operations, and their encodings for pictures and displays.

#![allow(
    clippy::cast_possible_truncation, // levels fit their bits; edges are rounded
    clippy::cast_possible_wrap,       // bits are compared as signed integers
    clippy::cast_precision_loss,      // levels are small
    clippy::cast_lossless,            // `From` is not const
    clippy::cast_sign_loss            // likewise
)]

mod encoding;
mod levels;
mod steps;

use core::iter::Sum;
use core::ops::{Add, Mul};

pub use crate::number::triple::Rgb;
use crate::number::{Mask, Real};
use crate::vector::{number_first, of_reals};
#[cfg(feature = "fixed")]
pub(crate) use steps::{FIXED_EIGHT_BITS, FIXED_FIVE_BITS, FIXED_SIX_BITS};

of_reals!(Rgb { r, g, b });

impl<T: Real> Rgb<T> {
    /// Black: 0 in each channel.
    pub const BLACK: Self = Self::gray(T::ZERO);
    /// White: 1 in each channel.
    pub const WHITE: Self = Self::gray(T::ONE);

    /// The same value in each channel.
    #[doc(alias = "splat")]
    #[inline]
    pub const fn gray(value: T) -> Self {
        Self::new(value, value, value)
    }

    /// The color with each channel clamped to [0, 1], for a display. NaN becomes 0.
    ///
    /// ```
    /// use shading::Rgb;
    /// assert_eq!(Rgb::new(1.5_f32, -0.5, 0.5).clamped(), Rgb::new(1.0, 0.0, 0.5));
    /// ```
    #[doc(alias("clamp", "saturate"))]
    #[inline]
    pub fn clamped(self) -> Self {
        // not `at_least`, which may let a signaling NaN through
        self.map(|channel| {
            channel
                .above(T::ZERO)
                .select(channel.at_most(T::ONE), T::ZERO)
        })
    }

    /// The color with the largest finite number for each channel that overflowed, or that is NaN, as
    /// infinite light times a factor of 0.
    #[inline]
    pub(crate) fn finite(self) -> Self {
        self.map(T::finite)
    }
}

impl<T: Real> Mul for Rgb<T> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::new(self.r * other.r, self.g * other.g, self.b * other.b)
    }
}
