//! The optional features, which implement other crates' traits and conversions. Each has a file
//! or a folder with its name.

#[cfg(feature = "approx")]
mod approx;
#[cfg(feature = "bytemuck")]
#[allow(unsafe_code)] // its traits are unsafe to implement
mod bytemuck;
#[cfg(feature = "defmt")]
mod defmt;
#[cfg(feature = "fixed")]
pub mod fixed;
#[cfg(feature = "mint")]
mod mint;
#[cfg(feature = "serde")]
mod serde;
#[cfg(feature = "wide")]
mod wide;

#[cfg(feature = "wide")]
pub use wide::Lanes;
