//! The claims against the tables of the documentation.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::claims;

/// Why a row of `docs/totality.md` is not proved; the page explains each.
const REASONS: [&str; 8] =
    ["digits", "products", "not generic", "a real m", "lanes", "of `libm`", "a sign of zero alone", "another machine"];
const BEGIN: &str = "| claim | what is proved |\n|---|---|\n";

fn read(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path);
    fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// The rows of `docs/proofs.md`, one for each claim.
pub fn rows() -> String {
    claims::all().fold(String::new(), |rows, claim| rows + &format!("| `{}` | {} |\n", claim.name, claim.promise))
}

/// What the tables lack, or have too much.
pub fn complaints() -> Vec<String> {
    let known: BTreeSet<&str> = claims::all().map(|claim| claim.name).collect();
    let mut complaints = Vec::new();
    if !read("docs/proofs.md").contains(&format!("{BEGIN}{}\n", rows())) {
        complaints.push("docs/proofs.md lists other claims; `shading-proofs rows` prints them".into());
    }
    let page = read("docs/totality.md");
    let floats = page.split("## Fixed point").next().unwrap_or_default();
    let rows = floats.lines().filter(|line| line.starts_with("| ") && line.ends_with(" |"));
    let mut number = 0;
    for row in rows.filter(|row| !row.contains("| proved | test |")) {
        number += 1;
        let cells: Vec<&str> = row.split(" | ").collect();
        let proved = if cells.len() == 5 { cells[3] } else { "" };
        let (cited, reason) = match proved.split_once("no") {
            Some((cited, reason)) if cited.is_empty() || cited.ends_with("; ") => (cited, Some(reason)),
            _ => (proved, None),
        };
        let cited: Vec<&str> = cited.split('`').skip(1).step_by(2).collect();
        let is_explained = |reason: &str| REASONS.iter().any(|known| reason.ends_with(&format!(": {known}")));
        let unknown = cited.iter().find(|name| !known.contains(*name));
        if let Some(name) = unknown {
            complaints.push(format!("no claim {name}: {row}"));
        } else if reason.is_some_and(|reason| !is_explained(reason)) || reason.is_none() && cited.is_empty() {
            complaints.push(format!("neither proved nor explained: {row}"));
        }
    }
    if number < 80 {
        complaints.push(format!("docs/totality.md has only {number} rows"));
    }
    complaints
}
