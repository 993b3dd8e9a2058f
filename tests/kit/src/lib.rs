//! What the tests share.
//!
//! The one table of the public functions, with a call of each: a new function takes one row in
//! `table.rs`: a name, a call, and what holds of the result whatever the bits of the arguments.
//! [`for_each_function`] hands all rows to a macro of the caller's; [`digest`] is one such caller.
#![no_std]
#![allow(clippy::float_cmp)] // floats are compared bit for bit, on purpose
#![allow(clippy::must_use_candidate, clippy::missing_panics_doc)] // lints for users; a panic is a failed test

#[cfg(feature = "std")]
extern crate std;

#[macro_use]
mod table;

#[cfg(feature = "fixed")]
pub mod any_bits;
pub mod digest;
pub mod given;
pub mod number;
pub mod places;
pub mod random;

#[cfg(feature = "std")]
pub mod everything;
#[cfg(feature = "std")]
pub mod promise;

pub use digest::{Each, Sink, Value};
pub use given::{Given, Input};
pub use number::{Float, Number, direction, rgb, vector};
pub use table::row;
