//! This crate against the same formulas written by hand: Blinn–Phong, RGB, attenuation, 4 lights,
//! 4,096 points; then the power alone against two `powf`. Prints nanoseconds, and the lines `ratio
//! <case> <ours/theirs>` for the shortest times and `ratio-of-medians <case> <ours/theirs>`.
//!
//! `cargo bench --bench versus` runs the scalar parts in a default build, then builds itself again
//! for the processor of this machine and runs the part with SIMD lanes.

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
#[path = "support/native.rs"]
mod native;
#[path = "versus/ours.rs"]
mod ours;
#[path = "versus/power.rs"]
mod power;
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
        power::contest();
        std::process::exit(native::run("versus"));
    }
}
