//! Every function of `shading.h` has the bits of the crate.

use std::path::Path;

use host::{answer, bytes, compiled};
use shading_languages::{Function, functions};
use support::{ALL, Draw, arguments, is_sound};

mod host;
mod support;

/// The first difference between the program and the crate.
fn difference(program: &Path, function: &Function, draw: Draw, count: usize) -> Option<String> {
    let all = arguments(function, draw, count);
    let inputs: usize = function.parameters.iter().map(|p| p.1.width()).sum();
    let found = answer(program, function.name, &bytes(&all)).expect("an answer");
    let found: Vec<_> = found
        .chunks_exact(4)
        .map(|b| f32::from_le_bytes(b.try_into().unwrap()))
        .collect();
    let results = function.result.width();
    assert_eq!(found.len(), count * results);
    let mut different = 0;
    let mut first = None;
    for (x, y) in all.chunks(inputs).zip(found.chunks(results)) {
        let right = (function.compute)(x);
        assert_eq!(right.len(), y.len());
        if right.iter().zip(y).any(|(a, b)| a.to_bits() != b.to_bits()) {
            different += 1;
            first.get_or_insert_with(|| format!("{x:?}: the crate {right:?}, the file {y:?}"));
        }
        assert!(
            is_sound(function, y),
            "{} {draw:?} {x:?}: {y:?}",
            function.name
        );
    }
    first.map(|first| {
        format!(
            "{} {draw:?}: {different} of {count}, first {first}",
            function.name
        )
    })
}

#[test]
fn each_bit_is_the_crates() {
    let warnings = [
        "-Wall",
        "-Wextra",
        "-pedantic",
        "-Wdouble-promotion",
        "-Werror",
    ];
    let command = [&["gcc", "-std=c99", "-O2"], &warnings[..]].concat();
    let program = compiled(&command, &host::program(|_| true), "bits-gcc").unwrap();
    let mut all = vec![];
    for draw in ALL {
        all.extend(
            functions()
                .iter()
                .filter_map(|function| difference(&program, function, draw, 20_000)),
        );
    }
    assert!(all.is_empty(), "{}", all.join("\n"));
    let light = host::light();
    let found = answer(&program, "levels", &bytes(&light)).expect("an answer");
    assert!(
        found == host::levels_by_the_crate(&light),
        "a level differs"
    );
}
