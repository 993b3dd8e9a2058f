//! What the prover does not record, with every number: the operations of floats that are written
//! for a processor, powers by a real m, constructors for constants, lanes, and the reciprocals of
//! fixed point. `proofs/run.sh --all` runs them.

#![allow(clippy::float_cmp, clippy::cast_possible_truncation)] // bits are compared, and lanes are eight

use shading::fixed::Fixed;
use shading::number::Mask;
use shading::{Attenuation, Cone, Dual, Lobe, Real, Rgb, Vec3};
use wide::f32x8;

/// Whether two results are the same; any NaN is as good as another.
fn are_same(x: f32, y: f32) -> bool {
    x.to_bits() == y.to_bits() || x.is_nan() && y.is_nan()
}

fn every_float() -> impl Iterator<Item = f32> {
    (0..=u32::MAX).map(f32::from_bits)
}

/// From +0 to 1, or to ∞.
fn up_to(most: f32) -> impl Iterator<Item = f32> {
    (0..=most.to_bits()).map(f32::from_bits)
}

/// A double has more than twice the digits, so its root, rounded once more, is the correctly rounded one.
#[test]
#[ignore = "every f32"]
fn a_root_is_correctly_rounded() {
    for x in every_float() {
        let root = f64::from(x).sqrt() as f32;
        assert!(are_same(Real::sqrt(x), root), "{x:e}");
    }
}

/// Positive floats are ordered as their bits are.
#[test]
#[ignore = "every f32"]
fn a_comparison_with_a_range_is_that_of_numbers() {
    for x in every_float() {
        let low = 1.0 / f32::EXTREME;
        for high in [f32::EXTREME, 1.0] {
            let is_inside = low < x && x < high;
            assert!(
                x.any_outside(low, high) != is_inside || x == low || x == high,
                "{x:e}"
            );
        }
    }
}

/// cᵐ = 2^(m log₂ c), for every c and m: where the logarithm is not positive, the product with m is
/// not, and the power of such a product is within [0, 1].
#[test]
#[ignore = "every f32"]
fn a_real_power_keeps_its_contract() {
    // log₂ ½ = −1 is exact, so that m takes every product; and each power is at most a unit above the one
    // before
    let mut before = 1.0_f32;
    for m in up_to(f32::INFINITY) {
        let power = m.raise(0.5_f32);
        assert!(
            (0.0..=1.0).contains(&power) && power <= before.next_up(),
            "{m:e}"
        );
        before = power.min(before);
        assert!(m.raise(1.0_f32).to_bits() == 1.0_f32.to_bits(), "{m:e}");
    }
    // the power of a quotient of squares limits its product to 0
    for square in up_to(f32::MAX) {
        for of in [1.0, 0.3, 1e-30, f32::MAX] {
            let power = 33.0_f32.raise_quotient(square, of);
            assert!((0.0..=1.0).contains(&power), "{square:e} / {of:e}");
        }
    }
    // a positive logarithm would show with one of these m: from 2⁻²⁶ on its product is between 2⁻¹⁹ and 2⁷
    let scales = [1.0, 128.0, 16_384.0, 2_097_152.0, 67_108_864.0_f32];
    for c in up_to(1.0) {
        for m in scales {
            assert!((0.0..=1.0).contains(&m.raise(c)), "{c:e} {m}");
        }
        // for m ≤ 1 the power is at least that of 1 less a unit, and that is at least c − 2⁻²¹
        assert!(1.0_f32.raise(c) >= c - 2.0_f32.powi(-21), "{c:e}");
        assert!(c == 0.0 || 0.0_f32.raise(c) == 1.0, "{c:e}");
    }
}

/// The constructors for constants make what the others make, which are proved.
#[test]
#[ignore = "every f32"]
fn constants_are_what_constructors_make() {
    let free = Attenuation::<f32>::NONE;
    for x in every_float() {
        for y in [0.0, 1.0] {
            for (a, b, c) in [(x, y, y), (y, x, y), (y, y, x)] {
                assert_eq!(
                    Attenuation::<f32>::const_new(a, b, c),
                    Attenuation::new(a, b, c),
                    "{x:e}"
                );
            }
        }
        assert_eq!(free.const_within(x), free.within(x), "{x:e}");
        assert_eq!(
            Cone::<f32>::const_from_half_angle(x),
            Cone::from_half_angle(x),
            "{x:e}"
        );
    }
}

#[test]
#[ignore = "every f32"]
fn each_lane_is_the_scalar() {
    let others = [1.5, -0.0, f32::MAX, f32::NAN];
    for bits in (0..=u32::MAX).step_by(8) {
        let x: [f32; 8] = core::array::from_fn(|i| f32::from_bits(bits + i as u32));
        let lanes = f32x8::from(x);
        let all = |of_lanes: f32x8, of_scalar: &dyn Fn(f32) -> f32| {
            let of_lanes = of_lanes.to_array();
            (0..8).all(|i| are_same(of_lanes[i], of_scalar(x[i])))
        };
        assert!(all(lanes.sqrt(), &Real::sqrt), "{bits:x}");
        for y in others {
            let other = f32x8::splat(y);
            assert!(all(lanes + other, &|x| x + y), "{bits:x} + {y:e}");
            assert!(all(lanes * other, &|x| x * y), "{bits:x} · {y:e}");
            assert!(all(other / lanes, &|x| y / x), "{y:e} / {bits:x}");
            assert!(
                all(lanes.above(other).select(other, lanes), &|x| x
                    .above(y)
                    .select(y, x)),
                "{bits:x} {y:e}"
            );
        }
    }
}

