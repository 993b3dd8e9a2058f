//! The Metal Shading Language.

use super::{Dialect, GRAPHICS, IS_EXTREME, Powers};

pub const METAL: Dialect = Dialect {
    prefix: "",
    namespace: "shading::",
    types: ["float", "float2", "float3"],
    truth: "bool",
    stored: "packed_float3",
    comment: ["// ", ""],
    structure: ["struct {name} {", "{type} {field};", "};"],
    pads: true,
    function: "inline {type} {name}({parameters}) {",
    parameter: "{type} {name}",
    pointers: None,
    variable: "{type} {name} = {value};",
    branch: "if ({test}) {",
    choice: "{test} ? {yes} : {no}",
    made: Err("{type} {name} = {{values}};"),
    vector: ("float3", true),
    suffix: "f",
    operators: None,
    builtins: &[],
    own: GRAPHICS,
    file: [
        "#ifndef SHADING_METAL\n#define SHADING_METAL\n\n#include <metal_stdlib>\n\nnamespace shading {\nusing namespace metal;\n\n",
        "} // namespace shading\n#endif\n",
    ],
    vectors: "",
    bits: BITS,
    powers: Powers::Defined,
    is_extreme: IS_EXTREME,
    encodings: "",
};

/// The operations on the bits of a number, which the crate's own power needs.
const BITS: &str = "\
// e of x = 2^e z, where z is within [least, 2 least).
inline float exponent(float x, float least) {
    return float((as_type<int>(x) - as_type<int>(least)) >> 23);
}

// z of x = 2^e z.
inline float significand(float x, float least) {
    int above = as_type<int>(x) - as_type<int>(least);
    return as_type<float>(as_type<int>(x) - (above & -0x800000));
}

// 2^(n - 127) for the low byte n of the bits of x.
inline float two_to_low_bits(float x) {
    return as_type<float>(as_type<int>(x) << 23);
}

// How many numbers x is above another of the same exponent: x - shift, which a compiler may take apart.
inline float steps_above(float x, float shift) {
    return float(as_type<int>(x) - as_type<int>(shift));
}

";
