//! Code that users of the features write, for the tests and for fuzzing.

pub mod gpu;

use serde::{Deserialize, Serialize};
use shading::f32::{Material, Ranged, Rgb, SoftCone};

/// A light of any kind, with or without a range, with a hard or a soft edge.
pub type Light = shading::Light<f32, SoftCone, Ranged>;

/// A scene as a renderer loads it.
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

/// The examples of the pages that the library alone cannot compile.
#[cfg(doctest)]
mod pages {
    #[doc = include_str!("../../../docs/buffers.md")]
    struct Buffers;
    #[doc = include_str!("../../../docs/renderers.md")]
    struct Renderers;
    #[doc = include_str!("../../../docs/schema.md")]
    struct Schema;
}

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
