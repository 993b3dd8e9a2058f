//! Builds a bench again, with other features or for the processor of this machine.

use std::process::{Command, exit};

/// Builds and runs the bench with the feature `wide`.
#[allow(dead_code)] // not every bench does
pub fn with_lanes(bench: &str) {
    run(bench, "wide", &mut Command::new(env!("CARGO")));
}

/// Builds and runs the bench with the feature `native`, for the processor of this machine.
#[allow(dead_code)]
pub fn native(bench: &str) {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.env("CARGO_TARGET_DIR", "../target/native");
    run(
        bench,
        "native",
        cargo.env("RUSTFLAGS", "-C target-cpu=native"),
    );
}

/// Passes on the arguments of this program, and exits as the bench does if it fails.
fn run(bench: &str, feature: &str, cargo: &mut Command) {
    let arguments = std::env::args().skip(1).filter(|a| a != "--bench");
    let run = cargo
        .args([
            "bench",
            "--quiet",
            "--bench",
            bench,
            "--features",
            feature,
            "--",
        ])
        .args(arguments)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .status();
    match run {
        Ok(status) if status.success() => {}
        Ok(status) => exit(status.code().unwrap_or(1)),
        Err(error) => {
            eprintln!("{bench}: cannot start cargo with the feature {feature}: {error}");
            exit(1);
        }
    }
}
