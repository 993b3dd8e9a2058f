//! The bits of every result.
//!
//! The other tests tolerate errors, and a changed formula may stay within their tolerances. This
//! test fails if any bit of any result changes, and names the function. **Bits change only by
//! decision**, and the changelog says which bits change and why. A new version of `libm` may change
//! the elementary functions and the powers of `f64`: adopting it is such a decision.
//!
//! The list of functions and the inputs are in `tests/functions`. The chips in `tests/firmware` run
//! the same code and must produce the same bits.

mod coverage;
mod interface;
#[cfg(feature = "wide")]
mod lanes;

use std::fs;

#[cfg(feature = "fixed")]
use functions::any_bits;
use functions::digest::{Fnv, Function, Of, absorb};

/// One line per function and number type, with the digest of all its results.
const PINNED: &str = include_str!("pinned.txt");

#[test]
fn bits_are_as_pinned() {
    let single = Of::<f32>::OF_NUMBERS
        .into_iter()
        .chain(Of::<f32>::OF_FLOATS);
    let double = Of::<f64>::OF_NUMBERS
        .into_iter()
        .chain(Of::<f64>::OF_FLOATS);
    assert_pinned(
        "pinned.txt",
        PINNED,
        lines("f32", single).chain(lines("f64", double)),
    );
}

#[cfg(feature = "fixed")]
#[test]
fn bits_of_fixed_point_are_as_pinned() {
    let mut digest = Fnv::EMPTY;
    any_bits::absorb(&mut digest);
    let any_bits = format!("{:016x} fixed any bits", digest.0);
    let lines = lines("fixed", Of::<shading::fixed::Fixed>::OF_NUMBERS).chain([any_bits]);
    assert_pinned("fixed.txt", include_str!("fixed.txt"), lines);
}

fn assert_pinned(file: &str, pinned: &str, lines: impl Iterator<Item = String>) {
    let lines: Vec<_> = lines.collect();
    let pinned: Vec<_> = pinned.lines().collect();
    if lines != pinned {
        let is_new = |line: &&String| !pinned.contains(&line.as_str());
        let new: Vec<_> = lines.iter().filter(is_new).collect();
        let now = format!("{}/{file}", env!("CARGO_TARGET_TMPDIR"));
        fs::write(&now, lines.join("\n") + "\n").expect("a file");
        panic!(
            "not in tests/bits/{file}:\n{new:#?}\n\
            If that is meant, say in CHANGELOG.md what changes and why, and run `.ci/renew pins`"
        );
    }
}

fn lines<T: functions::Number>(
    number: &str,
    lists: impl IntoIterator<Item = &'static [Function<T>]>,
) -> impl Iterator<Item = String> {
    lists.into_iter().flatten().map(move |function| {
        let (name, _) = function;
        let mut digest = Fnv::EMPTY;
        absorb(&[*function], &mut digest);
        format!("{:016x} {number} {name}", digest.0)
    })
}
