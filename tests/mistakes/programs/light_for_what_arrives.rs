//! Accepted: no attribute can add to an error about the items of an iterator. The error names
//! `IncidentLight`, and the page of that type shows how to get one: `sun.at(p)`.

use shading::f32::{DirectionalLight, Material, Rgb, UnitVec3};
use shading::shade;

const CLAY: Material = Material { k_a: Rgb::WHITE, k_d: Rgb::WHITE, k_s: Rgb::WHITE, m: 32 };

fn main() {
    let sun = DirectionalLight { l: UnitVec3::Z, intensity: Rgb::WHITE };
    let _shaded = shade::lambert(UnitVec3::Z, &CLAY, Rgb::BLACK, [sun]);
}
