//! What the tracer asks of a vector and of its number. The rest is written once.

use std::ops::{Add, Mul, Sub};

use shading::{Real, UnitVec3, Vec3};

pub trait Number: Real + PartialOrd + From<f32> + Send + Sync {
    fn to_f32(self) -> f32;
}

impl Number for f32 {
    fn to_f32(self) -> f32 {
        self
    }
}

impl Number for f64 {
    fn to_f32(self) -> f32 {
        self as f32
    }
}

pub trait Vector:
    Copy
    + Send
    + Sync
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Self::Number, Output = Self>
    + From<[Self::Number; 3]>
    + Into<[Self::Number; 3]>
{
    type Number: Number;
    fn dot(self, other: Self) -> Self::Number;
    fn cross(self, other: Self) -> Self;

    fn of_f32(coordinates: [f32; 3]) -> Self {
        coordinates.map(Self::Number::from).into()
    }

    fn normalized(self) -> Self {
        self * (Self::Number::ONE / Real::sqrt(self.dot(self)))
    }
}

// glue: from the tracer's vectors to those of `shading`; the way back is `<[_; 3]>::from(v).into()`
pub fn ours<V: Vector>(v: V) -> Vec3<V::Number> {
    v.into().into()
}
pub fn direction<V: Vector>(v: V) -> UnitVec3<V::Number> {
    UnitVec3::assume_unit(ours(v)) // normalized already
}
// end of glue
