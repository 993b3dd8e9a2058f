//! Floor 1: vectors, and vectors whose length was proved to be 1.

use core::ops::{Add, Deref, Mul, Neg, Sub};

use crate::componentwise::componentwise;
use crate::real::Real;

/// A vector or a point in space.
///
/// ```
/// use shading::Vec3;
///
/// let a = Vec3::new(1.0_f32, 2.0, 2.0);
/// assert_eq!(a + a, a * 2.0);
/// assert_eq!(a.dot(a), 9.0);
/// assert_eq!(a.unit().unwrap().dot(a), 3.0);
/// assert_eq!(Vec3::from([1.0, 2.0, 2.0]), a);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Vec3<T> {
    /// The first coordinate.
    pub x: T,
    /// The second coordinate.
    pub y: T,
    /// The third coordinate.
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
    /// The origin, and the vector without length.
    pub const ZERO: Self = Self::new(T::ZERO, T::ZERO, T::ZERO);

    /// The dot product a·b = x₁x₂ + y₁y₂ + z₁z₂, also with a [`UnitVec3`].
    #[inline]
    #[must_use]
    pub fn dot(self, other: impl Into<Self>) -> T {
        let other = other.into();
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// The cross product a×b: perpendicular to both, right-handed; exactly zero for a×a.
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

    /// The vector of length 1 in the same direction, v/|v|, right from the smallest subnormal to
    /// the largest finite number. `None` for the zero vector and where a component is infinite or
    /// not a number.
    ///
    /// ```
    /// use shading::Vec3;
    ///
    /// let n = Vec3::new(0.0_f32, 3e38, 0.0).unit();
    /// assert_eq!(n, Vec3::new(0.0, 1e-45, 0.0).unit());
    /// assert_eq!(Vec3::<f32>::ZERO.unit(), None);
    /// ```
    #[doc(alias = "normalize")]
    #[inline]
    #[must_use]
    pub fn unit(self) -> Option<UnitVec3<T>>
    where
        T: PartialOrd,
    {
        let tame = self.rescaled();
        let length = tame.dot(tame).sqrt();
        (length > T::ZERO && length <= T::MAX).then(|| UnitVec3(tame.divided(length)))
    }

    /// [`unit`](Vec3::unit), or `fallback` where there is none. Free of branches, so that it works
    /// in SIMD lanes too.
    #[doc(alias = "normalize_or")]
    #[inline]
    #[must_use]
    pub fn unit_or(self, fallback: UnitVec3<T>) -> UnitVec3<T> {
        let tame = self.rescaled();
        let length = tame.dot(tame).sqrt();
        // positive for a length that is neither zero nor infinite nor NaN
        let valid = length.if_positive(T::MAX / length, T::ZERO);
        let unit = tame.divided(valid.if_positive(length, T::ONE));
        let or = |a, b| valid.if_positive(a, b);
        UnitVec3(Self::new(
            or(unit.x, fallback.x),
            or(unit.y, fallback.y),
            or(unit.z, fallback.z),
        ))
    }

    #[inline]
    fn divided(self, length: T) -> Self {
        self.map(|component| component / length)
    }

    /// Whether |v|², given as `square`, over- or underflowed or may be inexact, in any lane.
    #[inline]
    pub(crate) fn is_extreme(square: T) -> bool {
        square.any_outside(T::ONE / T::RESCALE, T::RESCALE)
    }

    /// The same direction at a length whose square neither overflows nor vanishes. The factor is a
    /// power of two, so nothing is rounded.
    #[inline]
    pub(crate) fn rescaled(self) -> Self {
        if Self::is_extreme(self.dot(self)) {
            self * self.rescale_factor()
        } else {
            self
        }
    }

    /// The power of two by which [`rescaled`](Self::rescaled) multiplies.
    #[cold]
    #[inline(never)]
    pub(crate) fn rescale_factor(self) -> T {
        let [shrink, grow] = Self::rescale_factors(self.dot(self));
        shrink * grow
    }

    /// The same power of two for a |v|² as a factor of at most 1 and one of at least 1.
    #[inline]
    fn rescale_factors(square: T) -> [T; 2] {
        [
            T::RESCALE.if_above(square, T::ONE, T::ONE / T::RESCALE),
            (T::ONE / T::RESCALE).if_above(square, T::RESCALE, T::ONE),
        ]
    }

    /// The way from one point to another, [`rescaled`](Self::rescaled).
    #[inline]
    pub(crate) fn rescaled_way(from: Self, to: Self) -> Self {
        let way = to - from;
        let square = way.dot(way);
        if Self::is_extreme(square) {
            Self::rescaled_extreme_way(from, to)
        } else {
            way
        }
    }

    #[cold]
    #[inline(never)]
    fn rescaled_extreme_way(from: Self, to: Self) -> Self {
        let way = to - from;
        Self::extreme_way(from, to, way.dot(way)).0
    }

    /// [`rescaled_way`](Self::rescaled_way) where it is extreme, by its `square`, and the power of
    /// two. The points shrink before their difference is taken, which may overflow, and it grows
    /// afterwards, for they may be far out.
    #[inline]
    pub(crate) fn extreme_way(from: Self, to: Self, square: T) -> (Self, T) {
        let [shrink, grow] = Self::rescale_factors(square);
        ((to * shrink - from * shrink) * grow, shrink * grow)
    }
}

