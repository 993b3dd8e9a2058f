//! Powers of a cosine by a real m in single precision, for `f32` and SIMD lanes of it.
//!
//! ```text
//! cᵐ = 2^(m log₂ c)
//! ```
//!
//! The computation uses only correctly rounded + − × ÷ and integer operations on the bits, in a
//! fixed order and without branches. Every processor and every lane therefore gives the same bits.
//!
//! **The logarithm needs no extra precision.** Let y = m log₂ c ≤ 0. A relative error ε in the
//! logarithm changes the result by 2^y |y| ln 2 · ε. Since x e⁻ˣ ≤ 1/e, the *absolute* error of the
//! result is at most ε/e, for every c and m, although a tiny result may have a large relative
//! error. It is therefore enough that the logarithm has a small relative error, including near
//! c = 1, where it vanishes.
//!
//! **The power is monotone within one unit in the last place.** The computed logarithm never falls
//! as c rises. From one `f32` to the next, the true logarithm rises by more than a unit in its last
//! place; at √½, where z wraps around, P has almost no error. The rounded product with m then never
//! falls either. Only 2^y may step back, by one unit in the last place of the result.
//!
//! **The exponential is a quotient for speed.** It takes eight operations and a division. A
//! polynomial of the same accuracy takes twelve operations, each of which waits for the one before.
//!
//! `benches/minimax.py` finds the coefficients; `tests/numerics/exhaustive.rs` tries every c.

use crate::real::Real;

/// The operations of [`power`] on the bits of a single-precision number, lane by lane.
pub(crate) trait Binary32: Real {
    /// For a positive normal number, returns `(e, z)` such that self = 2^e z and z is within 2²⁴
    /// [√½, √2).
    fn split(self) -> (Self, Self);

    /// 2^(n − 127), where n, from 0 to 254, is the low byte of the bits of self; +0 for n = 0.
    fn two_to_low_byte(self) -> Self;

    /// n for self = `TO_INTEGER` + n.
    #[inline]
    fn to_integer(self) -> Self {
        self - Self::of_f32(TO_INTEGER)
    }
}

/// The bits of 2²⁴ √½, the least z that `split` returns.
pub(crate) const LEAST: i32 = 0x4B35_04F3;
/// The bits of the sign and the exponent.
pub(crate) const EXPONENT: i32 = -0x0080_0000;

impl Binary32 for f32 {
    #[inline]
    #[allow(
        clippy::cast_possible_wrap,  // only the bits matter
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

    // The driver of a GPU may simplify (y + c) − c to y. It cannot simplify the bits.
    #[cfg(target_arch = "spirv")]
    #[inline]
    fn to_integer(self) -> f32 {
        self.to_bits().wrapping_sub(TO_INTEGER.to_bits()) as i32 as f32
    }
}

/// log₂ z = s P(s²), s = (z − 1)/(z + 1), for z in [√½, √2).
///
/// P is the minimax polynomial of degree 2, weighted for the relative error of log₂ c. That error
/// is 2.0 · 2⁻²⁴ with exact coefficients, 2.5 · 2⁻²⁴ with these, and 5.4 · 2⁻²⁴ with all roundings.
const LOG: [f32; 3] = [
    2.885_390_5,  // 0x4038AA3D
    0.961_551_8,  // 0x3F762842
    0.597_326_93, // 0x3F18EA6B
];

/// 2^(1 + r) = 2 + 4r/(Q(r²) − r) for r in [−½, ½], because r(2^r + 1)/(2^r − 1) is even.
///
/// Q is the minimax polynomial of degree 2, weighted for the absolute error of 2^y, y ≤ 0. That
/// error is 0.004 · 2⁻²⁴ with exact coefficients, 0.02 · 2⁻²⁴ with these, and 1.1 · 2⁻²⁴ with all
/// roundings.
const EXP: [f32; 3] = [
    2.885_39,          // 0x4038AA3B
    0.115_524_82,      // 0x3DEC9847
    -0.000_923_172_75, // 0xBA720113
];

/// Between 2²³ and 2²⁴ the `f32` numbers are the integers. Adding this constant therefore rounds a
/// small number to the nearest integer, with ties to even, and leaves that integer plus 126 in the
/// low bits.
const TO_INTEGER: f32 = 12_583_038.0; // 1.5 · 2²³ + 126

/// cᵐ for c in [0, 1] and m ≥ 0.
///
/// The absolute error is below 2⁻²² for every c, subnormal or not, and every m; the largest one
/// found is 2.4 · 2⁻²⁴. 1ᵐ and c⁰ are exactly 1. A base of 0 gives 0 for **every** m, even m = 0. A
/// result below 2^−125.5 becomes 0, so no result is subnormal, and a processor that flushes
/// subnormal numbers gives the same bits.
///
/// Whatever the bits of c and m, the result is within [0, 1] and the same on every machine: c above
/// 1 counts as 1, and c below 0 or NaN counts as 0.
#[inline(always)]
pub(crate) fn power<T: Binary32>(c: T, m: T) -> T {
    let of = T::of_f32;

    // Scaling by 2²⁴ is exact and makes even the least subnormal number normal. The quotient s does
    // not change.
    let scale = of(16_777_216.0);
    let (e, z) = (c * scale).split();
    let s = (z - scale) / (z + scale);
    let x = s * s;
    let [p0, p1, p2] = LOG;
    let log2_c = e + s * (of(p0) + x * (of(p1) + x * of(p2)));

    // y = n + r within [−126, 0]; the result is 2^(n − 1) 2^(1 + r), or 0 for n = −126
    let m = T::ONE.if_above(c, m, T::ZERO);
    let y = (m * log2_c).at_least(of(-126.0));
    let shifted = y + of(TO_INTEGER);
    let r = y - shifted.to_integer();
    let x = r * r;
    let [q0, q1, q2] = EXP;
    let q = of(q0) - r + x * (of(q1) + x * of(q2));
    let power = (of(2.0) + of(4.0) * r / q) * shifted.two_to_low_byte();

    c.if_positive(power, T::ZERO)
}
