//! This crate against the same formulas written by hand: Blinn–Phong, RGB, attenuation, 4 lights, 4,096
//! points; then the power alone against two `powf`; then one point at a time with 4, 8 and 32 lights in
//! lanes. Prints nanoseconds, and the lines `ratio <case> <ours/theirs>` for the shortest times and
//! `ratio-of-medians <case> <ours/theirs>`.
//!
//! `cargo bench -p shading-benches --bench versus` runs the scalar parts in a default build. It then builds itself again with
//! the feature `wide` and runs the lights in lanes, and once more for the processor of this machine and
//! runs all parts with SIMD lanes.

#[path = "versus/by_hand.rs"]
mod by_hand;
#[cfg(c_peers)]
#[path = "versus/c.rs"]
mod c;
#[path = "versus/contest.rs"]
mod contest;
#[cfg(feature = "native")]
#[path = "versus/lanes.rs"]
mod lanes;
#[cfg(feature = "wide")]
#[path = "versus/lights.rs"]
mod lights;
#[path = "versus/ours.rs"]
mod ours;
#[path = "versus/power.rs"]
mod power;
#[path = "support/rebuilt.rs"]
mod rebuilt;
#[path = "versus/scalar.rs"]
mod scalar;
#[path = "versus/scene.rs"]
mod scene;
#[cfg(feature = "native")]
#[path = "versus/wide.rs"]
mod wide;

fn main() {
    #[cfg(feature = "native")]
    lanes::contest();
    #[cfg(feature = "wide")]
    lights::contest();
    if cfg!(not(feature = "wide")) {
        scalar::contest();
        power::contest();
        rebuilt::with_lanes("versus");
        rebuilt::native("versus");
    }
}
