//! Normals: of surfaces, of the vertices of a mesh, and made from other normals.
//!
//! | you have | use |
//! |---|---|
//! | the coefficients of a plane | [`plane`] |
//! | the vertices of a triangle | [`triangle`] |
//! | a sphere | [`sphere`] |
//! | a function f(p), 0 on the surface | [`implicit`], or [`from_gradient`] if you know ∇f |
//! | a function s(u, v), a point of the surface | [`parametric`], or [`from_tangents`] if you know the tangents |
//! | a mesh to be smoothed | [`corner`] |
//! | a normal, and a surface seen from both sides | [`facing`] |
//! | a normal and a matrix | [`transformed`] |
//! | a normal and a normal map | [`mapped`] |
//! | texture coordinates, and no tangents for the map | [`tangent`] |
//!
//! A normal is a [`UnitVec3`](crate::UnitVec3), and the functions return `None` if there is no
//! normal. Your arguments decide which side of the surface is outside. Turn a normal around with
//! `-n`, or toward the eye with [`facing`].

mod adjusted;
mod corner;
mod surface;
mod tangent;

pub use adjusted::{facing, mapped, transformed};
pub use corner::corner;
pub use surface::{from_gradient, from_tangents, implicit, parametric, plane, sphere, triangle};
pub use tangent::tangent;
