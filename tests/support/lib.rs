//! Code that the tests share.

#![allow(clippy::float_cmp)] // floats are compared bit for bit, on purpose
#![allow(clippy::missing_panics_doc, clippy::must_use_candidate)] // these lints are for users; a panic is a failed test

pub mod everything;
pub mod flushing;
pub mod number;
pub mod running;
