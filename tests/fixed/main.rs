//! Fixed point: the numbers against exact integer arithmetic, vectors and powers against their error
//! bounds, and colors against the same formulas in `f64`.

mod colors;
mod derivatives;
mod falloff;
mod numbers;
mod scene;
mod totality;
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

    /// A number in [low, high).
    #[allow(clippy::cast_precision_loss)] // 53 bits
    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.bits() >> 11) as f64 / (1_u64 << 53) as f64)
    }

    fn below(&mut self, count: usize) -> usize {
        usize::try_from(self.bits() % count as u64).expect("a small number")
    }

    /// A number of any magnitude: as many are between 1 and 2 as between 2 and 4 steps.
    fn fixed(&mut self) -> Fixed {
        let bits = self.bits();
        #[allow(clippy::cast_possible_truncation)] // any bits will do
        Fixed::from_bits(bits as i32 >> (bits >> 32 & 31))
    }
}

/// Zero, the powers of two and their neighbors, with both signs, and so both ends of the range.
fn edges() -> Vec<Fixed> {
    let mut edges = vec![0];
    for power in (0..32).map(|k| 1_i64 << k) {
        edges.extend([power - 1, power, power + 1].map(|steps| steps));
        edges.extend([power - 1, power, power + 1].map(|steps| -steps));
    }
    edges.sort_unstable();
    edges.dedup();
    let steps = edges
        .into_iter()
        .filter_map(|steps| i32::try_from(steps).ok());
    steps.map(Fixed::from_bits).collect()
}

/// The table of `docs/precision.md` must have this line, with the largest error rounded up.
fn assert_documented(what: &str, largest: f64, bound: f64, unit: &str) {
    assert!(largest <= bound, "{what}: {largest} {unit}");
    let largest = (largest * 1000.0).ceil() / 1000.0;
    let line = format!("| {what} | {largest:.3} | {bound} | {unit} |");
    let page = include_str!("../../docs/precision.md");
    let is_there = page.lines().any(|documented| documented == line);
    assert!(is_there, "docs/precision.md lacks\n{line}");
}

/// A number in steps.
fn steps(number: Fixed) -> f64 {
    f64::from(number.to_bits())
}

fn exact(number: Fixed) -> f64 {
    f64::from(number)
}
