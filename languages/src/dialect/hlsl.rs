//! HLSL, for Direct3D, Unity and Unreal.

use super::{Dialect, GRAPHICS, IS_EXTREME, Powers};

pub const HLSL: Dialect = Dialect {
    prefix: "shading_",
    namespace: "",
    types: ["float", "float2", "float3"],
    truth: "bool",
    stored: "float3",
    comment: ["// ", ""],
    structure: ["struct {name} {", "{type} {field};", "};"],
    pads: true,
    function: "{type} {name}({parameters}) {",
    parameter: "{type} {name}",
    pointers: None,
    variable: "{type} {name} = {value};",
    branch: "if ({test}) {",
    choice: "{test} ? {yes} : {no}",
    made: Err("{type} {name} = {{values}};"),
    vector: ("float3", false),
    suffix: "",
    operators: None,
    builtins: &[],
    own: GRAPHICS,
    file: ["#ifndef SHADING_HLSL\n#define SHADING_HLSL\n\n", "#endif\n"],
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
    return float((asint(x) - asint(least)) >> 23);
}

// z of x = 2^e z.
float shading_significand(float x, float least) {
    int above = asint(x) - asint(least);
    return asfloat(asint(x) - (above & -0x800000));
}

// 2^(n - 127) for the low byte n of the bits of x.
float shading_two_to_low_bits(float x) {
    return asfloat(asint(x) << 23);
}

// How many numbers x is above another of the same exponent: x - shift, which a compiler may take apart.
float shading_steps_above(float x, float shift) {
    return float(asint(x) - asint(shift));
}

";
