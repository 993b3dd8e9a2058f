//! Pictures for small displays, each a file to copy.
#![no_std]

pub mod ball;
pub mod ring;
