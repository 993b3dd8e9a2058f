//! A scene as a renderer loads it, for the tests and for fuzzing.

use serde::{Deserialize, Serialize};
use shading::f32::{Light, Material, Rgb};

/// What a file holds.
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

#[cfg(doctest)]
#[doc = include_str!("../../../docs/schema.md")]
struct Schema;

/// A direction cannot be read from bytes, since they may hold a vector of any length.
///
/// ```compile_fail
/// let bytes = [0_u8; 12];
/// let direction: shading::f32::UnitVec3 = bytemuck::must_cast(bytes);
/// ```
/// ```
/// let bytes = [0_u8; 12];
/// let vector: shading::f32::Vec3 = bytemuck::must_cast(bytes);
/// ```
#[cfg(doctest)]
struct DirectionsAreNotRead;
