//! SIMD lanes: [`Real`] and [`Lobe`] for the types of the crate `wide`. Each lane has the bits
//! of the scalar. [`Lanes`] adds what lights in lanes need.
//!
//! Maximum and minimum are comparisons. Those of `wide` choose between zeros, and between a number
//! and NaN, as the processor does.

mod pack;
mod sum;
mod transposed;

use wide::bytemuck::cast;
use wide::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8, i32x4, i32x8, i32x16, u64x2, u64x4, u64x8};

use crate::color::Rgb;
use crate::number::lobe::{self, half_shininess};
use crate::number::power::{self, Bits, EXPONENT};
use crate::number::{Lobe, Mask, Real, shininess};
use crate::target::ROOT_OF_LANES;

// x87 rounds a number in a register differently from a number in memory
#[cfg(all(target_arch = "x86", not(target_feature = "sse2")))]
compile_error!(
    "the feature `wide` needs SSE2: without it, a SIMD lane would not have the bits of the scalar. \
     Enable SSE2, or compute with `f32` and `f64`; lanes would be no faster here"
);

/// SIMD lanes: several numbers that are computed side by side. The float types of `wide` implement it.
///
/// # What does not take lanes
///
/// A function that takes a [`Scalar`](crate::Scalar) decides whether there is a result, and lanes may
/// differ in that. Call it for each lane, or call what stands beside it:
///
/// | not in lanes | in lanes |
/// |---|---|
/// | `Vec3::unit` | [`Vec3::unit_or`](crate::Vec3::unit_or) |
/// | `UnitVec3::new`, `Attenuation::new`, `Attenuation::within`, `Cone::from_cosines` | `cast` of what was made from scalars |
/// | `half_vector` | [`Vec3::unit_or`](crate::Vec3::unit_or) of L + V; the sums of [`shade`](mod@crate::shade) |
/// | `normal::plane`, `normal::triangle`, `normal::sphere`, `normal::implicit`, `normal::from_gradient`, `normal::parametric`, `normal::from_tangents`, `normal::transformed`, `normal::mapped`, `normal::tangent` | [`normal::corner`](crate::normal::corner), then [`Vec3::unit_or`](crate::Vec3::unit_or) |
///
/// [`Elementary`](crate::Elementary) functions and the encodings of an [`Rgb`](crate::Rgb) are for scalars too: take
/// the lanes apart by `to_array`.
///
/// # Points in lanes
///
/// `from_lanes` of [`Vec3`](crate::Vec3::from_lanes), [`UnitVec3`](crate::UnitVec3::from_lanes) and
/// [`Rgb`](crate::Rgb::from_lanes) puts an array of them into lanes, and `to_lanes` takes them out.
///
/// # Lights in lanes
///
/// [`PointLight::packed`](crate::PointLight::packed) puts lights into lanes, and
/// [`Shaded::sum_of_lanes`](crate::Shaded::sum_of_lanes) adds the lanes up.
///
/// ```
/// use shading::{Lanes, Real};
/// use wide::f32x8;
///
/// /// The same number in each lane.
/// fn splat<L: Lanes>(x: L::Lane) -> L {
///     L::from_fn(|_| x)
/// }
/// assert_eq!(splat::<f32x8>(2.0), f32x8::splat(2.0));
/// assert_eq!(splat::<f32x8>(2.0).sum(), 16.0);
/// ```
pub trait Lanes: Real {
    /// The number in one lane.
    type Lane: Real;

    /// A value for each lane: the array `[V; COUNT]`.
    type Array<V>: AsRef<[V]> + IntoIterator<Item = V>;

    /// How many lanes there are: a power of two, at most 16.
    const COUNT: usize;

    /// The number of each lane, by its index.
    #[must_use]
    fn from_fn(lane: impl FnMut(usize) -> Self::Lane) -> Self;

    /// A value for each lane, by its index: [`core::array::from_fn`].
    #[must_use]
    fn array<V>(value: impl FnMut(usize) -> V) -> Self::Array<V>;

    /// The numbers of all lanes.
    #[must_use]
    fn to_lanes(self) -> Self::Array<Self::Lane>;

    /// The sum of all lanes: the upper half is added to the lower half, until one is left.
    #[must_use]
    fn sum(self) -> Self::Lane;
}

/// The lanes in which a comparison holds: all bits of the number in them are set.
#[derive(Clone, Copy)]
pub struct In<L>(L);

