//! Floor 0: the power of a cosine by a real m in single precision, for `f32` and for lanes of it.
//!
//! ```text
//! cᵐ = 2^(m log₂ c)
//! ```
//!
//! Only correctly rounded + − × ÷ and integer operations on the bits, in one fixed order and without
//! a branch, so that every processor, and every lane, gives the same bits.
//!
//! **No second word is carried, and none is needed.** With y = m log₂ c ≤ 0, a relative error ε in
//! the logarithm moves the result by 2^y |y| ln 2 · ε, and x e⁻ˣ ≤ 1/e: *absolutely* the result is
//! at most ε/e wrong, for every c and m, though a tiny result may be relatively far off. So it is
//! enough that the logarithm is right relatively, also beside c = 1, where it vanishes.
//!
//! **Monotone.** The computed logarithm never falls as c rises: from one `f32` to the next the true
//! one rises by several units in its last place. The rounded product by m then never falls either;
//! only the last polynomial may step back, by one unit in the last place of the result.
//!
//! `benches/minimax.py` finds the polynomials, `tests/exhaustive.rs` tries every c.

use crate::real::Real;

/// What [`power`] does to the bits of a number in single precision, in every lane.
pub(crate) trait Binary32: Real {
    /// For a positive normal number, `(e, z)` with self = 2^(e + 24) z and z in [⅔, 4⁄3).
    fn split(self) -> (Self, Self);

    /// 2^(n − 127), where n, of 0 to 254, is the low byte of the bits of self; +0 for n = 0.
    fn two_to_low_byte(self) -> Self;
}

/// The bits of ⅔, rounded up: the least significand that `split` gives. A lower one would widen
/// s², a higher one would lose more digits where −1 + log₂ z cancels.
pub(crate) const TWO_THIRDS: i32 = 0x3F2A_AAAB;
/// The bits of sign and exponent.
pub(crate) const EXPONENT: i32 = -0x0080_0000;

impl Binary32 for f32 {
    #[inline]
    #[allow(
        clippy::cast_possible_wrap,  // the bits are meant
        clippy::cast_sign_loss,      // likewise
        clippy::cast_precision_loss  // e has eight bits
    )]
    fn split(self) -> (f32, f32) {
        let bits = self.to_bits() as i32;
        let above = bits.wrapping_sub(TWO_THIRDS);
        let e = (above >> 23) - 24;
        let z = bits.wrapping_sub(above & EXPONENT);
        (e as f32, f32::from_bits(z as u32))
    }

    #[inline]
    fn two_to_low_byte(self) -> f32 {
        f32::from_bits(self.to_bits() << 23)
    }
}

/// log₂ z = s P(s²), s = (z − 1)/(z + 1) in [−1⁄5, 1⁄7]. P minimax of degree 3, weight 1/log₂:
/// relative error 0.04 · 2⁻²⁴, with these coefficients 0.22 · 2⁻²⁴; that of log₂ c, with every
/// rounding, 3.1 · 2⁻²⁴.
const LOG: [f32; 4] = [
    2.885_39,     // 0x4038AA3B
    0.961_817_5,  // 0x3F7639AC
    0.575_337,    // 0x3F134949
    0.457_035_78, // 0x3EEA0098
];

/// 2^(1 + r) = 2 + r Q(r), for r in [−½, ½]. Q minimax of degree 5, weighted by its part in 2^y for
/// y ≤ 0: absolute error 0.03 · 2⁻²⁴, with these coefficients 0.04 · 2⁻²⁴, with every rounding
/// 1.0 · 2⁻²⁴.
const EXP: [f32; 6] = [
    1.386_294_4,      // 0x3FB17218
    0.480_452_9,      // 0x3EF5FDEC
    0.111_007_206,    // 0x3DE357BF
    0.019_237_595,    // 0x3C9D9829
    0.002_678_131_5,  // 0x3B2F8397
    0.000_305_149_97, // 0x399FFC89
];

/// From 2²³ to 2²⁴ the `f32` are the integers: to add this to a small number rounds it to the nearest
/// integer, even at a tie, and leaves that integer, and 126 more, in the low bits.
const TO_INTEGER: f32 = 12_583_038.0; // 1.5 · 2²³ + 126

/// cᵐ for c in [0, 1] and m ≥ 0.
///
/// The absolute error is below 2⁻²² for every c, subnormal or not, and every m; the greatest one
/// found is 1.8 · 2⁻²⁴. 1ᵐ and c⁰ are exactly 1. A base of 0 gives 0 for **every** m, also for
/// m = 0. A result below 2^−125.5 is 0: none is subnormal, and a processor that flushes those gives
/// the same bits.
///
/// Whatever the bits of c and m, the result is a number of [0, 1], the same one everywhere: c above 1
/// counts as 1, c below 0 or not a number as 0.
#[inline]
pub(crate) fn power<T: Binary32>(c: T, m: T) -> T {
    let (zero, one, two) = (T::ZERO, T::ONE, T::of(2.0));
    let of = |coefficient: f32| T::of(f64::from(coefficient));

    // scaled by 2²⁴, exactly, the least subnormal number is normal; `split` takes the 24 off again
    let (e, z) = (c * T::of(16_777_216.0)).split();
    let s = (z - one) / (z + one);
    let x = s * s;
    let [p0, p1, p2, p3] = LOG;
    let log2_c = e + s * (of(p0) + x * (of(p1) + x * (of(p2) + x * of(p3))));

    // y = n + r within [−126, 0]; the result is 2^(n − 1) 2^(1 + r), and 0 for n = −126
    let y = (m * log2_c).at_least(T::of(-126.0)).at_most(zero);
    let shifted = y + of(TO_INTEGER);
    let r = y - (shifted - of(TO_INTEGER));

    // written out: for a loop over the coefficients, opt-level s would copy them to the stack
    let [q0, q1, q2, q3, q4, q5] = EXP;
    let q = of(q0) + r * (of(q1) + r * (of(q2) + r * (of(q3) + r * (of(q4) + r * of(q5)))));

    (two + r * q) * c.if_positive(shifted.two_to_low_byte(), zero)
}

/// The [`power`] of each of four cosines.
///
/// Out of line and of numbers, not of an array: so compilers see a loop of four and nothing around
/// it, make SIMD instructions of it, and pass the cosines in registers. Written to memory one by one,
/// they could not be read as a vector before all of them had arrived there.
#[inline(never)]
pub(crate) fn four_powers(a: f32, b: f32, c: f32, d: f32, m: f32) -> [f32; 4] {
    let mut powers = [a, b, c, d];
    for power_of_c in &mut powers {
        *power_of_c = power(*power_of_c, m);
    }
    powers
}
