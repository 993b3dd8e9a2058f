//! The one table of the public functions, with a call of each.
//!
//! A new function takes one row in `table.rs`: a name, a call, and what holds of the result
//! whatever the bits of the arguments. [`for_each_function`] hands all rows to a macro of the
//! caller's; [`digest`] is one such caller.
#![no_std]
#![allow(clippy::must_use_candidate)] // no user calls these functions

#[macro_use]
mod table;

#[cfg(feature = "fixed")]
pub mod any_bits;
pub mod digest;
pub mod given;
pub mod number;
pub mod places;
pub mod promise;
pub mod value;

pub use given::{Given, Input};
pub use number::{Float, Number};
pub use table::row;
pub use value::{Each, Sink, Value};
