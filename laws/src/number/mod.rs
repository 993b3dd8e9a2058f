//! The laws of light for a number type: over a hundred properties of the formulas of [`shading`], each
//! tried on a thousand random and degenerate cases.
//!
//! In the tests of the crate that defines the type, implement [`Number`] and write one line,
//! [`number!`](crate::number!). The page
//! [`shading::guide::invariants`](https://docs.rs/shading/latest/shading/guide/invariants/) shows both in
//! full, with what a failure looks like.
//!
//! Tolerances are in units of u, the unit roundoff, and each has its reason beside it. Where a float and
//! an evenly spaced type, such as a fixed-point number, round differently, each has its own. Results
//! without a tolerance are compared bit for bit.

#![allow(clippy::float_cmp)] // floats are compared exactly, on purpose
#![allow(clippy::cast_precision_loss)] // counts of lights

use std::fmt::Debug;

use shading::{Dual, Elementary, Exponent, Real};

/// Lists the properties of a file. Those below `[real powers]` need a type with such powers.
///
/// It defines a macro named after the file, which [`number!`](crate::number!) calls and which makes a test of
/// each property.
macro_rules! properties {
    ($file:ident: $($property:ident,)* $([real powers] $($of_real_powers:ident,)*)?) => {
        pub mod properties {
            $(
                pub fn $property<T: $crate::Number>() {
                    super::$property::<T>();
                }
            )*
            $($(
                pub fn $of_real_powers<T: $crate::number::RealPowers>() {
                    super::$of_real_powers::<T>();
                }
            )*)?
        }

        #[doc(hidden)]
        #[macro_export]
        macro_rules! $file {
            (integer) => {
                $crate::tests_of_file! { $file: $($property,)* }
            };
            (real) => {
                $crate::tests_of_file! { $file: $($property,)* $($($of_real_powers,)*)? }
            };
        }
    };
}

#[doc(hidden)]
pub mod cast;
#[doc(hidden)]
pub mod check;
#[doc(hidden)]
pub mod derived;
#[doc(hidden)]
pub mod direction;
#[doc(hidden)]
pub mod dual;
#[doc(hidden)]
pub mod edge;
#[doc(hidden)]
pub mod energy;
mod exact;
#[doc(hidden)]
pub mod generators;
#[doc(hidden)]
pub mod light;
#[doc(hidden)]
pub mod lobe;
#[doc(hidden)]
pub mod motion;
#[doc(hidden)]
pub mod shade;
#[doc(hidden)]
pub mod surface;
#[doc(hidden)]
pub mod tangent;
#[doc(hidden)]
pub mod triangle;
#[doc(hidden)]
pub mod width;