/// Whether x is above 0 in any lane, and in each.
fn is_above_0<T: Real>(x: T) -> [bool; 2] {
    let mask = x.above(T::ZERO);
    [mask.any(), mask.all()]
}

/// Every choice of lanes, of plain numbers and of those that differentiate.
#[test]
fn masks_hold_in_their_lanes() {
    for choice in 0..256_u32 {
        let x = f32x8::from(core::array::from_fn(|i| {
            [0.0, 1.0][(choice >> i & 1) as usize]
        }));
        let expected = [choice != 0, choice == 255];
        assert_eq!(is_above_0(x), expected, "{choice:b}");
        assert_eq!(is_above_0(Dual::constant(x)), expected, "{choice:b}");
    }
}

/// Every denominator: light is never negative, never above what it was, and never rises.
#[test]
#[ignore = "every number"]
fn reciprocals_of_fixed_point() {
    let light = |a: i32, color: Fixed| {
        let dimmed = Real::attenuated(
            Rgb::gray(color),
            [Fixed::from_bits(a), Fixed::ZERO, Fixed::ZERO],
            Fixed::ZERO,
            Fixed::MAX,
        );
        i64::from((dimmed.color.r * dimmed.factor).to_bits())
    };
    let mut before = [i64::from(i32::MAX); 2];
    for a in 1..=i32::MAX {
        for (before, color) in before.iter_mut().zip([Fixed::MAX, Fixed::ONE]) {
            let lit = light(a, color);
            assert!(lit >= 0 && lit <= *before, "{a}: {before} {lit}");
            assert!(
                a < Fixed::ONE.to_bits() || lit <= i64::from(color.to_bits()),
                "{a}: {lit}"
            );
            *before = lit;
        }
    }
}

/// Every power of every cosine by m to 4,096, and some beyond.
#[test]
#[ignore = "every number"]
fn powers_of_fixed_point() {
    for m in (0..4097).chain([65_535, 1 << 20, u32::MAX]) {
        let mut before = 0;
        for cosine in 0..=Fixed::ONE.to_bits() {
            let power = m.raise(Fixed::from_bits(cosine)).to_bits();
            assert!(
                power >= before - 1 && power <= Fixed::ONE.to_bits(),
                "{cosine} to the {m}"
            );
            before = power;
        }
    }
}

/// The length of every vector along an axis is its component.
#[test]
#[ignore = "every number"]
fn lengths_of_fixed_point() {
    for x in 0..=i32::MAX {
        let v = Vec3::new(Fixed::ZERO, Fixed::from_bits(x), Fixed::ZERO);
        let length = v.length().to_bits();
        assert!(
            length >= 0 && (i64::from(length) - i64::from(x)).abs() <= 1 + i64::from(x >> 24),
            "{x}: {length}"
        );
    }
}

/// How many cosines a power is the product of. Its only operation that counts is the product; a square root
/// halves.
#[derive(Clone, Copy, PartialEq, PartialOrd, Debug)]
struct Factors(u64);

/// What a power must not use: no number of factors comes out of it right.
const WRONG: Factors = Factors(1 << 60);

macro_rules! wrong {
    ($($trait:ident::$method:ident)*) => {$(
        impl std::ops::$trait for Factors {
            type Output = Self;
            fn $method(self, _: Self) -> Self {
                WRONG
            }
        }
    )*};
}
wrong!(Add::add Sub::sub Div::div);

impl std::ops::Mul for Factors {
    type Output = Self;
    #[allow(clippy::suspicious_arithmetic_impl)] // a product has the factors of both
    fn mul(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl std::ops::Neg for Factors {
    type Output = Self;
    fn neg(self) -> Self {
        WRONG
    }
}

impl Real for Factors {
    type Mask = bool;
    type Sum = Rgb<Self>;
    const ZERO: Self = WRONG;
    const ONE: Self = Self(0);
    const NEG_ONE: Self = WRONG;
    const MAX: Self = WRONG;
    const EXTREME: Self = WRONG;
    fn of(_: f64) -> Self {
        WRONG
    }
    fn sqrt(self) -> Self {
        if self.0.is_multiple_of(2) {
            Self(self.0 / 2)
        } else {
            WRONG
        }
    }
    /// No cosine lies below the least one.
    fn above(self, _: Self) -> bool {
        false
    }
}

fn has_m_factors(m: u32) {
    assert_eq!(m.raise(Factors(1)), Factors(m.into()), "{m}");
    assert_eq!(
        m.raise_root(Factors(2)),
        Factors(m.into()),
        "{m}, by the square"
    );
}

/// With `one_squaring`, which keeps each product in [0, 1], a power is in [0, 1] for each m that is tried here.
#[test]
fn a_power_has_m_factors() {
    let near = |bit: u32| (0..32).map(move |i| (1_u32 << bit).wrapping_add(i).wrapping_sub(16));
    (0..1 << 20)
        .chain((20..32).flat_map(near))
        .for_each(has_m_factors);
}

#[test]
#[ignore = "every m"]
fn every_power_has_m_factors() {
    (0..=u32::MAX).for_each(has_m_factors);
}
