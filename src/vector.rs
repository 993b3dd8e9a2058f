//! Vectors, and the operations that they share with colors.

use core::iter::Sum;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

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
/// assert_eq!(Vec3::from([1.0, 2.0, 2.0]), a);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
#[must_use]
pub struct Vec3<T = f32> {
    /// The x coordinate.
    pub x: T,
    /// The y coordinate.
    pub y: T,
    /// The z coordinate.
    pub z: T,
}

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

    /// The point at the share t of the way to another, self + t (other − self).
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
        T::dot(self.into(), other.into().into())
    }

    /// The cross product, perpendicular to both vectors and right-handed, with either as for
    /// [`dot`](Vec3::dot).
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

impl<T: Real> Neg for Vec3<T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.map(|x| -x)
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

/// The operations that vectors and colors share.
macro_rules! componentwise {
    ($type:ident { $x:ident, $y:ident, $z:ident }) => {
        impl<T: Real> $type<T> {
            /// The value with these three components.
            #[inline]
            pub const fn new($x: T, $y: T, $z: T) -> Self {
                Self { $x, $y, $z }
            }
        }

        impl<T> $type<T> {
            /// Applies a function to each component.
            #[inline]
            pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> $type<U> {
                $type {
                    $x: f(self.$x),
                    $y: f(self.$y),
                    $z: f(self.$z),
                }
            }
        }

        impl<T: Real> Add for $type<T> {
            type Output = Self;
            #[inline]
            fn add(self, other: Self) -> Self {
                Self::new(self.$x + other.$x, self.$y + other.$y, self.$z + other.$z)
            }
        }

        impl<T: Real> Sub for $type<T> {
            type Output = Self;
            #[inline]
            fn sub(self, other: Self) -> Self {
                Self::new(self.$x - other.$x, self.$y - other.$y, self.$z - other.$z)
            }
        }

        impl<T: Real> Mul<T> for $type<T> {
            type Output = Self;
            #[inline]
            fn mul(self, factor: T) -> Self {
                self.map(|x| x * factor)
            }
        }

        impl<T: Real> Div<T> for $type<T> {
            type Output = Self;
            #[inline]
            fn div(self, divisor: T) -> Self {
                self.map(|x| x / divisor)
            }
        }

        number_first!($type f32);
        number_first!($type f64);

        impl<T: Real> AddAssign for $type<T> {
            #[inline]
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }

        impl<T: Real> Sum for $type<T> {
            #[inline]
            fn sum<I: Iterator<Item = Self>>(iter: I) -> Self {
                iter.fold(Self::new(T::ZERO, T::ZERO, T::ZERO), Add::add)
            }
        }

        impl<T> From<[T; 3]> for $type<T> {
            #[inline]
            fn from([$x, $y, $z]: [T; 3]) -> Self {
                Self { $x, $y, $z }
            }
        }

        impl<T> From<$type<T>> for [T; 3] {
            #[inline]
            fn from(value: $type<T>) -> Self {
                [value.$x, value.$y, value.$z]
            }
        }
    };
}

componentwise!(Vec3 { x, y, z });
pub(crate) use {componentwise, number_first};
