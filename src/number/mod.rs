//! What numbers are made of. A number of your own is a [`Real`]; this module has the other
//! names that its author may need.
//!
//! The simplest number needs none of them; [`guide::numbers`](mod@crate::guide::numbers) has one.

mod angle;
pub(crate) mod cast;
pub(crate) mod cosine;
pub(crate) mod elementary;
mod extent;
pub(crate) mod falloff;
#[cfg(feature = "serde")]
mod file;
mod float;
pub(crate) mod length;
mod literal;
pub(crate) mod lobe;
mod mask;
pub mod power;
pub(crate) mod real;
mod root;
pub(crate) mod scalar;
pub(crate) mod triple;

pub(crate) use angle::angle;
pub(crate) use elementary::Elementary;
pub(crate) use extent::{epsilon, least};
#[cfg(feature = "serde")]
pub use file::{Read, Written};
pub(crate) use length::{cold, is_extreme};
pub(crate) use literal::{constant, parts, whole};
pub(crate) use lobe::{Lobe, by_squaring, shininess};
pub use mask::Mask;
pub use real::{Dimmed, LightSum, Measured, Toward};
pub(crate) use real::{Real, magnitude};
pub(crate) use root::const_sqrt;
pub(crate) use scalar::Scalar;
