//! Floor 3: normals of surfaces, and what is done with normals.
//!
//! All of them have length 1, and are `None` where there is no normal. Whether the normal of a
//! surface points outside follows from what you pass in; turn it with `-n`, or to the eye with
//! [`facing`].

mod corner;
mod derived;
mod surface;

pub use corner::corner;
pub use derived::{facing, mapped, transformed};
pub use surface::{from_gradient, from_tangents, implicit, parametric, plane, sphere, triangle};
