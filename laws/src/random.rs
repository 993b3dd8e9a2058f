//! Pseudorandom numbers, the same on every machine.

use fastrand::Rng;

/// A stream of numbers.
pub struct Random(Rng);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(Rng::with_seed(seed))
    }

    /// From 0 to below `count`.
    #[allow(clippy::cast_possible_truncation)] // below a count
    pub fn below(&mut self, count: usize) -> usize {
        // a range of usize takes less of the stream on a machine of 32 bits
        self.0.u64(..count as u64) as usize
    }

    /// A whole number from `low` to `high`, both included.
    pub fn integer(&mut self, low: i32, high: i32) -> f64 {
        f64::from(self.0.i32(low..=high))
    }

    /// From `low` to `high`.
    pub fn real(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.0.f64()
    }

    /// From `low` to `high`, above 0, each power of two as often as another.
    pub fn scale(&mut self, low: f64, high: f64) -> f64 {
        libm::exp2(self.real(libm::log2(low), libm::log2(high)))
    }

    /// Once in `count` times.
    pub fn once_in(&mut self, count: usize) -> bool {
        self.below(count) == 0
    }

    pub fn one_of<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.below(values.len())]
    }

    pub fn shuffle<T>(&mut self, values: &mut [T]) {
        for i in 1..values.len() {
            values.swap(i, self.below(i + 1));
        }
    }
}
