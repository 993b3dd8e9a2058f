//! Accepted: the operators belong to the standard library, so no attribute of ours changes the error.
//! The page of `Real` shows `T::of(2.0)`.

use shading::{Real, Vec3};

fn ball<T: Real>(p: Vec3<T>) -> T {
    p.dot(p) - 1.0
}

fn main() {
    let _ = ball(Vec3::new(1.0_f32, 0.0, 0.0));
}
