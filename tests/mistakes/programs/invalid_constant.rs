//! Accepted: the error names the constant and shows the call. The page of each constructor says what
//! the constructor refuses.

use shading::f32::{Attenuation, UnitVec3};

const FALLOFF: Attenuation = Attenuation::new(1.0, -0.25, 0.0).unwrap();
const ASIDE: UnitVec3 = UnitVec3::new(1.0, 0.0, 1.0).unwrap();

fn main() {
    let _ = (FALLOFF, ASIDE);
}
