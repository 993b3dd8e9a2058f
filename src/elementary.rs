//! The elementary functions, for writing surfaces.

use crate::real::Real;
use crate::real::by_squaring;

/// The functions, beyond those of [`Real`], that surfaces are written with: sin, cos, exp, ln and
/// integer powers.
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

    /// The absolute value. Its derivative at 0 is taken to be 0, the mean of the slopes on the two
    /// sides.
    #[inline]
    #[must_use]
    fn abs(self) -> Self {
        // 0, −0 and NaN are neither above nor below 0; NaN stays NaN
        self.if_positive(self, (-self).if_positive(-self, self + -self))
    }

    /// An integer power, computed by repeated squaring. A negative exponent gives 1 over the
    /// positive power. The power 0 is 1 for every base, even for 0 and NaN.
    ///
    /// ```
    /// use shading::Elementary;
    ///
    /// assert_eq!(Elementary::powi(3.0_f32, 4), 81.0);
    /// assert_eq!(Elementary::powi(2.0_f32, -2), 0.25);
    /// ```
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
    ($float:ident, $sin:path, $cos:path, $exp:path, $ln:path) => {
        impl Elementary for $float {
            #[inline]
            fn sin(self) -> Self {
                $sin(self)
            }

            #[inline]
            fn cos(self) -> Self {
                $cos(self)
            }

            #[inline]
            fn exp(self) -> Self {
                $exp(self)
            }

            #[inline]
            fn ln(self) -> Self {
                $ln(self)
            }
        }
    };
}

elementary!(f32, libm::sinf, libm::cosf, libm::expf, libm::logf);
elementary!(f64, libm::sin, libm::cos, libm::exp, libm::log);
