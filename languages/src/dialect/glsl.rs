//! GLSL: ES 3.0, for WebGL 2 and three.js, and 3.30 and later.

use super::{Dialect, GRAPHICS, IS_EXTREME, Powers};

pub const GLSL: Dialect = Dialect {
    prefix: "shading_",
    namespace: "",
    types: ["float", "vec2", "vec3"],
    truth: "bool",
    stored: "vec3",
    comment: ["// ", ""],
    structure: ["struct {name} {", "{type} {field};", "};"],
    pads: false,
    function: "{type} {name}({parameters}) {",
    parameter: "{type} {name}",
    pointers: None,
    variable: "{type} {name} = {value};",
    branch: "if ({test}) {",
    choice: "{test} ? {yes} : {no}",
    made: Ok("{type}({values})"),
    vector: ("vec3", true),
    suffix: "",
    operators: None,
    builtins: &[("atan2", "atan")],
    own: GRAPHICS,
    file: ["#ifndef SHADING_GLSL\n#define SHADING_GLSL\n\n", "#endif\n"],
    vectors: "",
    bits: BITS,
    powers: Powers::Defined,
    is_extreme: IS_EXTREME,
    encodings: "",
};

/// The operations on the bits of a number, which the crate's own power needs.
const BITS: &str = "\
// e of x = 2^e z, where z is within [least, 2 least).
float shading_exponent(float x, float least) {
    return float((floatBitsToInt(x) - floatBitsToInt(least)) >> 23);
}

// z of x = 2^e z.
float shading_significand(float x, float least) {
    int above = floatBitsToInt(x) - floatBitsToInt(least);
    return intBitsToFloat(floatBitsToInt(x) - (above & -0x800000));
}

// 2^(n - 127) for the low byte n of the bits of x.
float shading_two_to_low_bits(float x) {
    return intBitsToFloat(floatBitsToInt(x) << 23);
}

// How many numbers x is above another of the same exponent: x - shift, which a compiler may take apart.
float shading_steps_above(float x, float shift) {
    return float(floatBitsToInt(x) - floatBitsToInt(shift));
}

";
