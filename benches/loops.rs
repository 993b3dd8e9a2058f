//! What a renderer calls for each pixel, vertex or light, beside the best of its rivals: inlined into a
//! loop over an array, and by a call; on random, smooth and hard data.
//!
//! `cargo bench --bench loops` prints nanoseconds in a loop and by a call, for each rival too, and the
//! ratios ours/theirs. A `!` marks a ratio above its limit. After three tries it fails.
//! The bench builds itself again with the feature `wide`, for several lights at a time.
//! `-- normals` runs the races of `loops/normals.rs` alone.

#[path = "loops/data.rs"]
mod data;
#[path = "loops/encodings.rs"]
mod encodings;
#[path = "loops/lights.rs"]
mod lights;
#[path = "loops/normals.rs"]
mod normals;
#[path = "loops/race.rs"]
mod race;
#[path = "support/rebuilt.rs"]
mod rebuilt;
#[path = "loops/terms.rs"]
mod terms;

use std::process::ExitCode;

/// Runs some races, and returns how many ratios exceed their limits.
type Races = fn() -> usize;

fn main() -> ExitCode {
    if cfg!(not(feature = "wide")) {
        rebuilt::with_lanes("loops");
        return ExitCode::SUCCESS;
    }
    let chosen: Vec<String> = std::env::args()
        .skip(1)
        .filter(|a| a != "--bench")
        .collect();
    let all: [(&str, Races); 4] = [
        ("encodings", encodings::race),
        ("lights", lights::race),
        ("normals", normals::race),
        ("terms", terms::race),
    ];
    let chosen = |name: &str| chosen.is_empty() || chosen.iter().any(|c| c == name);
    let exceeded: usize = all
        .iter()
        .filter(|(name, _)| chosen(name))
        .map(|(_, race)| race())
        .sum();
    if exceeded == 0 {
        return ExitCode::SUCCESS;
    }
    eprintln!("loops: {exceeded} ratios exceed their limits");
    ExitCode::FAILURE
}
