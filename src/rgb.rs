//! Colors.

use core::iter::Sum;
use core::ops::{Add, AddAssign, Div, Mul, Sub};

use crate::real::Real;
use crate::vector::{componentwise, number_first};

/// A color: linear light, or the reflectance of a material, in three channels.
///
/// The numbers are proportional to power: they are not encoded and may exceed 1.
/// [`from_srgb8`](Rgb::from_srgb8) decodes the bytes of a texture before shading.
/// [`to_srgb8`](Rgb::to_srgb8) and [`to_rgb565`](Rgb::to_rgb565) clamp and encode once, after the
/// sum.
///
/// ```
/// use shading::Rgb;
///
/// let lamp = Rgb::new(1.0_f32, 0.9, 0.7);
/// let brick = Rgb::new(0.6, 0.2, 0.1);
/// let reflected = lamp * brick; // channel by channel
/// assert_eq!(reflected, Rgb::from([0.6, 0.9 * 0.2, 0.7 * 0.1]));
/// ```
#[doc(alias("color", "colour"))]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
#[must_use]
pub struct Rgb<T = f32> {
    /// Red.
    pub r: T,
    /// Green.
    pub g: T,
    /// Blue.
    pub b: T,
}

componentwise!(Rgb { r, g, b });

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
        self.map(|channel| channel.if_positive(channel.at_most(T::ONE), T::ZERO))
    }

    /// The color with the largest finite number for each channel that overflowed.
    #[inline]
    pub(crate) fn finite(self) -> Self {
        self.map(|channel| channel.at_most(T::MAX))
    }
}

impl<T: Real> Mul for Rgb<T> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::new(self.r * other.r, self.g * other.g, self.b * other.b)
    }
}
