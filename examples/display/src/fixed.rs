//! The picture in fixed point, for a chip without floating point.

pub use shading::fixed::{Attenuation, Fixed as Number, Material, PointLight, Rgb, UnitVec3, Vec3};

pub const fn number(literal: f64) -> Number {
    Number::new(literal)
}
