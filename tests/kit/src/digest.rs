//! What functions return, taken apart into numbers, and the digest of them: 64-bit FNV-1a (Fowler,
//! Noll, and Vo) over their bits.

use shading::{Arrival, Dual, IncidentLight, Real, Rgb, Shaded, UnitVec3, Vec3};

use crate::given::Given;
use crate::number::{Float, Number};
use crate::places::places;
use crate::table::row;

/// Takes the numbers of a result one after another.
pub trait Sink {
    fn number(&mut self, number: impl Number);
    /// Whatever else a result has: flags, encoded colors, and `none` for what there is none of.
    fn bytes<const N: usize>(&mut self, bytes: [u8; N]);
}

/// A result of numbers.
pub trait Value {
    fn give(self, sink: &mut impl Sink);
}

macro_rules! values {
    ($($value:ty: |$self:ident, $sink:ident| $give:expr;)*) => {
        $(impl Value for $value {
            fn give(self, $sink: &mut impl Sink) {
                let $self = self;
                $give;
            }
        })*
    };
}

values! {
    f32: |number, sink| sink.number(number);
    f64: |number, sink| sink.number(number);
    bool: |flag, sink| sink.bytes([flag.into()]);
    u8: |byte, sink| sink.bytes([byte]);
    u16: |word, sink| sink.bytes(word.to_le_bytes());
}

#[cfg(feature = "fixed")]
values! { shading::fixed::Fixed: |number, sink| sink.number(number); }

impl<V: Value> Value for Option<V> {
    fn give(self, sink: &mut impl Sink) {
        match self {
            Some(value) => value.give(sink),
            None => sink.bytes(*b"none"),
        }
    }
}

/// Every value of an iterator.
pub struct Each<I>(pub I);

impl<V: Value, I: IntoIterator<Item = V>> Value for Each<I> {
    fn give(self, sink: &mut impl Sink) {
        for value in self.0 {
            value.give(sink);
        }
    }
}

macro_rules! generic_values {
    ($($value:ty [$($parameter:tt)*]: |$self:ident| $parts:expr;)*) => {
        $(impl<$($parameter)*> Value for $value {
            fn give(self, sink: &mut impl Sink) {
                let $self = self;
                $parts.give(sink);
            }
        })*
    };
}

generic_values! {
    [V; N] [V: Value, const N: usize]: |values| Each(values);
    Vec3<T> [T: Value]: |v| <[T; 3]>::from(v);
    UnitVec3<T> [T: Value]: |v| <[T; 3]>::from(v);
    Rgb<T> [T: Value]: |rgb| <[T; 3]>::from(rgb);
    Shaded<T> [T: Value]: |shaded| [shaded.ambient, shaded.diffuse, shaded.specular];
}

impl<T: Value> Value for Dual<T> {
    fn give(self, sink: &mut impl Sink) {
        self.value.give(sink);
        self.gradient.give(sink);
    }
}

impl<T: Value + Real> Value for Arrival<T> {
    fn give(self, sink: &mut impl Sink) {
        self.l.give(sink);
        self.intensity.give(sink);
        self.distance.give(sink);
    }
}

impl<T: Value + Real> Value for IncidentLight<T> {
    fn give(self, sink: &mut impl Sink) {
        self.l().give(sink);
        self.intensity().give(sink);
        self.distance().give(sink);
    }
}

pub struct Fnv(pub u64);

impl Fnv {
    pub const EMPTY: Self = Self(0xcbf2_9ce4_8422_2325);

    pub fn absorb(&mut self, value: impl Value) {
        value.give(self);
    }
}

impl Sink for Fnv {
    fn number(&mut self, number: impl Number) {
        number.absorb_into(self);
    }

    fn bytes<const N: usize>(&mut self, bytes: [u8; N]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
        }
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
