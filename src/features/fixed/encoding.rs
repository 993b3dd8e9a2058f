//! Encodings of linear light for pictures and displays, by the search in a table that encodes `f32`.

use super::{Fixed, ONE};
use crate::encoding::{decoded, level};
use crate::rgb::Rgb;

impl Rgb<Fixed> {
    /// Encodes linear light as sRGB bytes.
    ///
    /// ```text
    /// round(255 E),  E = 12.92 L                   for L ≤ 0.0031308
    ///                E = 1.055 L^(1/2.4) − 0.055   above
    /// ```
    ///
    /// The result is correctly rounded: for every [`Fixed`], each channel gets the byte nearest to
    /// the exact value. A channel below 0 gives 0, and one above 1 gives 255, so you need not call
    /// [`clamped`](Rgb::clamped) first. It takes comparisons of integers alone.
    ///
    /// Source: IEC 61966-2-1:1999, *Multimedia systems and equipment – Colour measurement and management –
    /// Part 2-1: Colour management – Default RGB colour space – sRGB*.
    ///
    /// ```
    /// use shading::fixed::{Fixed, Rgb};
    ///
    /// let x = Fixed::new;
    /// assert_eq!(Rgb::new(x(0.5), x(0.18), x(0.001)).to_srgb8(), [188, 118, 3]);
    /// assert_eq!(Rgb::new(x(2.0), x(-1.0), x(1.0)).to_srgb8(), [255, 0, 255]);
    /// ```
    #[doc(alias = "gamma")]
    #[doc(alias = "encode")]
    #[inline]
    #[must_use]
    pub const fn to_srgb8(self) -> [u8; 3] {
        [
            level(self.r.0, &EIGHT_BITS) as u8,
            level(self.g.0, &EIGHT_BITS) as u8,
            level(self.b.0, &EIGHT_BITS) as u8,
        ]
    }

    /// Encodes linear light as 16 bits for a small display: sRGB with five bits of red, six of
    /// green and five of blue, red in the highest bits.
    ///
    /// ```text
    /// round(31 E_r) · 2¹¹ + round(63 E_g) · 2⁵ + round(31 E_b),   E as for to_srgb8
    /// ```
    ///
    /// Each channel is rounded once, from the linear light. Channels outside [0, 1] are treated as
    /// in `to_srgb8`.
    ///
    /// Source: IEC 61966-2-1:1999, as for `to_srgb8`.
    ///
    /// ```
    /// use shading::fixed::{Fixed, Rgb};
    ///
    /// let x = Fixed::new;
    /// assert_eq!(Rgb::new(x(1.0), x(0.18), x(0.001)).to_rgb565(), 31 << 11 | 29 << 5);
    /// ```
    #[doc(alias = "encode")]
    #[inline]
    #[must_use]
    pub const fn to_rgb565(self) -> u16 {
        let r = level(self.r.0, &FIVE_BITS) as u16;
        let g = level(self.g.0, &SIX_BITS) as u16;
        let b = level(self.b.0, &FIVE_BITS) as u16;
        r << 11 | g << 5 | b
    }
}

static EIGHT_BITS: [i32; 256] = levels();
static SIX_BITS: [i32; 64] = levels();
static FIVE_BITS: [i32; 32] = levels();

/// The first step of each level, at which the encoding reaches the level minus one half.
const fn levels<const N: usize>() -> [i32; N] {
    let (mut begin, mut level) = ([i32::MIN; N], 1);
    while level < N {
        let exact = ONE as f64 * decoded((level as f64 - 0.5) / (N - 1) as f64);
        let whole = exact as i32;
        begin[level] = whole + ((whole as f64) < exact) as i32;
        level += 1;
    }
    begin
}
