//! Improved: a note on `Exponent` says that the models are in `shade`.

use shading::f32::{Material, Rgb, UnitVec3};
use shading::term::phong;

const CLAY: Material = Material { k_a: Rgb::WHITE, k_d: Rgb::WHITE, k_s: Rgb::WHITE, m: 32 };

fn main() {
    let (n, v) = (UnitVec3::Z, UnitVec3::Z);
    let _shaded = phong(n, v, &CLAY, Rgb::BLACK, []);
}
