//! The promises of `shading`, proved from its own source. See README.md.

mod claims;
mod faults;
mod gappa;
mod power;
mod random;
/// What `power` imports from the crate.
mod real {
    pub use shading::Real;
}
mod smt;
mod table;

use std::path::Path;
use std::process::{Command, ExitCode};
use std::time::Instant;

use shading_proofs::{Format, Verdict, check_ranges, is_proved_by_intervals, judge};

const USAGE: &str = "prove [CLAIM]… | check RUNS | tried | rows | bounds FOLDER [SHARE] | roundings | smt FOLDER [CLAIM] | derivations \
                     | plant FOLDER | faults PROVER";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    if let Some(name) = unknown(&arguments) {
        eprintln!("there is no claim named {name}");
        return ExitCode::FAILURE;
    }
    let is_right = match arguments[..] {
        ["prove", ref names @ ..] => prove(names),
        ["check", runs] => runs.parse().is_ok_and(check),
        ["bounds", folder] => bounds(folder, "1"),
        ["bounds", folder, share] => bounds(folder, share),
        ["roundings"] => {
            faults::roundings().for_each(|(number, bound)| println!("{number} {bound}"));
            true
        }
        ["smt", folder] => solved(folder, ""),
        ["smt", folder, claim] => solved(folder, claim),
        ["derivations"] => {
            faults::derivations().for_each(|(number, claim)| println!("{number} {claim}"));
            true
        }
        ["plant", folder] => faults::plant(Path::new(folder))
            .map_err(|e| println!("{e}"))
            .is_ok(),
        ["faults", prover] => find(prover),
        ["tried"] => tried(),
        ["rows"] => {
            print!("{}", table::rows());
            true
        }
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

/// A name that no claim of the command has.
fn unknown<'a>(arguments: &[&'a str]) -> Option<&'a str> {
    let is_claim = |name: &str| claims::all().any(|claim| claim.name == name);
    let is_solved = |name: &str| claims::solved().any(|claim| claim.name == name);
    match arguments {
        ["prove", names @ ..] => names.iter().copied().find(|name| !is_claim(name)),
        ["smt", _, name] => Some(*name).filter(|name| !is_solved(name)),
        _ => None,
    }
}

/// Writes the error bounds, or a share of each, as scripts for Gappa.
fn bounds(folder: &str, share: &str) -> bool {
    share.parse().is_ok_and(|share| {
        gappa::write(Path::new(folder), share)
            .map_err(|e| println!("{e}"))
            .is_ok()
    })
}

/// Writes the claims for Bitwuzla, or one of them.
fn solved(folder: &str, claim: &str) -> bool {
    smt::write(Path::new(folder), claim)
        .map_err(|e| println!("{e}"))
        .is_ok()
}

/// Proves the claims with these names, or all of them.
fn prove(names: &[&str]) -> bool {
    let (mut by_intervals, mut by_relations, mut open) = (0, 0, 0);
    for claim in claims::all().filter(|claim| names.is_empty() || names.contains(&claim.name)) {
        for format in [Format::F32, Format::F64] {
            let start = Instant::now();
            if is_proved_by_intervals(format, claim.formula) {
                by_intervals += 1;
                continue;
            }
            let verdict = judge(format, claim.formula, 20_000);
            if verdict == Verdict::Proved {
                by_relations += 1;
            } else {
                open += 1;
                println!("{format:?} {} {}: {verdict}", claim.name, claim.promise);
            }
            let seconds = start.elapsed().as_secs_f64();
            if seconds > 5.0 {
                println!("{format:?} {} took {seconds:.0} s", claim.name);
            }
        }
    }
    let complaints = if names.is_empty() {
        table::complaints()
    } else {
        vec![]
    };
    for complaint in &complaints {
        println!("{complaint}");
    }
    println!(
        "claims: {by_intervals} proved by intervals, {by_relations} by relations, {open} open"
    );
    open == 0 && complaints.is_empty()
}

/// Tries every input of what has one input.
fn tried() -> bool {
    let is_proved = power::is_proved();
    println!(
        "{} {}",
        power::CLAIMS[0].0,
        if is_proved {
            "proved: every input tried"
        } else {
            "refuted"
        }
    );
    is_proved
}

/// Tests the prover: with numbers, each value must lie in the range that it derived. The formulas are
/// random ones, and those of the claims.
fn check(runs: u64) -> bool {
    let formats = [Format::F32, Format::F64];
    let of_random =
        (1..=50 * runs).flat_map(|seed| formats.map(|format| random::check(seed, format, 20)));
    let of_claims = claims::all()
        .flat_map(|claim| formats.map(|format| check_ranges(format, claim.formula, runs)));
    let mut compared = 0;
    for result in of_random.chain(of_claims) {
        match result {
            Ok(number) => compared += number,
            Err(wrong) => {
                println!("{wrong}");
                return false;
            }
        }
    }
    println!("prover: {compared} values compared with their ranges");
    true
}

/// Whether the prover with planted faults finds each of them, and proves the same claim without it; and
/// whether its tests find each wrong rule.
fn find(prover: &str) -> bool {
    let succeeds = |number: Option<usize>, arguments: [&str; 2]| {
        let planted = number.map_or(String::new(), |number| number.to_string());
        let output = Command::new(prover)
            .env("PLANTED", planted)
            .args(arguments)
            .output();
        output.is_ok_and(|output| output.status.success())
    };
    let mut found = 0;
    for (number, (file, old, new, claim)) in faults::FAULTS.iter().enumerate() {
        if succeeds(None, ["prove", claim]) && !succeeds(Some(number), ["prove", claim]) {
            found += 1;
        } else {
            println!("{claim} does not find the fault {number} in {file}: {new} instead of {old}");
        }
    }
    let mut refuted = 0;
    for (rule, (file, old, new)) in faults::RULES.iter().enumerate() {
        if succeeds(Some(faults::FAULTS.len() + rule), ["check", "20"]) {
            println!(
                "the prover's tests do not find the wrong rule in {file}: {new} instead of {old}"
            );
        } else {
            refuted += 1;
        }
    }
    let (faults, rules) = (faults::FAULTS.len(), faults::RULES.len());
    println!("faults: {found} of {faults} found; wrong rules: {refuted} of {rules} found");
    found == faults && refuted == rules
}
