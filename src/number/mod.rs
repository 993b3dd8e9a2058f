//! Numbers: the trait that every formula is written over, and its floats.

mod angle;
pub(crate) mod cast;
mod elementary;
mod extent;
pub(crate) mod falloff;
mod float;
pub(crate) mod length;
mod literal;
pub(crate) mod lobe;
mod mask;
pub mod power;
mod real;
mod root;
mod scalar;
pub(crate) mod triple;

pub(crate) use angle::angle;
pub use elementary::Elementary;
pub(crate) use extent::{epsilon, least};
pub(crate) use length::{cold, is_extreme};
pub(crate) use literal::{constant, parts, whole};
pub use lobe::Lobe;
pub(crate) use lobe::{by_squaring, shininess};
pub use mask::{Mask, Select};
pub(crate) use real::magnitude;
pub use real::{Dimmed, LightSum, Measured, Real, Toward};
pub(crate) use root::const_sqrt;
pub use scalar::Scalar;
