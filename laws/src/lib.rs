//! [format]: crate::format
#![doc = include_str!("../README.md")]
#![forbid(unsafe_code)]
#![deny(missing_docs)]
#![allow(clippy::float_cmp)] // special cases are exact

// a renderer
mod profile;
mod renderer;
mod scene;

// the right color, how far a renderer may be from it, and the colors of mistakes
mod bounded;
mod formula;
mod mistakes;

// scenes, and what must hold between their colors
mod claim;
mod corpus;
mod edit;
mod generator;
mod law;
mod random;
mod shrink;

// a run: what it saw, what it may conclude, and what it says
mod cause;
mod place;
mod plan;
mod report;
mod run;

#[cfg(test)]
mod tests;

pub use cause::Cause;
pub use claim::Broken;
pub use mistakes::Fault;
pub use place::Place;
pub use profile::Profile;
pub use renderer::{Renderer, from_fn};
pub use report::{Counterexample, Finding, LawReport, Report, Verdict};
pub use run::{Laws, check};
pub use scene::{Kind, Light, Model, Scene, Triple};

/// The format that the program `shading-laws` and a renderer speak.
#[cfg(doc)]
#[doc = include_str!("../docs/format.md")]
pub mod format {}
