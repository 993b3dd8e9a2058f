//! How far each function is from its formula: the same formula is evaluated with 150 bits from the
//! very numbers that the function was given.
//!
//! The largest errors are the table of `docs/precision.md`, to a tenth. The inputs are the same in
//! each run, and are made of correctly rounded operations alone, so that a table that says more or
//! less than what is measured is wrong, on every machine.

mod many_digits;
mod measure;

#[path = "../support/srgb.rs"]
mod srgb;
#[path = "../support/mod.rs"]
mod support;

use std::fmt::Write;

use measure::{Row, encodings, rows};

const TABLE: &str = include_str!("../../docs/precision.md");

#[test]
fn table_of_errors_says_what_is_measured() {
    let (single, double) = std::thread::scope(|scope| {
        let double = scope.spawn(rows::<f64>);
        (rows::<f32>(), double.join().expect("no panic"))
    });
    let mut measured = String::new();
    for (
        Row {
            function,
            unit,
            error: single,
        },
        Row { error: double, .. },
    ) in single.into_iter().zip(double)
    {
        writeln!(
            measured,
            "| {function} | {single:.1} | {double:.1} | {unit} |"
        )
        .expect("a string");
    }
    for Row {
        function,
        unit,
        error,
    } in encodings()
    {
        writeln!(measured, "| {function} | {error:.1} | – | {unit} |").expect("a string");
    }
    println!("{measured}");
    let told: String = TABLE
        .lines()
        .filter(|line| line.starts_with("| `"))
        .flat_map(|line| [line, "\n"])
        .collect();
    assert!(
        told == measured,
        "docs/precision.md says\n{told}\nbut measured is\n{measured}"
    );
}
