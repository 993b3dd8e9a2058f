//! The half-precision float of IEEE 754: 11 significant bits, numbers from 2⁻²⁴ to 65,504.

use std::ops::{Add, Div, Mul, Neg, Sub};

use shading::{Elementary, Exponent, Real, UnitVec3, Vec3, normal};
use shading_laws::Number;

/// A half, as the `f64` that it stands for.
///
/// Each operation is computed in `f64` and rounded. That rounds correctly, since 53 ≥ 2·11 + 2 (Figueroa 1995).
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Half(f64);

const MAX: f64 = 65_504.0;
const TINY: f64 = 1.0 / 16_777_216.0; // 2⁻²⁴

/// Rounds to the nearest half, ties to even.
fn round(x: f64) -> Half {
    let [mut step, mut power] = [TINY, 1.0 / 8_192.0]; // 2⁻¹³: below it, all numbers are a step of 2⁻²⁴ apart
    while x.abs() >= power && power <= MAX {
        (step, power) = (2.0 * step, 2.0 * power);
    }
    let nearest = (x / step).round_ties_even() * step;
    Half(if nearest.abs() > MAX {
        f64::INFINITY.copysign(x)
    } else {
        nearest
    })
}

impl Add for Half {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        round(self.0 + other.0)
    }
}

impl Sub for Half {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        round(self.0 - other.0)
    }
}

impl Mul for Half {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        round(self.0 * other.0)
    }
}

impl Div for Half {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        round(self.0 / other.0)
    }
}

impl Neg for Half {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Real for Half {
    const ZERO: Self = Self(0.0);
    const ONE: Self = Self(1.0);
    const NEG_ONE: Self = Self(-1.0);
    const MAX: Self = Self(MAX);
    const EXTREME: Self = Self(4_096.0);

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

impl Elementary for Half {
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

impl Exponent<Half> for Half {
    fn raise(self, cosine: Half) -> Half {
        let power = round(cosine.0.min(1.0).powf(self.0));
        cosine.if_positive(power, Self::ZERO)
    }
    fn half(self) -> Option<Self> {
        Some(round(0.5 * self.0))
    }
}

impl Number for Half {
    const U: f64 = 1.0 / 2_048.0; // 2⁻¹¹
    const TINY: Self = Self(TINY);
    const POWER_ERROR: f64 = 1.0;
    type Shininess = Self;

    fn shininess(m: f64) -> Self {
        round(m)
    }
    fn to_f64(self) -> f64 {
        self.0
    }
}

shading_laws::number!(Half);

/// The columns a = (0, 0, −0.6875), b = (0, 2.5, 0) and c = (−30.5, −58.5, 0) have
///
/// ```text
/// b × c = (0, 0, 76.25), c × a = (40.21875, −20.96875, 0), a × b = (1.71875, 0, 0)
/// ```
///
/// times N = (0.016876, 0.007038, −1). The square of c is above `EXTREME`, that of N's second component below
/// 1/`EXTREME`: so the second product is two powers of `EXTREME` below the first, but a sixth of the sum.
#[test]
fn columns_of_different_sizes_transform_a_normal() {
    let [x, y] = [0.016_876, 0.007_038];
    let cofactors = [40.218_75 * y - 1.718_75, -20.968_75 * y, 76.25 * x];
    let length = cofactors.iter().map(|c| c * c).sum::<f64>().sqrt();

    let of = |x, y, z| Vec3::new(round(x), round(y), round(z));
    let columns = [
        of(0.0, 0.0, -0.6875),
        of(0.0, 2.5, 0.0),
        of(-30.5, -58.5, 0.0),
    ];
    let n = UnitVec3::assume_unit(of(x, y, -1.0));
    let transformed: [Half; 3] = (*normal::transformed(n, columns).unwrap()).into();
    for (c, expected) in transformed.into_iter().zip(cofactors) {
        assert!(
            (c.0 - expected / length).abs() < 16.0 * Half::U,
            "{c:?} is not {}",
            expected / length
        );
    }
}
