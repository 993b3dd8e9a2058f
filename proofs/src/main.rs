//! The promises of `shading`, proved from its own source. See README.md.

mod claims;

use std::process::ExitCode;
use std::time::Instant;

use claims::{CLAIMS, Claim};
use shading_proofs::{Format, Verdict, judge};

const USAGE: &str = "prove [CLAIM]…";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let is_right = match arguments[..] {
        ["prove", ref names @ ..] => prove(names),
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
