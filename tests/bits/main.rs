//! The bits of every result.
//!
//! The other tests tolerate errors, and a changed formula may stay within their tolerances. This
//! test fails if any bit of any result changes, and names the function. **Bits change only by
//! decision**, and the changelog says which bits change and why. A new version of `libm` may change
//! the elementary functions and the powers of `f64`: adopting it is such a decision.
//!
//! The list of functions and the inputs are in [`digest`]. The chips in `tests/firmware` run the
//! same code and must produce the same bits.

mod digest;
#[cfg(feature = "wide")]
mod lanes;

use std::any::type_name;
use std::fs;

use digest::{Float, Fnv, Of, absorb};

/// One line per function and number type, with the digest of all its results.
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
