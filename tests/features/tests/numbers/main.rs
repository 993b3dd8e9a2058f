//! Number types as a user writes them, put through the whole suite: a float of
//! 16 bits, whose range is short, and a fixed-point number, whose numbers are evenly spaced.

#![allow(clippy::float_cmp)] // floats are compared exactly, on purpose
#![allow(clippy::cast_possible_truncation, clippy::cast_precision_loss)] // rounding to fewer bits

mod half;
mod q8_24;
