//! What the tests share.

#![allow(clippy::float_cmp)] // where floats are compared, the very bits are meant
#![allow(clippy::missing_panics_doc, clippy::must_use_candidate)] // for users; a panic is a failed test

pub mod everything;
pub mod flushing;
pub mod number;
