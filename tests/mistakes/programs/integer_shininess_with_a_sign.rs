//! Improved: a note on `Exponent` lists the types of a shininess.

use shading::{UnitVec3, term};

fn main() {
    let (r, v) = (UnitVec3::<f32>::Z, UnitVec3::Z);
    let m: i32 = 32;
    let _highlight = term::phong(r, v, m);
}
