//! Vectors whose length is known to be 1.

use core::ops::{Add, Deref, Mul, Neg, Sub};

use super::Vec3;
use crate::number::triple::assign;
use crate::number::{Real, Scalar, const_sqrt, epsilon, magnitude};

/// A vector of length 1: a direction.
///
/// **It dereferences to its [`Vec3`]**, so you can use all fields and methods of the vector:
/// `n.dot(l)`, `n.x`, `*n * 2.0`.
///
/// All directions in this crate have this type and point **away** from the surface. The field is
/// private, so the length is checked once, where the direction is made:
///
/// - [`Vec3::unit`] divides a vector by its length.
/// - [`UnitVec3::new`] does so for coordinates, and keeps those of a vector that has the length 1 already.
/// - [`const_new`](UnitVec3#method.const_new) does the same in a constant.
/// - [`UnitVec3::assume_unit`] trusts the caller.
///
/// ```
/// use shading::f32::{UnitVec3, Vec3};
///
/// const UP: UnitVec3 = UnitVec3::Z;
/// let l = Vec3::new(0.0, 3.0, 4.0).unit().unwrap();
/// assert_eq!(UP.dot(l), 0.8);
/// assert_eq!(Vec3::ZERO.unit(), None);
/// ```
#[doc(alias = "direction")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
#[must_use]
pub struct UnitVec3<T = f32>(Vec3<T>);

impl<T> UnitVec3<T> {
    /// A direction whose length the caller guarantees to be 1 up to rounding, such as one that another
    /// library has just normalized. Nothing is checked, and nothing panics.
    ///
    /// If the length differs from 1, colors are wrong: Lambert's factor is that length times too bright,
    /// and a highlight its m-th power. A normal from a file needs [`Vec3::unit`], because formats do not
    /// promise a length: some programs write normals up to 2π long, and three bytes give a length that
    /// is off by up to 0.7 %, which takes four fifths from a highlight of m = 250.
    #[doc(alias = "new_unchecked")]
    #[inline]
    pub const fn assume_unit(v: Vec3<T>) -> Self {
        Self(v)
    }

    /// The same direction in another number type, as in `n.cast(f64::from)`. `f` converts each
    /// coordinate and may only round it.
    #[inline]
    pub fn cast<U>(self, f: impl FnMut(T) -> U) -> UnitVec3<U> {
        UnitVec3(self.0.map(f))
    }
}

impl<T: Real> UnitVec3<T> {
    /// The direction of the vector (x, y, z), of any length. It is `None` for the zero vector, and if a
    /// coordinate is infinite or NaN. In a constant, use [`const_new`](UnitVec3#method.const_new).
    ///
    /// A vector that has the length 1 up to rounding (|v|² within 4ε of 1) keeps its bits. Any other is
    /// divided by its length, as [`Vec3::unit`] does.
    ///
    /// ```
    /// use shading::UnitVec3;
    ///
    /// assert_eq!(UnitVec3::new(3.0, 0.0, 4.0), UnitVec3::new(0.6, 0.0, 0.8));
    /// assert_eq!(UnitVec3::new(0.6, 0.0, 0.8).unwrap().x, 0.6);
    /// assert_eq!(UnitVec3::new(0.0, 0.0, 0.0), None);
    /// ```
    #[doc(alias("normalize", "try_normalize"))]
    #[inline]
    #[must_use]
    pub fn new(x: T, y: T, z: T) -> Option<Self>
    where
        T: Scalar,
    {
        let two = T::ONE + T::ONE;
        let v = Vec3::new(x, y, z);
        let is_unit = magnitude(v.dot(v) - T::ONE) <= two * two * epsilon();
        if is_unit { Some(Self(v)) } else { v.unit() }
    }

    /// The direction of the x axis.
    pub const X: Self = Self(Vec3::new(T::ONE, T::ZERO, T::ZERO));
    /// The direction of the y axis.
    pub const Y: Self = Self(Vec3::new(T::ZERO, T::ONE, T::ZERO));
    /// The direction of the z axis.
    pub const Z: Self = Self(Vec3::new(T::ZERO, T::ZERO, T::ONE));
    /// The direction opposite to the x axis.
    pub const NEG_X: Self = Self(Vec3::new(T::NEG_ONE, T::ZERO, T::ZERO));
    /// The direction opposite to the y axis.
    pub const NEG_Y: Self = Self(Vec3::new(T::ZERO, T::NEG_ONE, T::ZERO));
    /// The direction opposite to the z axis.
    pub const NEG_Z: Self = Self(Vec3::new(T::ZERO, T::ZERO, T::NEG_ONE));
}

macro_rules! constants {
    ($float:ident) => {
        impl UnitVec3<$float> {
            /// [`new`](UnitVec3::new) for constants: the direction of the vector (x, y, z), of any length.
            ///
            /// It has the same bits, and is `None` in the same cases. At run time, `new` is faster.
            ///
            /// ```
            #[doc = concat!("use shading::", stringify!($float), "::UnitVec3;")]
            ///
            /// const DOWN_AND_ASIDE: UnitVec3 = UnitVec3::const_new(1.0, -3.0, 0.5).unwrap();
            /// assert_eq!(Some(DOWN_AND_ASIDE), UnitVec3::new(1.0, -3.0, 0.5));
            /// ```
            #[doc(alias = "normalize")]
            #[allow(clippy::cast_possible_truncation, clippy::cast_lossless)]
            #[must_use]
            pub const fn const_new(x: $float, y: $float, z: $float) -> Option<Self> {
                const LARGE: $float = <$float as Real>::EXTREME;
                let square = x * x + y * y + z * z;
                if (square - 1.0).abs() <= 4.0 * $float::EPSILON {
                    return Some(Self(Vec3::new(x, y, z)));
                }
                let scale = if square >= LARGE {
                    1.0 / LARGE
                } else if square < 1.0 / LARGE {
                    LARGE
                } else {
                    1.0
                };
                let (x, y, z) = (x * scale, y * scale, z * scale);
                let square = x * x + y * y + z * z;
                if square > 0.0 && square <= $float::MAX {
                    let length = const_sqrt(square as f64) as $float;
                    Some(Self(Vec3::new(x / length, y / length, z / length)))
                } else {
                    None
                }
            }
        }
    };
}

constants!(f32);
constants!(f64);

impl<T> Deref for UnitVec3<T> {
    type Target = Vec3<T>;
    #[inline]
    fn deref(&self) -> &Vec3<T> {
        &self.0
    }
}

impl<T> From<UnitVec3<T>> for Vec3<T> {
    #[inline]
    fn from(unit: UnitVec3<T>) -> Self {
        unit.0
    }
}

impl<T> From<UnitVec3<T>> for [T; 3] {
    #[inline]
    fn from(unit: UnitVec3<T>) -> Self {
        unit.0.into()
    }
}

/// The vector with this direction and the given length.
impl<T: Real> Mul<T> for UnitVec3<T> {
    type Output = Vec3<T>;
    #[inline]
    fn mul(self, length: T) -> Vec3<T> {
        self.0 * length
    }
}

macro_rules! with_vectors {
    ($($trait:ident $method:ident)*) => {$(
        impl<T: Real> $trait<UnitVec3<T>> for Vec3<T> {
            type Output = Self;
            #[inline]
            fn $method(self, direction: UnitVec3<T>) -> Self {
                self.$method(direction.0)
            }
        }
    )*};
}

with_vectors!(Add add Sub sub);
assign!([T] Vec3<T>, UnitVec3<T>: Add Sub);

impl<T: Real> Neg for UnitVec3<T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}
