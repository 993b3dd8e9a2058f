//! The digest of the results: 64-bit FNV-1a (Fowler, Noll, and Vo) over the bits of numbers.

use crate::given::Given;
use crate::number::{Float, Number};
use crate::places::places;
use crate::table::row;
use crate::value::{Sink, Value};

pub struct Fnv(pub u64);

impl Fnv {
    pub const EMPTY: Self = Self(0xcbf2_9ce4_8422_2325);

    pub fn absorb(&mut self, value: impl Value) {
        value.give(self);
    }

    pub fn bytes<const N: usize>(&mut self, bytes: [u8; N]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
        }
    }
}

impl Sink for Fnv {
    fn number(&mut self, number: impl Number) {
        number.absorb_into(self);
    }

    fn bytes<const N: usize>(&mut self, bytes: [u8; N]) {
        self.bytes(bytes);
    }
}

/// A function's name, and a function that digests its results at a place.
pub type Function<T> = (&'static str, fn(&Given<T>, &mut Fnv));

/// Digests the results of the functions at all places.
pub fn absorb<T: Number>(functions: &[Function<T>], digest: &mut Fnv) {
    for given in places() {
        for (_, absorb_results) in functions {
            absorb_results(&given, digest);
        }
    }
}

/// The sections of the table, in one number type.
pub struct Of<T>(T);

macro_rules! digests {
    ($($section:ident: $bound:ident {
        $($row:ident $name:literal |$given:ident| $call:expr => $promise:ident;)*
    })*) => {$(
        impl<T: $bound> Of<T> {
            pub const $section: &[Function<T>] =
                &[$(($name, |given, digest| digest.absorb(row::$row(given)))),*];
        }
    )*};
}
for_each_function!(digests);

impl<T: Number> Of<T> {
    /// Everything that promises not to compute in doubles, whatever the number.
    pub const WITHOUT_DOUBLES: [&[Function<T>]; 5] = [
        Self::ARITHMETIC,
        Self::SWEEPS,
        Self::OFF_GPU,
        Self::FUNCTIONS,
        Self::BYTES,
    ];
    /// Everything that every number has.
    pub const OF_NUMBERS: [&[Function<T>]; 6] = [
        Self::ARITHMETIC,
        Self::SWEEPS,
        Self::OFF_GPU,
        Self::FUNCTIONS,
        Self::BYTES,
        Self::ANGLES,
    ];
}

impl<T: Float> Of<T> {
    /// Everything that floats have besides.
    pub const OF_FLOATS: [&[Function<T>]; 2] = [Self::REAL_M, Self::SERIES];
}
