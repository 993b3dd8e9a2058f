//! [`Fixed`], a number for processors without floating point, and the types of a scene in it.
//!
//! ```
//! use shading::fixed::{Attenuation, Fixed, PointLight, Rgb, Vec3};
//!
//! const fn x(literal: f64) -> Fixed {
//!     Fixed::new(literal)
//! }
//! static LAMP: PointLight = PointLight {
//!     position: Vec3::new(x(0.0), x(3.0), x(0.0)),
//!     intensity: Rgb::WHITE,
//!     attenuation: Attenuation::const_new(x(1.0), x(0.0), x(0.25)).unwrap(),
//! };
//! assert!(LAMP.at(Vec3::ZERO).intensity().r > x(0.0));
//! ```
//!
//! A scene in `f32` becomes one in `Fixed` by [`cast`](crate::PointLight::cast):
//! `lamp.cast(Fixed::from_f32)`.
//!
//! Choose a unit of length in which the scene is a few units wide, and not a pixel: the coefficient
//! c = 1/h² has 7 steps for h = 100, and none for h = 500. `docs/embedded.md` has the figures.
//!
//! # What is promised
//!
//! - A color is within one level of sRGB of the color that `f64` gives for the same numbers, if no
//!   number and no sum leaves the range. This holds for an integer m up to 128, distances from 0.01 to
//!   200, light that arrives with up to 4, ranges from 1, soft edges from 0.1 (of the cosine), and
//!   |L + V| ≥ 0.1. At the edge of a hard cone, a point may fall on either side.
//! - The normals of triangles, tangents and spheres of any size are within 0.56 of a step of the exact ones,
//!   but for triangles of which an edge is longer than 32,768.
//! - A sum over lights has 64 bits and is rounded once. So it does not depend on the order of the lights,
//!   and it differs from the results of [`shade`](mod@crate::shade) for one light each, added up, by at
//!   most a step for each light, and one. It may differ by more from intensities times the factors of
//!   [`term`](mod@crate::term), because those factors are rounded before the light multiplies their errors.
//! - Light is never negative. It never rises as the distance that a falloff is given does, not by a step;
//!   between two points, whose distances are rounded, it never rises by more than a level.
//! - A negative intensity counts as black.
//! - Nothing panics, and every machine gives the same bits. The functions of
//!   [`Elementary`](crate::Elementary) are the exception: they go by way of `f32`, whose last digits may
//!   differ on x86 without SSE2.

#![allow(
    clippy::cast_lossless,            // `From` is not const
    clippy::cast_possible_truncation, // numbers saturate before, or their size is known
    clippy::cast_possible_wrap,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss
)]

mod constants;
mod cosine;
mod encoding;
mod falloff;
mod product;
mod real;
mod reciprocal;
mod root;
mod triangle;

#[allow(missing_docs)] // each is documented where it is defined
mod types {
    crate::aliases::types!(super::Fixed);
}

use core::fmt;
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::number::triple::assign;
use crate::target::NARROW_PRODUCT;
use crate::vector::number_first;
use product::{product, times_fraction};
pub use types::*;

/// A fixed-point number: 32 bits, 16 of them after the binary point.
///
/// The numbers are the multiples of the **step** 2⁻¹⁶ from −32,768 to 32,768 − 2⁻¹⁶. They saturate: a
/// result beyond an end is that end. Nothing wraps, and there is neither an infinity nor a NaN. A product,
/// a quotient and a root are rounded once, to the nearest step. x/0 is an end, and 0 for 0/0. The root of a
/// negative number is 0.
///
/// ```
/// use shading::fixed::Fixed;
///
/// assert_eq!(Fixed::new(2.5) * Fixed::new(0.5), Fixed::new(1.25));
/// assert_eq!(Fixed::new(200.0) * Fixed::new(200.0), Fixed::MAX);
/// ```
#[doc(alias = "Q16.16")]
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(transparent)]
pub struct Fixed(i32);

/// 2¹⁶ steps make 1.
const ONE: i32 = 1 << 16;

impl Fixed {
    /// The largest number, 32,768 − 2⁻¹⁶.
    pub const MAX: Self = Self(i32::MAX);
    /// The smallest number, −32,768.
    pub const MIN: Self = Self(i32::MIN);
    /// The distance between two neighboring numbers, 2⁻¹⁶.
    pub const STEP: Self = Self(1);

    /// The number nearest to a literal; a tie goes away from 0. It is for constants.
    ///
    /// ```
    /// use shading::fixed::Fixed;
    /// const HALF: Fixed = Fixed::new(0.5);
    /// assert_eq!(HALF + HALF, Fixed::from(1));
    /// ```
    #[inline]
    #[must_use]
    pub const fn new(literal: f64) -> Self {
        let steps = literal * ONE as f64;
        let whole = steps as i32;
        // exact, which steps + 0.5 is not
        let rest = steps - whole as f64;
        Self(whole.saturating_add((rest >= 0.5) as i32 - (rest <= -0.5) as i32))
    }

