//! What functions return, taken apart into numbers.

use shading::{Dual, IncidentLight, Rgb, Shaded, UnitVec3, Vec3};

use crate::number::Number;

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

macro_rules! number {
    ($($(#[$if:meta])? $number:ty),*) => {$(
        $(#[$if])?
        impl Value for $number {
            fn give(self, sink: &mut impl Sink) {
                sink.number(self);
            }
        }
    )*};
}

number!(
    f32,
    f64,
    #[cfg(feature = "fixed")]
    shading::fixed::Fixed
);

impl Value for bool {
    fn give(self, sink: &mut impl Sink) {
        sink.bytes([self.into()]);
    }
}

impl Value for u8 {
    fn give(self, sink: &mut impl Sink) {
        sink.bytes([self]);
    }
}

impl Value for u16 {
    fn give(self, sink: &mut impl Sink) {
        sink.bytes(self.to_le_bytes());
    }
}

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

impl<V: Value, const N: usize> Value for [V; N] {
    fn give(self, sink: &mut impl Sink) {
        Each(self).give(sink);
    }
}

impl<T: Value> Value for Vec3<T> {
    fn give(self, sink: &mut impl Sink) {
        <[T; 3]>::from(self).give(sink);
    }
}

impl<T: Value> Value for UnitVec3<T> {
    fn give(self, sink: &mut impl Sink) {
        <[T; 3]>::from(self).give(sink);
    }
}

impl<T: Value> Value for Rgb<T> {
    fn give(self, sink: &mut impl Sink) {
        <[T; 3]>::from(self).give(sink);
    }
}

impl<T: Value> Value for Dual<T> {
    fn give(self, sink: &mut impl Sink) {
        self.value.give(sink);
        self.gradient.give(sink);
    }
}

impl<T: Value> Value for IncidentLight<T> {
    fn give(self, sink: &mut impl Sink) {
        self.l.give(sink);
        self.intensity.give(sink);
        self.distance.give(sink);
    }
}

impl<T: Value> Value for Shaded<T> {
    fn give(self, sink: &mut impl Sink) {
        [self.ambient, self.diffuse, self.specular].give(sink);
    }
}
