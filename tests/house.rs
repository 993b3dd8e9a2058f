//! The source tree agrees with the tables in its documentation.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The Rust files in a folder and its subfolders, or the one file.
fn rust_files(path: &Path) -> Vec<PathBuf> {
    if path.is_file() {
        let is_rust = path.extension().is_some_and(|extension| extension == "rs");
        return is_rust.then(|| path.to_owned()).into_iter().collect();
    }
    let entries = fs::read_dir(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let paths = entries.map(|entry| entry.expect("an entry").path());
    paths.flat_map(|path| rust_files(&path)).collect()
}

fn at_root(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

fn read(path: impl AsRef<Path>) -> String {
    let path = path.as_ref();
    fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// The cells of the Markdown table whose header contains `title`, row by row.
fn table<'a>(page: &'a str, title: &str) -> Vec<Vec<&'a str>> {
    let text = |line: &'a str| line.trim_start_matches("//! ").trim_start_matches("/// ");
    let lines = page.lines().map(text);
    let from_title = lines.skip_while(|line| !(line.starts_with('|') && line.contains(title)));
    let rows = from_title.skip(2).take_while(|line| line.starts_with('|'));
    rows.map(|row| row.trim_matches('|').split('|').map(str::trim).collect())
        .collect()
}

/// The names in backticks.
fn names(cell: &str) -> impl Iterator<Item = &str> {
    cell.split('`').skip(1).step_by(2)
}

/// A file uses only files below it, or to its left on its own floor, in the table of `src/lib.rs`.
/// Files that are not in the table, such as the optional features, stand above all of it.
#[test]
fn no_file_uses_one_above_it() {
    let lib = read(at_root("src/lib.rs"));
    let rows = table(&lib, "| floor |");
    let upward = rows.iter().rev().flat_map(|cells| names(cells[1]));
    let upward: Vec<&str> = upward.collect();
    let place = |module: &str| upward.iter().position(|name| *name == module);
    let place = |module: &str| place(module).unwrap_or(upward.len());
    let reexported = reexported(&lib);

    let mut modules = BTreeSet::new();
    let mut wrong = Vec::new();
    for path in rust_files(&at_root("src")) {
        let own = module(&path);
        for used in used_modules(&read(&path)) {
            let used = reexported.get(&used).unwrap_or(&used);
            if own != "lib" && *used != own && place(used) >= place(&own) {
                wrong.push(format!("{own} uses {used}"));
            }
        }
        modules.insert(own);
    }
    let missing = upward.iter().filter(|name| !modules.contains(**name));
    wrong.extend(missing.map(|name| format!("{name} is missing")));
    assert!(
        wrong.is_empty(),
        "{wrong:?}; the files from the lowest floor up are {upward:?}"
    );
}

/// The module that a file of `src` is or belongs to.
fn module(path: &Path) -> String {
    let path = path.strip_prefix(at_root("src")).expect("a file of src");
    let path = path.with_extension("");
    let first = path.iter().next().expect("a name");
    first.to_string_lossy().into_owned()
}

/// The names that `lib.rs` re-exports, each with the module that it comes from.
fn reexported(lib: &str) -> BTreeMap<String, String> {
    let code = code(lib);
    let uses = code.split("pub use ").skip(1);
    let mut modules = BTreeMap::new();
    for (module, names) in uses.filter_map(|path| path.split_once("::")) {
        for name in heads(names) {
            modules.insert(name, module.to_owned());
        }
    }
    modules
}

/// The modules named after `crate::` in the paths of a file.
fn used_modules(source: &str) -> BTreeSet<String> {
    let code = code(source);
    let names = code.split("crate::").skip(1).flat_map(heads);
    names.filter(|name| !name.is_empty()).collect()
}

/// A file without its comments, on one line.
fn code(source: &str) -> String {
    let lines = source.lines().map(str::trim);
    let lines: Vec<_> = lines.filter(|line| !line.starts_with("//")).collect();
    lines.join(" ")
}

/// The name that a path begins with, or those in a list in braces.
fn heads(path: &str) -> Vec<String> {
    let Some(list) = path.strip_prefix('{') else {
        let is_name = |c: &char| c.is_alphanumeric() || *c == '_';
        return vec![path.chars().take_while(is_name).collect()];
    };
    let list = list.split_once(';').map_or(list, |(list, _)| list);
    let mut depth = 0;
    let items = list.split(|c| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        depth == 0 && c == ','
    });
    items.map(str::trim).flat_map(heads).collect()
}

/// A dual number hands every hidden operation on to the number that it is made of, except for two that follow
/// from the operators, and for one that asks for an order, which the number need not have.
#[test]
fn dual_numbers_hand_every_operation_on() {
    let real = code(&read(at_root("src/real/mod.rs")));
    let dual = code(&read(at_root("src/dual/real.rs")));
    let hidden = real.split("#[doc(hidden)]").skip(1);
    let names = hidden
        .filter_map(|item| item.split_once("fn "))
        .map(|(_, item)| {
            let end = item.find(['(', '<']).expect("arguments");
            &item[..end]
        });
    let missing: Vec<_> = names
        .filter(|name| !["any_outside", "scaled", "cosine_of_half_angle"].contains(name))
        .filter(|name| {
            !dual.contains(&format!("fn {name}(")) && !dual.contains(&format!("fn {name}<"))
        })
        .collect();
    assert!(missing.is_empty(), "{missing:?}");
}

