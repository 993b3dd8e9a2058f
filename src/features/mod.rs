//! The optional features, one file each, named as the feature: other crates' types and traits.

#[cfg(feature = "approx")]
mod approx;
#[cfg(feature = "wide")]
mod wide;
