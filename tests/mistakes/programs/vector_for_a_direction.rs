//! Accepted: no attribute can add to this error, and it names the expected type. The page of
//! `UnitVec3` begins with the ways to make one.

use shading::f32::{UnitVec3, Vec3};
use shading::term;

fn main() {
    let l = Vec3::new(0.0, 3.0, 4.0);
    let _cosine = term::lambert(UnitVec3::Z, l);
}
