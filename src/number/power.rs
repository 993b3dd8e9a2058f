//! Powers of a cosine by a real m, for floats and SIMD lanes of them.
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
//! as c rises. From one float to the next, the true logarithm rises by more than a unit in its last
//! place; at √½, where z wraps around, P has almost no error. The rounded product with m then never
//! falls either. Only 2^y may step back, by one unit in the last place of the result.
//!
//! The polynomials are summed in pairs, which wait less for each other than the terms of Horner's
//! scheme do. `benches/minimax.py` finds the coefficients, or their errors.
//!
//! [`Lobe`](crate::Lobe) uses them for `f32`, `f64` and lanes. A number of your own that implements
//! [`Bits`] has them, too.

use super::Real;

/// The operations of the powers on the bits of a float, lane by lane.
///
/// ```
/// use shading::number::power::Bits;
/// assert_eq!(12.0_f32.split(1.0), (3.0, 1.5)); // 12 = 2³ · 1.5
/// ```
pub trait Bits: Real {
    /// For positive normal numbers, returns `(e, z)` such that self = 2^e z and z is within
    /// [`least`, 2 `least`).
    #[must_use]
    fn split(self, least: Self) -> (Self, Self);

    /// 2^(n − 127) for the low byte n of the bits of an `f32`, from 0 to 254, or 2^(n − 1023) for the
    /// low eleven bits n of those of an `f64`, from 0 to 2046; +0 for n = 0.
    #[must_use]
    fn two_to_low_bits(self) -> Self;

    /// self − `shift`, for self = `shift` + n.
    #[inline]
    #[must_use]
    fn unshifted(self, shift: Self) -> Self {
        self - shift
    }
}

/// The bits of the sign and the exponent.
pub(crate) const EXPONENT: (i32, i64) = (-0x0080_0000, -0x0010_0000_0000_0000);

macro_rules! bits {
    ($float:ident $integer:ident $part:tt, $digits:literal) => {
        impl Bits for $float {
            #[inline]
            #[allow(clippy::pedantic)] // casts: only the bits matter, and e has eleven
            fn split(self, least: Self) -> (Self, Self) {
                let bits = self.to_bits() as $integer;
                let above = bits.wrapping_sub(least.to_bits() as $integer);
                let z = bits.wrapping_sub(above & EXPONENT.$part);
                let e = (above >> $digits) as i32;
                (e as $float, $float::from_bits(z as _))
            }

            #[inline]
            fn two_to_low_bits(self) -> Self {
                $float::from_bits(self.to_bits() << $digits)
            }
        }
    };
}

bits!(f32 i32 0, 23);
bits!(f64 i64 1, 52);

/// log₂ (z/d) = s P(s²), s = (z − d)/(z + d), for z/d in [√½, √2).
///
/// P is the minimax polynomial of degree 2, weighted for the relative error of log₂ c. That error is 2.0 ·
/// 2⁻²⁴ with exact coefficients, 2.5 · 2⁻²⁴ with these, and 5.91 · 2⁻²⁴ with all roundings, at c =
/// 0.8334765. Every c was tried, for d = 1.
const LOG: [f32; 3] = [
    2.885_390_5,  // 0x4038AA3D
    0.961_551_8,  // 0x3F762842
    0.597_326_93, // 0x3F18EA6B
];

/// 2^(1 + r) = (2 + r) + r Q(r) for r in [−½, ½].
///
/// Q is the minimax polynomial of degree 5, weighted for the absolute error of 2^y, y ≤ 0. That
/// error is 0.03 · 2⁻²⁴ with exact coefficients and with these, and 1.24 · 2⁻²⁴ with all roundings,
/// at y = −0.5114769; every y was tried.
const EXP: [f32; 6] = [
    0.386_294_43,     // 0x3EC5C862
    0.480_453_1,      // 0x3EF5FDF3
    0.111_006_565,    // 0x3DE35769
    0.019_235_516,    // 0x3C9D93CD
    0.002_679_750_8,  // 0x3B2F9EC2
    0.000_310_134_72, // 0x39A29994
];

/// Between 2²³ and 2²⁴ the `f32` numbers are the integers. Adding this constant therefore rounds a
/// small number to the nearest integer, with ties to even, and leaves that integer plus 126 in the
/// low bits.
const SHIFT: f32 = 12_583_038.0; // 1.5 · 2²³ + 126

/// cᵐ in single precision, for c in [0, 1] and a finite m ≥ 0.
///
/// The absolute error is below 2⁻²² for every c > 0, subnormal or not, and every m. 1ᵐ and c⁰ are
/// exactly 1. A result below 2^−125.5 becomes 0, so no result is subnormal, and a processor that
/// flushes subnormal numbers gives the same bits. The power of 0 is some number within [0, 1].
///
/// ```
/// use shading::number::power;
/// assert_eq!(power::single(0.5_f32, 3.0), 0.125);
/// ```
#[inline(always)]
#[must_use]
pub fn single<T: Bits>(c: T, m: T) -> T {
    exp2_single(m * log2_single(c, T::ONE))
}

