//! The promises of `shading`, proved from its own source. See README.md.

mod claims;
mod gappa;
mod operands;

use std::fs;
use std::path::Path;
use std::process::ExitCode;

use claims::{Claim, claims};
use shading_proofs::{Format, Verdict, judge, smt};

const USAGE: &str =
    "claims | prove [CLAIM]… | queries FOLDER [CLAIM]… | bounds FOLDER [SHARE] | operands";
const FORMATS: [Format; 2] = [Format::F32, Format::F64];

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let is_right = match arguments[..] {
        ["claims"] => {
            chosen(&[]).for_each(|claim| println!("{}: {}", claim.name, claim.by));
            true
        }
        ["prove", ref names @ ..] => prove(names),
        ["queries", folder, ref names @ ..] => queries(Path::new(folder), names).is_ok(),
        ["bounds", folder] => gappa::write(Path::new(folder), 1.0).is_ok(),
        ["bounds", folder, share] => share
            .parse()
            .is_ok_and(|share| gappa::write(Path::new(folder), share).is_ok()),
        ["operands"] => {
            operands::print();
            true
        }
        _ => {
            eprintln!("{USAGE}");
            false
        }
    };
    ExitCode::from(u8::from(!is_right))
}

fn chosen(names: &[&str]) -> impl Iterator<Item = Claim> {
    let is_chosen = |claim: &Claim| names.is_empty() || names.contains(&claim.name);
    claims().into_iter().filter(is_chosen)
}

/// Proves the claims with these names, or all of them: the rules must prove those that are theirs,
/// leave open those that another tool completes, and refute none.
fn prove(names: &[&str]) -> bool {
    let (mut proved, mut left, mut wrong) = (0, 0, 0);
    for claim in chosen(names) {
        for format in FORMATS {
            let verdict = judge(format, claim.formula, 20_000);
            match (claim.by.starts_with("rules"), &verdict) {
                (true, Verdict::Proved) => proved += 1,
                (false, Verdict::Open(_)) => left += 1,
                _ => {
                    wrong += 1;
                    println!("{} {format:?}, by {}: {verdict}", claim.name, claim.by);
                }
            }
        }
    }
    println!("{proved} proved by the rules, {left} left to Bitwuzla and Gappa, {wrong} wrong");
    wrong == 0
}

/// Writes the queries of these claims, or of all, each to a file of its own.
fn queries(folder: &Path, names: &[&str]) -> std::io::Result<()> {
    fs::create_dir_all(folder)?;
    for claim in chosen(names) {
        for format in FORMATS {
            for (i, query) in smt::queries(format, claim.formula).iter().enumerate() {
                let file = format!("{}.{format:?}.{i}.smt2", claim.name);
                fs::write(folder.join(file), query)?;
            }
        }
    }
    Ok(())
}
