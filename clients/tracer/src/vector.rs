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
    Copy + Send + Sync + Add<Output = Self> + Sub<Output = Self> + Mul<Self::Number, Output = Self>
{
    type Number: Number;
    fn of(coordinates: [Self::Number; 3]) -> Self;
    fn array(self) -> [Self::Number; 3];
    fn dot(self, other: Self) -> Self::Number;
    fn cross(self, other: Self) -> Self;

    fn of_f32(coordinates: [f32; 3]) -> Self {
        Self::of(coordinates.map(Self::Number::from))
    }

    fn normalized(self) -> Self {
        self * (Self::Number::ONE / Real::sqrt(self.dot(self)))
    }
}

/// A point or a vector for `shading`.
pub fn ours<V: Vector>(v: V) -> Vec3<V::Number> {
    v.array().into()
}

/// A vector that is normalized already, for `shading`.
pub fn direction<V: Vector>(v: V) -> UnitVec3<V::Number> {
    UnitVec3::assume_unit(ours(v))
}

/// A vector of `shading` for the tracer.
pub fn theirs<V: Vector>(v: impl Into<[V::Number; 3]>) -> V {
    V::of(v.into())
}
