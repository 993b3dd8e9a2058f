//! [format]: crate::format
#![doc = include_str!("../README.md")]
#![forbid(unsafe_code)]
#![deny(missing_docs)]
#![allow(clippy::float_cmp)] // special cases are exact
#![allow(clippy::test_attr_in_doctest)] // the page shows a whole file of tests

// Each group uses only itself and those above it, and no two files use each other.

// a scene, and numbers that know their error
mod bounded;
mod scene;

// a renderer
mod profile;
mod renderer;

// the right color, how far a renderer may be from it, and the colors of mistakes
mod formula;
mod mistakes;

// scenes, simpler ones, and what must hold of their colors
mod corpus;
mod edit;
mod generator;
mod law;
mod random;
mod shrink;

// a run: what it tries, what it may conclude, and what it says
mod cause;
mod evidence;
mod experiment;
mod options;
mod place;
mod plan;
mod report;
mod run;
mod search;

pub use cause::Cause;
pub use law::Broken;
pub use mistakes::Fault;
pub use options::{Clock, Laws};
pub use place::Place;
pub use profile::Profile;
pub use renderer::{Progress, Renderer, from_fn};
pub use report::{Counterexample, Finding, LawReport, Report, Verdict};
pub use run::check;
pub use scene::{Kind, Light, Model, Scene, Triple};

/// The format that the program `shading-laws` and a renderer speak.
#[cfg(doc)]
#[doc = include_str!("../docs/format.md")]
pub mod format {}
