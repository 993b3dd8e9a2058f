//! The formulas of the crate [`shading`] as files to copy, in WGSL, GLSL, HLSL, Metal and C; and a surface of your
//! own, with its exact normal, in each of them.
//!
//! The files stand beside this package's manifest; [`files`] writes them anew. [`implicit`] and
//! [`parametric`] write a surface that you describe by a generic function.
//!
//! A number that records, [`Expr`], computes the functions of the crate. What it has recorded is a graph of
//! operations, in which equal ones are one; a printer turns it into statements, by the table of a
//! [language](dialect::Dialect).

pub mod dialect;
mod file;
mod graph;
mod kind;
mod light;
mod number;
mod print;
mod surface;
mod table;
mod tree;
mod vector;
mod wrap;

pub use file::{files, text};
pub use kind::Kind;
pub use number::Expr;
pub use surface::{implicit, parametric};
pub use table::{Function, functions};
