//! Renderers on trial, in one program, so that little is compiled twice: right ones hold in every form, and the mistake of
//! each wrong one is found and named. Beside them the program `shading-laws`.

#![allow(clippy::float_cmp)] // floats are compared exactly, on purpose
#![allow(clippy::cast_possible_truncation)] // scenes are given in f64, and short
#![allow(clippy::cast_precision_loss, clippy::cast_sign_loss)] // small counts

mod by_hand;
mod found;
mod holds;
mod planted;
mod profiles;
#[cfg(feature = "cli")]
mod program;
mod report;
mod right;
mod textbook;
