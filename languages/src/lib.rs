//! The formulas of [`shading`] in other languages.
pub mod dialect;
mod file;
mod graph;
mod kind;
mod number;
mod print;
mod table;
mod tree;
mod values;

pub use file::{files, text};
pub use kind::{Arguments, Kind};
pub use number::Expr;
pub use table::{Function, functions};
