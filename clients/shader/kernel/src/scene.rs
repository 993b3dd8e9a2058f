//! The surfaces f(p) = 0 of the gallery's still life: negative inside, and |f| never larger than the
//! distance. The CPU marches along f, and the GPU differentiates it.

use shading::{Real, Vec3};

pub const FLOOR: u32 = 0;
pub const BALL: u32 = 1;
pub const RING: u32 = 2;
pub const CUBE: u32 = 3;

pub fn surface<T: Real>(object: u32, p: Vec3<T>) -> T {
    match object {
        FLOOR => p.y,
        BALL => ball(p),
        RING => ring(p),
        _ => cube(p),
    }
}

fn from<T: Real>(center: [f32; 3], p: Vec3<T>) -> Vec3<T> {
    let [x, y, z] = center;
    Vec3::new(p.x - T::of_f32(x), p.y - T::of_f32(y), p.z - T::of_f32(z))
}

fn ball<T: Real>(p: Vec3<T>) -> T {
    let p = from([-1.35, 0.8, 0.25], p);
    p.dot(p).sqrt() - T::of_f32(0.8)
}

/// It stands upright.
fn ring<T: Real>(p: Vec3<T>) -> T {
    let p = from([0.35, 0.95, -1.0], p);
    let from_circle = (p.x * p.x + p.y * p.y).sqrt() - T::of_f32(0.7);
    (from_circle * from_circle + p.z * p.z).sqrt() - T::of_f32(0.25)
}

/// With round edges, and turned by 30° around the vertical.
fn cube<T: Real>(p: Vec3<T>) -> T {
    let p = from([1.5, 0.6, 0.3], p);
    let (cos, sin) = (T::of_f32(0.866_025_4), T::of_f32(0.5));
    let outside = |c: T| (c.abs() - T::of_f32(0.38)).at_least(T::ZERO);
    let outside = Vec3::new(
        outside(p.x * cos - p.z * sin),
        outside(p.y),
        outside(p.x * sin + p.z * cos),
    );
    outside.dot(outside).sqrt() - T::of_f32(0.22)
}
