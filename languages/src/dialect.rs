//! How a language writes what the printer has found. A language is a table.

use crate::graph::{MINIMUM, Op};
use crate::kind::Kind;

/// A language. In the texts, `{type}`, `{name}` and the like stand for what is meant.
#[derive(Debug)]
pub struct Dialect {
    /// What stands before the names of the functions and the types: in the file, and after it.
    pub prefix: [&'static str; 2],
    /// The types of one number, two and three, and what makes three a vector.
    pub types: [&'static str; 4],
    /// What stands before the type of three numbers in a buffer.
    pub packed: &'static str,
    pub comment: [&'static str; 2],
    /// The beginning of a struct, a field, and the end.
    pub structure: [&'static str; 3],
    /// Whether a struct needs numbers in the places that the others leave empty.
    pub pads: bool,
    pub function: &'static str,
    pub parameter: &'static str,
    /// In a language that passes structs by pointers: one that is read, one that is changed, and what
    /// stands before a field.
    pub pointers: Option<[&'static str; 3]>,
    pub variable: &'static str,
    pub branch: &'static str,
    pub choice: &'static str,
    /// Returns a struct of the values of its fields.
    pub made: &'static str,
    /// Whether a vector of three times the same number takes it once.
    pub splats: bool,
    /// What follows a number.
    pub suffix: &'static str,
    /// Functions in place of the operations on vectors, in a language without.
    pub vector_functions: &'static [(Op, &'static str)],
    /// The name of a function that most languages have.
    pub own: fn(&str) -> String,
    /// How its results compare with the crate's for extreme numbers.
    pub extremes: &'static [&'static str],
    /// What begins the file and what ends it.
    pub around: [&'static str; 2],
    /// The file, in which `{structs}`, `{functions}`, the crate's `{own}` power and the language's `{built_in}`
    /// have their places.
    pub file: &'static str,
    /// What gives the bits of a number as an integer, and a number of such bits.
    pub bits: [&'static str; 2],
}

/// What most languages for graphics have in common.
const GRAPHICS: Dialect = Dialect {
    prefix: ["shading_"; 2],
    types: ["float", "float2", "float3", "float3"],
    packed: "",
    comment: ["// ", ""],
    structure: ["struct {name} {", "{type} {field};", "};"],
    pads: true,
    function: "{type} {name}({parameters}) {",
    parameter: "{type} {name}",
    pointers: None,
    variable: "{type} {name} = {value};",
    branch: "if ({test}) {",
    choice: "{test} ? {yes} : {no}",
    made: "{type} result = {{values}};\nreturn result;",
    splats: true,
    suffix: "",
    vector_functions: &[],
    own: str::to_string,
    extremes: &[
        "Tried with 860,000 calls and numbers from 1e-45 to 1e38, in WGSL on Mesa's llvmpipe and in GLSL in Chromium's SwiftShader:",
        "with the crate's own power, 0.998 and 0.963 of the results were the crate's; with the language's, 0.950 and 0.957.",
    ],
    around: ["", ""],
    file: include_str!("dialect/graphics.txt"),
    bits: ["", ""],
};

/// WGSL, for wgpu, Bevy and browsers.
pub const WGSL: Dialect = Dialect {
    types: ["f32", "vec2f", "vec3f", "vec3f"],
    structure: ["struct {name} {", "{field}: {type},", "}"],
    pads: false,
    function: "fn {name}({parameters}) -> {type} {",
    parameter: "{name}: {type}",
    variable: "let {name} = {value};",
    branch: "if {test} {",
    choice: "select({no}, {yes}, {test})",
    made: "return {type}({values});",
    file: include_str!("dialect/wgsl.txt"),
    ..GRAPHICS
};

/// With the crate's own power.
pub const WGSL_EXACT: Dialect = Dialect {
    file: include_str!("dialect/wgsl_exact.txt"),
    ..WGSL
};

/// GLSL: ES 3.0, for WebGL 2 and three.js, and 3.30 and later.
pub const GLSL: Dialect = Dialect {
    types: ["float", "vec2", "vec3", "vec3"],
    pads: false,
    made: "return {type}({values});",
    own: |name| if name == "atan2" { "atan" } else { name }.into(),
    around: ["#ifndef SHADING_GLSL\n#define SHADING_GLSL\n\n", "#endif\n"],
    bits: ["floatBitsToInt", "intBitsToFloat"],
    ..GRAPHICS
};

/// HLSL, for Direct3D, Unity and Unreal.
pub const HLSL: Dialect = Dialect {
    splats: false,
    extremes: &[
        "Tried with 820,000 calls and numbers from 1e-45 to 1e38, by glslang on Mesa's llvmpipe, not by Direct3D:",
        "with the crate's own power, 0.998 of the results were the crate's; with the language's, 0.950.",
    ],
    around: ["#ifndef SHADING_HLSL\n#define SHADING_HLSL\n\n", "#endif\n"],
    bits: ["asint", "asfloat"],
    ..GRAPHICS
};

/// The Metal Shading Language.
pub const METAL: Dialect = Dialect {
    prefix: ["", "shading::"],
    packed: "packed_",
    function: "inline {type} {name}({parameters}) {",
    suffix: "f",
    extremes: &[
        "Tried with 820,000 calls and numbers from 1e-45 to 1e38, compiled as C++, not by a compiler for Metal:",
        "with the crate's own power, 0.998 of the results were the crate's; with the language's, 0.995.",
    ],
    around: [
        "#ifndef SHADING_METAL\n#define SHADING_METAL\n\n#include <metal_stdlib>\n\nnamespace shading {\nusing namespace metal;\n\n",
        "} // namespace shading\n#endif\n",
    ],
    bits: ["as_type<int>", "as_type<float>"],
    ..GRAPHICS
};

/// C99 and C++11.
pub const C: Dialect = Dialect {
    types: ["float", "shading_vec2", "shading_vec3", "shading_vector"],
    comment: ["/* ", " */"],
    structure: ["typedef struct {", "{type} {field};", "} {name};"],
    pads: false,
    function: "static inline {type} {name}({parameters}) {",
    pointers: Some(["const {type} *{name}", "{type} *{name}", "->"]),
    splats: false,
    suffix: "f",
    vector_functions: &[
        (Op::Add, "shading_add"),
        (Op::Sub, "shading_sub"),
        (Op::Mul, "shading_mul"),
        (Op::Scale, "shading_scale"),
        (Op::Div, "shading_over"),
        (Op::Neg, "shading_neg"),
        (MINIMUM, "shading_at_most"),
    ],
    own: |name| match name {
        "abs" => "fabsf".into(),
        "dot" | "cross" | "min" | "max" | "clamp" => format!("shading_{name}"),
        _ => format!("{name}f"),
    },
    extremes: &[
        "Every bit is the crate's, also for numbers from 1e-45 to 1e38; GCC needs -ffp-contract=off.",
    ],
    file: include_str!("dialect/c.h"),
    ..GRAPHICS
};

impl Dialect {
    /// The name of a function or a type of the files, where it is defined.
    pub(crate) fn named(&self, name: &str) -> String {
        format!("{}{name}", self.prefix[0])
    }

    pub(crate) fn type_of(&self, kind: Kind) -> String {
        match kind.fields() {
            Some((name, _, _)) => self.named(name),
            None => self.types[kind.width() - 1].into(),
        }
    }

    pub(crate) fn number(&self, x: f32) -> String {
        if x.to_bits() == f32::MAX.to_bits() {
            // rounded down, because browsers call 3.4028235e38 an overflow
            return format!("3.4028234e38{}", self.suffix);
        }
        format!("{x:?}{}", self.suffix)
    }
}

/// A text with its places filled.
pub(crate) fn filled(text: &str, places: &[(&str, &str)]) -> String {
    places
        .iter()
        .fold(text.into(), |text: String, (place, value)| {
            text.replace(&format!("{{{place}}}"), value)
        })
}
