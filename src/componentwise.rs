//! What three numbers have in common, whether they are coordinates or channels.

macro_rules! componentwise {
    ($type:ident { $x:ident, $y:ident, $z:ident }) => {
        impl<T> $type<T> {
            /// From its three components.
            #[inline]
            #[must_use]
            pub const fn new($x: T, $y: T, $z: T) -> Self {
                Self { $x, $y, $z }
            }

            /// The same function of each component: a change of the number type, for example.
            #[inline]
            #[must_use]
            pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> $type<U> {
                $type::new(f(self.$x), f(self.$y), f(self.$z))
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
                Self::new(self.$x * factor, self.$y * factor, self.$z * factor)
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

pub(crate) use componentwise;
