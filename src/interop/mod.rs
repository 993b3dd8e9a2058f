//! Other crates' traits for this crate's types, one file a crate.

#[cfg(feature = "approx")]
mod approx;
