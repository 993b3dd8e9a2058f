//! What is wrong with an argument: a status for programs and a sentence for people. Python, JavaScript
//! and C all get the sentences from here.

use std::fmt::Display;

/// What a function of `shading.h` returns. All but the first five are about an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum Status {
    Null = 1,
    Alignment,
    Size,
    Overlap,
    Count,
    Model,
    Points,
    Normals,
    Eye,
    Reflectance,
    Shininess,
    Ambient,
    Visible,
    Kind,
    Position,
    Toward,
    Axis,
    Intensity,
    Attenuation,
    Range,
    Angles,
    Gltf,
    Heights,
    Step,
    Faces,
    Crease,
    Values,
}

/// The sentence of each status, in the order of [`Status`]. They end in a zero byte, for C.
const TEXTS: [&str; 28] = [
    "no error\0",
    "the pointer is null, and its buffer is not empty\0",
    "the pointer is not a multiple of its type's alignment\0",
    "the buffer is larger than the address space\0",
    "the output overlaps this input\0",
    "an array has too few or too many values\0",
    "model: there is no such model\0",
    "points: a coordinate is not finite, or is outside of the grid\0",
    "normals: a coordinate is not finite\0",
    "eye: a coordinate is not finite\0",
    "k_a, k_d, k_s: a reflectance is negative, not finite or an image's byte, or there is none\0",
    "m: a shininess is negative or NaN\0",
    "ambient: a channel is negative or not finite\0",
    "visible: a fraction is not within 0 and 1\0",
    "kind: there is no such kind of light\0",
    "position: a coordinate is not finite\0",
    "toward: the direction is 0 or not finite\0",
    "axis: the direction is 0 or not finite\0",
    "intensity: a channel is negative or not finite\0",
    "attenuation: a coefficient is negative or not finite, or all are 0\0",
    "range: it is not above 0\0",
    "inner, outer: they are not half-angles in radians, 0 <= inner <= outer <= pi\0",
    "gltf: it is neither 0 nor 1\0",
    "z: a height is not finite\0",
    "dx, dy, dz: a step is 0 or not finite\0",
    "faces: an index is not that of a vertex\0",
    "crease: it is not an angle in radians, 0 <= crease <= pi\0",
    "values: a value is not finite\0",
];

/// The sentence of a status, with a zero byte at its end.
pub fn text(status: i32) -> &'static str {
    let index = usize::try_from(status).ok();
    let text = index.and_then(|index| TEXTS.get(index));
    text.copied().unwrap_or("there is no such status\0")
}

#[derive(Clone, Debug)]
pub struct Problem {
    pub status: Status,
    /// The index of the light whose number is wrong.
    pub light: Option<usize>,
    /// The index of the point, or of whatever else the array contains.
    pub index: Option<usize>,
    pub message: String,
}

impl Problem {
    /// `name: expected …, got …`.
    pub fn new(status: Status, name: &str, expected: &str, got: impl Display) -> Self {
        let message = format!("{name}: expected {expected}, got {got}");
        Self {
            status,
            light: None,
            index: None,
            message,
        }
    }

    /// A problem with a buffer, of which the status says everything.
    pub fn of(status: Status, name: &str) -> Self {
        let message = format!("{name}: {}", text(status as i32).trim_end_matches('\0'));
        Self {
            status,
            light: None,
            index: None,
            message,
        }
    }

    pub fn in_light(mut self, light: usize) -> Self {
        self.message = format!("lights[{light}].{}", self.message);
        self.light = Some(light);
        self
    }

    /// Says which row is wrong, unless there is only one.
    pub fn at(mut self, index: usize, count: usize) -> Self {
        self.index = (count > 1).then_some(index);
        self
    }

    pub fn sentence(&self) -> String {
        let Self { message, index, .. } = self;
        index.map_or_else(
            || message.clone(),
            |index| format!("{message} at [{index}]"),
        )
    }
}

/// Three numbers as they are written in a message.
pub fn triple<T: Display>([x, y, z]: [T; 3]) -> String {
    format!("({x}, {y}, {z})")
}
