//! Numbers that a user might write, from the page of [`Real`] alone: the items without a default,
//! and nothing else.

use std::ops::{Add, Div, Mul, Neg, Sub};

use properties::Number;
use shading::{Real, Rgb};

/// A float by way of `f64`, which has enough digits that rounding twice rounds once.
macro_rules! float {
    ($name:ident, bits: $bits:literal, least: $least:literal, max: $max:expr, extreme: $extreme:expr) => {
        #[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
        pub struct $name(f64);

        impl $name {
            fn round(x: f64) -> Self {
                if x == 0.0 || !x.is_finite() {
                    return Self(x);
                }
                let spacing = (x.abs().log2().floor() + 1.0 - f64::from($bits))
                    .max(-f64::from($least))
                    .exp2();
                let rounded = (x / spacing).round_ties_even() * spacing;
                Self(if rounded.abs() > $max {
                    f64::INFINITY.copysign(x)
                } else {
                    rounded
                })
            }
        }

        operators!($name, |x, y, op| Self::round(op(x.0, y.0)));

        impl Real for $name {
            type Mask = bool;
            type Sum = Rgb<Self>;
            const ZERO: Self = Self(0.0);
            const ONE: Self = Self(1.0);
            const NEG_ONE: Self = Self(-1.0);
            const MAX: Self = Self($max);
            const EXTREME: Self = Self($extreme);

            fn of(literal: f64) -> Self {
                Self::round(literal)
            }

            fn sqrt(self) -> Self {
                Self::round(self.0.sqrt())
            }

            fn above(self, other: Self) -> bool {
                self > other
            }
        }

        #[allow(clippy::cast_precision_loss)] // a power of two
        impl Number for $name {
            const U: f64 = 1.0 / (1_u64 << $bits) as f64;
            const SMALLEST: f64 = f64::from_bits((1023 - $least) << 52);
            const LARGEST: f64 = $max;
            const LARGE: f64 = $extreme;

            fn exact(self) -> f64 {
                self.0
            }
        }
    };
}

macro_rules! operators {
    ($name:ident, |$x:ident, $y:ident, $op:ident| $apply:expr) => {
        operators!($name, |$x, $y, $op| $apply; Add add, Sub sub, Mul mul, Div div);

        impl Neg for $name {
            type Output = Self;
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }
    };
    ($name:ident, |$x:ident, $y:ident, $op:ident| $apply:expr; $($trait:ident $method:ident),*) => {
        $(impl $trait for $name {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                let ($x, $y, $op) = (self, other, <f64 as $trait>::$method);
                $apply
            }
        })*
    };
}

// (2 − 2⁻¹⁰) 2¹⁵. Its EXTREME: 3·65504²/p² < p for p > 2345, and the smallest number is 2⁻²⁴
float!(Half, bits: 11, least: 24, max: 65_504.0, extreme: 4096.0);
// (2 − 2⁻⁷) 2¹²⁷, the upper half of an f32, whose EXTREME is 2¹⁰⁰
float!(Bf16, bits: 8, least: 133, max: 3.389_531_389_251_535_5e38, extreme: f32::EXTREME as f64);

/// Fixed point with 16 bits behind the point, which saturates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Q16(i32);

impl Q16 {
    const SCALE: f64 = 65_536.0;

    #[allow(clippy::cast_possible_truncation)] // saturates, and NaN is 0
    fn round(x: f64) -> Self {
        Self(((x * Self::SCALE).round() as i32).max(-i32::MAX))
    }
}

operators!(Q16, |x, y, op| Self::round(op(x.exact(), y.exact())));

impl Real for Q16 {
    type Mask = bool;
    type Sum = Rgb<Self>;
    const ZERO: Self = Self(0);
    const ONE: Self = Self(1 << 16);
    const NEG_ONE: Self = Self(-1 << 16);
    const MAX: Self = Self(i32::MAX);
    const EXTREME: Self = Self(1 << 24);

    fn of(literal: f64) -> Self {
        Self::round(literal)
    }

    fn sqrt(self) -> Self {
        Self::round(self.exact().max(0.0).sqrt())
    }

    fn above(self, other: Self) -> bool {
        self > other
    }
}

impl Number for Q16 {
    const U: f64 = 0.0;
    const SMALLEST: f64 = 1.0 / Self::SCALE;
    const LARGEST: f64 = i32::MAX as f64 / Self::SCALE;
    const LARGE: f64 = 256.0;
    const DOUBLES_EXACTLY: bool = false;

    fn exact(self) -> f64 {
        f64::from(self.0) / Self::SCALE
    }
}
