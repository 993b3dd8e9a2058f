//! Vectors and colors as bytes, for buffers; `docs/buffers.md` is about those.
//!
//! Lights and materials are not: `Light` is an enum, and what a shader takes has padding of its own.

use bytemuck::{NoUninit, Pod, Zeroable};

use crate::{Rgb, UnitVec3, Vec3};

macro_rules! pod {
    ($type:ident) => {
        // SAFETY: it is `repr(C)` and has three fields of one type. So they follow each other without padding,
        // and every bit pattern that is one of three `T` is one of it.
        unsafe impl<T: Zeroable> Zeroable for $type<T> {}
        unsafe impl<T: Pod> Pod for $type<T> {}
    };
}

pod!(Vec3);
pod!(Rgb);

// SAFETY: it is a transparent `Vec3`. It can only be written: read from bytes, it might have any length.
unsafe impl<T: Pod> NoUninit for UnitVec3<T> {}
