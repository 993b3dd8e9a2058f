//! How far each function is from its formula: the same formula is evaluated with 150 bits from the
//! very numbers that the function was given.
//!
//! `docs/precision.md` has a bound for each error, derived, and the largest error that a search found.
//! The search climbs hills, and is the same in each run and on every machine: its inputs are made of
//! correctly rounded operations alone. By default it climbs a few of the hills that the page's
//! figures come from; all of them take minutes:
//!
//! ```text
//! SHADING_SEARCH=all cargo test --release --test precision
//! ```

mod any_size;
mod many_digits;
mod measure;
mod search;
mod table;

use table::{Row, line, rows};

const PAGE: &str = include_str!("../../docs/precision.md");

/// How many hills the page's figures come from, and how many are climbed by default.
const ALL: u64 = 400;
const FEW: u64 = 4;

#[test]
fn no_error_that_is_found_exceeds_its_bound() {
    let is_all = std::env::var_os("SHADING_SEARCH").is_some();
    let hills = if is_all { ALL } else { FEW };
    let (single, double) = std::thread::scope(|scope| {
        let double = scope.spawn(|| rows::<f64>(hills));
        (rows::<f32>(hills), double.join().expect("no panic"))
    });
    for row in single.iter().chain(&double) {
        let Row {
            function,
            found,
            bound,
            ..
        } = row;
        assert!(found <= bound, "{function}: {found}, and {bound} is proved");
    }
    let measured: Vec<String> = single.iter().zip(&double).map(line).collect();
    let measured = measured.join("\n");
    println!("{measured}");
    let lines = PAGE.lines().filter(|line| line.starts_with("| `"));
    let told = lines.collect::<Vec<_>>().join("\n");
    if is_all {
        assert!(
            told == measured,
            "docs/precision.md says\n{told}\nbut measured is\n{measured}"
        );
    } else {
        assert_eq!(
            told.lines().count(),
            single.len(),
            "rows of docs/precision.md"
        );
        told.lines().zip(measured.lines()).for_each(compare);
    }
}

/// A line of the page and of what was measured on some of its hills: the same function, bound and unit,
/// and an error that is not above the page's, and not so far below that the search could be at fault.
fn compare((told, measured): (&str, &str)) {
    let [told, measured] = [told, measured].map(|line| line.split(" | ").collect::<Vec<_>>());
    for (column, (told, measured)) in told.into_iter().zip(measured).enumerate() {
        if column == 1 || column == 2 {
            let [most, found] = [told, measured].map(|x| x.parse::<f64>().expect("a number"));
            assert!(
                found <= most && found >= most / 3.0,
                "found {found}, on the page {most}"
            );
        } else {
            assert_eq!(told, measured, "docs/precision.md");
        }
    }
}
