//! Calls every public item of `shading` as its users do: from outside, without `std`, with each feature.
//!
//! Each item is written with its full name, also where a user would write an operator or a method:
//! `tests/every_item.rs` looks the names up.
#![no_std]

pub mod features;
pub mod formulas;
pub mod numbers;
pub mod scenes;
pub mod types;
pub mod vectors;
