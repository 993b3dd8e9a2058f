//! A bench built a second time, with lanes and for this very processor.

use std::process::Command;

/// Builds and runs it; its exit status.
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
            eprintln!("{bench}: cannot start cargo for the lanes: {error}");
            1
        }
    }
}
