//! Vectors and colors as bytes, for buffers. `docs/gpu.md` explains such buffers.
//!
//! Lights and materials have no such form: `Light` is an enum, and a shader's structs have their
//! own padding.

use bytemuck::{NoUninit, Pod, Zeroable};

#[cfg(feature = "fixed")]
use crate::fixed::Fixed;
use crate::{Rgb, UnitVec3, Vec3};

macro_rules! pod {
    ($type:ident) => {
        // SAFETY: The type is `repr(C)` and has three fields of one type, so it has no padding.
        // Every bit pattern of three valid `T` is a valid value.
        unsafe impl<T: Zeroable> Zeroable for $type<T> {}
        unsafe impl<T: Pod> Pod for $type<T> {}
    };
}

pod!(Vec3);
pod!(Rgb);

// SAFETY: The type is a transparent `Vec3`. It can only be written: a value read from bytes might
// have any length.
unsafe impl<T: Pod> NoUninit for UnitVec3<T> {}

#[cfg(feature = "fixed")]
// SAFETY: The type is a transparent `i32`, and every `i32` is a number.
unsafe impl Zeroable for Fixed {}
#[cfg(feature = "fixed")]
// SAFETY: As above.
unsafe impl Pod for Fixed {}
