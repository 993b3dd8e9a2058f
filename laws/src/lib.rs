//! The laws of local illumination, as a test suite for whatever shades.

mod profile;
mod renderer;
mod scene;

pub use profile::Profile;
pub use renderer::{Renderer, from_fn};
pub use scene::{Light, Material, Model, Scene, Triple};
