//! WGSL, for wgpu, Bevy and browsers.

use super::{Dialect, GRAPHICS, IS_EXTREME, Powers};

pub const WGSL: Dialect = Dialect {
    prefix: "shading_",
    namespace: "",
    types: ["f32", "vec2f", "vec3f"],
    truth: "bool",
    stored: "vec3f",
    comment: ["// ", ""],
    structure: ["struct {name} {", "{field}: {type},", "}"],
    pads: false,
    function: "fn {name}({parameters}) -> {type} {",
    parameter: "{name}: {type}",
    pointers: None,
    variable: "let {name} = {value};",
    branch: "if {test} {",
    choice: "select({no}, {yes}, {test})",
    made: Ok("{type}({values})"),
    vector: ("vec3f", true),
    suffix: "",
    operators: None,
    builtins: &[],
    own: GRAPHICS,
    file: ["", ""],
    vectors: "",
    bits: BITS,
    powers: Powers::BuiltIn,
    is_extreme: IS_EXTREME,
    encodings: "",
};

/// The operations on the bits of a number, which the crate's own power needs.
const BITS: &str = "\
// e of x = 2^e z, where z is within [least, 2 least).
fn shading_exponent(x: f32, least: f32) -> f32 {
    return f32((bitcast<i32>(x) - bitcast<i32>(least)) >> 23);
}

// z of x = 2^e z.
fn shading_significand(x: f32, least: f32) -> f32 {
    let above = bitcast<i32>(x) - bitcast<i32>(least);
    return bitcast<f32>(bitcast<i32>(x) - (above & -0x800000));
}

// 2^(n - 127) for the low byte n of the bits of x.
fn shading_two_to_low_bits(x: f32) -> f32 {
    return bitcast<f32>(bitcast<i32>(x) << 23);
}

// How many numbers x is above another of the same exponent: x - shift, which a compiler may take apart.
fn shading_steps_above(x: f32, shift: f32) -> f32 {
    return f32(bitcast<i32>(x) - bitcast<i32>(shift));
}

";
