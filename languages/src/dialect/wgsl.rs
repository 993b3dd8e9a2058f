//! WGSL, for wgpu, Bevy and browsers.

use super::{Dialect, GRAPHICS};

pub const WGSL: Dialect = Dialect {
    types: ["f32", "vec2f", "vec3f", "bool"],
    structure: ["struct {name} {", "{field}: {type},", "}"],
    pads: false,
    function: "fn {name}({parameters}) -> {type} {",
    parameter: "{name}: {type}",
    variable: "let {name} = {value};",
    branch: "if {test} {",
    choice: "select({no}, {yes}, {test})",
    made: "return {type}({values});",
    bits: Ok(["bitcast<i32>", "bitcast<f32>"]),
    powers: "{built_in}",
    ..GRAPHICS
};

/// With the crate's own power.
pub const WGSL_EXACT: Dialect = Dialect {
    powers: "{own}",
    ..WGSL
};
