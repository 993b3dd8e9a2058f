//! What the firmware programs share: a scene in flash, the digested work, and the board.
#![no_std]

#[cfg(target_os = "none")]
pub mod board;
pub mod broken;
pub mod digest;
pub mod picture;
pub mod scene;
