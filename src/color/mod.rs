//! Colors: their operations, and their encodings for pictures and displays.
//!
//! The levels of an encoding rise with the light, so each level begins at a certain number, which
//! [`levels`] finds exactly. Encoding a number means finding the last level that begins at or below it,
//! with integer operations and a table that the compiler computes: by [`steps`] or, where flash is
//! scarce, by a [`climb`]. The result is correctly rounded. It needs no powers, no division and, on a chip
//! without an FPU, no floating-point routine.

#![allow(
    clippy::cast_possible_truncation, // levels fit their bits; edges are rounded
    clippy::cast_possible_wrap,       // bits are compared as signed integers
    clippy::cast_precision_loss,      // levels are small
    clippy::cast_lossless,            // `From` is not const
    clippy::cast_sign_loss            // likewise
)]

mod clamp;
mod climb;
mod levels;
mod steps;
mod table;

use core::iter::Sum;
use core::ops::{Add, Mul};

pub use crate::number::triple::Rgb;
use crate::number::triple::assign;
use crate::number::{Mask, Real};
use crate::vector::{number_first, of_reals};
use clamp::clamped;
use levels::decoded;
#[cfg(feature = "fixed")]
pub(crate) use table::{FIXED_EIGHT_BITS, FIXED_FIVE_BITS, FIXED_SIX_BITS};
use table::{eight_bits, five_bits, six_bits};

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

assign!([T] Rgb<T>, Self: Mul);

/// Colors on a display, whose light is encoded as sRGB, and linear colors for programs that
/// encode elsewhere or not at all. Single precision is more than any display shows.
impl Rgb<f32> {
    /// Encodes linear light as sRGB bytes.
    ///
    /// ```text
    /// round(255 E),  E = 12.92 L                   for L ≤ 0.0031308
    ///                E = 1.055 L^(1/2.4) − 0.055   above
    /// ```
    ///
    /// The result is correctly rounded: for every number, each channel gets the byte nearest to
    /// the exact value. A channel below 0 or NaN gives 0, and one above 1 gives 255, so you need
    /// not call [`clamped`](Rgb::clamped) first. [`to_linear8`](Self::to_linear8) does not
    /// encode.
    ///
    /// Source: IEC 61966-2-1:1999, *Default RGB colour space – sRGB*.
    ///
    /// ```
    /// use shading::f32::Rgb;
    ///
    /// assert_eq!(Rgb::new(0.5, 0.18, 0.001).to_srgb8(), [188, 118, 3]);
    /// assert_eq!(Rgb::new(2.0, -1.0, f32::NAN).to_srgb8(), [255, 0, 0]);
    /// ```
    #[doc(alias("gamma", "encode"))]
    #[inline]
    #[must_use]
    pub const fn to_srgb8(self) -> [u8; 3] {
        [
            eight_bits(self.r) as u8,
            eight_bits(self.g) as u8,
            eight_bits(self.b) as u8,
        ]
    }

    /// Encodes linear light as 16 bits for a small display: sRGB with five bits of red, six of
    /// green and five of blue, red in the highest bits.
    ///
    /// ```text
    /// round(31 E_r) · 2¹¹ + round(63 E_g) · 2⁵ + round(31 E_b),   E as for to_srgb8
    /// ```
    ///
    /// Each channel is rounded once, from the linear light. Rounding the sRGB bytes again would
    /// change an eighth of the colors, and cutting off their low bits would change half.
    /// Channels outside [0, 1] and NaN are treated as in [`to_srgb8`](Self::to_srgb8).
    ///
    /// ```
    /// use shading::f32::Rgb;
    ///
    /// assert_eq!(Rgb::new(1.0, 0.18, 0.001).to_rgb565(), 31 << 11 | 29 << 5);
    /// ```
    #[doc(alias = "encode")]
    #[inline]
    #[must_use]
    pub const fn to_rgb565(self) -> u16 {
        // from the lowest bits up: the other order takes 1.08 of the time where it is called
        (five_bits(self.b) | six_bits(self.g) << 5 | five_bits(self.r) << 11) as u16
    }

    /// Rounds linear light to bytes **without encoding it as sRGB**. A display that is given
    /// them shows the light too dark. They are for what encodes by itself, such as a texture in
    /// a linear format, and for a renderer whose pictures have never been encoded.
    ///
    /// ```text
    /// round(255 L),  rounding ½ up
    /// ```
    ///
    /// The result is correctly rounded. Channels outside [0, 1] and NaN are treated as in
    /// [`to_srgb8`](Self::to_srgb8).
    ///
    /// ```
    /// use shading::f32::Rgb;
    ///
    /// assert_eq!(Rgb::new(1.0, 0.5, 0.001).to_linear8(), [255, 128, 0]); // sRGB is [255, 188, 3]
    /// ```
    #[doc(alias = "quantize")]
    #[inline]
    #[must_use]
    pub const fn to_linear8(self) -> [u8; 3] {
        [linear(self.r), linear(self.g), linear(self.b)]
    }
}

