//! The promises of `shading`, proved from its own source. See README.md.

mod claims;
mod gappa;

use std::fs;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use claims::{CLAIMS, Claim};
use shading_proofs::{Format, Verdict, judge, smt};

const USAGE: &str = "prove [CLAIM]…";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let is_right = match arguments[..] {
        ["prove", ref names @ ..] => prove(names),
        ["bounds", folder] => bounds(folder, "1"),
        ["bounds", folder, share] => bounds(folder, share),
        ["queries", folder, ref names @ ..] => queries(Path::new(folder), names)
            .map_err(|error| println!("{error}"))
            .is_ok(),
        _ => {
            eprintln!("{USAGE}");
            false
        }
    };
    if is_right {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

fn chosen<'a>(names: &'a [&str]) -> impl Iterator<Item = &'static Claim> + 'a {
    CLAIMS
        .iter()
        .filter(move |claim| names.is_empty() || names.contains(&claim.name))
}

/// Writes the error bounds, or a share of each, as scripts for Gappa.
fn bounds(folder: &str, share: &str) -> bool {
    let share = share.parse().expect("a share");
    gappa::write(Path::new(folder), share).is_ok()
}

/// Writes the queries of these claims, or of all, each to a file of its own.
fn queries(folder: &Path, names: &[&str]) -> std::io::Result<()> {
    fs::create_dir_all(folder)?;
    for claim in chosen(names) {
        for format in [Format::F32, Format::F64] {
            for (i, query) in smt::queries(format, claim.formula).iter().enumerate() {
                let file = format!("{}.{format:?}.{i}.smt2", claim.name);
                fs::write(folder.join(file), query)?;
            }
        }
    }
    Ok(())
}

/// Proves the claims with these names, or all of them.
fn prove(names: &[&str]) -> bool {
    let mut open = 0;
    for claim in chosen(names) {
        for format in [Format::F32, Format::F64] {
            let start = Instant::now();
            let verdict = judge(format, claim.formula, 20_000);
            let s = start.elapsed().as_secs_f64();
            if verdict != Verdict::Proved || s > 1.0 {
                open += 1;
                println!(
                    "{format:?} {} {}: {}  {s:.1}",
                    claim.name,
                    claim.promise,
                    verdict.to_string().chars().take(300).collect::<String>()
                );
            }
        }
    }
    println!("{open}");
    open == 0
}
