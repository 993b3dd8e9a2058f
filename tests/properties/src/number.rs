//! What the properties must know of a number.

use core::fmt::Debug;

use shading::{Dual, Real};

/// A number to try: how far apart its values are, and how far they go.
pub trait Number: Real + PartialOrd + Debug + 'static {
    /// The largest error of a rounding, relative to the result: half the distance from 1 to the
    /// next number, or 0 in fixed point.
    const U: f64;
    /// The smallest number above 0.
    const SMALLEST: f64;
    /// `MAX`, for constants.
    const LARGEST: f64;
    /// `EXTREME`, for constants.
    const LARGE: f64;
    /// The largest error of a rounding near 0: half the distance from 0 to the next number, or half
    /// a step.
    const STEP: f64 = Self::SMALLEST / 2.0;
    /// The error of its own hooks of `Real`, relative to the result, beyond those of its operations.
    const HOOK: f64 = 0.0;
    /// The error of the cosine that its hook for cones computes: in a number of few digits, L is shorter or longer
    /// than 1, and the hook may measure it.
    const COSINE: f64 = 0.0;
    /// Whether a product with a power of two is exact, as in a binary float.
    const DOUBLES_EXACTLY: bool = true;

    fn exact(self) -> f64;
}

macro_rules! floats {
    ($($number:ty: $float:ident, $exact:expr;)*) => {$(
        #[allow(clippy::cast_lossless)]
        impl Number for $number {
            const U: f64 = $float::EPSILON as f64 / 2.0;
            const SMALLEST: f64 = $float::from_bits(1) as f64;
            const LARGEST: f64 = $float::MAX as f64;
            const LARGE: f64 = <$float as Real>::EXTREME as f64;

            fn exact(self) -> f64 {
                $exact(self)
            }
        }
    )*};
}

floats! {
    f32: f32, f64::from;
    f64: f64, f64::from;
    Dual<f64>: f64, |x: Self| x.value;
}

#[cfg(feature = "fixed")]
impl Number for shading::fixed::Fixed {
    const U: f64 = 0.0;
    const SMALLEST: f64 = 1.0 / 65_536.0;
    const LARGEST: f64 = 32_768.0 - Self::SMALLEST;
    const LARGE: f64 = 512.0;
    const HOOK: f64 = 1.0 / 16_777_216.0; // a reciprocal of 24 bits
    const COSINE: f64 = 0.9 * Self::SMALLEST; // L is off by half a step along each axis: by √3/2 at most
    const DOUBLES_EXACTLY: bool = false;

    fn exact(self) -> f64 {
        self.into()
    }
}
