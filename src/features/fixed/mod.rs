//! [`Fixed`], a fixed-point number for processors without floating point, and the types of a scene in
//! it.
//!
//! The constructors that work in constants take `Fixed`, which [`Fixed::new`] makes of a literal:
//!
//! ```
//! use shading::fixed::{Attenuation, Cone, Fixed, PointLight, Rgb, SpotLight, UnitVec3, Vec3};
//!
//! const fn x(literal: f64) -> Fixed {
//!     Fixed::new(literal)
//! }
//! static SPOT: SpotLight = SpotLight {
//!     point: PointLight {
//!         position: Vec3::new(x(0.0), x(3.0), x(0.0)),
//!         intensity: Rgb::WHITE,
//!         attenuation: Attenuation::new(x(1.0), x(0.0), x(0.25)).unwrap(),
//!     },
//!     axis: UnitVec3::normalized(x(0.1), x(-1.0), x(0.0)).unwrap(),
//!     cone: Cone::from_half_angle(x(0.5)).unwrap(),
//! };
//! assert!(SPOT.at(Vec3::ZERO).intensity.r > x(0.0));
//! ```
//!
//! A scene in `f32` becomes one in `Fixed` by [`cast`](crate::PointLight::cast):
//! `lamp.cast(Fixed::from_f32)`.

// the bits of a number are moved between integers of every kind, on purpose
#![allow(
    clippy::cast_lossless,
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss
)]

mod arithmetic;
mod encoding;
mod falloff;
mod product;
mod real;
mod reciprocal;
mod scene;
mod vector;

#[allow(missing_docs)] // each is documented where it is defined
mod types {
    crate::aliases::types!(super::Fixed);
}

use core::fmt;

pub use types::*;

/// A fixed-point number: 32 bits, 16 of them after the binary point.
///
/// It is for processors without floating point. On a Cortex-M0 a point light in `Fixed` takes less
/// than a quarter of the instructions that it takes in `f32`, and on a Cortex-M3 a tenth.
/// [`guide::embedded`](mod@crate::guide::embedded) says which number suits which chip.
///
/// ```
/// use shading::fixed::{Attenuation, Fixed, Material, PointLight, Rgb, UnitVec3, Vec3};
/// use shading::shade;
///
/// const fn x(literal: f64) -> Fixed {
///     Fixed::new(literal)
/// }
/// static LAMP: PointLight = PointLight {
///     position: Vec3::new(x(0.0), x(0.0), x(4.0)),
///     intensity: Rgb::new(x(1.0), x(0.9), x(0.7)),
///     attenuation: Attenuation::new(x(1.0), x(0.25), x(0.0)).unwrap(), // ½ at 4
/// };
/// static BRICK: Material =
///     Material { k_a: Rgb::BLACK, k_d: Rgb::gray(x(0.5)), k_s: Rgb::BLACK, m: 1 };
///
/// let shaded = shade::lambert(UnitVec3::Z, &BRICK, Rgb::BLACK, [LAMP.at(Vec3::ZERO)]);
/// assert_eq!(shaded.total().r, x(0.25));
/// ```
///
/// # Range and precision
///
/// The numbers are the multiples of the **step** 2⁻¹⁶ = 0.000015 from −32,768 to 32,768 − 2⁻¹⁶.
/// They saturate: a result beyond an end is that end. Nothing wraps, nothing panics, and there is
/// neither an infinity nor a NaN. x/0 is [`MAX`](Fixed::MAX) for x > 0, [`MIN`](Fixed::MIN) for
/// x < 0, and 0 for 0/0. The square root of a negative number is 0.
///
/// What arrives from a lamp is within two steps or 2⁻¹⁵ of the exact formula, whichever is larger: at every
/// distance, for every attenuation and every range. It never rises with the distance.
///
/// A color of one light that arrives with an intensity of up to 1 is within half a level of an 8-bit display
/// for an m of up to 80, and within one level for an m of up to 128, if its spot has no soft edge. The error
/// grows with the number of lights and their intensity. [`guide::precision`](mod@crate::guide::precision)
/// has the bound. Keep two things away from the step:
///
/// - the cosines of a soft cone, which should be 0.05 or more apart. A smoothstep may fall by a step where
///   the formula rises;
/// - the half vector of Blinn–Phong, which is imprecise where L is within 6° of −V, so that the light
///   grazes the surface.
///
/// The sum, the difference, the product, the quotient and the square root round correctly: to the
/// nearest number, and a product halfway between two numbers goes up. The results have the same bits
/// on every machine, with or without a divider or a long multiply.
#[doc(alias = "fixed-point")]
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
    /// The distance between two neighboring numbers, 2⁻¹⁶, which is also the smallest number above 0.
    pub const STEP: Self = Self(1);

    /// The number nearest to a literal; a tie goes away from 0. Beyond the range, it is the end of the
    /// range, and for NaN it is 0.
    ///
    /// In a constant, the conversion costs nothing at run time. At run time, use
    /// [`from_f32`](Fixed::from_f32), which takes no double precision.
    ///
    /// ```
    /// use shading::fixed::Fixed;
    ///
    /// const HALF: Fixed = Fixed::new(0.5);
    /// assert_eq!(HALF + HALF, Fixed::from(1_i16));
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

    /// The nearest number; a tie goes away from 0. Beyond the range, it is the end of the range, and
    /// for NaN it is 0.
    ///
    /// ```
    /// use shading::fixed::Fixed;
    ///
    /// assert_eq!(Fixed::from_f32(0.25).to_f32(), 0.25);
    /// assert_eq!(Fixed::from_f32(1e9), Fixed::MAX);
    /// ```
    #[inline]
    #[must_use]
    pub const fn from_f32(number: f32) -> Self {
        let steps = number * ONE as f32;
        let whole = steps as i32;
        // exact: from 2²³ on, there is no fraction
        let rest = steps - whole as f32;
        Self(whole.saturating_add((rest >= 0.5) as i32 - (rest <= -0.5) as i32))
    }

    /// The nearest number in single precision.
    ///
    /// ```
    /// use shading::fixed::Fixed;
    /// assert_eq!(Fixed::new(-1.5).to_f32(), -1.5);
    /// ```
    #[inline]
    #[must_use]
    pub const fn to_f32(self) -> f32 {
        self.0 as f32 / ONE as f32
    }

    /// The number that is so many steps of 2⁻¹⁶.
    ///
    /// ```
    /// use shading::fixed::Fixed;
    /// assert_eq!(Fixed::from_bits(0x8000), Fixed::new(0.5));
    /// ```
    #[inline]
    #[must_use]
    pub const fn from_bits(steps: i32) -> Self {
        Self(steps)
    }

    /// The number of steps of 2⁻¹⁶.
    ///
    /// ```
    /// use shading::fixed::Fixed;
    /// assert_eq!(Fixed::new(1.0).to_bits(), 0x1_0000);
    /// ```
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
