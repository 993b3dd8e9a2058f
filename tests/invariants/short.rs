//! A number type from outside the crate, put through the whole suite. This is what users write to
//! check that the invariants hold for a type of their own.
//!
//! It is a float with 16 significant bits. Such a short number also tests the tolerances: they are
//! stated in units of its roundoff u, so mistakes in them show early.

use std::ops::{Add, Div, Mul, Neg, Sub};

use shading::{Elementary, Exponent, Real};
use shading_laws::Number;

/// A float with 16 significant bits and the range of `f64`.
///
/// Each operation is computed in `f64` and rounded. That rounds correctly, since 53 ≥ 2·16 + 2
/// (Figueroa 1995).
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Short(f64);

/// The bits of an `f64` that a [`Short`] does not have.
const DROPPED: u32 = 53 - 16;

/// Rounds to the nearest [`Short`], ties to even.
#[allow(clippy::cast_possible_truncation)]
fn round(x: f64) -> Short {
    let bits = x.to_bits();
    let half = (1 << (DROPPED - 1)) - 1 + (bits >> DROPPED & 1);
    if x.is_finite() {
        Short(f64::from_bits((bits + half) >> DROPPED << DROPPED))
    } else {
        Short(x)
    }
}

impl Add for Short {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        round(self.0 + other.0)
    }
}

impl Sub for Short {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        round(self.0 - other.0)
    }
}

impl Mul for Short {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        round(self.0 * other.0)
    }
}

impl Div for Short {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        round(self.0 / other.0)
    }
}

impl Neg for Short {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Real for Short {
    const ZERO: Self = Self(0.0);
    const ONE: Self = Self(1.0);
    const NEG_ONE: Self = Self(-1.0);
    const MAX: Self = Self(f64::from_bits(f64::MAX.to_bits() >> DROPPED << DROPPED));
    const EXTREME: Self = Self(f64::EXTREME);

    fn of(literal: f64) -> Self {
        round(literal)
    }
    fn sqrt(self) -> Self {
        round(self.0.sqrt())
    }
    fn if_positive(self, then: Self, otherwise: Self) -> Self {
        if self.0 > 0.0 { then } else { otherwise }
    }
    fn any_positive(self) -> bool {
        self.0 > 0.0
    }
}

impl Elementary for Short {
    fn sin(self) -> Self {
        round(self.0.sin())
    }
    fn cos(self) -> Self {
        round(self.0.cos())
    }
    fn exp(self) -> Self {
        round(self.0.exp())
    }
    fn ln(self) -> Self {
        round(self.0.ln())
    }
}

impl Exponent<Short> for Short {
    fn raise(self, cosine: Short) -> Short {
        let power = round(cosine.0.min(1.0).powf(self.0));
        cosine.if_positive(power, Self::ZERO)
    }
    fn half(self) -> Option<Self> {
        Some(round(0.5 * self.0))
    }
}

impl Number for Short {
    const U: f64 = 1.0 / 65536.0; // 2⁻¹⁶
    const TINY: Self = Self(f64::from_bits(1 << DROPPED));
    const POWER_ERROR: f64 = 1.0;
    type Shininess = Self;

    fn shininess(m: f64) -> Self {
        round(m)
    }
    fn to_f64(self) -> f64 {
        self.0
    }
}

shading_laws::number!(Short);
