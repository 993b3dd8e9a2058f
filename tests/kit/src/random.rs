//! Pseudorandom numbers, the same in each run and on every machine.
//!
//! Source: SplitMix64, Vigna's C of 2015 after Steele, Lea and Flood 2014, *Fast Splittable Pseudorandom Number
//! Generators*.

#[cfg(feature = "fixed")]
use shading::fixed::Fixed;

/// A stream of numbers, by its seed.
pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number below the limit.
    #[allow(clippy::cast_possible_truncation)] // less than the limit
    pub fn below(&mut self, limit: usize) -> usize {
        (self.bits() % limit as u64) as usize
    }

    /// A number in [0, 1).
    #[allow(clippy::cast_precision_loss)] // 53 bits
    pub fn fraction(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number in [−1, 1).
    pub fn signed(&mut self) -> f64 {
        2.0 * self.fraction() - 1.0
    }

    /// A number between two, evenly.
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.fraction()
    }

    /// A number of any magnitude: as many are between 1 and 2 as between 2 and 4 steps.
    #[cfg(feature = "fixed")]
    #[allow(clippy::cast_possible_truncation)] // any bits will do
    pub fn fixed(&mut self) -> Fixed {
        let bits = self.bits();
        Fixed::from_bits(bits as i32 >> (bits >> 32 & 31))
    }

    #[cfg(feature = "fixed")]
    pub fn three(&mut self) -> [Fixed; 3] {
        [(); 3].map(|()| self.fixed())
    }
}
