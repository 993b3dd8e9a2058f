//! C99 and C++11.

use super::{Dialect, GRAPHICS};
use crate::graph::{MINIMUM, Op};

pub const C: Dialect = Dialect {
    types: ["float", "shading_vec2", "shading_vec3", "int"],
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
    own: &[
        ("vector", "shading_vector"),
        ("dot", "shading_dot"),
        ("cross", "shading_cross"),
        ("max", "shading_max"),
        ("min", "shading_min"),
        ("clamp", "shading_clamp"),
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
    extremes: &[
        "Every bit is the crate's, also for numbers from 1e-45 to 1e38; GCC needs -ffp-contract=off.",
    ],
    file: [
        concat!(
            "#ifndef SHADING_H\n#define SHADING_H\n\n#include <math.h>\n#include <stdint.h>\n#include <string.h>\n\n",
            include_str!("c/vectors.h"),
        ),
        concat!(include_str!("c/encodings.h"), "#endif\n"),
    ],
    bits: Err(include_str!("c/bits.h")),
    powers: "{own}",
    is_extreme: "(uint32_t)shading_bits(square) - {low_bits}u >= {width}u",
    ..GRAPHICS
};
