//! The elementary functions, for writing surfaces.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, SQRT_2};

use crate::real::{Real, Select, by_squaring, constant, magnitude, parts};

/// The functions, beyond those of [`Real`], that surfaces are written with. sin, cos, exp and ln are
/// required; the others are derived from them. [`Dual`](crate::Dual) has all of them without an import.
///
/// The formulas of illumination use none of them. [`normal::implicit`](crate::normal::implicit) and
/// [`normal::parametric`](crate::normal::parametric) differentiate through all of them.
///
/// For `f32` and `f64` they come from `libm`, so they have the same bits on every machine. In code
/// that is generic over `T`, `x.sin()` is this trait's; in `f32` or `f64`, the standard library's
/// method of that name comes first, and its bits differ between machines: write
/// `Elementary::sin(x)`. `libm`'s `sinf` and `cosf` compute in double precision internally.
///
/// ```
/// use shading::{Elementary, Vec3};
///
/// /// The gyroid: write it once, march rays with `f32`, take normals with `Dual<f32>`.
/// fn gyroid<T: Elementary>(p: Vec3<T>) -> T {
///     p.x.sin() * p.y.cos() + p.y.sin() * p.z.cos() + p.z.sin() * p.x.cos()
/// }
/// assert_eq!(gyroid(Vec3::new(0.0_f32, 0.0, 0.0)), 0.0);
/// ```
pub trait Elementary: Real {
    /// The sine of an angle in radians.
    #[must_use]
    fn sin(self) -> Self;
    /// The cosine of an angle in radians.
    #[must_use]
    fn cos(self) -> Self;
    /// e to the power of `self`.
    #[must_use]
    fn exp(self) -> Self;
    /// The natural logarithm: −∞ at 0, NaN below 0.
    #[must_use]
    fn ln(self) -> Self;

    /// The tangent of an angle in radians.
    #[inline]
    #[must_use]
    fn tan(self) -> Self {
        self.sin() / self.cos()
    }

    /// The angle within [−π, π] from the x axis to the point (x, y), where `self` is y. At the origin,
    /// it is 0 or ±π for floats, by the signs of their zeros, and unspecified for other numbers.
    #[inline]
    #[must_use]
    fn atan2(self, x: Self) -> Self {
        let angle = angle(magnitude(self), x);
        Self::ZERO.above(self).select(-angle, angle)
    }

    /// A real power.
    #[inline]
    #[must_use]
    fn powf(self, exponent: Self) -> Self {
        (exponent * self.ln()).exp()
    }

    /// The absolute value. Its derivative at 0 is taken to be 0, the mean of the slopes on the two
    /// sides.
    #[inline]
    #[must_use]
    fn abs(self) -> Self {
        // 0, −0 and NaN are neither above nor below 0; NaN stays NaN
        let otherwise = Self::ZERO.above(self).select(-self, self + -self);
        self.above(Self::ZERO).select(self, otherwise)
    }

    /// An integer power, computed by repeated squaring. A negative exponent gives 1 over the
    /// positive power. The power 0 is 1 for every base, even for 0 and NaN.
    #[inline]
    #[must_use]
    fn powi(self, exponent: i32) -> Self {
        let power = by_squaring(self, exponent.unsigned_abs());
        if exponent < 0 {
            Self::ONE / power
        } else {
            power
        }
    }
}

macro_rules! elementary {
    ($float:ident: $($method:ident($($other:ident)?) $function:path),*) => {
        impl Elementary for $float {
            $(#[inline]
            fn $method(self $(, $other: Self)?) -> Self {
                $function(self $(, $other)?)
            })*
        }
    };
}

elementary!(f32: sin() libm::sinf, cos() libm::cosf, tan() libm::tanf, atan2(x) libm::atan2f,
    exp() libm::expf, ln() libm::logf, powf(exponent) libm::powf);
elementary!(f64: sin() libm::sin, cos() libm::cos, tan() libm::tan, atan2(x) libm::atan2,
    exp() libm::exp, ln() libm::log, powf(exponent) libm::pow);

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
    let [tan_pi_8, tan_3_pi_8] = [
        constant(const { parts(SQRT_2 - 1.0) }),
        constant(const { parts(SQRT_2 + 1.0) }),
    ];
    let toward_x = magnitude(cosine);
    let sign = cosine.above(T::ZERO).select(T::ONE, T::NEG_ONE);
    let x = (toward_x * tan_3_pi_8).above(sine).select(sign, T::ZERO);
    let y = sine.above(toward_x * tan_pi_8).select(T::ONE, T::ZERO);

    let [quarter, half] = [
        constant(const { parts(FRAC_PI_4) }),
        constant(const { parts(FRAC_PI_2) }),
    ];
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
    // sums of few terms do not wait for each other, as those of Horner's scheme do
    let z = t * t;
    let z2 = z * z;
    let z4 = z2 * z2;
    let two = |a, b| constant::<T>(a) + z * constant(b);
    let first = two(C[0], C[1]) + z2 * two(C[2], C[3]);
    let second = two(C[4], C[5]) + z2 * two(C[6], C[7]);
    let third = two(C[8], C[9]) + z2 * constant(C[10]);
    t + t * (z * (first + z4 * (second + z4 * third)))
}
