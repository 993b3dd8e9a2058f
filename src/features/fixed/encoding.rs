//! Encodings of linear light for pictures and displays: a straight line guesses the level or the one
//! below, and a comparison with the beginning of the next level decides.

use super::{Fixed, ONE};
use crate::encoding::edges::{edges, encoded};
use crate::encoding::packed;
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
    /// [`clamped`](Rgb::clamped) first. `to_linear8` does not encode.
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
    /// Each channel is rounded once, from the linear light. Channels outside [0, 1] are treated as
    /// in `to_srgb8`. `to_linear565` does not encode.
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
        packed(five_bits(self.r), six_bits(self.g), five_bits(self.b))
    }

    /// Rounds linear light to bytes **without encoding it as sRGB**. A display that is given them shows
    /// the light too dark. They are for what encodes by itself, and for a renderer whose pictures have
    /// never been encoded.
    ///
    /// ```text
    /// round(255 L),  rounding ½ up
    /// ```
    ///
    /// The result is correctly rounded. Channels outside [0, 1] are treated as in `to_srgb8`.
    ///
    /// ```
    /// use shading::fixed::{Fixed, Rgb};
    ///
    /// let x = Fixed::new;
    /// assert_eq!(Rgb::new(x(1.0), x(0.5), x(0.001)).to_linear8(), [255, 128, 0]);
    /// ```
    #[doc(alias = "quantize")]
    #[inline]
    #[must_use]
    pub const fn to_linear8(self) -> [u8; 3] {
        [
            linear(self.r, 255) as u8,
            linear(self.g, 255) as u8,
            linear(self.b, 255) as u8,
        ]
    }

    /// Rounds linear light to 16 bits **without encoding it as sRGB**: five bits of red, six of green
    /// and five of blue, red in the highest bits.
    ///
    /// ```text
    /// round(31 L_r) · 2¹¹ + round(63 L_g) · 2⁵ + round(31 L_b),  rounding ½ up
    /// ```
    ///
    /// The result is correctly rounded. Channels outside [0, 1] are treated as in `to_srgb8`.
    ///
    /// ```
    /// use shading::fixed::{Fixed, Rgb};
    ///
    /// let x = Fixed::new;
    /// assert_eq!(Rgb::new(x(1.0), x(0.5), x(0.001)).to_linear565(), 31 << 11 | 32 << 5);
    /// ```
    #[doc(alias = "quantize")]
    #[inline]
    #[must_use]
    pub const fn to_linear565(self) -> u16 {
        packed(linear(self.r, 31), linear(self.g, 63), linear(self.b, 31))
    }
}

/// The level of a channel, of 256.
#[inline]
const fn eight_bits(channel: Fixed) -> u32 {
    let steps = clamped(channel);
    let level = guess(steps) >> 15;
    level + (steps >= EIGHT_BITS[level as usize % 256] as u32) as u32
}

/// Of 64.
#[inline]
const fn six_bits(channel: Fixed) -> u32 {
    let steps = clamped(channel);
    let level = ((guess(steps) >> 7) * 63 + 0x6000) >> 16;
    level + (steps >= SIX_BITS[level as usize % 64] as u32) as u32
}

/// Of 32.
#[inline]
const fn five_bits(channel: Fixed) -> u32 {
    let steps = clamped(channel);
    let level = ((guess(steps) >> 7) * 31 + 0x6000) >> 16;
    level + (steps >= FIVE_BITS[level as usize % 32] as u32) as u32
}

/// round(highest · channel) for a highest level of at most 255.
#[inline]
const fn linear(channel: Fixed, highest: u32) -> u32 {
    let channel = if channel.0 > ONE { ONE } else { channel.0 };
    let steps = if channel < 0 { 0 } else { channel as u32 };
    (steps * highest + (1 << 15)) >> 16
}

/// The steps of a channel from 0 to 1, less the two brightest, which are as bright. Any other fits into
/// 16 bits and is below the edge after the highest level.
#[inline]
const fn clamped(channel: Fixed) -> u32 {
    let channel = if channel.0 > ONE - 2 {
        ONE - 2
    } else {
        channel.0
    };
    if channel < 0 { 0 } else { channel as u32 }
}

/// The first step of the next level.
static EIGHT_BITS: [u16; 256] = next_edges();
static SIX_BITS: [u16; 64] = next_edges();
static FIVE_BITS: [u16; 32] = next_edges();

const fn next_edges<const N: usize>() -> [u16; N] {
    // no channel reaches the last of them, above the highest level
    let (edges, mut next, mut level) = (edges::<N>(), [u16::MAX; N], 1);
    while level < N {
        let exact = ONE as f64 * edges[level];
        let whole = exact as u16;
        next[level - 1] = whole + ((whole as f64) < exact) as u16;
        level += 1;
    }
    next
}

/// 255 E + ½ in units of 2⁻¹⁵, up to 1 too low.
#[inline]
const fn guess(steps: u32) -> u32 {
    let (first, shift) = segments(steps);
    let line = LINES[(first + (steps >> shift)) as usize % 64];
    steps.wrapping_mul(line % SLOPES).wrapping_add(line)
}

/// The lines are long where the curve is flat: 2^shift steps. The first line of the next length follows.
#[inline]
const fn segments(steps: u32) -> (u32, u32) {
    if steps < 1 << 10 {
        (0, 7)
    } else if steps < 1 << 13 {
        (8 - 2, 9)
    } else {
        (22 - 4, 11)
    }
}

/// The slope is in the low bits; the rest is the level, in units of 2⁻¹⁵, of the step 0.
static LINES: [u32; 64] = {
    let (mut lines, mut begin) = ([0; 64], 0);
    while begin < ONE as u32 {
        let (first, shift) = segments(begin);
        let length = 1 << shift;
        let (low, high) = (at(begin), at(begin + length));
        let sag = at(begin + length / 2) - f64::midpoint(low, high);
        let slope = ((high - low) * 32_768.0 / length as f64 + 0.5) as u32;
        assert!(slope < SLOPES);
        // the curve lies between the line and 1 above it: half of what is left goes to either side
        let missed = (high - low) - (slope * length) as f64 / 32_768.0;
        let level = low - (1.0 - sag) / 2.0 + missed / 2.0;
        let level = (level * 32_768.0) as u32;
        let level = level.wrapping_sub(slope * begin);
        lines[(first + (begin >> shift)) as usize] = level & !(SLOPES - 1) | slope;
        begin += length;
    }
    lines
};
const SLOPES: u32 = 1 << 11;

const fn at(steps: u32) -> f64 {
    encoded(steps as f64 / ONE as f64)
}

// A guess rises within a line, so the levels are right if they are right at both ends of each stretch that
// has one line and one level.
macro_rules! assert_right {
    ($level:ident: $n:literal) => {
        const _: () = {
            const NEXT: [u16; $n] = next_edges();
            let (mut begin, mut level) = (0, 0);
            while begin < ONE as u32 {
                while level < $n - 1 && NEXT[level] as u32 <= begin {
                    level += 1;
                }
                let (_, shift) = segments(begin);
                let mut end = (begin >> shift << shift) + (1 << shift);
                if level < $n - 1 && end > NEXT[level] as u32 {
                    end = NEXT[level] as u32;
                }
                let [first, last] = [Fixed(begin as i32), Fixed(end as i32 - 1)];
                assert!($level(first) == level as u32 && $level(last) == level as u32);
                begin = end;
            }
        };
    };
}

assert_right!(eight_bits: 256);
assert_right!(six_bits: 64);
assert_right!(five_bits: 32);
