//! Fixed point: numbers against exact integers, directions and falloff against their bounds, constructors, and
//! colors against the same formulas in `f64`.

mod colors;
mod constructors;
mod falloff;
mod normals;
mod numbers;
mod products;
mod rises;
#[allow(dead_code)]
#[path = "../../src/target.rs"]
mod target; // which `products` reads
mod vectors;

// files of the crate, of which the tests try what is private
#[allow(dead_code, clippy::pedantic)]
#[path = "../../src/fixed/product.rs"]
mod product;
#[allow(dead_code, clippy::pedantic)]
#[path = "../../src/fixed/reciprocal.rs"]
mod reciprocal;

use kit::random::Random;
use shading::fixed::Fixed;

/// Zero, the powers of two and their neighbors, with both signs, and so both ends of the range.
fn edges() -> Vec<Fixed> {
    let powers = (0..32).map(|k| 1_i64 << k);
    let near = powers.flat_map(|power| [power - 1, power, power + 1]);
    let steps = near.flat_map(|steps| [steps, -steps]);
    let fitting = steps.filter_map(|steps| i32::try_from(steps).ok());
    fitting.map(Fixed::from_bits).collect()
}

/// A number in steps.
fn steps(number: Fixed) -> f64 {
    f64::from(number.to_bits())
}

fn exact(number: Fixed) -> f64 {
    f64::from(number)
}
