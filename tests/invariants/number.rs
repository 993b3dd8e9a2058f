//! What the invariants need from a number type beyond [`Real`](shading::Real).

use std::fmt::Debug;

use shading::{Dual, Elementary, Exponent, Real};

/// A number type for which the invariants are tested. Implement it for your own: see `short.rs`.
pub trait Number: Elementary + PartialOrd + Debug + 'static {
    /// The unit roundoff u: half the distance from 1 to the next number above.
    const U: f64;
    /// The smallest positive number.
    const TINY: Self;
    /// The largest error of a power by a [`Shininess`](Number::Shininess), in units of u.
    const POWER_ERROR: f64;
    /// A real shininess, or `u32` for a type without real powers.
    type Shininess: Exponent<Self> + Debug;

    /// The shininess nearest to m.
    fn shininess(m: f64) -> Self::Shininess;
    /// The same number, rounded if the type is wider than `f64`.
    fn to_f64(self) -> f64;
}

impl Number for f32 {
    const U: f64 = 1.0 / 16_777_216.0; // 2⁻²⁴
    const TINY: Self = f32::from_bits(1);
    const POWER_ERROR: f64 = 4.0; // 2⁻²²
    type Shininess = Self;

    fn shininess(m: f64) -> Self {
        Self::of(m)
    }
    fn to_f64(self) -> f64 {
        self.into()
    }
}

impl Number for f64 {
    const U: f64 = f64::EPSILON / 2.0;
    const TINY: Self = f64::from_bits(1);
    const POWER_ERROR: f64 = 2.0; // libm: one unit in the last place
    type Shininess = Self;

    fn shininess(m: f64) -> Self {
        m
    }
    fn to_f64(self) -> f64 {
        self
    }
}

/// The value of a dual number obeys every invariant; its gradient has invariants of its own in
/// `dual.rs`.
impl<T: Number> Number for Dual<T> {
    const U: f64 = T::U;
    const TINY: Self = Self::constant(T::TINY);
    const POWER_ERROR: f64 = 0.0;
    type Shininess = u32;

    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    fn shininess(m: f64) -> u32 {
        m as u32
    }
    fn to_f64(self) -> f64 {
        self.value.to_f64()
    }
}
