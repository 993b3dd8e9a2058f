//! Floor 3: normals of planes, triangles, spheres, implicit and parametric surfaces.
//!
//! All of them have length 1, and are `None` where the surface has no normal. Whether a normal
//! points outside follows from what you pass in; turn it with `-n`.

mod surface;

pub use surface::{from_gradient, from_tangents, implicit, parametric, plane, sphere, triangle};
