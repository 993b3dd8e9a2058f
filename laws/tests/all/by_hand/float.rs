//! Floats of either precision, and their vectors.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A float.
pub trait Float:
    Copy
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    fn of(x: f64) -> Self;
    fn get(self) -> f64;
    fn sqrt(self) -> Self;
    fn powf(self, m: Self) -> Self;
    fn powi(self, m: i32) -> Self;
    fn cos(self) -> Self;
    fn exp(self) -> Self;
    fn ln(self) -> Self;
    fn mul_add(self, b: Self, c: Self) -> Self;
    fn max(self, other: Self) -> Self;
    fn min(self, other: Self) -> Self;
    fn abs(self) -> Self;
    /// About 1/√x, by its bits.
    fn guess_of_inverse_root(self) -> Self;
}

macro_rules! float {
    ($float:ident, $magic:literal) => {
        impl Float for $float {
            fn of(x: f64) -> Self {
                x as $float
            }
            fn get(self) -> f64 {
                f64::from(self)
            }
            fn sqrt(self) -> Self {
                self.sqrt()
            }
            fn powf(self, m: Self) -> Self {
                self.powf(m)
            }
            fn powi(self, m: i32) -> Self {
                self.powi(m)
            }
            fn cos(self) -> Self {
                self.cos()
            }
            fn exp(self) -> Self {
                self.exp()
            }
            fn ln(self) -> Self {
                self.ln()
            }
            fn mul_add(self, b: Self, c: Self) -> Self {
                self.mul_add(b, c)
            }
            fn max(self, other: Self) -> Self {
                self.max(other)
            }
            fn min(self, other: Self) -> Self {
                self.min(other)
            }
            fn abs(self) -> Self {
                self.abs()
            }
            fn guess_of_inverse_root(self) -> Self {
                Self::from_bits($magic.wrapping_sub(self.to_bits() >> 1))
            }
        }
    };
}

float!(f32, 0x5f37_59df_u32);
float!(f64, 0x5fe6_eb50_c7b5_37a9_u64);

/// A float whose operations are rounded to so many bits.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
pub struct Short<const BITS: i32>(f64);

macro_rules! operators {
    ($($trait:ident $method:ident),+) => {$(
        impl<const BITS: i32> $trait for Short<BITS> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self::of(self.0.$method(other.0))
            }
        }
    )+};
}

operators!(Add add, Sub sub, Mul mul, Div div);

impl<const BITS: i32> Neg for Short<BITS> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<const BITS: i32> Float for Short<BITS> {
    fn of(x: f64) -> Self {
        Self(bits(x, BITS.into()))
    }
    fn get(self) -> f64 {
        self.0
    }
    fn sqrt(self) -> Self {
        Self::of(self.0.sqrt())
    }
    fn powf(self, m: Self) -> Self {
        Self::of(self.0.powf(m.0))
    }
    fn powi(self, m: i32) -> Self {
        Self::of(self.0.powi(m))
    }
    fn cos(self) -> Self {
        Self::of(self.0.cos())
    }
    fn exp(self) -> Self {
        Self::of(self.0.exp())
    }
    fn ln(self) -> Self {
        Self::of(self.0.ln())
    }
    fn mul_add(self, b: Self, c: Self) -> Self {
        Self::of(self.0 * b.0 + c.0)
    }
    fn max(self, other: Self) -> Self {
        Self(self.0.max(other.0))
    }
    fn min(self, other: Self) -> Self {
        Self(self.0.min(other.0))
    }
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    fn guess_of_inverse_root(self) -> Self {
        Self::of(1.0 / self.0.sqrt())
    }
}

pub type Vec3<T> = [T; 3];

pub fn dot<T: Float>(a: Vec3<T>, b: Vec3<T>) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn scale<T: Float>(a: Vec3<T>, s: T) -> Vec3<T> {
    a.map(|c| c * s)
}

pub fn add<T: Float>(a: Vec3<T>, b: Vec3<T>) -> Vec3<T> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub fn sub<T: Float>(a: Vec3<T>, b: Vec3<T>) -> Vec3<T> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn mul<T: Float>(a: Vec3<T>, b: Vec3<T>) -> Vec3<T> {
    [a[0] * b[0], a[1] * b[1], a[2] * b[2]]
}

pub fn normalize<T: Float>(a: Vec3<T>) -> Vec3<T> {
    scale(a, T::of(1.0) / dot(a, a).sqrt())
}

pub fn of<T: Float>(triple: [f64; 3]) -> Vec3<T> {
    triple.map(T::of)
}

/// Rounded to so many bits.
pub fn bits(x: f64, bits: f64) -> f64 {
    if x == 0.0 || !x.is_finite() {
        return x;
    }
    let unit = (x.abs().log2().floor() + 1.0 - bits).exp2();
    (x / unit).round() * unit
}
