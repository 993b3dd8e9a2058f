//! The picture in floating point.

pub use shading::f32::{Attenuation, Material, PointLight, Rgb, UnitVec3, Vec3};

pub type Number = f32;

pub const fn number(literal: f64) -> Number {
    literal as f32
}
