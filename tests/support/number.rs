//! Tests are written once, as generic functions, and run for `f32` and `f64`.

use std::fmt::{Debug, Display, LowerExp};

use shading::{Attenuation, Cone, Elementary, Exponent, Ranged, SoftCone, UnitVec3, Vec3};

/// A number type that a test computes with: a float, or a number that carries its error bound.
pub trait Number: Elementary + PartialOrd + Exponent<Self> + Debug {
    /// An attenuation with the coefficients a, b, c.
    fn attenuation(coefficients: [f64; 3]) -> Option<Attenuation<Self>>;
    /// The cone with a half-angle in degrees.
    fn cone(degrees: f64) -> Option<Cone<Self>>;
    /// The soft cone with an inner and an outer half-angle in degrees.
    fn soft_cone(degrees: [f64; 2]) -> Option<SoftCone<Self>>;
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
    fn new_attenuation(a: Self, b: Self, c: Self) -> Option<Attenuation<Self>>;
    fn cone_from_half_angle(radians: Self) -> Option<Cone<Self>>;
    fn cone_from_cosine(cosine: Self) -> Option<Cone<Self>>;
    fn soft_cone_from_half_angles(inner: Self, outer: Self) -> Option<SoftCone<Self>>;
    fn soft_cone_from_cosines(inner: Self, outer: Self) -> Option<SoftCone<Self>>;
    fn within(attenuation: Attenuation<Self>, range: Self) -> Option<Ranged<Self>>;
    fn direction(x: Self, y: Self, z: Self) -> Option<UnitVec3<Self>>;
    fn normalized(x: Self, y: Self, z: Self) -> Option<UnitVec3<Self>>;

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
        impl Number for $float {
            #[allow(clippy::cast_possible_truncation, clippy::cast_lossless)]
            fn attenuation([a, b, c]: [f64; 3]) -> Option<Attenuation<Self>> {
                Attenuation::<$float>::new(a as $float, b as $float, c as $float)
            }

            #[allow(clippy::cast_possible_truncation, clippy::cast_lossless)]
            fn cone(degrees: f64) -> Option<Cone<Self>> {
                // π rounds up in f32, and must stay in the valid range
                let radians = (degrees.to_radians() as $float).min(core::$float::consts::PI);
                Cone::<$float>::from_half_angle(radians)
            }

            #[allow(clippy::cast_possible_truncation, clippy::cast_lossless)]
            fn soft_cone(degrees: [f64; 2]) -> Option<SoftCone<Self>> {
                let [inner, outer] = degrees
                    .map(|angle| (angle.to_radians() as $float).min(core::$float::consts::PI));
                SoftCone::<$float>::from_half_angles(inner, outer)
            }
        }

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

            fn new_attenuation(a: Self, b: Self, c: Self) -> Option<Attenuation<Self>> {
                Attenuation::<$float>::new(a, b, c)
            }

            fn cone_from_half_angle(radians: Self) -> Option<Cone<Self>> {
                Cone::<$float>::from_half_angle(radians)
            }

            fn cone_from_cosine(cosine: Self) -> Option<Cone<Self>> {
                Cone::<$float>::from_cosine(cosine)
            }

            fn soft_cone_from_half_angles(inner: Self, outer: Self) -> Option<SoftCone<Self>> {
                SoftCone::<$float>::from_half_angles(inner, outer)
            }

            fn soft_cone_from_cosines(inner: Self, outer: Self) -> Option<SoftCone<Self>> {
                SoftCone::<$float>::from_cosines(inner, outer)
            }

            fn within(attenuation: Attenuation<Self>, range: Self) -> Option<Ranged<Self>> {
                attenuation.within(range)
            }

            fn direction(x: Self, y: Self, z: Self) -> Option<UnitVec3<Self>> {
                UnitVec3::<$float>::new(x, y, z)
            }

            fn normalized(x: Self, y: Self, z: Self) -> Option<UnitVec3<Self>> {
                UnitVec3::<$float>::normalized(x, y, z)
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

/// Runs each generic test, by name, for `f32` and for `f64`.
#[macro_export]
macro_rules! for_f32_and_f64 {
    ($($(#[$attribute:meta])* $test:ident),+ $(,)?) => {
        mod f32 { $(#[test] $(#[$attribute])* fn $test() { super::$test::<f32>(); })+ }
        mod f64 { $(#[test] $(#[$attribute])* fn $test() { super::$test::<f64>(); })+ }
    };
}
pub use for_f32_and_f64;
