//! Accepted: the compiler finds the trait with this method and says where to write it.

use shading::{Real, Vec3, normal};

fn waves<T: Real>(p: Vec3<T>) -> T {
    p.z - p.x.sin()
}

fn main() {
    let p = Vec3::new(1.0_f32, 0.0, 0.0);
    let _normal = normal::implicit(waves, p);
    let _normal = normal::implicit(|p| p.z - p.x.sin(), p);
}
