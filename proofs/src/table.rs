//! The claims against the tables of the documentation.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::{claims, gappa, power};

#[path = "../../tests/bits/interface.rs"]
mod interface;

/// Why a row of `docs/totality.md` is not proved; the page explains each.
const REASONS: [&str; 7] = [
    "digits",
    "products",
    "a real m",
    "lanes",
    "every input is tried",
    "a sign of zero alone",
    "another machine",
];
const BEGIN: &str = "| claim | what is proved |\n|---|---|\n";
const UNPROVED: &str = "| not proved | why, and what is done instead |\n|---|---|\n";

fn read(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path);
    fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

const SECTION: &str = "| the section *";

/// The rows of `docs/proofs.md`, one for each claim.
pub fn rows() -> String {
    claims::all()
        .chain(claims::solved())
        .map(|claim| (claim.name, claim.promise))
        .chain(power::CLAIMS)
        .fold(String::new(), |rows, (name, promise)| {
            rows + &format!("| `{name}` | {promise} |\n")
        })
}

/// What the tables lack, or have too much.
pub fn complaints() -> Vec<String> {
    let (claims, page) = (read("docs/proofs.md"), read("docs/totality.md"));
    let mut complaints = of_functions(&claims);
    complaints.extend(gappa::complaints(&read("docs/precision.md")));
    if !claims.contains(&format!("{BEGIN}{}\n", rows())) {
        complaints
            .push("docs/proofs.md lists other claims; `shading-proofs rows` prints them".into());
    }
    for section in page
        .split("\n## ")
        .filter(|section| section.contains("\n|---"))
    {
        let title = section.lines().next().unwrap_or_default();
        if section.contains("| proved | test |") {
            complaints.extend(of_section(section));
        } else if !claims.contains(&format!("\n{SECTION}{title}* of ")) {
            complaints.push(format!(
                "the section {title} is neither proved nor explained"
            ));
        }
    }
    complaints
}

/// Each public function has a claim, or stands in the table of those that are tested only.
fn of_functions(page: &str) -> Vec<String> {
    let untested = page
        .split(UNPROVED)
        .nth(1)
        .and_then(|table| table.split("\n\n").next())
        .unwrap_or_default();
    let explained: String = untested
        .lines()
        .filter(|row| !row.starts_with(SECTION))
        .filter_map(|row| row.split(" | ").next())
        .collect();
    let proved = rows();
    let is_in = |text: &str, function: &str| {
        let short = function
            .split_once("::")
            .filter(|(module, _)| module.starts_with(char::is_lowercase));
        [Some(function), short.map(|(_, name)| name)]
            .into_iter()
            .flatten()
            .any(|name| text.contains(&format!("`{name}`")))
    };
    let wrong = |function: &String| match (is_in(&proved, function), is_in(&explained, function)) {
        (false, false) => Some(format!(
            "{function} has no claim, and docs/proofs.md does not say why"
        )),
        (true, true) => Some(format!(
            "{function} has a claim, and docs/proofs.md says why it has none"
        )),
        _ => None,
    };
    let functions = interface::public_functions();
    let named = explained.split('`').skip(1).step_by(2);
    let unknown = named
        .filter(|name| !functions.contains(*name))
        .map(|name| format!("there is no function {name}"));
    unknown.chain(functions.iter().filter_map(wrong)).collect()
}

/// Each row has a claim, or a reason.
fn of_section(section: &str) -> Vec<String> {
    let known: BTreeSet<&str> = claims::all().map(|claim| claim.name).collect();
    let mut complaints = Vec::new();
    let rows = section
        .lines()
        .filter(|line| line.starts_with("| ") && !line.contains("| proved | test |"));
    for row in rows {
        let cells: Vec<&str> = row.split(" | ").collect();
        let proved = if cells.len() == 5 { cells[3] } else { "" };
        let (cited, reason) = match proved.split_once("no") {
            Some((cited, reason)) if cited.is_empty() || cited.ends_with("; ") => {
                (cited, Some(reason))
            }
            _ => (proved, None),
        };
        let cited: Vec<&str> = cited.split('`').skip(1).step_by(2).collect();
        let is_explained = |reason: &str| {
            REASONS
                .iter()
                .any(|known| reason.ends_with(&format!(": {known}")))
        };
        if let Some(name) = cited.iter().find(|name| !known.contains(*name)) {
            complaints.push(format!("no claim {name}: {row}"));
        } else if reason.is_some_and(|reason| !is_explained(reason))
            || reason.is_none() && cited.is_empty()
        {
            complaints.push(format!("neither proved nor explained: {row}"));
        }
    }
    complaints
}