macro_rules! real {
    ($lanes:ident of $count:literal $float:ident, $power:path, $of_quotient:path) => {
        lobe::real!($float in $lanes, $lanes::splat, $power, $of_quotient);

        impl Lanes for $lanes {
            type Lane = $float;
            type Array<V> = [V; $count];
            const COUNT: usize = $count;

            #[inline]
            fn from_fn(lane: impl FnMut(usize) -> $float) -> Self {
                Self::new(core::array::from_fn(lane))
            }

            #[inline]
            fn array<V>(value: impl FnMut(usize) -> V) -> [V; $count] {
                core::array::from_fn(value)
            }

            #[inline]
            fn to_lanes(self) -> [$float; $count] {
                self.to_array()
            }

            #[inline]
            fn sum(self) -> $float {
                let mut lanes = self.to_array();
                let mut count = $count;
                while count > 1 {
                    count /= 2;
                    for i in 0..count {
                        lanes[i] += lanes[i + count];
                    }
                }
                lanes[0]
            }
        }

        impl Mask<$lanes> for In<$lanes> {
            #[inline]
            fn any(self) -> bool {
                self.0.any()
            }

            #[inline]
            fn all(self) -> bool {
                self.0.all()
            }

            #[inline]
            fn select(self, then: $lanes, otherwise: $lanes) -> $lanes {
                self.0.bitselect(then, otherwise)
            }
        }

        #[diagnostic::do_not_recommend] // the trait's own message names the types
        impl Real for $lanes {
            type Mask = In<Self>;
            type Sum = Rgb<Self>;

            const ZERO: Self = Self::splat($float::ZERO);
            const ONE: Self = Self::splat($float::ONE);
            const NEG_ONE: Self = Self::splat($float::NEG_ONE);
            const MAX: Self = Self::splat(<$float as Real>::MAX);
            const EXTREME: Self = Self::splat($float::EXTREME);

            #[inline]
            fn of(literal: f64) -> Self {
                Self::splat($float::of(literal))
            }

            #[inline]
            fn of_f32(literal: f32) -> Self {
                Self::splat($float::of_f32(literal))
            }

            #[inline]
            fn sqrt(self) -> Self {
                if ROOT_OF_LANES {
                    self.sqrt()
                } else {
                    Self::new(self.to_array().map(<$float as Real>::sqrt))
                }
            }

            #[inline]
            fn above(self, other: Self) -> In<Self> {
                In(self.simd_gt(other))
            }

            // elsewhere, these three compare and choose
            #[cfg(target_feature = "sse2")]
            #[inline]
            fn at_least(self, floor: Self) -> Self {
                self.fast_max(floor)
            }

            #[cfg(target_feature = "sse2")]
            #[inline]
            fn at_most(self, limit: Self) -> Self {
                limit.fast_min(self)
            }

            #[cfg(target_feature = "sse2")]
            #[inline]
            fn finite(self) -> Self {
                self.fast_min(Self::MAX)
            }
        }
    };
}

/// Lanes of `f32`, with as many integer lanes for the power.
macro_rules! single {
    ($lanes:ident * $count:literal, $integers:ident, $from_integers:ident) => {
        real!($lanes of $count f32, power::single, power::single_of_quotient);

        impl Bits for $lanes {
            #[inline]
            fn split(self, least: Self) -> (Self, Self) {
                let (bits, least): ($integers, $integers) = (cast(self), cast(least));
                let above = bits - least;
                let z = bits - (above & $integers::splat(EXPONENT.0));
                (Self::$from_integers(above >> 23), cast(z))
            }

            #[inline]
            fn two_to_low_bits(self) -> Self {
                let bits: $integers = cast(self);
                cast(bits << 23)
            }
        }
    };
}

/// The doubles from here to twice it are the integers, in their low bits.
const TWO_TO_52: f64 = 4_503_599_627_370_496.0;

/// Lanes of `f64`. SSE2 cannot convert integers of 64 bits, so the exponent becomes a float as the low
/// bits of one.
macro_rules! double {
    ($lanes:ident * $count:literal, $integers:ident) => {
        real!($lanes of $count f64, power::double, power::double_of_quotient);

        impl Bits for $lanes {
            #[inline]
            #[allow(clippy::cast_sign_loss)] // only the bits matter
            fn split(self, least: Self) -> (Self, Self) {
                let (bits, least): ($integers, $integers) = (cast(self), cast(least));
                let above = bits - least;
                let z = bits - (above & $integers::splat(EXPONENT.1 as u64));
                let e = (above + $integers::splat(1 << 63)) >> 52_u32; // e + 2048
                let e: Self = cast(e | $integers::splat(TWO_TO_52.to_bits()));
                (e - Self::splat(TWO_TO_52 + 2048.0), cast(z))
            }

            #[inline]
            fn two_to_low_bits(self) -> Self {
                let bits: $integers = cast(self);
                cast(bits << 52_u32)
            }
        }
    };
}

single!(f32x4 * 4, i32x4, from_i32x4);
single!(f32x8 * 8, i32x8, from_i32x8);
single!(f32x16 * 16, i32x16, from_i32x16);
double!(f64x2 * 2, u64x2);
double!(f64x4 * 4, u64x4);
double!(f64x8 * 8, u64x8);
