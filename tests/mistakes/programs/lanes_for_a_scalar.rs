//! Improved: a message on `Scalar` says what to call instead.

use shading::{Vec3, normal};
use wide::f32x8;

fn main() {
    let p = Vec3::<f32x8>::ZERO;
    let _direction = p.unit();
    let _normal = normal::triangle(p, p, p);
}
