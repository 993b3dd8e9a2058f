//! How good the laws are: planted mistakes are found at every seed and named, and right renderers of other algebraic forms
//! never raise an alarm.

#![allow(clippy::float_cmp)] // floats are compared exactly, on purpose
#![allow(clippy::cast_possible_truncation)] // scenes are given in f64, and short
#![allow(clippy::cast_precision_loss, clippy::cast_sign_loss)] // small counts

#[path = "../by_hand/mod.rs"]
mod by_hand;
mod planted;
mod right;
