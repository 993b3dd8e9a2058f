//! The angle between two directions, by + − × ÷ alone.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, SQRT_2};

use super::{Mask, Real, constant, magnitude, parts};

/// The angle θ within [0, π], given its sine and its cosine, both times the same number.
///
/// ```text
/// θ = b + arctan((x sin θ − y cos θ)/(x cos θ + y sin θ))
/// ```
///
/// Here b is the multiple of π/4 nearest to θ. (x, y) is its direction: x is 1, 0 or −1, and y is 1
/// or 0, which makes the products exact.
#[inline]
pub(crate) fn angle<T: Real>(sine: T, cosine: T) -> T {
    let tan_pi_8 = constant(const { parts(SQRT_2 - 1.0) });
    let tan_3_pi_8 = constant(const { parts(SQRT_2 + 1.0) });
    let toward_x = magnitude(cosine);
    let sign = cosine.above(T::ZERO).select(T::ONE, T::NEG_ONE);
    let x = (toward_x * tan_3_pi_8).above(sine).select(sign, T::ZERO);
    let y = sine.above(toward_x * tan_pi_8).select(T::ONE, T::ZERO);

    let quarter = constant(const { parts(FRAC_PI_4) });
    let half: T = constant(const { parts(FRAC_PI_2) });
    let b = half - x * (half - y * quarter);
    b + arctangent((x * sine - y * cosine) / (x * cosine + y * sine))
}

/// arctan t for |t| ≤ tan π/8, by the first twelve terms of a series of Chebyshev polynomials.
///
/// ```text
/// arctan t = 2 Σ (−1)ᵏ τ²ᵏ⁺¹/(2k + 1) · T₂ₖ₊₁(t/tan π/8),  τ = tan π/16
/// ```
///
/// The other terms sum to less than 2⁻⁵⁵ of the result. `benches/minimax.py` computes the
/// coefficients of the powers of t.
///
/// Source: Charles W. Clenshaw, *Chebyshev Series for Mathematical Functions*, 1962.
#[inline]
fn arctangent<T: Real>(t: T) -> T {
    const C: [[f32; 3]; 11] = [
        parts(-0.333_333_333_333_324_3),
        parts(0.199_999_999_998_374_1),
        parts(-0.142_857_142_720_424_74),
        parts(0.111_111_104_658_496_84),
        parts(-0.090_908_902_051_649_43),
        parts(0.076_919_449_385_710_23),
        parts(-0.066_619_511_616_215_96),
        parts(0.058_403_740_045_694_916),
        parts(-0.050_085_507_013_288_32),
        parts(0.037_347_322_168_330_96),
        parts(-0.017_180_029_701_564_188),
    ];
    // these short sums are independent; in Horner's scheme, each step waits for the one before
    let z = t * t;
    let z2 = z * z;
    let z4 = z2 * z2;
    let two = |a, b| constant::<T>(a) + z * constant(b);
    let first = two(C[0], C[1]) + z2 * two(C[2], C[3]);
    let second = two(C[4], C[5]) + z2 * two(C[6], C[7]);
    let third = two(C[8], C[9]) + z2 * constant(C[10]);
    t + t * (z * (first + z4 * (second + z4 * third)))
}
