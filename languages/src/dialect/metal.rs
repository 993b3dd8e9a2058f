//! The Metal Shading Language.

use super::{Dialect, GRAPHICS};

pub const METAL: Dialect = Dialect {
    prefix: "",
    namespace: "shading::",
    packed: "packed_",
    function: "inline {type} {name}({parameters}) {",
    suffix: "f",
    file: [
        "#ifndef SHADING_METAL\n#define SHADING_METAL\n\n#include <metal_stdlib>\n\nnamespace shading {\nusing namespace metal;\n\n",
        "} // namespace shading\n#endif\n",
    ],
    bits: Ok(["as_type<int>", "as_type<float>"]),
    ..GRAPHICS
};
