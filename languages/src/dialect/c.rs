//! C99 and C++11.

use super::{Dialect, GRAPHICS, Powers};

pub const C: Dialect = Dialect {
    types: ["float", "shading_vec2", "shading_vec3"],
    truth: "int",
    stored: "shading_vec3",
    comment: ["/* ", " */"],
    structure: ["typedef struct {", "{type} {field};", "} {name};"],
    pads: false,
    function: "static inline {type} {name}({parameters}) {",
    pointers: Some(["const {type} *{name}", "{type} *{name}", "->"]),
    vector: ("shading_vector", false),
    suffix: "f",
    operators: Some(["add", "sub", "mul", "over", "at_most", "scale", "neg"]),
    builtins: &[
        ("sqrt", "sqrtf"),
        ("abs", "fabsf"),
        ("sin", "sinf"),
        ("cos", "cosf"),
        ("tan", "tanf"),
        ("atan2", "atan2f"),
        ("exp", "expf"),
        ("log", "logf"),
        ("pow", "powf"),
    ],
    own: &[],
    extremes: &[
        "Every bit is the crate's, also for numbers from 1e-45 to 1e38; GCC needs -ffp-contract=off.",
    ],
    file: [
        "#ifndef SHADING_H\n#define SHADING_H\n\n#include <math.h>\n#include <stdint.h>\n#include <string.h>\n\n",
        "#endif\n",
    ],
    vectors: include_str!("c/vectors.h"),
    bits: Err(include_str!("c/bits.h")),
    powers: Powers::Own,
    is_extreme: "(uint32_t)shading_bits(square) - {low_bits}u >= {width}u",
    encodings: include_str!("c/encodings.h"),
    ..GRAPHICS
};
