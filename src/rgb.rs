//! The operations of colors.

use core::iter::Sum;
use core::ops::{Add, Mul};

use crate::real::{Real, Select};
pub use crate::triple::Rgb;
use crate::vector::{number_first, of_reals};

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
