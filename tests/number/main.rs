//! What holds of every number type: of the crate's own, and of some that are written from the page of
//! [`Real`](shading::Real) alone.

mod gradients;
mod naive;

use kit::invariants::check;
use naive::{Bf16, Broken, Half, Q16};
use shading::Dual;

#[test]
fn single() {
    check::<f32>(400);
}

#[test]
fn double() {
    check::<f64>(400);
}

#[test]
fn dual() {
    check::<Dual<f64>>(150);
}

/// A half: 11 bits, and a short range with subnormal numbers.
#[test]
fn half() {
    check::<Half>(400);
}

/// Eight bits.
#[test]
fn bf16() {
    check::<Bf16>(400);
}

/// Saturating fixed point.
#[test]
fn q16() {
    check::<Q16>(400);
}

#[cfg(feature = "fixed")]
#[test]
fn fixed() {
    check::<shading::fixed::Fixed>(400);
}

/// The laws find a number that computes wrongly.
#[test]
fn a_broken_number_is_found() {
    let is_found = |check: fn(u32)| std::panic::catch_unwind(|| check(400)).is_err();
    let found = [
        is_found(check::<Broken<1>>),
        is_found(check::<Broken<2>>),
        is_found(check::<Broken<3>>),
        is_found(check::<Broken<4>>),
        is_found(check::<Broken<5>>),
    ];
    assert_eq!(found, [true; 5]);
}
