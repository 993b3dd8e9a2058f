//! The inputs.

use shading::Vec3;

/// Whole shininess, and in the same order a real one.
pub const WHOLE: [u32; 7] = [0, 1, 2, 5, 32, 33, 1000];
pub const REAL: [f32; 7] = [0.0, 0.5, 1.0, 10.25, 32.0, 100.5, 1e4];

/// Distances from nothing to the largest finite number, by way of subnormal ones.
pub const DISTANCES: [f32; 10] = [
    0.0, 1e-45, 1e-38, 1e-20, 1e-8, 1.0, 4096.0, 1e15, 1e20, 3e38,
];

/// A linear congruential generator (Knuth's constants, as in *Numerical Recipes*): each of its
/// numbers is exact, and the same on every machine.
pub struct Numbers(pub u32);

impl Numbers {
    /// A multiple of 2⁻²³ within [−1, 1).
    fn next(&mut self) -> f32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let whole = self.0 >> 8; // 24 bits: exact in an f32
        whole as f32 / 8_388_608.0 - 1.0
    }

    /// Each coordinate within [−limit, limit).
    pub fn vector(&mut self, limit: f32) -> Vec3<f32> {
        Vec3::new(self.next(), self.next(), self.next()) * limit
    }
}
