//! Every public function has a row in the table of `tests/kit`, and a row calls what it names.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// Functions without a row: they store what they are given, apply a function of the user's, round a
/// literal, differ in nothing but that they work in constants (`tests/totality` compares them), are those
/// of lanes (`lanes.txt`, `tests/lanes.rs`), or are the parts of a power, which the rows of `Lobe` compute.
const WITHOUT_A_ROW: [&str; 27] = [
    "new",
    "constant",
    "point",
    "cast",
    "map",
    "from_lanes",
    "to_lanes",
    "of",
    "of_f32",
    "const_new",
    "const_within",
    "const_from_srgb8",
    "const_from_half_angle",
    "const_from_half_angles",
    "from_fn",
    "first",
    "packed",
    "sum_of_lanes",
    "sum",
    "splat",
    "split",
    "two_to_low_bits",
    "unshifted",
    "single",
    "single_of_quotient",
    "double",
    "double_of_quotient",
];

macro_rules! names {
    ($($section:ident: $bound:ident {
        $($row:ident $name:literal |$given:ident| $call:expr => $promise:ident;)*
    })*) => {
        &[$($(($name, stringify!($call))),*),*]
    };
}

/// The name and the call of each row.
const ROWS: &[(&str, &str)] = kit::for_each_function!(names);

/// The public name of the function of a row.
fn function_of(name: &str) -> &str {
    let path = name.split(',').next().unwrap_or_default();
    path.rsplit("::").next().unwrap_or_default()
}

/// The names of public functions and of the methods of public traits, in the files of a folder.
fn public_functions(folder: &Path, names: &mut BTreeSet<String>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.ends_with("features") || path.ends_with("fixed") {
            continue; // which tests/features and tests/fixed call
        }
        if path.is_dir() {
            public_functions(&path, names);
            continue;
        }
        let (text, mut is_trait) = (fs::read_to_string(&path).expect("a file"), false);
        for line in text.lines() {
            if !line.starts_with(' ') {
                is_trait = line.starts_with("pub trait ");
            }
            let declaration = line.trim_start();
            let public = declaration
                .strip_prefix("pub ")
                .or(is_trait.then_some(declaration));
            let function = public.map(|rest| rest.strip_prefix("const ").unwrap_or(rest));
            if let Some(rest) = function.and_then(|rest| rest.strip_prefix("fn ")) {
                let name = rest.split(['(', '<']).next().unwrap_or_default();
                // a macro makes methods only of functions that have a name elsewhere
                if !name.starts_with('$') {
                    names.insert(name.to_owned());
                }
            }
        }
    }
}

#[test]
fn every_public_function_has_a_row() {
    let mut functions = BTreeSet::new();
    public_functions(
        &Path::new(env!("CARGO_MANIFEST_DIR")).join("src"),
        &mut functions,
    );
    assert!(functions.len() > 70, "{functions:#?}");
    let rows: BTreeSet<_> = ROWS.iter().map(|(name, _)| function_of(name)).collect();
    let has_row =
        |name: &&String| rows.contains(name.as_str()) || WITHOUT_A_ROW.contains(&name.as_str());
    let missing: Vec<_> = functions.iter().filter(|name| !has_row(name)).collect();
    assert!(
        missing.is_empty(),
        "no row in tests/kit/src/table.rs: {missing:#?}"
    );
}

#[test]
fn every_row_calls_what_it_names() {
    let mut seen = BTreeSet::new();
    for (name, call) in ROWS {
        assert!(seen.insert(name), "{name} has two rows");
        let function = function_of(name);
        // operators and conversions have no name of their own
        let is_type = function.starts_with(char::is_uppercase);
        let is_word = |word: &str| word == function;
        let mut words = call.split(|c: char| !c.is_alphanumeric() && c != '_');
        let is_called = words.any(is_word) || call.contains("T ::") || call.contains("T::");
        assert!(is_type || is_called, "{name} does not call {function}");
    }
}
