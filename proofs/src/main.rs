//! The promises of `shading`, proved from its own source. See README.md.

mod claims;

use std::time::Instant;

use shading_laws::proof::{Format, Verdict, check_ranges, judge};

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let names: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match names[..] {
        ["check"] => check(2_000),
        _ => prove(&names),
    }
}

fn prove(names: &[&str]) {
    let (mut proved, mut open) = (0, 0);
    for claim in claims::all().filter(|claim| names.is_empty() || names.contains(&claim.name)) {
        for format in [Format::F32, Format::F64] {
            let start = Instant::now();
            let verdict = judge(format, claim.formula, 20_000);
            *if verdict == Verdict::Proved { &mut proved } else { &mut open } += 1;
            println!("{:8.3} s {format:?} {}: {verdict}", start.elapsed().as_secs_f64(), claim.name);
        }
    }
    println!("{proved} proved by ranges, {open} open");
}

fn check(runs: u64) {
    let mut compared = 0;
    for claim in claims::all() {
        for format in [Format::F32, Format::F64] {
            match check_ranges(format, claim.formula, runs) {
                Ok(number) => compared += number,
                Err(wrong) => println!("{} {format:?}: {wrong}", claim.name),
            }
        }
    }
    println!("{compared} values, each in its range");
}
