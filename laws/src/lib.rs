//! The laws of local illumination, as a test suite for whatever shades.

#![allow(clippy::float_cmp)] // special cases are exact

mod bounded;
mod claim;
mod generator;
mod law;
mod mistake;
mod profile;
mod reference;
mod renderer;
mod report;
mod run;
mod scene;
mod textbook;

pub use mistake::Mistake;
pub use profile::Profile;
pub use renderer::{Renderer, from_fn};
pub use report::{Counterexample, LawReport, Report, Verdict};
pub use run::{Laws, Progress, check};
pub use scene::{Light, Material, Model, Scene, Triple};
