//! Renderers on trial: right ones hold, and the mistake of each wrong one is found and named.

#![allow(clippy::float_cmp)] // floats are compared exactly, on purpose
#![allow(clippy::cast_possible_truncation)] // scenes are given in f64, and short
#![allow(clippy::cast_precision_loss, clippy::cast_sign_loss)] // small counts

#[path = "../by_hand/mod.rs"]
mod by_hand;
mod found;
mod holds;
mod profiles;
mod report;
mod textbook;
