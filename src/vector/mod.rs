//! Vectors of real numbers, and those whose length is known to be 1.

mod unit;

use core::iter::Sum;
use core::ops::Add;

pub use crate::number::triple::Vec3;
use crate::number::{Mask, Measured, Real, Scalar};
pub use unit::UnitVec3;

impl<T: Real> Vec3<T> {
    /// The origin, and the vector of length 0.
    pub const ZERO: Self = Self::new(T::ZERO, T::ZERO, T::ZERO);

    /// The same number in each component.
    #[inline]
    pub const fn splat(value: T) -> Self {
        Self::new(value, value, value)
    }

    /// The length of the vector.
    ///
    /// ```text
    /// |v| = √(v·v)
    /// ```
    ///
    /// The result is accurate from the smallest subnormal number to the largest finite one, which it
    /// is, too, if it overflows. It is infinite if a component is infinite.
    ///
    /// ```
    /// use shading::Vec3;
    /// assert_eq!(Vec3::new(2.0_f32, 3.0, 6.0).length(), 7.0);
    /// assert_eq!(Vec3::new(0.0_f32, 3e30, 4e30).length(), 5e30);
    /// ```
    #[doc(alias("magnitude", "norm"))]
    #[inline]
    #[must_use]
    pub fn length(self) -> T {
        T::measured(self).length
    }

    /// The direction of the vector: the vector of length 1 that points the same way.
    ///
    /// ```text
    /// v / |v|
    /// ```
    ///
    /// The result is accurate from the smallest subnormal vector to the largest finite one. It is
    /// `None` for the zero vector, and if a component is infinite or NaN.
    ///
    /// ```
    /// use shading::Vec3;
    ///
    /// let n = Vec3::new(0.0_f32, 3e38, 0.0).unit();
    /// assert_eq!(n, Vec3::new(0.0, 1e-45, 0.0).unit());
    /// assert_eq!(Vec3::<f32>::ZERO.unit(), None);
    /// ```
    #[doc(alias("normalize", "try_normalize"))]
    #[inline]
    #[must_use]
    pub fn unit(self) -> Option<UnitVec3<T>>
    where
        T: Scalar,
    {
        let Measured { w, w_length, .. } = T::measured(self);
        // not `>`, which is a library call without an FPU
        let has_direction = w_length.above(T::ZERO).any();
        has_direction.then(|| UnitVec3::assume_unit(w / w_length))
    }

    /// [`unit`](Vec3::unit), or `fallback` if that is `None`. This method does not branch on the
    /// result, so it also works in SIMD lanes.
    ///
    /// ```
    /// use shading::{UnitVec3, Vec3};
    /// assert_eq!(Vec3::<f32>::ZERO.unit_or(UnitVec3::X), UnitVec3::X);
    /// ```
    #[doc(alias = "normalize_or")]
    #[inline]
    pub fn unit_or(self, fallback: UnitVec3<T>) -> UnitVec3<T> {
        self.unit_or_with_length(fallback).0
    }

    /// [`unit_or`](Vec3::unit_or) and the length, computed with a single square root.
    #[inline]
    pub(crate) fn unit_or_with_length(self, fallback: UnitVec3<T>) -> (UnitVec3<T>, T) {
        let measured = T::measured(self);
        let has_direction = measured.w_length.above(T::ZERO);
        let unit = Vec3::select(has_direction, measured.w / measured.w_length, *fallback);
        (UnitVec3::assume_unit(unit), measured.length)
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

    /// The dot product. `other` is a vector or a [`UnitVec3`](UnitVec3).
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
    /// [`UnitVec3`](UnitVec3), as in [`dot`](Vec3::dot).
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
    ($number:ty: $($type:ty)+) => {$(
        impl core::ops::Mul<$type> for $number {
            type Output = $type;
            #[inline]
            fn mul(self, value: $type) -> $type {
                value * self
            }
        }
    )+};
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

        number_first!(f32: $type<f32>);
        number_first!(f64: $type<f64>);
    };
}

of_reals!(Vec3 { x, y, z });
pub(crate) use {number_first, of_reals};
