//! WGSL, for wgpu, Bevy and browsers.

use super::{Dialect, GRAPHICS, Powers};

pub const WGSL: Dialect = Dialect {
    types: ["f32", "vec2f", "vec3f"],
    stored: "vec3f",
    structure: ["struct {name} {", "{field}: {type},", "}"],
    pads: false,
    function: "fn {name}({parameters}) -> {type} {",
    parameter: "{name}: {type}",
    variable: "let {name} = {value};",
    branch: "if {test} {",
    choice: "select({no}, {yes}, {test})",
    made: "return {type}({values});",
    vector: ("vec3f", true),
    bits: Ok(["bitcast<i32>", "bitcast<f32>"]),
    powers: Powers::BuiltIn,
    ..GRAPHICS
};

/// With the crate's own power.
pub const WGSL_EXACT: Dialect = Dialect {
    powers: Powers::Own,
    ..WGSL
};