/// Tests a number type: makes a test of each property, in modules named after the topics.
///
/// A type whose [`Shininess`](Number::Shininess) is `u32` has no powers by real numbers. Say so, and the
/// properties of such powers are left out: `number!(MyFixed, integer powers);`.
///
/// ```test_harness,no_run
/// mod single {
///     shading_laws::number!(f32);
/// }
/// mod derivatives {
///     shading_laws::number!(shading::Dual<f64>, integer powers);
/// }
/// ```
///
/// The tests are then called `single::shade::no_light_is_negative`, and so on.
#[macro_export]
macro_rules! number {
    ($number:ty $(,)?) => {
        $crate::tests_of_number! { $number, real }
    };
    ($number:ty, integer powers $(,)?) => {
        $crate::tests_of_number! { $number, integer }
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! tests_of_number {
    ($number:ty, $powers:ident) => {
        type NumberUnderTest = $number;
        $crate::cast! { $powers }
        $crate::derived! { $powers }
        $crate::direction! { $powers }
        $crate::dual! { $powers }
        $crate::edge! { $powers }
        $crate::energy! { $powers }
        $crate::light! { $powers }
        $crate::lobe! { $powers }
        $crate::motion! { $powers }
        $crate::shade! { $powers }
        $crate::surface! { $powers }
        $crate::tangent! { $powers }
        $crate::triangle! { $powers }
        $crate::width! { $powers }
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! tests_of_file {
    ($file:ident: $($property:ident,)*) => {
        mod $file {
            $(
                #[test]
                fn $property() {
                    $crate::number::$file::properties::$property::<super::NumberUnderTest>();
                }
            )*
        }
    };
}

/// What the tests must know about a number type, beyond how it computes.
///
/// ```
/// use shading_laws::Number;
///
/// assert_eq!(1.0 + f32::U as f32, 1.0); // halfway to the next number, and rounded to even
/// assert_eq!(f32::TINY * 0.5, 0.0);
/// assert_eq!(f32::shininess(2.5).to_f64(), 2.5);
/// ```
pub trait Number: Elementary + PartialOrd + Debug + 'static {
    /// The unit roundoff u: half the distance from 1 to the next number above.
    const U: f64;
    /// Whether the distance from a number to the next is 2u everywhere, as in fixed point. A float is off by
    /// u of a result, an evenly spaced type by u itself, which is half a step.
    const EVENLY_SPACED: bool = false;
    /// The smallest positive number.
    const TINY: Self;
    /// The largest error of a power by a real number, in units of u. The base is at most 1. It is 0 if
    /// [`Shininess`](Number::Shininess) is `u32`: a power by m then has m roundings. An evenly spaced type
    /// with better integer powers states their error for m up to 128.
    const POWER_ERROR: f64;
    /// `Self` for a type with powers by real numbers, and `u32` for one without.
    type Shininess: Exponent<Self> + Debug;

    /// The shininess nearest to m, a multiple of ¼ from 0 to 10,000.
    fn shininess(m: f64) -> Self::Shininess;
    /// The same number, rounded if the type is wider than `f64`.
    fn to_f64(self) -> f64;
}

/// A number type with powers by real numbers.
#[doc(hidden)]
pub trait RealPowers: Number<Shininess = Self> + Exponent<Self> {}

impl<T: Number<Shininess = T> + Exponent<T>> RealPowers for T {}

impl Number for f32 {
    const U: f64 = 1.0 / 16_777_216.0; // 2⁻²⁴
    const TINY: Self = f32::from_bits(1);
    const POWER_ERROR: f64 = 4.0; // 2⁻²²
    type Shininess = Self;

    fn shininess(m: f64) -> Self {
        Self::of(m)
    }
    fn to_f64(self) -> f64 {
        self.into()
    }
}

impl Number for f64 {
    const U: f64 = f64::EPSILON / 2.0;
    const TINY: Self = f64::from_bits(1);
    const POWER_ERROR: f64 = 2.0; // libm: one unit in the last place
    type Shininess = Self;

    fn shininess(m: f64) -> Self {
        m
    }
    fn to_f64(self) -> f64 {
        self
    }
}

#[cfg(feature = "fixed")]
impl Number for shading::fixed::Fixed {
    const U: f64 = 1.0 / 131_072.0; // 2⁻¹⁷
    const EVENLY_SPACED: bool = true;
    const TINY: Self = Self::STEP;
    const POWER_ERROR: f64 = 1.02; // 0.51 steps
    type Shininess = u32;

    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    fn shininess(m: f64) -> u32 {
        m as u32
    }
    fn to_f64(self) -> f64 {
        self.into()
    }
}

/// The value of a dual number obeys every invariant; its gradient has invariants of its own in
/// `dual.rs`.
impl<T: Number> Number for Dual<T> {
    const U: f64 = T::U;
    const EVENLY_SPACED: bool = T::EVENLY_SPACED;
    const TINY: Self = Self::constant(T::TINY);
    const POWER_ERROR: f64 = 0.0;
    type Shininess = u32;

    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    fn shininess(m: f64) -> u32 {
        m as u32
    }
    fn to_f64(self) -> f64 {
        self.value.to_f64()
    }
}