/// Each invariant has a number and a row, and each property appears in a row.
#[test]
fn table_of_invariants_is_complete() {
    let readme = read(at_root("tests/README.md"));
    let rows = table(&readme, "| invariant |");
    let rows: Vec<_> = rows
        .iter()
        .filter(|cells| !cells[1].starts_with("**"))
        .collect();
    let mut numbers: Vec<usize> = rows
        .iter()
        .filter_map(|cells| cells[0].parse().ok())
        .collect();
    numbers.sort_unstable();
    assert!(
        numbers.into_iter().eq(1..=rows.len()),
        "a number is missing or appears twice"
    );

    let named = rows.iter().flat_map(|cells| names(cells[cells.len() - 1]));
    let is_file = |name: &String| Path::new(name).extension().is_some();
    let (files, named): (BTreeSet<_>, BTreeSet<_>) = named.map(str::to_owned).partition(is_file);
    let folders = ["laws/src/number", "tests/invariants", "tests"].map(at_root);
    for file in files {
        assert!(
            folders.iter().any(|folder| folder.join(&file).exists()),
            "{file}"
        );
    }
    assert_same(&named, &properties());
}

/// The names in the lists `properties! { … }`, and those of the tests beside them.
fn properties() -> BTreeSet<String> {
    let mut properties = BTreeSet::new();
    let folders = ["laws/src/number", "tests/invariants"].map(at_root);
    for path in folders.iter().flat_map(|folder| rust_files(folder)) {
        let code = code(&read(path));
        for list in code.split("properties! {").skip(1) {
            let list = list.split('}').next().unwrap_or_default();
            let names = list
                .split(',')
                .filter_map(|name| name.rsplit([':', ']']).next()) // drop a label
                .map(str::trim)
                .filter(|name| !name.is_empty());
            properties.extend(names.map(str::to_owned));
        }
        let tests = code.split("#[test] fn ").skip(1).flat_map(heads);
        properties.extend(tests.filter(|name| !name.is_empty()));
    }
    properties
}

/// The list of the public interface, by which the tests find a function without a row or a call,
/// has every function of the source.
#[test]
fn public_interface_is_listed() {
    let interface = read(at_root("tests/public-api/interface.txt"));
    let listed: BTreeSet<_> = interface
        .split(|c: char| !c.is_alphanumeric() && c != '_')
        .collect();
    let is_core = |path: &PathBuf| !path.starts_with(at_root("src/features"));
    for path in rust_files(&at_root("src")).into_iter().filter(is_core) {
        let source = read(&path);
        let functions = ["pub fn ", "pub const fn "].map(|start| source.split(start).skip(1));
        for item in functions.into_iter().flatten() {
            let name = item.split(['(', '<']).next().unwrap_or_default();
            let path = path.display();
            assert!(
                listed.contains(name),
                "{name} of {path} is not in interface.txt"
            );
        }
    }
}

/// Each test program is in the table, and the table has nothing else.
#[test]
fn table_of_tests_is_complete() {
    let readme = read(at_root("tests/README.md"));
    let rows = table(&readme, "| test |");
    let named = rows.iter().flat_map(|cells| names(cells[0]));
    let named = named
        .map(|name| name.trim_end_matches('/').to_owned())
        .collect();

    let entries = fs::read_dir(at_root("tests")).expect("a folder");
    let entries = entries.map(|entry| entry.expect("an entry").path());
    let is_test = |path: &PathBuf| {
        let programs = ["main.rs", "Cargo.toml"].map(|name| path.join(name));
        path.extension().is_some_and(|e| e == "rs") || programs.iter().any(|path| path.exists())
    };
    let name = |path: PathBuf| {
        path.file_stem()
            .map(|name| name.to_string_lossy().into_owned())
    };
    assert_same(&named, &entries.filter(is_test).filter_map(name).collect());
}

fn assert_same(table: &BTreeSet<String>, there: &BTreeSet<String>) {
    let too_many: Vec<_> = table.difference(there).collect();
    let missing: Vec<_> = there.difference(table).collect();
    assert!(
        too_many.is_empty() && missing.is_empty(),
        "the table has {too_many:?} and lacks {missing:?}"
    );
}

/// The page of `Lanes` names the functions that ask for a scalar, and no others.
#[test]
fn lanes_page_names_what_does_not_take_them() {
    let interface = read(at_root("tests/public-api/interface.txt"));
    let functions = interface.lines().filter_map(|line| {
        let function = line.strip_prefix("pub fn shading::")?;
        function.contains("shading::Scalar").then_some(function)
    });
    // `Vec3<T>::unit(self) -> …` is `Vec3::unit`
    let name = |function: &str| {
        let path = function.split('(').next().expect("a path");
        let before = path
            .split('<')
            .map(|part| part.rsplit('>').next().expect("a part"));
        before.collect::<String>()
    };
    let asking: BTreeSet<String> = functions.map(name).collect();

    let page = read(at_root("src/features/wide/mod.rs"));
    let rows = table(&page, "| not in lanes |");
    let listed: BTreeSet<String> = rows
        .iter()
        .flat_map(|cells| names(cells[0]))
        .map(str::to_owned)
        .collect();
    assert_eq!(listed, asking);
    assert!(!asking.is_empty());
}
