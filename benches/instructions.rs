//! Counts the instructions of each public function under valgrind, whose counts are exactly
//! reproducible, and compares them with the table in `instructions.txt`.
//!
//! - `cargo bench -p shading-benches --bench instructions` prints the table;
//! - with `-- --check`, it fails if a count differs from the table by more than 3%;
//! - with `-- --write`, it writes the table.
//!
//! Each function is called out of line for 4,096 random arguments; `nothing` is the cost of that
//! alone. The bench builds itself again with the feature `wide`, for the lights in lanes.

#[path = "support/functions.rs"]
mod functions;
#[path = "support/rebuilt.rs"]
mod rebuilt;
#[path = "support/table.rs"]
mod table;

use std::process::{Command, ExitCode};

use table::Table;

const TABLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/instructions.txt");

fn main() -> ExitCode {
    if cfg!(not(feature = "wide")) {
        rebuilt::with_lanes("instructions");
        return ExitCode::SUCCESS;
    }
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let Some(name) = arguments.iter().find_map(|a| a.strip_prefix("--call=")) {
        call(name);
        return ExitCode::SUCCESS;
    }
    let given = |option: &str| arguments.iter().any(|a| a == option);
    match report(given("--check"), given("--write")) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("instructions: {message}");
            ExitCode::FAILURE
        }
    }
}

fn report(check: bool, write: bool) -> Result<(), String> {
    let counts = functions::all().map(|(name, _)| Ok((*name, count(name)?)));
    let table = Table(counts.collect::<Result<_, String>>()?);
    print!("{table}");
    if write {
        std::fs::write(TABLE, table.to_string()).map_err(|error| format!("{TABLE}: {error}"))?;
    }
    if check {
        let kept = std::fs::read_to_string(TABLE).map_err(|error| format!("{TABLE}: {error}"))?;
        table.compare(&kept)?;
    }
    Ok(())
}

/// The number of instructions per call.
fn count(name: &str) -> Result<f64, String> {
    let this = std::env::current_exe().map_err(|error| error.to_string())?;
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .args(["--collect-atstart=no", "--toggle-collect=shading_counted_*"])
        .arg(this)
        .arg(format!("--call={name}"))
        .output()
        .map_err(|error| format!("cannot run valgrind: {error}"))?;
    let said = String::from_utf8_lossy(&output.stderr);
    let collected = said
        .lines()
        .find_map(|line| line.split_once("Collected : "));
    let instructions: Option<f64> = collected.and_then(|(_, number)| number.trim().parse().ok());
    match instructions {
        Some(instructions) if output.status.success() => {
            Ok(instructions / f64::from(functions::CALLS))
        }
        _ => Err(format!("valgrind counted nothing for {name}: {said}")),
    }
}

/// Calls a function at each of the random places.
fn call(name: &str) {
    let found = functions::all().find(|(known, _)| *known == name);
    let (_, function) = found.unwrap_or_else(|| panic!("no function {name}"));
    for place in &functions::places() {
        function(place);
    }
}
