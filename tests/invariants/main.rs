//! The invariants of local illumination, as properties of every number type.
//!
//! Each property is a generic function over [`Number`](number::Number), and each file ends with a
//! list of its properties, which [`invariants!`] turns into tests for each number type. To run them
//! for a type of your own, see `docs/invariants.md`.
//!
//! Tolerances are in units of u, the unit roundoff, and each has its reason beside it. Results
//! without a tolerance are compared bit for bit.

#![allow(clippy::float_cmp)] // floats are compared exactly, on purpose
#![allow(clippy::cast_precision_loss)] // counts of lights

mod check;
mod exact;
mod generators;
mod number;
mod short;

/// Makes a test of each property for each number type.
macro_rules! invariants {
    ($($property:ident,)*) => {
        invariants!(f32 as single: $($property,)*);
        invariants!(f64 as double: $($property,)*);
        invariants!(shading::Dual<f64> as dual: $($property,)*);
        invariants!(crate::short::Short as short: $($property,)*);
    };
    (of numbers with real powers: $($property:ident,)*) => {
        invariants!(f32 as single_with_powers: $($property,)*);
        invariants!(f64 as double_with_powers: $($property,)*);
        invariants!(crate::short::Short as short_with_powers: $($property,)*);
    };
    (of lights in lanes: $($property:ident,)*) => {
        invariants!(wide::f32x4 as four: $($property,)*);
        invariants!(wide::f32x8 as eight: $($property,)*);
        invariants!(wide::f64x4 as four_of_double: $($property,)*);
    };
    ($number:ty as $module:ident: $($property:ident,)*) => {
        mod $module {
            $(
                #[test]
                fn $property() {
                    super::$property::<$number>();
                }
            )*
        }
    };
}

mod derived;
mod direction;
mod dual;
mod edge;
mod encoding;
mod energy;
#[cfg(feature = "wide")]
mod lanes;
mod light;
mod lobe;
mod motion;
mod shade;
mod surface;
mod triangle;
mod width;
