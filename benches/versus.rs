//! This crate against the same formulas by hand: Blinn–Phong, RGB, attenuation, 4 lights, 4,096
//! points. Prints nanoseconds per point and light, and lines `ratio <case> <ours/theirs>`.
//!
//! `cargo bench --bench versus` runs the scalar part as it is built by default, then builds itself
//! again for this very processor and runs the part in lanes.

#[path = "versus/by_hand.rs"]
mod by_hand;
#[cfg(c_peers)]
#[path = "versus/c.rs"]
mod c;
#[path = "versus/contest.rs"]
mod contest;
#[cfg(feature = "wide")]
#[path = "versus/lanes.rs"]
mod lanes;
#[path = "versus/ours.rs"]
mod ours;
#[path = "versus/scalar.rs"]
mod scalar;
#[path = "versus/scene.rs"]
mod scene;
#[cfg(feature = "wide")]
#[path = "versus/wide.rs"]
mod wide;

fn main() {
    #[cfg(feature = "wide")]
    lanes::contest();
    if cfg!(not(feature = "wide")) {
        scalar::contest();
        std::process::exit(run_for_this_processor());
    }
}

/// Builds and runs the part in lanes.
fn run_for_this_processor() -> i32 {
    let run = std::process::Command::new(env!("CARGO"))
        .args([
            "bench",
            "--quiet",
            "--bench",
            "versus",
            "--features",
            "wide",
        ])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(["--target-dir", "../target/native"])
        .env("RUSTFLAGS", "-C target-cpu=native")
        .status();
    match run {
        Ok(status) => status.code().unwrap_or(1),
        Err(error) => {
            eprintln!("versus: cannot start cargo for the lanes: {error}");
            1
        }
    }
}
