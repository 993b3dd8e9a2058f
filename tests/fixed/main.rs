//! Fixed point: numbers against exact integers, directions and falloff against their bounds, constructors, and
//! colors against the same formulas in `f64`.

mod colors;
mod constructors;
mod falloff;
mod numbers;
mod products;
mod vectors;

use shading::fixed::Fixed;

/// Steele, Lea, Flood, *Fast Splittable Pseudorandom Number Generators*, 2014.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ self.0 >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ z >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ z >> 31
    }

    /// A number in [0, 1).
    #[allow(clippy::cast_precision_loss)] // 53 bits
    fn share(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number of any magnitude: as many are between 1 and 2 as between 2 and 4 steps.
    #[allow(clippy::cast_possible_truncation)] // any bits will do
    fn fixed(&mut self) -> Fixed {
        let bits = self.bits();
        Fixed::from_bits(bits as i32 >> (bits >> 32 & 31))
    }

    fn three(&mut self) -> [Fixed; 3] {
        [(); 3].map(|()| self.fixed())
    }
}

/// Zero, the powers of two and their neighbors, with both signs, and so both ends of the range.
fn edges() -> Vec<Fixed> {
    let powers = (0..32).map(|k| 1_i64 << k);
    let near = powers.flat_map(|power| [power - 1, power, power + 1]);
    let steps = near.flat_map(|steps| [steps, -steps]);
    let fitting = steps.filter_map(|steps| i32::try_from(steps).ok());
    fitting.map(Fixed::from_bits).collect()
}

/// A number in steps.
fn steps(number: Fixed) -> f64 {
    f64::from(number.to_bits())
}

fn exact(number: Fixed) -> f64 {
    f64::from(number)
}
