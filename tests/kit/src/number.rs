//! The numbers that the functions are called with.

use core::fmt::{Debug, LowerExp};

#[cfg(feature = "fixed")]
use shading::fixed::Fixed;
use shading::{Cone, Dual, Elementary, Lobe, Real, Rgb, UnitVec3, Vec3};

use crate::digest::{Fnv, Sink, Value};
use crate::places::Numbers;

/// `f32`, `f64` or a fixed-point number, with the functions that exist separately for each.
pub trait Number: Elementary + PartialOrd + Debug + Value + 'static {
    const EPSILON: Self;
    /// Sizes from zero to the largest number, with subnormal ones.
    const SIZES: [Self; 10];
    const CONE: Cone<Self>;

    /// A number in [−1, 1), with all the digits that the type holds.
    fn draw(numbers: &mut Numbers) -> Self;
    /// A finite number of any size.
    fn draw_any(numbers: &mut Numbers) -> Self;

    fn absorb_into(self, digest: &mut Fnv);
    fn single(self) -> f32;
    fn double(self) -> f64;
    fn const_unit(v: Vec3<Self>) -> Option<UnitVec3<Self>>;

    fn times_vector(self, v: Vec3<Self>) -> Vec3<Self>;
    fn times_rgb(self, rgb: Rgb<Self>) -> Rgb<Self>;
}

/// `f32` or `f64`.
pub trait Float: Number + Lobe<Self> + From<f32> + Into<f64> + LowerExp {
    const NAME: &str;
    /// The unit roundoff u: half the distance from 1 to the next larger number.
    const U: f64;
    /// The smallest subnormal number.
    const TINIEST: f64;
    /// The smallest normal number.
    const MIN_POSITIVE: f64;
    const INFINITY: Self;
    const NAN: Self;

    /// The number with these bits, signaling NaN among them; a narrower type takes the lower ones.
    fn of_bits(bits: u64) -> Self;
    /// self + dual, self − dual, self · dual and self / dual.
    fn before(self, dual: Dual<Self>) -> [Dual<Self>; 4];
}

/// The vector of the numbers nearest to these.
pub fn vector<T: Real>(xyz: [f64; 3]) -> Vec3<T> {
    Vec3::from(xyz).map(T::of)
}

/// The direction of this vector, normalized in `T`.
pub fn direction<T: Real + PartialOrd>(xyz: [f64; 3]) -> UnitVec3<T> {
    vector::<T>(xyz).unit().expect("a direction")
}

/// The color of the numbers nearest to these.
pub fn rgb<T: Real>(rgb: [f64; 3]) -> Rgb<T> {
    Rgb::from(rgb).map(T::of)
}

/// Runs each generic test, by name, for `f32` and for `f64`.
#[macro_export]
macro_rules! for_f32_and_f64 {
    ($($test:ident),+ $(,)?) => {
        mod f32 { $(#[test] fn $test() { super::$test::<f32>(); })+ }
        mod f64 { $(#[test] fn $test() { super::$test::<f64>(); })+ }
    };
}

macro_rules! number {
    (
        $number:ident, $epsilon:expr, $sizes:expr, $cone:expr,
        $draw:expr, $draw_any:expr, $single:expr, $absorb:expr
    ) => {
        impl Number for $number {
            const EPSILON: Self = $epsilon;
            const SIZES: [Self; 10] = $sizes;
            const CONE: Cone<Self> = Cone::<$number>::const_from_half_angle($cone).unwrap();

            #[allow(clippy::cast_precision_loss)] // nothing is lost: as many bits are drawn as fit
            fn draw(numbers: &mut Numbers) -> Self {
                $draw(numbers)
            }

            fn draw_any(numbers: &mut Numbers) -> Self {
                $draw_any(numbers)
            }

            fn absorb_into(self, digest: &mut Fnv) {
                $absorb(self, digest);
            }

            #[allow(clippy::cast_possible_truncation)] // of a double, on purpose: only `f32` is encoded
            fn single(self) -> f32 {
                $single(self)
            }

            fn double(self) -> f64 {
                self.into()
            }

            fn const_unit(v: Vec3<Self>) -> Option<UnitVec3<Self>> {
                UnitVec3::<$number>::const_new(v.x, v.y, v.z)
            }

            fn times_vector(self, v: Vec3<Self>) -> Vec3<Self> {
                self * v
            }

            fn times_rgb(self, rgb: Rgb<Self>) -> Rgb<Self> {
                self * rgb
            }
        }
    };
}

macro_rules! float {
    ($float:ident, $sizes:expr, $draw:expr, $any_bits:expr, $nan:literal) => {
        number!(
            $float,
            $float::EPSILON,
            $sizes,
            0.9,
            $draw,
            |numbers: &mut Numbers| {
                let any = $float::from_bits($any_bits(numbers));
                if any.is_finite() { any } else { $float::MAX }
            },
            |number: $float| number as f32,
            |number: $float, digest: &mut Fnv| {
                // the bits of NaN differ between processors
                let bits = if number.is_nan() {
                    $nan
                } else {
                    number.to_bits()
                };
                digest.bytes(bits.to_le_bytes());
            }
        );

        #[allow(clippy::cast_lossless, clippy::cast_possible_truncation)]
        impl Float for $float {
            const NAME: &str = stringify!($float);
            const U: f64 = $float::EPSILON as f64 / 2.0;
            const TINIEST: f64 = $float::from_bits(1) as f64;
            const MIN_POSITIVE: f64 = $float::MIN_POSITIVE as f64;
            const INFINITY: Self = $float::INFINITY;
            const NAN: Self = $float::NAN;

            fn of_bits(bits: u64) -> Self {
                $float::from_bits(bits as _)
            }

            fn before(self, dual: Dual<Self>) -> [Dual<Self>; 4] {
                [self + dual, self - dual, self * dual, self / dual]
            }
        }
    };
}

float!(
    f32,
    [
        0.0, 1e-45, 1e-38, 1e-20, 1e-8, 1.0, 4096.0, 1e15, 1e20, 3e38
    ],
    |numbers: &mut Numbers| (numbers.next() >> 8) as f32 / 8_388_608.0 - 1.0,
    |numbers: &mut Numbers| numbers.next(),
    0x7fc0_0000
);
float!(
    f64,
    [
        0.0, 5e-324, 1e-308, 1e-160, 1e-16, 1.0, 4096.0, 1e120, 1e160, 1.7e308
    ],
    |numbers: &mut Numbers| (numbers.next_u64() >> 11) as f64 / 4_503_599_627_370_496.0 - 1.0,
    |numbers: &mut Numbers| numbers.next_u64(),
    0x7ff8_0000_0000_0000
);

#[cfg(feature = "fixed")]
number!(
    Fixed,
    Fixed::STEP,
    [
        Fixed::new(0.0),
        Fixed::STEP,
        Fixed::new(0.001),
        Fixed::new(0.1),
        Fixed::new(0.5),
        Fixed::new(1.0),
        Fixed::new(181.0), // its square is within the range
        Fixed::new(182.0), // and that of this number is not
        Fixed::new(16384.0),
        Fixed::MAX
    ],
    Fixed::new(0.9),
    |numbers: &mut Numbers| Fixed::from_bits(numbers.next_i32() >> 15),
    Numbers::next_fixed,
    Fixed::to_f32,
    |number: Fixed, digest: &mut Fnv| digest.bytes(number.to_bits().to_le_bytes())
);
