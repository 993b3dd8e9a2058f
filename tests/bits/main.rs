//! The bits of every result.
//!
//! The other tests tolerate errors, and a changed formula may stay within their tolerances. This test fails
//! if any bit of any result changes, and names the function. **Bits change only by decision**, and the
//! changelog says which bits change and why. A new version of `libm` may change the elementary functions:
//! adopting it is such a decision.
//!
//! The list of functions and the inputs are in `tests/kit`. The chips in `tests/firmware` run the same code
//! and must produce the same bits.

mod coverage;
#[cfg(feature = "wide")]
mod lanes;
mod layers;

use std::fs;

use kit::digest::{Fnv, Function, Of, absorb};

#[test]
fn bits_are_as_pinned() {
    let single = Of::<f32>::OF_NUMBERS
        .into_iter()
        .chain(Of::<f32>::OF_FLOATS);
    let double = Of::<f64>::OF_NUMBERS
        .into_iter()
        .chain(Of::<f64>::OF_FLOATS);
    let lines = lines("f32", single).chain(lines("f64", double));
    assert_pinned("pinned.txt", include_str!("pinned.txt"), lines);
}

#[cfg(feature = "fixed")]
#[test]
fn bits_of_fixed_point_are_as_pinned() {
    let mut digest = Fnv::EMPTY;
    kit::any_bits::absorb(&mut digest);
    let any_bits = format!("{:016x} fixed any bits", digest.0);
    let lines = lines("fixed", Of::<shading::fixed::Fixed>::OF_NUMBERS).chain([any_bits]);
    assert_pinned("fixed.txt", include_str!("fixed.txt"), lines);
}

fn lines<T: kit::Number>(
    number: &str,
    lists: impl IntoIterator<Item = &'static [Function<T>]>,
) -> impl Iterator<Item = String> {
    lists.into_iter().flatten().map(move |function| {
        let mut digest = Fnv::EMPTY;
        absorb(&[*function], &mut digest);
        format!("{:016x} {number} {}", digest.0, function.0)
    })
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
