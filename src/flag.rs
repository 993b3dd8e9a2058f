//! A yes or no in a public type.

/// A `bool`, except for rust-gpu. It cannot compile an `Option` of a type with spare values, as a
/// `bool` has them.
#[cfg(not(target_arch = "spirv"))]
pub(crate) type Flag = bool;
#[cfg(target_arch = "spirv")]
pub(crate) type Flag = u32;

pub(crate) const NO: Flag = false as Flag;
pub(crate) const YES: Flag = true as Flag;
