//! Accepted: the error names both types and the place.

use shading::Vec3;

fn main() {
    let p = Vec3::new(0.0_f32, 3.0, 4.0);
    let t: f64 = 0.5;
    let _middle = p * t;
    let _moved = p + Vec3::new(t, t, t);
}
