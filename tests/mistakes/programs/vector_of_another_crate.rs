//! Accepted: the error names both types, and with `.into()` it lists the types that a `Vec3` is made
//! from, such as an array. The guide on vectors shows the conversion.

use shading::f32::{UnitVec3, Vec3};
use shading::term;

mod glam {
    pub struct Vec3 {
        pub x: f32,
        pub y: f32,
        pub z: f32,
    }
}

fn main() {
    let [n, l] = [0.6, 0.8].map(|x| glam::Vec3 { x, y: 0.0, z: 1.0 });
    let _cosine = term::lambert(UnitVec3::Z, l);
    let _normal = Vec3::unit(n.into());
}
