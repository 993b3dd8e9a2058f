//! Encodings of linear light for pictures and displays, and back.
//!
//! The levels of an encoding rise with the light, so each level begins at a certain `f32`. Encoding
//! a number means finding the last level that begins at or below it. A search in a table does this
//! with integer comparisons alone. The result is correctly rounded by construction. The search
//! needs no powers, no division and, on a chip without an FPU, no floating-point routine. The
//! compiler computes the tables from the formula.

#![allow(
    clippy::cast_possible_truncation, // levels fit their bits; edges are rounded
    clippy::cast_possible_wrap,       // bits are compared as signed integers
    clippy::cast_precision_loss       // levels are small
)]

use crate::rgb::Rgb;

/// Encodings exist only for `f32` and, with the feature `fixed`, for fixed point. Convert colors of
/// other types first; a display shows no difference.
impl Rgb<f32> {
    /// Encodes linear light as sRGB bytes.
    ///
    /// ```text
    /// round(255 E),  E = 12.92 L                   for L ≤ 0.0031308
    ///                E = 1.055 L^(1/2.4) − 0.055   above
    /// ```
    ///
    /// The result is correctly rounded: for every `f32`, each channel gets the byte nearest to the
    /// exact value. A channel below 0 or NaN gives 0, and one above 1 gives 255, so you need not
    /// call [`clamped`](Rgb::clamped) first.
    ///
    /// Source: IEC 61966-2-1:1999, *Multimedia systems and equipment – Colour measurement and management –
    /// Part 2-1: Colour management – Default RGB colour space – sRGB*.
    ///
    /// ```
    /// use shading::Rgb;
    /// assert_eq!(Rgb::new(0.5, 0.18, 0.001).to_srgb8(), [188, 118, 3]);
    /// assert_eq!(Rgb::new(2.0, -1.0, f32::NAN).to_srgb8(), [255, 0, 0]);
    /// ```
    #[doc(alias = "gamma")]
    #[doc(alias = "encode")]
    #[inline]
    #[must_use]
    pub const fn to_srgb8(self) -> [u8; 3] {
        [
            level(order(self.r), &EIGHT_BITS) as u8,
            level(order(self.g), &EIGHT_BITS) as u8,
            level(order(self.b), &EIGHT_BITS) as u8,
        ]
    }

    /// Decodes sRGB bytes, such as those of a texture or of a designer's color, to linear light.
    ///
    /// ```text
    /// L = E/12.92                     for E = byte/255 ≤ 0.04045
    /// L = ((E + 0.055)/1.055)^2.4     above
    /// ```
    ///
    /// The result is correctly rounded, and [`to_srgb8`](Rgb::to_srgb8) gives the same bytes back.
    ///
    /// Source: IEC 61966-2-1:1999, as for [`to_srgb8`](Rgb::to_srgb8).
    ///
    /// ```
    /// use shading::Rgb;
    /// static BRASS: Rgb = Rgb::from_srgb8([0xB5, 0xA6, 0x42]);
    /// assert_eq!(BRASS.to_srgb8(), [0xB5, 0xA6, 0x42]);
    /// assert_eq!(Rgb::from_srgb8([255, 0, 255]), Rgb::new(1.0, 0.0, 1.0));
    /// ```
    #[doc(alias = "gamma")]
    #[doc(alias = "decode")]
    #[inline]
    #[must_use]
    pub const fn from_srgb8([r, g, b]: [u8; 3]) -> Self {
        Self::new(
            DECODED[r as usize],
            DECODED[g as usize],
            DECODED[b as usize],
        )
    }

    /// Encodes linear light as 16 bits for a small display: sRGB with five bits of red, six of
    /// green and five of blue, red in the highest bits.
    ///
    /// ```text
    /// round(31 E_r) · 2¹¹ + round(63 E_g) · 2⁵ + round(31 E_b),   E as for to_srgb8
    /// ```
    ///
    /// Each channel is rounded once, from the linear light. Rounding the sRGB bytes again would
    /// change an eighth of the colors, and cutting off their low bits would change half. Channels
    /// outside [0, 1] and NaN are treated as in [`to_srgb8`](Rgb::to_srgb8).
    ///
    /// Source: IEC 61966-2-1:1999, as for [`to_srgb8`](Rgb::to_srgb8).
    ///
    /// ```
    /// use shading::Rgb;
    /// assert_eq!(Rgb::new(1.0, 0.18, 0.001).to_rgb565(), 31 << 11 | 29 << 5);
    /// ```
    #[doc(alias = "encode")]
    #[inline]
    #[must_use]
    pub const fn to_rgb565(self) -> u16 {
        let r = level(order(self.r), &FIVE_BITS) as u16;
        let g = level(order(self.g), &SIX_BITS) as u16;
        let b = level(order(self.b), &FIVE_BITS) as u16;
        r << 11 | g << 5 | b
    }
}

/// The most by which the bits of a NaN exceed those of infinity.
const NAN: i32 = 0x007F_FFFF;

/// The place of a number in the order of all numbers. As signed integers, the bits of positive
/// floats are in order, and those of negative floats are below them. The sum wraps every NaN around
/// to below all levels.
#[inline]
const fn order(value: f32) -> i32 {
    (value.to_bits() as i32).wrapping_add(NAN)
}

/// The last level that begins at or below a place. N must be a power of two.
#[inline]
pub(crate) const fn level<const N: usize>(place: i32, begin: &[i32; N]) -> usize {
    let (mut level, mut step) = (0, N / 2);
    while step > 0 {
        // the mask changes nothing, but shows the compiler that the index is within bounds
        if place >= begin[(level | step) & (N - 1)] {
            level |= step;
        }
        step /= 2;
    }
    level
}

static EIGHT_BITS: [i32; 256] = levels();
static SIX_BITS: [i32; 64] = levels();
static FIVE_BITS: [i32; 32] = levels();

/// The [`order`] of the least `f32` of each level, at which the encoding reaches the level minus
/// one half.
const fn levels<const N: usize>() -> [i32; N] {
    let (mut begin, mut level) = ([i32::MIN; N], 1);
    while level < N {
        let exact = decoded((level as f64 - 0.5) / (N - 1) as f64);
        let nearest = exact as f32;
        let is_below = (nearest as f64) < exact;
        begin[level] = order(nearest) + is_below as i32;
        level += 1;
    }
    begin
}

/// The linear light of each byte.
static DECODED: [f32; 256] = {
    let (mut light, mut byte) = ([0.0; 256], 0);
    while byte < 256 {
        light[byte] = decoded(byte as f64 / 255.0) as f32;
        byte += 1;
    }
    light
};

/// The standard's decoding, used only at compile time. The error is at most 2⁻⁵⁰ of the result. That
/// suffices: no level begins within 2⁻³⁶ of an `f32`, and the light of no byte is within 2⁻³⁶ of a
/// tie.
pub(crate) const fn decoded(encoded: f64) -> f64 {
    if encoded <= 0.040_45 {
        return encoded / 12.92;
    }
    // x^2.4 = x² ⁵√x²; Newton's iteration descends to the root until rounding stops it
    let x = (encoded + 0.055) / 1.055;
    let (square, mut root) = (x * x, 1.0);
    loop {
        let next = 0.8 * root + 0.2 * square / (root * root * root * root);
        if next >= root {
            return square * root;
        }
        root = next;
    }
}
