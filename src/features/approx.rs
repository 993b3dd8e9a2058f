//! Comparison within a tolerance, number by number, with the traits of the `approx` crate.

use approx::{AbsDiffEq, RelativeEq, UlpsEq};

use crate::{IncidentLight, Real, Rgb, Shaded, UnitVec3, Vec3};

macro_rules! compare {
    ($type:ident $(in $number:ident)? { $([$($part:tt)+])+ }) => {
        impl<T: AbsDiffEq<Epsilon: Copy> $(+ $number)?> AbsDiffEq for $type<T> {
            type Epsilon = T::Epsilon;

            fn default_epsilon() -> T::Epsilon {
                T::default_epsilon()
            }

            fn abs_diff_eq(&self, other: &Self, epsilon: T::Epsilon) -> bool {
                $(self.$($part)+.abs_diff_eq(&other.$($part)+, epsilon))&&+
            }
        }

        impl<T: RelativeEq<Epsilon: Copy> $(+ $number)?> RelativeEq for $type<T> {
            fn default_max_relative() -> T::Epsilon {
                T::default_max_relative()
            }

            fn relative_eq(&self, other: &Self, epsilon: T::Epsilon, relative: T::Epsilon) -> bool {
                $(self.$($part)+.relative_eq(&other.$($part)+, epsilon, relative))&&+
            }
        }

        impl<T: UlpsEq<Epsilon: Copy> $(+ $number)?> UlpsEq for $type<T> {
            fn default_max_ulps() -> u32 {
                T::default_max_ulps()
            }

            fn ulps_eq(&self, other: &Self, epsilon: T::Epsilon, max_ulps: u32) -> bool {
                $(self.$($part)+.ulps_eq(&other.$($part)+, epsilon, max_ulps))&&+
            }
        }
    };
}

compare!(Vec3 { [x] [y] [z] });
compare!(UnitVec3 { [x] [y] [z] });
compare!(Rgb { [r] [g] [b] });
compare!(IncidentLight in Real { [l()] [intensity()] [distance()] });
compare!(Shaded { [ambient] [diffuse] [specular] });
