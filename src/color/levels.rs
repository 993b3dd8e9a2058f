//! Where each level begins: the least number whose encoding reaches the level minus one half. The
//! compiler decides it in whole numbers, so the tables are right to the last bit.

/// The edges of N levels. Constants, so that the compiler searches for them once and not in each table.
pub(super) struct Levels<const N: usize>;

impl<const N: usize> Levels<N> {
    const EDGES: [f64; N] = edges();
    /// The bits of the least `f32` of the next level, and of NaN above the highest level.
    pub(super) const NEXT: [u32; N] = next(Self::EDGES);
}

/// The least `f64` of each level of N, and 0 for the lowest.
const fn edges<const N: usize>() -> [f64; N] {
    let (mut edges, mut level) = ([0.0; N], 1);
    while level < N {
        let mut bits = decoded((level as f64 - 0.5) / (N - 1) as f64).to_bits();
        while reaches(bits, level as u64, N as u64 - 1) {
            bits -= 1;
        }
        while !reaches(bits, level as u64, N as u64 - 1) {
            bits += 1;
        }
        edges[level] = f64::from_bits(bits);
        level += 1;
    }
    edges
}

const fn next<const N: usize>(edges: [f64; N]) -> [u32; N] {
    let (mut next, mut level) = ([u32::MAX; N], 1);
    while level < N {
        let nearest = edges[level] as f32;
        let is_below = (nearest as f64) < edges[level];
        next[level - 1] = nearest.to_bits() + is_below as u32;
        level += 1;
    }
    next
}

/// The least fixed-point number with 16 bits after the point of the next level, and the largest number
/// of 16 bits above the highest level.
#[cfg(feature = "fixed")]
pub(super) const fn next_fixed_edges<const N: usize>() -> [u16; N] {
    let (edges, mut next, mut level) = (Levels::<N>::EDGES, [u16::MAX; N], 1);
    while level < N {
        let steps = edges[level] * 65536.0;
        let floor = steps as u16;
        next[level - 1] = floor + ((floor as f64) < steps) as u16;
        level += 1;
    }
    next
}

/// Whether the encoding E of a number reaches the level minus one half.
///
/// ```text
/// 12.92 L ≥ (l − ½)/n                              for (l − ½)/n ≤ 0.04045
/// L ≥ (((l − ½)/n + 0.055)/1.055)^2.4 = (a/b)^(12/5),
///     so L⁵ b¹² ≥ a¹²                              above
/// ```
///
/// With L = m/2ᵏ, both sides are whole numbers.
const fn reaches(bits: u64, level: u64, highest: u64) -> bool {
    let m = bits << 12 >> 12 | 1 << 52;
    let k = 1075 - (bits >> 52);
    let (odd, twice) = (2 * level - 1, 2 * highest);
    if 100_000 * odd <= 4045 * twice {
        return m as u128 * (1292 * twice) as u128 >= ((100 * odd) as u128) << k;
    }
    let (a, b) = (200 * odd + 11 * twice, 211 * twice);
    let left = times(times(power_of_two(0), m, 5), b * b * b, 4);
    let right = times(power_of_two(5 * k), a * a * a, 4);
    let mut limb = LIMBS - 1;
    while limb > 0 && left[limb] == right[limb] {
        limb -= 1;
    }
    left[limb] >= right[limb]
}

/// A whole number, its lowest 64 bits first. The largest is 107,410¹² · 2³³⁵, below 2⁵³⁶.
type Whole = [u64; LIMBS];
const LIMBS: usize = 9;

const fn power_of_two(exponent: u64) -> Whole {
    let mut number = [0; LIMBS];
    number[exponent as usize / 64] = 1 << (exponent % 64);
    number
}

/// The number times a power of a factor.
const fn times(mut number: Whole, factor: u64, exponent: u32) -> Whole {
    let mut i = 0;
    while i < exponent {
        let (mut carry, mut limb) = (0, 0);
        while limb < LIMBS {
            let product = number[limb] as u128 * factor as u128 + carry;
            number[limb] = product as u64;
            carry = product >> 64;
            limb += 1;
        }
        i += 1;
    }
    number
}

/// The standard's decoding, used only at compile time. The error is at most 2⁻⁵⁰ of the result. That
/// suffices: the light of no byte is within 2⁻³⁶ of a tie.
pub(super) const fn decoded(encoded: f64) -> f64 {
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
