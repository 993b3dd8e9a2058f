//! The bits of every result.
//!
//! The other tests allow for errors, and a change of a formula may stay within them. Here a change of any
//! bit of any result fails, and the failure names the function. **Bits change by decision only**, and
//! the changelog says which do and why. Another version of `libm` may change the elementary functions
//! and the powers of `f64`: to take it is such a decision.
//!
//! The list of functions and the inputs are in [`digest`]. The chips of `tests/firmware` run the same
//! and give the same bits.

mod digest;

use std::any::type_name;
use std::fs;

use digest::{Float, Fnv, Of, absorb};

/// A line a function and number type, with the digest of all results.
const PINNED: &str = include_str!("pinned.txt");

#[test]
fn bits_are_as_pinned() {
    let lines: Vec<_> = lines::<f32>().chain(lines::<f64>()).collect();
    let pinned: Vec<_> = PINNED.lines().collect();
    if lines != pinned {
        let is_new = |line: &&String| !pinned.contains(&line.as_str());
        let new: Vec<_> = lines.iter().filter(is_new).collect();
        let now = concat!(env!("CARGO_TARGET_TMPDIR"), "/pinned.txt");
        fs::write(now, lines.join("\n") + "\n").expect("a file");
        panic!(
            "not in tests/bits/pinned.txt:\n{new:#?}\n\
            If that is meant, say in CHANGELOG.md what changes and why, and\n\
            cp {now} tests/bits/pinned.txt"
        );
    }
}

fn lines<T: Float>() -> impl Iterator<Item = String> {
    let functions = Of::<T>::FUNCTIONS.iter().chain(Of::ANGLES);
    functions.map(|function| {
        let (name, _) = function;
        let mut digest = Fnv::EMPTY;
        absorb(&[*function], &mut digest);
        format!("{:016x} {} {name}", digest.0, type_name::<T>())
    })
}
