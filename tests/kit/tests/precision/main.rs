//! The error of each function: the same formula is evaluated with 150 bits, from exactly the
//! numbers that the function was given.
//!
//! `docs/precision.md` has a derived bound for each error, and the largest error that a search
//! found. The search climbs hills, and is the same in each run and on every machine, because its
//! inputs come from correctly rounded operations only. By default it climbs a few of the hills
//! behind the page's figures; all of them take minutes:
//!
//! ```text
//! SHADING_SEARCH=all cargo test --release -p kit --test precision
//! ```

mod many_digits;
mod measure;
mod search;
mod table;

use table::{Row, line, rows};

const PAGE: &str = include_str!("../../../../docs/precision.md");

/// The number of hills behind the page's figures, and the number climbed by default.
const ALL: u64 = 40;
const FEW: u64 = 4;

#[test]
fn no_error_exceeds_its_bound() {
    let is_all = std::env::var("SHADING_SEARCH").is_ok_and(|extent| extent == "all");
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
        assert!(
            found <= bound,
            "{function}: found {found}, but {bound} is the proved bound"
        );
    }
    let measured = single
        .iter()
        .zip(&double)
        .map(line)
        .collect::<Vec<_>>()
        .join("\n");
    println!("{measured}");
    // what proves a bound is no measurement: the last column is checked where the bounds are proved
    let (errors, varied) = PAGE
        .split_once("## What the search varied")
        .expect("a heading");
    let lines = errors.lines().filter(|line| line.starts_with("| `"));
    let rows = lines
        .filter_map(|line| line.strip_suffix(" |")?.rsplit_once("| "))
        .map(|(row, _)| row.to_owned() + "|");
    let documented = rows.collect::<Vec<_>>().join("\n");
    let named: Vec<_> = varied
        .lines()
        .filter_map(|line| line.strip_prefix("| `")?.split(" | ").next())
        .flat_map(|functions| functions.split("; "))
        .map(|function| format!("`{}", function.trim_start_matches('`')))
        .collect();
    for Row { function, .. } in &single {
        let count = named.iter().filter(|name| *name == function).count();
        assert_eq!(count, 1, "rows that say what was varied for {function}");
    }
    if is_all {
        assert!(
            documented == measured,
            "docs/precision.md says\n{documented}\nbut the measurement gives\n{measured}"
        );
    } else {
        assert_eq!(
            documented.lines().count(),
            single.len(),
            "rows of docs/precision.md"
        );
        documented.lines().zip(measured.lines()).for_each(compare);
    }
}

/// Compares a line of the page with the measurement on some of its hills. Function, bound, and unit
/// must be the same. The error must not exceed the page's, nor be so far below it that the search
/// could be at fault.
fn compare((documented, measured): (&str, &str)) {
    let [documented, measured] =
        [documented, measured].map(|line| line.split(" | ").collect::<Vec<_>>());
    for (column, (documented, measured)) in documented.into_iter().zip(measured).enumerate() {
        if column == 1 || column == 2 {
            let [limit, found] =
                [documented, measured].map(|x| x.parse::<f64>().expect("a number"));
            assert!(
                found <= limit && found >= limit / 3.0,
                "found {found}, but the page says {limit}"
            );
        } else {
            assert_eq!(documented, measured, "docs/precision.md");
        }
    }
}
