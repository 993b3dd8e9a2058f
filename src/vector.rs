//! Vectors.

use core::iter::Sum;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use crate::componentwise::componentwise;
use crate::real::Real;

/// A vector or a point in space, with operators for sums, differences and scaling.
///
/// ```
/// use shading::Vec3;
///
/// let a = Vec3::new(1.0_f32, 2.0, 2.0);
/// assert_eq!(a + a, 2.0 * a);
/// assert_eq!(a.dot(a), 9.0);
/// assert_eq!(a.length(), 3.0);
/// assert_eq!(a.unit().unwrap().dot(a), 3.0);
/// assert_eq!(Vec3::from([1.0, 2.0, 2.0]), a);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Vec3<T = f32> {
    /// The x coordinate.
    pub x: T,
    /// The y coordinate.
    pub y: T,
    /// The z coordinate.
    pub z: T,
}

componentwise!(Vec3 { x, y, z });

impl<T: Real> Neg for Vec3<T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

impl<T: Real> Vec3<T> {
    /// The origin, and the vector of length 0.
    pub const ZERO: Self = Self::new(T::ZERO, T::ZERO, T::ZERO);

    /// The dot product. `other` is a vector or a [`UnitVec3`](crate::UnitVec3).
    ///
    /// ```text
    /// a·b = a.x b.x + a.y b.y + a.z b.z
    /// ```
    ///
    /// If products overflow with opposite signs, the result is ∞ − ∞, which is NaN.
    ///
    /// ```
    /// use shading::{UnitVec3, Vec3};
    /// assert_eq!(Vec3::new(1.0_f32, 2.0, 3.0).dot(UnitVec3::Z), 3.0);
    /// ```
    #[inline]
    #[must_use]
    pub fn dot(self, other: impl Into<Self>) -> T {
        T::dot(self.into(), other.into().into())
    }

    /// The cross product, perpendicular to both vectors and right-handed. `other` is a vector or a
    /// [`UnitVec3`](crate::UnitVec3).
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
    #[must_use]
    pub fn cross(self, other: impl Into<Self>) -> Self {
        let other = other.into();
        Self::new(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }

    /// The vector times a power of two that keeps its products within range.
    #[inline]
    pub(crate) fn rescaled(self) -> Self {
        self.rescaled_from(Self::ZERO).0
    }

    /// The vector from `origin` to this one, likewise, and the power.
    #[inline]
    pub(crate) fn rescaled_from(self, origin: Self) -> (Self, T) {
        let (rescaled, power) = T::rescaled_difference(self.into(), origin.into());
        (rescaled.into(), power)
    }
}
