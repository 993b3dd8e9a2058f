//! What a function returns, as numbers in a buffer.

use bytemuck::{Pod, Zeroable};
use shading::f32::Vec3;
use shading::{Dual, IncidentLight, Rgb, Shaded, UnitVec3};

use super::Number;

/// Up to nine numbers.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub struct Output(pub Vec3, pub Vec3, pub Vec3);

/// A result of numbers. No result is zeros.
pub trait Value: Copy {
    fn output(self) -> Output;
}

fn first(v: Vec3) -> Output {
    Output(v, Vec3::ZERO, Vec3::ZERO)
}

fn vector<T: Number>(v: shading::Vec3<T>) -> Vec3 {
    Vec3::new(v.x.into(), v.y.into(), v.z.into())
}

fn color<T: Number>(c: Rgb<T>) -> Vec3 {
    Vec3::new(c.r.into(), c.g.into(), c.b.into())
}

impl Value for f32 {
    fn output(self) -> Output {
        first(Vec3::new(self, 1.0, 0.0))
    }
}

impl<T: Number> Value for [T; 2] {
    fn output(self) -> Output {
        first(Vec3::new(self[0].into(), self[1].into(), 1.0))
    }
}

impl<T: Number> Value for [T; 3] {
    fn output(self) -> Output {
        first(Vec3::new(self[0].into(), self[1].into(), self[2].into()))
    }
}

impl<T: Number> Value for shading::Vec3<T> {
    fn output(self) -> Output {
        first(vector(self))
    }
}

impl<T: Number> Value for UnitVec3<T> {
    fn output(self) -> Output {
        first(vector(*self))
    }
}

impl<T: Number> Value for Rgb<T> {
    fn output(self) -> Output {
        first(color(self))
    }
}

impl<T: Number> Value for Dual<T> {
    fn output(self) -> Output {
        let value = Vec3::new(self.value.into(), 1.0, 0.0);
        Output(vector(self.gradient), value, Vec3::ZERO)
    }
}

impl<T: Number> Value for IncidentLight<T> {
    fn output(self) -> Output {
        let distance = Vec3::new(self.distance.into(), 1.0, 0.0);
        Output(vector(*self.l), color(self.intensity), distance)
    }
}

impl<T: Number> Value for Shaded<T> {
    fn output(self) -> Output {
        Output(
            color(self.ambient),
            color(self.diffuse),
            color(self.specular),
        )
    }
}

impl<V: Value> Value for Option<V> {
    fn output(self) -> Output {
        match self {
            Some(value) => value.output(),
            None => first(Vec3::ZERO),
        }
    }
}
