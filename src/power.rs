//! Floor 0: powers of a cosine, by an integer m in any number, and by a real m in single precision, for
//! `f32` and for lanes of it.
//!
//! An integer power is taken by squaring. A real one is
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
//! one rises by more than a unit in its last place, and at √½, where z turns over, P hardly errs.
//! The rounded product by m then never falls either; only 2^y may step back, by one unit in the
//! last place of the result.
//!
//! **Quick.** The exponential is a quotient: eight operations and a division. A polynomial as good
//! takes twelve, each of which waits for the one before.
//!
//! `benches/minimax.py` finds the polynomials, `tests/exhaustive.rs` tries every c.

use crate::real::Real;

/// The bits of 1 in single precision, and those from a power of two to the next.
const ONE: u32 = 0x3F80_0000;
const OCTAVE: u32 = 0x0080_0000;

/// The m-th power of a cosine, as a function of the cosine. A cosine counts as 0 where its power would be
/// subnormal in single precision: squaring would lead through subnormal numbers, which cost processors
/// up to a hundred times as much as others. Numbers of a wider range hardly ever come to theirs and keep
/// every power.
#[inline]
pub(crate) fn integer_power<T: Real>(m: u32) -> impl Fn(T) -> T {
    let is_wider = (T::MAX - T::of_f32(f32::MAX)).any_positive();
    let (least, top, m) = if m == 0 {
        // the first power of a cosine that counts as 1 from 0 on
        (T::ZERO, T::ZERO, 1)
    } else if is_wider {
        (T::ZERO, T::ONE, m)
    } else {
        (T::of_f32(least_normal_base(m)), T::ONE, m)
    };
    move |cosine: T| {
        let cosine = cosine.if_above(top, T::ONE, cosine);
        by_squaring(cosine.if_above(least, cosine, T::ZERO), m)
    }
}

/// 2^(−126/m), whose power m ≥ 1 is the least normal number: never more, and its power not below
/// 2⁻¹³⁰ up to m = 10⁴.
#[inline]
fn least_normal_base(m: u32) -> f32 {
    // the bits of a float are its logarithm, but for the significand 1 + x, of which
    // log₂(1 + x) ≈ x + 0.39 (¼ − (x − ½)²)
    let linear = ONE - 126 * OCTAVE / m;
    let from_half = (linear >> 12 & 0x7FF).wrapping_sub(0x400);
    let bend = 0x10_0000 - from_half.wrapping_mul(from_half);
    f32::from_bits(linear - bend / 32 * 25 - 1600)
}

/// baseᵐ by squaring, from the highest bit of m down; the zeros at its end are squares of the base.
#[inline]
pub(crate) fn by_squaring<T: Real>(mut base: T, m: u32) -> T {
    if m == 0 {
        return T::ONE;
    }
    // one bit comes down past these zeros; a loop over their number compilers would unroll, and
    // small chips lack the registers for that
    let mut bit = (m & m.wrapping_neg()) >> 1;
    while bit != 0 {
        base = base * base;
        bit >>= 1;
    }
    let mut power = base;
    // the bits of m below its highest one, leftmost first, down to its last one
    let mut bits = m << m.leading_zeros() << 1;
    while bits != 0 {
        power = power * power;
        if bits >> 31 == 1 {
            power = power * base;
        }
        bits <<= 1;
    }
    power
}

/// What [`power`] does to the bits of a number in single precision, in every lane.
pub(crate) trait Binary32: Real {
    /// For a positive normal number, `(e, z)` with self = 2^e z and z in 2²⁴ [√½, √2).
    fn split(self) -> (Self, Self);

    /// 2^(n − 127), where n, of 0 to 254, is the low byte of the bits of self; +0 for n = 0.
    fn two_to_low_byte(self) -> Self;
}

/// The bits of 2²⁴ √½, the least z that `split` gives.
pub(crate) const LEAST: i32 = 0x4B35_04F3;
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
        let above = bits.wrapping_sub(LEAST);
        let z = bits.wrapping_sub(above & EXPONENT);
        ((above >> 23) as f32, f32::from_bits(z as u32))
    }

    #[inline]
    fn two_to_low_byte(self) -> f32 {
        f32::from_bits(self.to_bits() << 23)
    }
}

/// log₂ z = s P(s²), s = (z − 1)/(z + 1) for z in [√½, √2). P minimax of degree 2, weighted for the
/// relative error of log₂ c: 2.0 · 2⁻²⁴, with these coefficients 2.5 · 2⁻²⁴, with every rounding
/// 5.4 · 2⁻²⁴.
const LOG: [f32; 3] = [
    2.885_390_5,  // 0x4038AA3D
    0.961_551_8,  // 0x3F762842
    0.597_326_93, // 0x3F18EA6B
];

/// 2^(1 + r) = 2 + 4r/(Q(r²) − r) for r in [−½, ½], as r(2^r + 1)/(2^r − 1) is even. Q minimax of
/// degree 2, weighted for the absolute error of 2^y, y ≤ 0: 0.004 · 2⁻²⁴, with these coefficients
/// 0.02 · 2⁻²⁴, with every rounding 1.1 · 2⁻²⁴.
const EXP: [f32; 3] = [
    2.885_39,          // 0x4038AA3B
    0.115_524_82,      // 0x3DEC9847
    -0.000_923_172_75, // 0xBA720113
];

/// From 2²³ to 2²⁴ the `f32` are the integers: to add this to a small number rounds it to the nearest
/// integer, even at a tie, and leaves that integer, and 126 more, in the low bits.
const TO_INTEGER: f32 = 12_583_038.0; // 1.5 · 2²³ + 126

/// cᵐ for c in [0, 1] and m ≥ 0.
///
/// The absolute error is below 2⁻²² for every c, subnormal or not, and every m; the greatest one
/// found is 2.4 · 2⁻²⁴. 1ᵐ and c⁰ are exactly 1. A base of 0 gives 0 for **every** m, also for
/// m = 0. A result below 2^−125.5 is 0: none is subnormal, and a processor that flushes those gives
/// the same bits.
///
/// Whatever the bits of c and m, the result is a number of [0, 1], the same one everywhere: c above 1
/// counts as 1, c below 0 or not a number as 0.
#[inline(always)]
pub(crate) fn power<T: Binary32>(c: T, m: T) -> T {
    let of = T::of_f32;

    // scaled by 2²⁴, exactly, the least subnormal number is normal; the quotient s is the same
    let scale = of(16_777_216.0);
    let (e, z) = (c * scale).split();
    let s = (z - scale) / (z + scale);
    let x = s * s;
    let [p0, p1, p2] = LOG;
    let log2_c = e + s * (of(p0) + x * (of(p1) + x * of(p2)));

    // y = n + r within [−126, 0]; the result is 2^(n − 1) 2^(1 + r), and 0 for n = −126
    let m = T::ONE.if_above(c, m, T::ZERO);
    let y = (m * log2_c).at_least(of(-126.0));
    let shifted = y + of(TO_INTEGER);
    let r = y - (shifted - of(TO_INTEGER));
    let x = r * r;
    let [q0, q1, q2] = EXP;
    let q = of(q0) - r + x * (of(q1) + x * of(q2));
    let power = (of(2.0) + of(4.0) * r / q) * shifted.two_to_low_byte();

    c.if_positive(power, T::ZERO)
}
