//! Comparison within a tolerance, component by component, for tests with the `approx` crate.

use approx::{AbsDiffEq, RelativeEq, UlpsEq};

use crate::{Rgb, UnitVec3, Vec3};

macro_rules! compare {
    ($type:ident { $x:ident, $y:ident, $z:ident }) => {
        impl<T: AbsDiffEq<Epsilon: Copy>> AbsDiffEq for $type<T> {
            type Epsilon = T::Epsilon;

            fn default_epsilon() -> T::Epsilon {
                T::default_epsilon()
            }

            fn abs_diff_eq(&self, other: &Self, epsilon: T::Epsilon) -> bool {
                self.$x.abs_diff_eq(&other.$x, epsilon)
                    && self.$y.abs_diff_eq(&other.$y, epsilon)
                    && self.$z.abs_diff_eq(&other.$z, epsilon)
            }
        }

        impl<T: RelativeEq<Epsilon: Copy>> RelativeEq for $type<T> {
            fn default_max_relative() -> T::Epsilon {
                T::default_max_relative()
            }

            fn relative_eq(&self, other: &Self, epsilon: T::Epsilon, relative: T::Epsilon) -> bool {
                self.$x.relative_eq(&other.$x, epsilon, relative)
                    && self.$y.relative_eq(&other.$y, epsilon, relative)
                    && self.$z.relative_eq(&other.$z, epsilon, relative)
            }
        }

        impl<T: UlpsEq<Epsilon: Copy>> UlpsEq for $type<T> {
            fn default_max_ulps() -> u32 {
                T::default_max_ulps()
            }

            fn ulps_eq(&self, other: &Self, epsilon: T::Epsilon, max_ulps: u32) -> bool {
                self.$x.ulps_eq(&other.$x, epsilon, max_ulps)
                    && self.$y.ulps_eq(&other.$y, epsilon, max_ulps)
                    && self.$z.ulps_eq(&other.$z, epsilon, max_ulps)
            }
        }
    };
}

compare!(Vec3 { x, y, z });
compare!(UnitVec3 { x, y, z });
compare!(Rgb { r, g, b });
