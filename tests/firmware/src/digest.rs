//! Digests that change with any bit of any result that the crate computes: the functions and inputs
//! of `tests/bits`, on every machine.

pub use functions::digest::Fnv;
use functions::digest::{Function, Of, absorb};
use functions::{Number, any_bits};
use shading::fixed::Fixed;

use crate::{broken, picture};

/// The digest of [`without_doubles`], of the angles, which `libm` computes in doubles, and of the
/// [`picture`] for a display.
#[must_use]
pub fn single() -> u64 {
    let mut digest = Fnv(without_doubles());
    absorb(Of::<f32>::ANGLES, &mut digest);
    picture::absorb(&mut digest);
    digest.0
}

/// The digest of all functions of `f32` that promise not to link any double-precision routine.
#[must_use]
pub fn without_doubles() -> u64 {
    let mut digest = Fnv::EMPTY;
    absorb_all(Of::<f32>::WITHOUT_DOUBLES, &mut digest);
    absorb_all(Of::<f32>::OF_FLOATS, &mut digest);
    absorb(Of::<f32>::HALF_ANGLES, &mut digest);
    digest.absorb(broken::promise(0.0));
    digest.0
}

/// The digest of the same functions for `f64`.
#[must_use]
pub fn double() -> u64 {
    let mut digest = Fnv::EMPTY;
    absorb_all(Of::<f64>::OF_NUMBERS, &mut digest);
    absorb_all(Of::<f64>::OF_FLOATS, &mut digest);
    digest.0
}

/// The digest of fixed-point numbers.
#[must_use]
pub fn fixed() -> u64 {
    let mut digest = Fnv(fixed_without_doubles());
    absorb(Of::<Fixed>::HALF_ANGLES, &mut digest);
    absorb(Of::<Fixed>::ANGLES, &mut digest);
    digest.0
}

/// The digest of all functions of fixed-point numbers that promise not to link any double-precision
/// routine.
#[must_use]
pub fn fixed_without_doubles() -> u64 {
    let mut digest = Fnv::EMPTY;
    absorb_all(Of::<Fixed>::WITHOUT_DOUBLES, &mut digest);
    any_bits::absorb(&mut digest);
    digest.absorb(broken::promise(0.0));
    digest.0
}

fn absorb_all<T: Number, const N: usize>(sections: [&[Function<T>]; N], digest: &mut Fnv) {
    for section in sections {
        absorb(section, digest);
    }
}