    /// The nearest number; a tie goes away from 0. NaN gives 0.
    #[inline]
    #[must_use]
    pub const fn from_f32(number: f32) -> Self {
        // with integers, because each operation would be a library call without an FPU
        let bits = number.to_bits();
        let significand = bits & 0x7F_FFFF | 0x80_0000;
        let exponent = (bits >> 23 & 0xFF) as i32 - 134; // of the significand in steps
        let size = if bits << 1 > 0xFF << 24 || exponent < -24 {
            0 // NaN, or less than half a step
        } else if exponent > 7 {
            return Self(bits as i32 >> 31 ^ i32::MAX);
        } else if exponent >= 0 {
            significand << exponent
        } else {
            (significand + (1 << (-1 - exponent))) >> -exponent
        };
        Self(if bits >> 31 == 0 {
            size as i32
        } else {
            -(size as i32)
        })
    }

    /// The nearest number in single precision; from −256 to 256 it is equal.
    #[inline]
    #[must_use]
    pub const fn to_f32(self) -> f32 {
        // subtracts 16 from the exponent, because a multiplication would be a library call without an FPU
        let exponent = if self.0 == 0 { 0 } else { 16 << 23 };
        f32::from_bits((self.0 as f32).to_bits() - exponent)
    }

    /// The number that is so many steps of 2⁻¹⁶.
    #[inline]
    #[must_use]
    pub const fn from_bits(steps: i32) -> Self {
        Self(steps)
    }

    /// The number of steps of 2⁻¹⁶.
    #[inline]
    #[must_use]
    pub const fn to_bits(self) -> i32 {
        self.0
    }
}

impl From<i16> for Fixed {
    #[inline]
    fn from(whole: i16) -> Self {
        Self(i32::from(whole) << 16)
    }
}

impl From<Fixed> for f64 {
    #[inline]
    fn from(number: Fixed) -> f64 {
        f64::from(number.0) / f64::from(ONE)
    }
}

/// The number in decimal digits.
impl fmt::Debug for Fixed {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        fmt::Debug::fmt(&f64::from(*self), f)
    }
}

/// The number in decimal digits.
impl fmt::Display for Fixed {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        fmt::Display::fmt(&f64::from(*self), f)
    }
}

/// x/2^`bits`, rounded to the nearest step. `sign` is negative if x is.
#[inline]
const fn rounded(x: i64, bits: u32, sign: i32) -> Fixed {
    let x = x + (1 << (bits - 1));
    let (upper, above) = ((x >> 32) as i32, 32 - bits);
    Fixed(if upper << above >> above == upper {
        (x >> bits) as i32
    } else {
        sign >> 31 ^ i32::MAX
    })
}

/// So many steps, or as many as there are.
#[inline]
fn saturated(steps: u64) -> Fixed {
    Fixed(steps.min(i32::MAX as u64) as i32)
}

impl Add for Fixed {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self(self.0.saturating_add(other.0))
    }
}

impl Sub for Fixed {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self(self.0.saturating_sub(other.0))
    }
}

impl Neg for Fixed {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self(self.0.saturating_neg())
    }
}

impl Mul for Fixed {
    type Output = Self;
    #[inline]
    #[allow(clippy::suspicious_arithmetic_impl)] // ^ is of the signs
    fn mul(self, other: Self) -> Self {
        if NARROW_PRODUCT {
            return narrow_product(self, other);
        }
        // not by the sign of the product, which LLVM would compute again
        rounded(product(self.0, other.0), 16, self.0 ^ other.0)
    }
}

/// Not inline, because each of forty products takes a hundred bytes.
#[inline(never)]
fn narrow_product(x: Fixed, other: Fixed) -> Fixed {
    if other.0 as u32 <= ONE as u32 {
        // as most reflectances are; it cannot leave the range
        return Fixed(times_fraction(x.0, other.0));
    }
    rounded(product(x.0, other.0), 16, x.0 ^ other.0)
}

impl Div for Fixed {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        if other.0 == ONE {
            self // a direction over its length
        } else {
            quotient(self.0, other.0)
        }
    }
}

fn quotient(of: i32, by: i32) -> Fixed {
    if by == 0 {
        return Fixed(if of == 0 { 0 } else { of >> 31 ^ i32::MAX });
    }
    let steps = ((of.unsigned_abs() as u64) << 17) / by.unsigned_abs() as u64;
    let steps = (steps + 1) as i64 / 2;
    Fixed(if (of ^ by) < 0 { -steps } else { steps }.clamp(i32::MIN as i64, i32::MAX as i64) as i32)
}

assign!([] Fixed, Self: Add Sub Mul Div);

number_first!(Fixed: Vec3 Rgb);
