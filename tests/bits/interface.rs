//! The public functions, read from the list of the interface. `proofs/` includes this file, too.

use std::collections::BTreeSet;

const INTERFACE: &str = include_str!("../public-api/interface.txt");

/// The last name of a path.
pub fn last(path: &str) -> &str {
    path.rsplit("::").next().unwrap_or_default()
}

/// The free functions and the methods of the interface, named as in the table. Those of an
/// implementation of a trait follow its line, `impl … for …`; the trait itself names them.
pub fn public_functions() -> BTreeSet<String> {
    let mut functions = BTreeSet::new();
    let mut implementor = None; // of a trait
    for line in INTERFACE.lines() {
        if line.starts_with("impl") {
            let header = line.split(" where ").next().unwrap_or_default();
            implementor = header.split_once(" for ").map(|(_, path)| plain(path));
        } else if let Some(function) = line.split_once("fn ").map(|(_, path)| plain(path)) {
            let of_a_trait = |owner: &String| function.starts_with(owner.as_str());
            if !implementor.as_ref().is_some_and(of_a_trait) {
                functions.insert(short(&function));
            }
        }
    }
    functions
}

/// A path without parameters: `shading::Vec3<T>::dot(self, …)` as `shading::Vec3::dot`.
fn plain(path: &str) -> String {
    let mut depth = 0;
    let is_outside = |c: &char| {
        depth += i32::from(*c == '<');
        let is_outside = depth == 0;
        depth -= i32::from(*c == '>');
        is_outside
    };
    let path = path.split('(').next().unwrap_or_default();
    path.chars().filter(is_outside).collect()
}

/// `shading::Vec3::dot` as `Vec3::dot`, `shading::reflection` as `reflection`.
fn short(function: &str) -> String {
    let names: Vec<_> = function.split("::").collect();
    match names[..] {
        [.., owner, name] if owner != "shading" => format!("{owner}::{name}"),
        _ => last(function).to_owned(),
    }
}
