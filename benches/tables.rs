//! `cargo bench` from the root: prints the tables of the package `shading-benches`, and passes words on to it.

use std::process::{Command, ExitCode};

fn main() -> ExitCode {
    let words = std::env::args().skip(1).filter(|word| word != "--bench");
    let status = Command::new(env!("CARGO"))
        .args([
            "bench",
            "--package",
            "shading-benches",
            "--features",
            "peers",
            "--bench",
            "time",
            "--",
        ])
        .args(words)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .status();
    ExitCode::from(u8::from(!status.is_ok_and(|status| status.success())))
}
