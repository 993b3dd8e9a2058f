//! Three numbers side by side: vectors and colors, and the operators that they share. Nothing here
//! needs more of a number than its operators.

use core::ops::{Add, Div, Mul, Neg, Sub};

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

/// A color: linear light, or the reflectance of a material, in three channels.
///
/// The numbers are proportional to power: they are not encoded and may exceed 1.
/// [`from_srgb8`](Rgb::from_srgb8) decodes the bytes of a texture before shading.
/// [`to_srgb8`](Rgb::to_srgb8) and [`to_rgb565`](Rgb::to_rgb565) clamp and encode once, after the
/// sum.
///
/// ```
/// use shading::Rgb;
///
/// let lamp = Rgb::new(1.0_f32, 0.9, 0.7);
/// let brick = Rgb::new(0.6, 0.2, 0.1);
/// let reflected = lamp * brick; // channel by channel
/// assert_eq!(reflected, Rgb::from([0.6, 0.9 * 0.2, 0.7 * 0.1]));
/// ```
#[doc(alias("color", "colour"))]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
#[must_use]
pub struct Rgb<T = f32> {
    /// Red.
    pub r: T,
    /// Green.
    pub g: T,
    /// Blue.
    pub b: T,
}

impl<T: Neg<Output = T>> Neg for Vec3<T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.map(|x| -x)
    }
}

/// `a -= b` and its like for a type and another, for which `a - b` is of the first type. One for each pair
/// of types, because the compiler infers the numbers of `sum += v` from v only then.
macro_rules! assign {
    (Add $($of:tt)*) => { $crate::number::triple::assign!(AddAssign add_assign Add add $($of)*); };
    (Sub $($of:tt)*) => { $crate::number::triple::assign!(SubAssign sub_assign Sub sub $($of)*); };
    (Mul $($of:tt)*) => { $crate::number::triple::assign!(MulAssign mul_assign Mul mul $($of)*); };
    (Div $($of:tt)*) => { $crate::number::triple::assign!(DivAssign div_assign Div div $($of)*); };
    ($assign:ident $method:ident $operator:ident $function:ident [$($t:ident)?] $type:ty, $other:ty) => {
        impl<$($t)?> core::ops::$assign<$other> for $type
        where
            Self: Copy + core::ops::$operator<$other, Output = Self>,
        {
            #[inline]
            fn $method(&mut self, other: $other) {
                *self = core::ops::$operator::$function(*self, other);
            }
        }
    };
    ($generic:tt $type:ty, $other:ty: $($operator:ident)*) => {
        $($crate::number::triple::assign!($operator $generic $type, $other);)*
    };
}

/// The operations that vectors and colors share.
macro_rules! componentwise {
    ($type:ident { $x:ident, $y:ident, $z:ident }) => {
        impl<T> $type<T> {
            /// The value with these three components.
            #[inline]
            pub const fn new($x: T, $y: T, $z: T) -> Self {
                Self { $x, $y, $z }
            }

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

        impl<T: Add<Output = T>> Add for $type<T> {
            type Output = Self;
            #[inline]
            fn add(self, other: Self) -> Self {
                Self::new(self.$x + other.$x, self.$y + other.$y, self.$z + other.$z)
            }
        }

        impl<T: Sub<Output = T>> Sub for $type<T> {
            type Output = Self;
            #[inline]
            fn sub(self, other: Self) -> Self {
                Self::new(self.$x - other.$x, self.$y - other.$y, self.$z - other.$z)
            }
        }

        impl<T: Copy + Mul<Output = T>> Mul<T> for $type<T> {
            type Output = Self;
            #[inline]
            fn mul(self, factor: T) -> Self {
                self.map(|x| x * factor)
            }
        }

        impl<T: Copy + Div<Output = T>> Div<T> for $type<T> {
            type Output = Self;
            #[inline]
            fn div(self, divisor: T) -> Self {
                self.map(|x| x / divisor)
            }
        }

        assign!([T] $type<T>, Self: Add Sub);
        assign!([T] $type<T>, T: Mul Div);

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
componentwise!(Rgb { r, g, b });
pub(crate) use assign;
