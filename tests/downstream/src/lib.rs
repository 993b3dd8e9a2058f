//! Uses every public item of `shading` as its users do: from outside, without `std`, with each
//! feature. `tests/functions` calls the functions; here is what its rows do not name. Whoever adds
//! an item that no row names adds it here: `tests/every_item.rs` looks the names up.
#![no_std]

#[cfg(all(test, feature = "fixed"))]
mod fixed;
#[cfg(test)]
mod items;
pub mod names;
pub mod traits;
#[cfg(all(test, feature = "wide"))]
mod wide;

use functions::digest::{Fnv, Function, Of, absorb};

/// Compiles the calls of the functions for the target.
#[must_use]
pub fn digest() -> u64 {
    let mut digest = Fnv::EMPTY;
    all(&Of::<f32>::OF_NUMBERS, &mut digest);
    all(&Of::<f32>::OF_FLOATS, &mut digest);
    all(&Of::<f64>::OF_NUMBERS, &mut digest);
    all(&Of::<f64>::OF_FLOATS, &mut digest);
    #[cfg(feature = "fixed")]
    all(&Of::<shading::fixed::Fixed>::OF_NUMBERS, &mut digest);
    digest.0
}

fn all<T: functions::Number>(sections: &[&[Function<T>]], digest: &mut Fnv) {
    for section in sections {
        absorb(section, digest);
    }
}
