//! Points, directions and colors into lanes and back.

use super::Lanes;
use crate::color::Rgb;
use crate::vector::{UnitVec3, Vec3};

macro_rules! transposed {
    ($type:ident { $x:ident, $y:ident, $z:ident }) => {
        impl<L: Lanes> $type<L> {
            /// One value for each lane, from an array of as many: arrays of structures are what scenes and
            /// pictures hold.
            ///
            /// ```
            #[doc = concat!("use shading::", stringify!($type), ";")]
            /// use wide::f32x4;
            ///
            #[doc = concat!("let value = ", stringify!($type), "::new(1.0, 2.0, 3.0);")]
            #[doc = concat!("let doubled = ", stringify!($type), "::<f32x4>::from_lanes([value; 4]) * f32x4::splat(2.0);")]
            /// assert_eq!(doubled.to_lanes(), [value * 2.0; 4]);
            /// ```
            #[doc(alias("transpose", "gather"))]
            #[inline]
            pub fn from_lanes(values: L::Array<$type<L::Lane>>) -> Self {
                let values = values.as_ref();
                Self::new(
                    L::from_fn(|i| values[i].$x),
                    L::from_fn(|i| values[i].$y),
                    L::from_fn(|i| values[i].$z),
                )
            }

            /// The value in each lane.
            #[doc(alias("transpose", "scatter"))]
            #[inline]
            #[must_use]
            pub fn to_lanes(self) -> L::Array<$type<L::Lane>> {
                let ($x, $y, $z) = (self.$x.to_lanes(), self.$y.to_lanes(), self.$z.to_lanes());
                L::array(|i| $type::new($x.as_ref()[i], $y.as_ref()[i], $z.as_ref()[i]))
            }
        }
    };
}

transposed!(Vec3 { x, y, z });
transposed!(Rgb { r, g, b });

impl<L: Lanes> UnitVec3<L> {
    /// One direction for each lane; see [`Vec3::from_lanes`].
    #[inline]
    #[allow(clippy::needless_pass_by_value)] // as the others
    pub fn from_lanes(directions: L::Array<UnitVec3<L::Lane>>) -> Self {
        let directions = directions.as_ref();
        Self::assume_unit(Vec3::from_lanes(L::array(|i| *directions[i])))
    }

    /// The direction in each lane.
    #[inline]
    #[must_use]
    pub fn to_lanes(self) -> L::Array<UnitVec3<L::Lane>> {
        let vectors = Vec3::to_lanes(*self);
        L::array(|i| UnitVec3::assume_unit(vectors.as_ref()[i]))
    }
}