/// (c/d)ᵐ, by one division in place of two, for c ≥ 0 and d > 0 whose products with 2²⁴ are finite. A
/// quotient above 1 counts as 1, and the power of NaN is 0.
///
/// ```
/// use shading::number::power;
/// assert_eq!(power::single_of_quotient(1.0_f32, 2.0, 3.0), 0.125);
/// ```
#[inline(always)]
#[must_use]
pub fn single_of_quotient<T: Bits>(c: T, d: T, m: T) -> T {
    exp2_single((m * log2_single(c, d)).at_most(T::ZERO))
}

/// log₂ (c/d).
#[inline(always)]
fn log2_single<T: Bits>(c: T, d: T) -> T {
    let of = T::of_f32;

    // Scaling by 2²⁴ is exact and makes even the least subnormal number normal. The quotient s does
    // not change.
    let scale = of(16_777_216.0);
    let (e, z) = (c * scale).split(d * of(11_863_283.0)); // 2²⁴ √½
    let d = d * scale;
    let s = (z - d) / (z + d);
    let x = s * s;
    let [p0, p1, p2] = LOG;
    e + s * ((of(p0) + x * of(p1)) + x * x * of(p2))
}

/// 2^y for y ≤ 0.
#[inline(always)]
fn exp2_single<T: Bits>(y: T) -> T {
    let of = T::of_f32;

    // y = n + r within [−126, 0]; the result is 2^(n − 1) 2^(1 + r), or 0 for n = −126
    let y = y.at_least(of(-126.0));
    let shifted = y + of(SHIFT);
    let r = y - shifted.unshifted(of(SHIFT));
    let x = r * r;
    let [q0, q1, q2, q3, q4, q5] = EXP;
    let pair = |a, b| of(a) + of(b) * r;
    let q = pair(q0, q1) + x * pair(q2, q3) + x * x * pair(q4, q5);
    ((of(2.0) + r) + r * q) * shifted.two_to_low_bits()
}

/// log₂ z as for single precision. P has degree 7; with these coefficients, the relative
/// error of log₂ c is below 2⁻⁵⁵.
const LOG_DOUBLE: [f64; 8] = [
    2.885_390_081_777_926_8,
    0.961_796_693_925_989_8,
    0.577_078_016_345_470_4,
    0.412_198_585_851_064_56,
    0.320_598_533_926_462_26,
    0.262_334_401_745_152,
    0.220_911_866_857_804_67,
    0.213_670_779_463_431_35,
];

/// 2^(1 + r) = 2 + 4r/(Q(r²) − r) for r in [−½, ½], because r(2^r + 1)/(2^r − 1) is even. Q has degree
/// 5; with these coefficients, the relative error is below 2⁻⁵⁶. A polynomial in r would need twice as
/// many terms.
const EXP_DOUBLE: [f64; 6] = [
    2.885_390_081_777_926_8,
    0.115_524_530_093_322_43,
    -0.000_925_068_477_691_848_2,
    1.058_218_826_580_622_2e-5,
    -1.271_012_696_423_044_7e-7,
    1.526_815_949_401_570_2e-9,
];

const SHIFT_DOUBLE: f64 = 6_755_399_441_056_766.0; // 1.5 · 2⁵² + 1022

/// cᵐ in double precision, as [`single`]. The absolute error is below 2⁻⁵¹, and a result below about
/// 2⁻¹⁰²² becomes 0.
///
/// ```
/// use shading::number::power;
/// assert_eq!(power::double(0.5_f64, 3.0), 0.125);
/// ```
#[inline(always)]
#[must_use]
pub fn double<T: Bits>(c: T, m: T) -> T {
    exp2_double(m * log2_double(c, T::ONE))
}

/// (c/d)ᵐ, as [`single_of_quotient`], for products with 2⁵³ that are finite.
///
/// ```
/// use shading::number::power;
/// assert_eq!(power::double_of_quotient(1.0_f64, 2.0, 3.0), 0.125);
/// ```
#[inline(always)]
#[must_use]
pub fn double_of_quotient<T: Bits>(c: T, d: T, m: T) -> T {
    exp2_double((m * log2_double(c, d)).at_most(T::ZERO))
}

#[inline(always)]
fn log2_double<T: Bits>(c: T, d: T) -> T {
    let of = T::of;

    let scale = of(9_007_199_254_740_992.0); // 2⁵³
    let (e, z) = (c * scale).split(d * of(6_369_051_672_525_773.0)); // 2⁵³ √½
    let d = d * scale;
    let s = (z - d) / (z + d);
    let x = s * s;
    let x2 = x * x;
    let [p0, p1, p2, p3, p4, p5, p6, p7] = LOG_DOUBLE;
    let pair = |a, b| of(a) + of(b) * x;
    let low = pair(p0, p1) + x2 * pair(p2, p3);
    let high = pair(p4, p5) + x2 * pair(p6, p7);
    e + s * (low + x2 * x2 * high)
}

#[inline(always)]
fn exp2_double<T: Bits>(y: T) -> T {
    let of = T::of;

    let y = y.at_least(of(-1022.0));
    let shifted = y + of(SHIFT_DOUBLE);
    let r = y - shifted.unshifted(of(SHIFT_DOUBLE));
    let x = r * r;
    let x2 = x * x;
    let [q0, q1, q2, q3, q4, q5] = EXP_DOUBLE;
    let pair = |a, b| of(a) + of(b) * x;
    let q = pair(q0, q1) + x2 * (pair(q2, q3) + x2 * pair(q4, q5));
    (of(2.0) + of(4.0) * r / (q - r)) * shifted.two_to_low_bits()
}
