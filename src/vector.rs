//! The operations of vectors of real numbers.

use core::iter::Sum;
use core::ops::{Add, Mul};

use crate::real::{Real, Select};
pub use crate::triple::Vec3;

impl<T: Real> Vec3<T> {
    /// The origin, and the vector of length 0.
    pub const ZERO: Self = Self::new(T::ZERO, T::ZERO, T::ZERO);

    /// The same number in each component.
    #[inline]
    pub const fn splat(value: T) -> Self {
        Self::new(value, value, value)
    }

    /// The distance between two points, |other − self|.
    #[inline]
    #[must_use]
    pub fn distance(self, other: Self) -> T {
        (other - self).length()
    }

    /// The point at the fraction t of the way to another, self + t (other − self).
    #[doc(alias = "mix")]
    #[inline]
    pub fn lerp(self, other: Self, t: T) -> Self {
        self + (other - self) * t
    }

    /// The dot product. `other` is a vector or a [`UnitVec3`](crate::UnitVec3).
    ///
    /// ```text
    /// a·b = a.x b.x + a.y b.y + a.z b.z
    /// ```
    ///
    /// If products overflow with opposite signs, the result is ∞ − ∞, which is NaN.
    #[inline]
    #[must_use]
    pub fn dot(self, other: impl Into<Self>) -> T {
        T::dot(self, other.into())
    }

    /// The cross product, perpendicular to both vectors and right-handed; `other` may be a
    /// [`UnitVec3`](crate::UnitVec3), as in [`dot`](Vec3::dot).
    ///
    /// ```text
    /// a × b = (a.y b.z − a.z b.y, a.z b.x − a.x b.z, a.x b.y − a.y b.x)
    /// ```
    ///
    /// a × a is exactly zero unless a product overflows. Then the result is ∞ − ∞, which is NaN.
    ///
    /// ```
    /// use shading::{UnitVec3, Vec3};
    /// assert_eq!(Vec3::new(2.0_f32, 0.0, 0.0).cross(UnitVec3::Y), Vec3::new(0.0, 0.0, 2.0));
    /// ```
    #[inline]
    pub fn cross(self, other: impl Into<Self>) -> Self {
        let other = other.into();
        Self::new(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }
}

macro_rules! number_first {
    ($type:ident $float:ident) => {
        impl Mul<$type<$float>> for $float {
            type Output = $type<$float>;
            #[inline]
            fn mul(self, value: $type<$float>) -> $type<$float> {
                value * self
            }
        }
    };
}

/// What a vector and a color can do if their numbers are real.
macro_rules! of_reals {
    ($type:ident { $x:ident, $y:ident, $z:ident }) => {
        impl<T: Real> $type<T> {
            /// Each component of `then` where the mask holds, and of `otherwise` elsewhere.
            #[inline]
            pub(crate) fn select(mask: T::Mask, then: Self, otherwise: Self) -> Self {
                Self::new(
                    mask.select(then.$x, otherwise.$x),
                    mask.select(then.$y, otherwise.$y),
                    mask.select(then.$z, otherwise.$z),
                )
            }
        }

        impl<T: Real> Sum for $type<T> {
            #[inline]
            fn sum<I: Iterator<Item = Self>>(iter: I) -> Self {
                iter.fold(Self::new(T::ZERO, T::ZERO, T::ZERO), Add::add)
            }
        }

        number_first!($type f32);
        number_first!($type f64);
    };
}

of_reals!(Vec3 { x, y, z });
pub(crate) use {number_first, of_reals};
