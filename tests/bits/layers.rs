//! A file of `src` uses only files on layers below, or before it in its own, as the table of
//! CONTRIBUTING.md orders them. The optional features stand above all of them.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let files = paths.flat_map(|path| {
        if path.is_dir() {
            rust_files(&path)
        } else {
            vec![path]
        }
    });
    files
        .filter(|path| path.extension().is_some_and(|extension| extension == "rs"))
        .collect()
}

/// The files of the table, the lowest first.
fn layers() -> Vec<String> {
    let page = read(&root().join("CONTRIBUTING.md"));
    let table = page
        .lines()
        .skip_while(|line| !line.starts_with("| layer |"))
        .skip(2);
    let rows: Vec<_> = table.take_while(|line| line.starts_with('|')).collect();
    let names = |row: &str| {
        row.split('`')
            .skip(1)
            .step_by(2)
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    rows.into_iter().rev().flat_map(names).collect()
}

/// A file without its comments, on one line.
fn code(path: &Path) -> String {
    let text = read(path);
    text.lines()
        .map(str::trim)
        .filter(|line| !line.starts_with("//"))
        .collect::<Vec<_>>()
        .join(" ")
}

/// The names that a path begins with: one, or those of a list in braces.
fn heads(path: &str) -> Vec<&str> {
    let is_part = |c: char| !(c.is_alphanumeric() || c == '_');
    let Some(list) = path.strip_prefix('{') else {
        return path.split(is_part).take(1).collect();
    };
    let mut depth = 0;
    let list = list.split(';').next().unwrap_or_default();
    let items = list.split(|c| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        depth == 0 && c == ','
    });
    items.flat_map(|item| heads(item.trim())).collect()
}

/// The names that a path ends with, up to the semicolon: one, or those of a list in braces.
fn tails(path: &str) -> impl Iterator<Item = &str> {
    let list = path.split(';').next().unwrap_or_default();
    let items = list.split(['{', ',', '}']).map(str::trim);
    items.filter_map(|item| item.rsplit("::").next())
}

/// The file or folder of `src` that a path belongs to.
fn module(path: &Path) -> String {
    let inside = path
        .strip_prefix(root().join("src"))
        .expect("a file of src")
        .with_extension("");
    inside
        .iter()
        .next()
        .expect("a name")
        .to_string_lossy()
        .into_owned()
}

#[test]
fn no_file_uses_one_above_it() {
    let layers = layers();
    assert!(layers.len() > 10, "the table of layers in CONTRIBUTING.md");
    let place = |module: &str| {
        layers
            .iter()
            .position(|name| name == module)
            .unwrap_or(layers.len())
    };
    let lib = code(&root().join("src/lib.rs"));
    let paths = lib
        .split("pub use ")
        .skip(1)
        .filter_map(|path| path.split_once("::"));
    let reexported: BTreeMap<_, _> = paths
        .flat_map(|(module, names)| tails(names).map(move |name| (name, module)))
        .collect();
    let mut wrong = vec![];
    let mut uses = 0;
    for path in rust_files(&root().join("src")) {
        let (own, code) = (module(&path), code(&path));
        for used in code.split("crate::").skip(1).flat_map(heads) {
            let used = reexported.get(used).copied().unwrap_or(used);
            uses += 1;
            if !["lib", "features"].contains(&own.as_str())
                && used != own
                && place(used) >= place(&own)
            {
                wrong.push(format!("{own} uses {used}"));
            }
        }
    }
    assert!(uses > 50, "{uses}");
    let is_file = |name: &&String| {
        root().join("src").join(name).is_dir() || root().join(format!("src/{name}.rs")).is_file()
    };
    wrong.extend(
        layers
            .iter()
            .filter(|name| !is_file(name))
            .map(|name| format!("{name} is missing")),
    );
    assert!(
        wrong.is_empty(),
        "{wrong:?}; the layers, the lowest first, are {layers:?}"
    );
}
