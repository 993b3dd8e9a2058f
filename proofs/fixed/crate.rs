// The crate, as far as the files of `Fixed` name it, for programs that compile these files alone.

#[derive(Clone, Copy, PartialEq, PartialOrd)]
pub struct Fixed(i32);
const ONE: i32 = 1 << 16;

/// A type that the files name, with no more than they need.
macro_rules! stand_in {
    ($module:ident: $type:ident) => {
        mod $module {
            use crate::Fixed;

            pub struct $type<T>(T);
            impl core::ops::Mul<Fixed> for $type<Fixed> {
                type Output = Self;
                fn mul(self, _: Fixed) -> Self {
                    self
                }
            }
        }
    };
}
stand_in!(vector: Vec3);
stand_in!(rgb: Rgb);
