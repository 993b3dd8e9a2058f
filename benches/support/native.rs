//! Builds a bench a second time, with SIMD lanes and for the processor of this machine.

use std::process::Command;

/// Builds and runs the bench, and returns its exit status.
pub fn run(bench: &str) -> i32 {
    let run = Command::new(env!("CARGO"))
        .args(["bench", "--quiet", "--bench", bench, "--features", "wide"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(["--target-dir", "../target/native"])
        .env("RUSTFLAGS", "-C target-cpu=native")
        .status();
    match run {
        Ok(status) => status.code().unwrap_or(1),
        Err(error) => {
            eprintln!("{bench}: cannot start cargo for the SIMD build: {error}");
            1
        }
    }
}
