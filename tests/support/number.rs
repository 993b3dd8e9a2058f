//! Tests are written once, as generic functions, and run for `f32` and `f64`.

use std::fmt::{Debug, Display, LowerExp};

use shading::{Attenuation, Cone, Elementary, Exponent, UnitVec3, Vec3};

/// A number type that a test computes with: a float, or a number that carries its error bound.
pub trait Number: Elementary + PartialOrd + Exponent<Self> + Debug {
    /// An attenuation with the coefficients a, b, c.
    fn attenuation(coefficients: [f64; 3]) -> Option<Attenuation<Self>> {
        let [a, b, c] = coefficients.map(Self::of);
        Attenuation::of(a, b, c)
    }

    /// The cone with a half-angle in degrees.
    fn cone(degrees: f64) -> Option<Cone<Self>> {
        let degrees = [degrees, degrees];
        Self::soft_cone(degrees)
    }

    /// The soft cone with an inner and an outer half-angle in degrees.
    fn soft_cone(degrees: [f64; 2]) -> Option<Cone<Self>> {
        let [inner, outer] = degrees.map(f64::to_radians);
        Cone::<f64>::from_half_angles(inner, outer).map(|cone| cone.cast(Self::of))
    }
}

/// `f32` or `f64`.
pub trait Float: Number + Into<f64> + Display + LowerExp + Debug + Default + 'static {
    const NAME: &str;
    /// The unit roundoff u: half the distance from 1 to the next larger number.
    const U: f64;
    /// The smallest subnormal number.
    const TINIEST: f64;
    /// The smallest normal number.
    const MIN_POSITIVE: f64;
    const INFINITY: Self;
    const NAN: Self;

    fn to_f64(self) -> f64;
    fn normalized(x: Self, y: Self, z: Self) -> Option<UnitVec3<Self>>;
    fn half_angles(inner: Self, outer: Self) -> Option<Cone<Self>>;

    fn is_finite(self) -> bool {
        self.to_f64().is_finite()
    }

    /// Whether `x` is within the normal range of the type, so that it differs from a number of the
    /// type only by rounding.
    fn in_range(x: f64) -> bool {
        x == 0.0 || Self::of(x).to_f64() == x || {
            Self::of(x).is_finite() && x.abs() >= Self::MIN_POSITIVE
        }
    }
}

macro_rules! float {
    ($float:ident) => {
        impl Number for $float {}

        impl Float for $float {
            const NAME: &str = stringify!($float);
            #[allow(clippy::cast_lossless)]
            const U: f64 = $float::EPSILON as f64 / 2.0;
            #[allow(clippy::cast_lossless)]
            const TINIEST: f64 = $float::from_bits(1) as f64;
            #[allow(clippy::cast_lossless)]
            const MIN_POSITIVE: f64 = $float::MIN_POSITIVE as f64;
            const INFINITY: Self = $float::INFINITY;
            const NAN: Self = $float::NAN;

            #[allow(clippy::cast_lossless)]
            fn to_f64(self) -> f64 {
                self as f64
            }

            fn normalized(x: Self, y: Self, z: Self) -> Option<UnitVec3<Self>> {
                UnitVec3::<$float>::normalized(x, y, z)
            }

            fn half_angles(inner: Self, outer: Self) -> Option<Cone<Self>> {
                Cone::<$float>::from_half_angles(inner, outer)
            }
        }
    };
}

float!(f32);
float!(f64);

/// The vector of the numbers nearest to these.
pub fn vector<T: Number>(xyz: [f64; 3]) -> Vec3<T> {
    Vec3::from(xyz).map(T::of)
}

/// The direction of this vector, normalized in `T`.
pub fn direction<T: Number>(xyz: [f64; 3]) -> UnitVec3<T> {
    vector::<T>(xyz).unit().expect("a direction")
}

/// Distances at the ends of the range and between, whose squares may leave it.
pub fn distances<T: Float>() -> [f64; 7] {
    let largest = T::MAX.to_f64();
    [
        T::TINIEST,
        T::MIN_POSITIVE,
        1e-30,
        1e-15,
        1e15,
        1e30,
        largest,
    ]
}

/// Runs each generic test, by name, for `f32` and for `f64`.
#[macro_export]
macro_rules! for_f32_and_f64 {
    ($($(#[$attribute:meta])* $test:ident),+ $(,)?) => {
        mod f32 { $(#[test] $(#[$attribute])* fn $test() { super::$test::<f32>(); })+ }
        mod f64 { $(#[test] $(#[$attribute])* fn $test() { super::$test::<f64>(); })+ }
    };
}
pub use for_f32_and_f64;
