//! The elementary functions, for writing surfaces.

use super::{Mask, Real, angle, by_squaring, magnitude};

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
