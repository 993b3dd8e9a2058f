//! The optional features that implement the traits and conversions of other crates. Each has a file
//! with its name.

#[cfg(feature = "approx")]
mod approx;
#[cfg(feature = "bytemuck")]
#[allow(unsafe_code)] // its traits are unsafe to implement
mod bytemuck;
#[cfg(feature = "defmt")]
mod defmt;
#[cfg(feature = "mint")]
mod mint;
#[cfg(feature = "serde")]
mod serde;
