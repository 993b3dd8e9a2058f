//! GLSL: ES 3.0, for WebGL 2 and three.js, and 3.30 and later.

use super::{Dialect, GRAPHICS};

pub const GLSL: Dialect = Dialect {
    types: ["float", "vec2", "vec3", "bool"],
    pads: false,
    made: "return {type}({values});",
    own: &[("atan2", "atan")],
    file: ["#ifndef SHADING_GLSL\n#define SHADING_GLSL\n\n", "#endif\n"],
    bits: Ok(["floatBitsToInt", "intBitsToFloat"]),
    ..GRAPHICS
};
