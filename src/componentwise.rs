//! The operations that vectors and colors share.

macro_rules! componentwise {
    ($type:ident { $x:ident, $y:ident, $z:ident }) => {
        impl<T: Real> $type<T> {
            /// The value with these three components.
            ///
            /// ```
            #[doc = concat!("use shading::", stringify!($type), ";")]
            #[doc = concat!("let value = ", stringify!($type), "::new(1.0_f32, 2.0, 3.0);")]
            /// assert_eq!(<[f32; 3]>::from(value), [1.0, 2.0, 3.0]);
            /// ```
            #[inline]
            #[must_use]
            pub const fn new($x: T, $y: T, $z: T) -> Self {
                Self { $x, $y, $z }
            }
        }

        impl<T> $type<T> {
            /// Applies a function to each component.
            ///
            /// ```
            #[doc = concat!("use shading::", stringify!($type), ";")]
            #[doc = concat!("let value = ", stringify!($type), "::new(1.0_f32, 2.0, 3.0);")]
            #[doc = concat!("assert_eq!(value.map(|x| 2.0 * x), ", stringify!($type), "::new(2.0, 4.0, 6.0));")]
            /// ```
            #[inline]
            #[must_use]
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
                T::scaled(self.into(), factor).into()
            }
        }

        impl<T: Real> Div<T> for $type<T> {
            type Output = Self;
            #[inline]
            fn div(self, divisor: T) -> Self {
                Self::new(self.$x / divisor, self.$y / divisor, self.$z / divisor)
            }
        }

        componentwise!(f32 * $type);
        componentwise!(f64 * $type);
        componentwise!($type AddAssign::add_assign(Self) is +);
        componentwise!($type SubAssign::sub_assign(Self) is -);
        componentwise!($type MulAssign::mul_assign(T) is *);

        impl<T: Real> Sum for $type<T> {
            #[inline]
            fn sum<I: Iterator<Item = Self>>(iter: I) -> Self {
                iter.fold(Self::new(T::ZERO, T::ZERO, T::ZERO), Add::add)
            }
        }

        impl<'a, T: Real> Sum<&'a Self> for $type<T> {
            #[inline]
            fn sum<I: Iterator<Item = &'a Self>>(iter: I) -> Self {
                iter.copied().sum()
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

    ($float:ident * $type:ident) => {
        impl Mul<$type<$float>> for $float {
            type Output = $type<$float>;
            #[inline]
            fn mul(self, value: $type<$float>) -> $type<$float> {
                value * self
            }
        }
    };

    ($type:ident $assign:ident::$method:ident($other:ty) is $operator:tt) => {
        impl<T: Real> $assign<$other> for $type<T> {
            #[inline]
            fn $method(&mut self, other: $other) {
                *self = *self $operator other;
            }
        }
    };
}

pub(crate) use componentwise;
