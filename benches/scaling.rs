//! The time over points × lights, from one to a million, drawn into `target/scaling.svg` and
//! `target/numbers.svg`: it grows linearly. Fails if anything is allocated.
//!
//! It then draws three ways to shade with many lights: one by one, lights in lanes, points in lanes.
//! `target/lights.svg` is for a default build; `target/lights_native.svg` and the other charts are for
//! the processor of this machine.

#![allow(clippy::cast_precision_loss)] // a million is exact

#[cfg(feature = "wide")]
#[path = "scaling/allocations.rs"]
mod allocations;
#[cfg(feature = "wide")]
#[path = "scaling/chart.rs"]
mod chart;
#[cfg(feature = "wide")]
#[path = "scaling/growth.rs"]
mod growth;
#[cfg(feature = "wide")]
#[path = "scaling/measure.rs"]
mod measure;
#[cfg(not(feature = "wide"))]
#[path = "support/rebuilt.rs"]
mod rebuilt;
#[cfg(feature = "wide")]
#[path = "scaling/ways.rs"]
mod ways;

#[cfg(not(feature = "wide"))]
fn main() {
    rebuilt::with_lanes("scaling");
    rebuilt::native("scaling");
}

#[cfg(feature = "wide")]
const TARGET: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../target/");

#[cfg(feature = "wide")]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    if cfg!(feature = "native") {
        growth::draw()?;
        ways::draw("lights_native.svg")
    } else {
        ways::draw("lights.svg")
    }
}