/// Decoding, to every number type.
impl<T: Real> Rgb<T> {
    /// Decodes sRGB bytes, such as those of a texture or of a designer's color, to linear light. In a
    /// constant, use [`const_from_srgb8`](Rgb::<f32>::const_from_srgb8).
    ///
    /// ```text
    /// L = E/12.92                     for E = byte/255 ≤ 0.04045
    /// L = ((E + 0.055)/1.055)^2.4     above
    /// ```
    ///
    /// The result is that of single precision, correctly rounded, and
    /// [`to_srgb8`](Rgb::<f32>::to_srgb8) gives the same bytes back.
    ///
    /// ```
    /// let brass = shading::f64::Rgb::from_srgb8([0xB5, 0xA6, 0x42]);
    /// assert_eq!(brass.to_srgb8(), [0xB5, 0xA6, 0x42]);
    /// ```
    #[doc(alias("gamma", "decode", "texture"))]
    #[inline]
    pub fn from_srgb8(bytes: [u8; 3]) -> Self {
        Rgb::<f32>::const_from_srgb8(bytes).map(T::of_f32)
    }

    /// Decodes the 16 bits of [`to_rgb565`](Rgb::<f32>::to_rgb565), such as those of a picture for a small
    /// display, to linear light.
    ///
    /// ```text
    /// E_r = bits₁₅…₁₁/31,  E_g = bits₁₀…₅/63,  E_b = bits₄…₀/31,   L as for from_srgb8
    /// ```
    ///
    /// The result is that of single precision, correctly rounded, and
    /// [`to_rgb565`](Rgb::<f32>::to_rgb565) gives the same bits back.
    ///
    /// ```
    /// assert_eq!(shading::f32::Rgb::from_rgb565(0x1234).to_rgb565(), 0x1234);
    /// ```
    #[doc(alias = "decode")]
    #[inline]
    pub fn from_rgb565(bits: u16) -> Self {
        // by one expression a channel: through `map` of an array, the compiler no longer sees the bounds
        let bits = usize::from(bits);
        let r = FIVE_BITS[bits >> 11 & 31];
        let g = SIX_BITS[bits >> 5 & 63];
        let b = FIVE_BITS[bits & 31];
        Rgb::new(r, g, b).map(T::of_f32)
    }
}

impl Rgb<f32> {
    /// [`from_srgb8`](Rgb::from_srgb8) for constants.
    ///
    /// ```
    /// use shading::f32::Rgb;
    /// static BRASS: Rgb = Rgb::const_from_srgb8([0xB5, 0xA6, 0x42]);
    /// assert_eq!(BRASS, Rgb::from_srgb8([0xB5, 0xA6, 0x42]));
    /// ```
    #[inline]
    pub const fn const_from_srgb8([r, g, b]: [u8; 3]) -> Self {
        Self::new(
            EIGHT_BITS[r as usize],
            EIGHT_BITS[g as usize],
            EIGHT_BITS[b as usize],
        )
    }
}

/// Encodings of the color that is nearest in single precision. That can be another level than the nearest
/// only where the light is within 2⁻²⁴ of itself from the edge between two.
impl Rgb<f64> {
    /// Encodes linear light as sRGB bytes; see [`Rgb::<f32>::to_srgb8`].
    ///
    /// ```
    /// assert_eq!(shading::f64::Rgb::new(0.5, 0.18, 0.001).to_srgb8(), [188, 118, 3]);
    /// ```
    #[inline]
    #[must_use]
    pub const fn to_srgb8(self) -> [u8; 3] {
        self.single().to_srgb8()
    }

    /// Encodes linear light as sRGB with five, six and five bits; see [`Rgb::<f32>::to_rgb565`].
    #[inline]
    #[must_use]
    pub const fn to_rgb565(self) -> u16 {
        self.single().to_rgb565()
    }

    /// Rounds linear light to bytes without encoding it; see [`Rgb::<f32>::to_linear8`].
    #[inline]
    #[must_use]
    pub const fn to_linear8(self) -> [u8; 3] {
        self.single().to_linear8()
    }

    /// [`from_srgb8`](Rgb::from_srgb8) for constants.
    #[inline]
    pub const fn const_from_srgb8(bytes: [u8; 3]) -> Self {
        let Rgb { r, g, b } = Rgb::<f32>::const_from_srgb8(bytes);
        Self::new(r as f64, g as f64, b as f64)
    }

    /// The nearest color in single precision.
    #[inline]
    const fn single(self) -> Rgb<f32> {
        Rgb::new(self.r as f32, self.g as f32, self.b as f32)
    }
}

/// round(255 · channel) in whole numbers, which are exact.
#[inline]
const fn linear(channel: f32) -> u8 {
    let bits = clamped(channel, 1.0 / 512.0, 1.0); // 2⁻⁹ is dark
    let significand = bits & 0x007F_FFFF | 0x0080_0000;
    let shift = 150 - (bits >> 23); // 23 to 32
    ((((significand * 255) >> (shift - 1)) + 1) >> 1) as u8
}

static EIGHT_BITS: [f32; 256] = light();
static SIX_BITS: [f32; 64] = light();
static FIVE_BITS: [f32; 32] = light();

/// The linear light of each level.
const fn light<const N: usize>() -> [f32; N] {
    let (mut light, mut level) = ([0.0; N], 0);
    while level < N {
        light[level] = decoded(level as f64 / (N - 1) as f64) as f32;
        level += 1;
    }
    light
}
