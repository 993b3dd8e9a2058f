//! Accepted: the errors name `Dual`, and no conversion is suggested that would lose the derivatives.

use shading::f32::Vec3;
use shading::normal;

fn ball(p: Vec3) -> f32 {
    p.dot(p) - 1.0
}

fn main() {
    let p = Vec3::new(1.0, 0.0, 0.0);
    let _normal = normal::implicit(ball, p);
    let _normal = normal::implicit(|p| ball(p.map(|c| c.value)), p);
}
