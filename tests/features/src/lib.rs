//! A scene file as a user of the library has it, for the tests and for fuzzing.

use serde::{Deserialize, Serialize};
use shading::f32::{Light, Material, Rgb};

/// What a renderer loads.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// I_a.
    pub ambient: Rgb,
    /// All lights.
    pub lights: Vec<Light>,
    /// The material of each object.
    pub materials: Vec<Material<f32>>,
}

/// The examples of the page on scene files.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/schema.md")]
struct Schema;
