//! The laws of local illumination, as a test suite for whatever shades: a renderer in any language,
//! or a shader on a GPU.
//!
//! # A renderer
//!
//! No light is negative. The light of two lamps is the sum of the light of each. A lamp farther away
//! is not brighter. Some thirty such laws need no reference picture, and one more compares with the
//! formulas, evaluated by [`shading`] in `f64`. In a test, that takes three lines:
//!
//! ```
//! # use shading_laws::Scene;
//! # fn my_color(scene: &Scene) -> [f64; 3] {
//! #     let lights = scene.lights.iter().map(|light| match light {
//! #         shading_laws::Light::Directional { l, intensity } => (l, intensity),
//! #         _ => unreachable!(),
//! #     });
//! #     let n = shading::Vec3::from(scene.n).unit().unwrap();
//! #     let mut sum = [0, 1, 2].map(|i| scene.material.k_a[i] * scene.i_a[i]);
//! #     for (l, intensity) in lights {
//! #         let cosine = n.dot(shading::Vec3::from(*l)).max(0.0);
//! #         for i in 0..3 {
//! #             sum[i] += scene.material.k_d[i] * intensity[i] * cosine;
//! #         }
//! #     }
//! #     sum
//! # }
//! # fn my_profile() -> shading_laws::Profile {
//! #     shading_laws::Profile {
//! #         models: vec![shading_laws::Model::Lambert],
//! #         point_lights: false,
//! #         spot_lights: false,
//! #         ..Default::default()
//! #     }
//! # }
//! # /*
//! #[test]
//! # */
//! fn my_renderer_obeys_the_laws() {
//!     shading_laws::check(shading_laws::from_fn(my_profile(), |scene| my_color(scene)));
//! }
//! # my_renderer_obeys_the_laws();
//! ```
//!
//! [`Scene`] is what there is to shade, and [`Profile`] what the renderer says of itself: its
//! precision, the models and lights that it has, and where it departs from the formulas on purpose.
//! A law that needs more than the renderer has is listed as not tried, never as passed. Whatever
//! shades in batches, such as a shader on a GPU, implements [`Renderer`]. [`Laws`] sets the seed and
//! the number of cases; without that, every run is the same.
//!
//! Where a law is broken, the [`Report`] shows the smallest scene that breaks it, as a line of the format and as Rust to copy
//! into a test, and names the [`Mistake`] that gives nearly all of the wrong colors:
//!
//! ```text
//! dark_side    311  BROKEN in 104
//!
//! Finding 1 of 1: dark_side
//! Likely cause: the highlight is not gated on N·L > 0, so faces turned away from a light have one
//!   It explains 100 % of the wrong colors: 24 of 24.
//! ```
//!
//! No tolerance is flat. Each follows, by a running error analysis, from the precision that the
//! renderer says it has and from the conditioning of the scene.
//!
//! A renderer in another language speaks JSON lines with the program `shading-laws`, which this
//! package has too.

#![allow(clippy::float_cmp)] // special cases are exact

// a renderer: each paragraph uses the ones above it
mod mistake;
mod profile;
mod renderer;
mod scene;

// the right color, how far a renderer may be from it, and the colors of mistakes
mod bounded;
mod reference;
mod reply;
mod textbook;

// scenes, and what must hold between their colors
mod batch;
mod case;
mod claim;
mod corpus;
mod generator;
mod law;
mod random;
mod smaller;

// a run: what it saw, what it may conclude, and what it says
mod cause;
mod coverage;
mod junit;
mod report;
mod reproduction;
mod run;
mod trial;

pub use cause::Cause;
pub use coverage::Exercised;
pub use mistake::{Fault, Mistake};
pub use profile::Profile;
pub use renderer::{Renderer, from_fn};
pub use report::{Counterexample, Finding, LawReport, Report, Verdict};
pub use reproduction::Reproduction;
#[doc(hidden)]
pub use run::Prepared;
pub use run::{Laws, Progress, check};
pub use scene::{Light, Material, Model, Scene, Triple};
#[doc(hidden)]
pub use textbook::compared;

/// The format that the program `shading-laws` and a renderer speak.
#[cfg(doc)]
#[doc = include_str!("../docs/format.md")]
pub mod format {}