/// A vector of length 1: a direction.
///
/// All directions in this crate are of this type, and all of them point **away** from the surface.
/// Its field is private, so that its length was proved once, where it was made:
///
/// - [`Vec3::unit`] divides by the length;
/// - [`UnitVec3::known`] checks literals, in a constant at compile time;
/// - [`UnitVec3::assume_unit`] takes your word.
///
/// It dereferences to its [`Vec3`]: `n.x`, `*n * 2.0`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct UnitVec3<T>(Vec3<T>);

impl<T> UnitVec3<T> {
    /// Vouches for a vector that is known to have length 1, to rounding: one read from a file of
    /// normals, or rotated. A wrong word makes wrong colours, but no panic.
    #[doc(alias = "new_unchecked")]
    #[inline]
    #[must_use]
    pub const fn assume_unit(v: Vec3<T>) -> Self {
        Self(v)
    }

    /// The same direction over another number type; `f` gives the same number in that type.
    #[inline]
    #[must_use]
    pub fn map<U>(self, f: impl FnMut(T) -> U) -> UnitVec3<U> {
        UnitVec3(self.0.map(f))
    }
}

impl<T: Real> UnitVec3<T> {
    /// The direction of the first axis.
    pub const X: Self = Self(Vec3::new(T::ONE, T::ZERO, T::ZERO));
    /// The direction of the second axis.
    pub const Y: Self = Self(Vec3::new(T::ZERO, T::ONE, T::ZERO));
    /// The direction of the third axis.
    pub const Z: Self = Self(Vec3::new(T::ZERO, T::ZERO, T::ONE));
}

macro_rules! known {
    ($float:ident) => {
        impl UnitVec3<$float> {
            /// A direction that you know: `Some` where the length of (x, y, z) is 1 to rounding.
            /// In a constant, a vector of another length fails the build:
            ///
            /// ```
            /// use shading::UnitVec3;
            #[doc = concat!("const UP_AND_RIGHT: UnitVec3<", stringify!($float), "> =")]
            #[doc = concat!("    UnitVec3::<", stringify!($float), ">::known(0.6, 0.0, 0.8).unwrap();")]
            /// ```
            /// ```compile_fail
            /// # use shading::UnitVec3;
            #[doc = concat!("const TOO_LONG: UnitVec3<", stringify!($float), "> =")]
            #[doc = concat!("    UnitVec3::<", stringify!($float), ">::known(1.0, 0.0, 1.0).unwrap();")]
            /// ```
            #[inline]
            #[must_use]
            pub const fn known(x: $float, y: $float, z: $float) -> Option<Self> {
                // rounded literals are off by 1 epsilon and the sum by 2 more
                let excess = x * x + y * y + z * z - 1.0;
                if -4.0 * $float::EPSILON <= excess && excess <= 4.0 * $float::EPSILON {
                    Some(Self(Vec3::new(x, y, z)))
                } else {
                    None
                }
            }
        }
    };
}

known!(f32);
known!(f64);

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

impl<T: Real> Neg for UnitVec3<T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}
