//! Conversion of vectors and points from and to `mint`, and through it from and to the vectors of
//! other crates.

use mint::{IntoMint, Point3, Vector3};

use crate::{UnitVec3, Vec3};

macro_rules! convert {
    ($mint:ident) => {
        impl<T> From<$mint<T>> for Vec3<T> {
            #[inline]
            fn from($mint { x, y, z }: $mint<T>) -> Self {
                Self { x, y, z }
            }
        }

        impl<T> From<Vec3<T>> for $mint<T> {
            #[inline]
            fn from(Vec3 { x, y, z }: Vec3<T>) -> Self {
                Self { x, y, z }
            }
        }
    };
}

convert!(Vector3);
convert!(Point3);

impl<T> IntoMint for Vec3<T> {
    type MintType = Vector3<T>;
}

/// There is no conversion back, because only [`Vec3::unit`] can ensure that the length is 1.
impl<T> From<UnitVec3<T>> for Vector3<T> {
    #[inline]
    fn from(unit: UnitVec3<T>) -> Self {
        Vec3::from(unit).into()
    }
}

impl<T> IntoMint for UnitVec3<T> {
    type MintType = Vector3<T>;
}
