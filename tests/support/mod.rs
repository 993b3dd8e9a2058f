//! What the tests share.
#![allow(dead_code, unused_imports, unused_macros)] // each test program takes a part of it
#![allow(clippy::float_cmp)] // where floats are compared, the very bits are meant

pub mod everything;
pub mod flushing;
pub mod number;
pub mod reference;
pub mod running;
pub mod scene;
pub mod surfaces;
