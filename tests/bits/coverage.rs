//! Every public function has a row in the table of `tests/functions`.

use std::collections::BTreeSet;

use crate::interface::{last, public_functions};

/// Functions that only move or convert numbers, or that are pinned elsewhere, and so need no row.
/// An owner of `_` stands for every type.
const WITHOUT_A_ROW: &[(&str, &[&str])] = &[
    // store what they are given
    ("Vec3", &["new"]),
    ("Rgb", &["new"]),
    ("Dual", &["constant", "point"]),
    // apply the user's own function; `PointLight::cast` has a row for all
    ("_", &["cast", "map"]),
    // the constructors in constants, which `tests/constructors.rs` compares with those that have a row
    ("Attenuation", &["new", "within"]),
    ("Cone", &["from_cosine", "from_half_angle"]),
    ("SoftCone", &["from_cosines", "from_half_angles"]),
    ("UnitVec3", &["new"]),
    // round a literal
    ("Real", &["of", "of_f32"]),
    (
        "Fixed",
        &["new", "from_bits", "from_f32", "to_bits", "to_f32"],
    ),
    // lanes, which `lanes.txt` pins or `tests/lanes` compares with what it pins
    ("_", &["packed", "sum_of_lanes"]),
    ("Lanes", &["first", "from_fn", "sum"]),
];

macro_rules! names {
    ($($section:ident: $bound:ident {
        $($row:ident $name:literal |$given:ident| $call:expr => $promise:ident;)*
    })*) => {
        &[$($(($name, stringify!($call))),*),*]
    };
}

/// The name and the call of each row.
const ROWS: &[(&str, &str)] = functions::for_each_function!(names);

/// The public name of the function of a row.
fn function_of(name: &str) -> &str {
    name.split(',').next().unwrap_or_default()
}

fn needs_no_row(function: &str) -> bool {
    let (owner, name) = function.split_once("::").unwrap_or_default();
    WITHOUT_A_ROW
        .iter()
        .any(|(of, names)| ["_", owner].contains(of) && names.contains(&name))
}

#[test]
fn every_public_function_has_a_row() {
    let rows: BTreeSet<_> = ROWS.iter().map(|(name, _)| function_of(name)).collect();
    let missing: Vec<_> = public_functions()
        .into_iter()
        .filter(|function| !needs_no_row(function) && !rows.contains(function.as_str()))
        .collect();
    assert!(
        missing.is_empty(),
        "no row in tests/functions/src/table.rs: {missing:#?}"
    );
}

/// A row names what it calls. Operators and conversions have no name of their own.
#[test]
fn every_row_calls_what_it_names() {
    let functions = public_functions();
    let mut seen = BTreeSet::new();
    for (name, call) in ROWS {
        assert!(seen.insert(name), "{name} has two rows");
        let function = function_of(name);
        let is_called = call
            .split(|c: char| !c.is_alphanumeric() && c != '_')
            .any(|word| last(function) == word)
            || call.contains("T ::"); // a checked constructor, which differs by number
        let is_type = function.starts_with(char::is_uppercase) && !function.contains("::");
        assert!(is_type || is_called, "{name} does not call {function}");
        assert!(
            is_type || is_inherited(function) || functions.contains(function),
            "{name}: there is no public function {function}"
        );
    }
}

/// Whether a row names the method of a trait by the type that implements it.
fn is_inherited(function: &str) -> bool {
    let (owner, name) = function.split_once("::").unwrap_or_default();
    name == "sum" || owner == "Dual"
}
