//! Numbers in files.

use serde::{Deserialize, Serialize};

use super::{Real, Scalar};

/// A number that a file can hold: what a scene needs to be written.
pub trait Written: Real + Scalar + Serialize {}
impl<T: Real + Scalar + Serialize> Written for T {}

/// A number that a file can give: what a scene needs to be read.
pub trait Read<'de>: Real + Scalar + Deserialize<'de> {}
impl<'de, T: Real + Scalar + Deserialize<'de>> Read<'de> for T {}
