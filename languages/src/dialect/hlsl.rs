//! HLSL, for Direct3D, Unity and Unreal.

use super::{Dialect, GRAPHICS};

pub const HLSL: Dialect = Dialect {
    splats: false,
    file: ["#ifndef SHADING_HLSL\n#define SHADING_HLSL\n\n", "#endif\n"],
    bits: Ok(["asint", "asfloat"]),
    ..GRAPHICS
};
