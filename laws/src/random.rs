//! Pseudorandom numbers, the same on every machine.
//!
//! Source: Sebastiano Vigna, *splitmix64.c*, 2015, after Steele, Lea and Flood, *Fast Splittable Pseudorandom Number
//! Generators*, 2014.

/// A stream of numbers.
pub struct Random(u64);

impl Random {
    /// The stream of a seed and a name.
    pub fn new(seed: u64, name: &str) -> Self {
        let mut random = Self(seed);
        for byte in name.bytes() {
            random.0 = random.next() ^ u64::from(byte);
        }
        random
    }

    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// From 0 to below `count`.
    #[allow(clippy::cast_possible_truncation)] // the remainder is small
    pub fn below(&mut self, count: usize) -> usize {
        (self.next() % count.max(1) as u64) as usize
    }

    /// A whole number from `low` to `high`, both included.
    #[allow(clippy::cast_precision_loss)] // small numbers
    pub fn integer(&mut self, low: i16, high: i16) -> f64 {
        f64::from(low) + self.below(usize::from(high.abs_diff(low)) + 1) as f64
    }

    /// From 0 to below 1.
    #[allow(clippy::cast_precision_loss)] // 53 bits
    pub fn share(&mut self) -> f64 {
        (self.next() >> 11) as f64 * (f64::EPSILON / 2.0)
    }

    /// From `low` to `high`.
    pub fn real(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.share()
    }

    /// From `low` to `high`, above 0, each power of two as often as another.
    pub fn scale(&mut self, low: f64, high: f64) -> f64 {
        self.real(low.log2(), high.log2()).exp2()
    }

    /// Once in `count` times.
    pub fn once_in(&mut self, count: usize) -> bool {
        self.below(count) == 0
    }

    pub fn one_of<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.below(values.len())]
    }

    pub fn shuffle<T>(&mut self, values: &mut [T]) {
        for i in (1..values.len()).rev() {
            values.swap(i, self.below(i + 1));
        }
    }
}
