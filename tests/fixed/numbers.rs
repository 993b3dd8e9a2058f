//! Operators, roots, powers and conversions.

use shading::fixed::{Fixed, Rgb};
use shading::number::{Dimmed, LightSum, Mask};
use shading::{Elementary, Lobe, Real};

use crate::{Random, edges, exact, steps};

const ONE: i128 = 1 << 16;

/// All pairs of edges, and many pairs of numbers of any magnitude.
fn pairs() -> impl Iterator<Item = (Fixed, Fixed)> {
    let of_edges = edges().into_iter();
    let of_edges = of_edges.flat_map(|a| edges().into_iter().map(move |b| (a, b)));
    let mut random = Random(1);
    of_edges.chain((0..300_000).map(move |_| (random.fixed(), random.fixed())))
}

fn wide(number: Fixed) -> i128 {
    number.to_bits().into()
}

fn saturated(steps: i128) -> Fixed {
    let steps = steps.clamp(i32::MIN.into(), i32::MAX.into());
    Fixed::from_bits(i32::try_from(steps).expect("clamped"))
}

/// x/2¹⁶ in whole steps, where a tie goes up.
fn rounded(x: i128) -> Fixed {
    saturated((x + ONE / 2).div_euclid(ONE))
}

#[test]
fn sums_and_comparisons_are_exact_or_saturate() {
    for (a, b) in pairs() {
        assert_eq!(a + b, saturated(wide(a) + wide(b)), "{a} + {b}");
        assert_eq!(a - b, saturated(wide(a) - wide(b)), "{a} − {b}");
        assert_eq!(-a, saturated(-wide(a)), "−{a}");
        assert_eq!(a.cmp(&b), wide(a).cmp(&wide(b)));
        assert_eq!(a.at_least(b), a.max(b));
        assert_eq!(a.at_most(b), a.min(b));
        assert_eq!(
            a.above(Fixed::ZERO).select(a, b),
            if wide(a) > 0 { a } else { b }
        );
        assert_eq!(a.above(Fixed::ZERO), wide(a) > 0);
    }
}

#[test]
fn products_are_rounded_once_and_a_tie_goes_up() {
    for (a, b) in pairs() {
        assert_eq!(a * b, rounded(wide(a) * wide(b)), "{a} × {b}");
    }
}

/// A tie goes away from 0, as the sign is set apart from the division.
#[test]
fn quotients_are_rounded_once() {
    for (a, b) in pairs() {
        let sign = wide(a).signum() * if wide(b) < 0 { -1 } else { 1 };
        let (dividend, divisor) = (wide(a).abs() * ONE, wide(b).abs());
        let expected = match (sign * (2 * dividend + divisor)).checked_div(2 * divisor) {
            Some(quotient) => quotient,
            None => sign * i128::MAX,
        };
        assert_eq!(a / b, saturated(expected), "{a} / {b}");
    }
}

#[test]
fn roots_are_rounded_once() {
    let mut random = Random(2);
    let some = (0..300_000).map(|_| random.fixed());
    for x in edges().into_iter().chain(some) {
        // r ± ½ in halves of a step, so that all is whole
        let (root, square) = (2 * wide(x.sqrt()), 4 * ONE * wide(x).max(0));
        let is_nearest = (root - 1).max(0).pow(2) <= square && square < (root + 1).pow(2);
        assert!(is_nearest, "√{x} is not {}", x.sqrt());
    }
}

/// Its sign is exact: it decides whether a light is in front of a surface.
#[test]
fn dot_products_are_rounded_once_and_keep_the_sign() {
    let mut random = Random(3);
    for _ in 0..300_000 {
        let (a, b) = (random.three(), random.three());
        let sum: i128 = (0..3).map(|i| wide(a[i]) * wide(b[i])).sum();
        let dot = <Fixed as Real>::dot(a.into(), b.into());
        assert_eq!(dot.above(Fixed::ZERO), sum > 1, "{a:?} · {b:?}"); // to 2⁻³¹
        // each half may lose half of 2⁻³²
        let [low, high] = [-3, 0].map(|lost| wide(rounded(sum + lost)));
        assert!((low..=high.max(1)).contains(&wide(dot)), "{a:?} · {b:?}");
    }
}

/// A product adds its factors' errors and half a step, so the m-th power is off by (m − 1)/2 steps.
#[test]
fn powers_of_every_cosine_are_within_their_bound() {
    for m in [1, 2, 3, 7, 32, 33, 100, 127, 128, 1000_u32] {
        for cosine in (1..=1 << 16).map(Fixed::from_bits) {
            let power = exact(cosine).powi(m.try_into().expect("small"));
            let error = (exact(m.raise(cosine)) - power).abs() * 65536.0;
            let bound = f64::from(m - 1) / 2.0;
            assert!(
                error <= bound + 1e-6,
                "{cosine}^{m} is off by {error} steps"
            );
        }
    }
    assert_eq!(0_u32.raise(Fixed::STEP), Fixed::ONE);
    assert_eq!(u32::MAX.raise(Fixed::ONE), Fixed::ONE);
    assert_eq!(u32::MAX.raise(Fixed::ONE - Fixed::STEP), Fixed::ZERO);
}

/// The number nearest to a number of steps, where a tie goes away from 0.
#[allow(clippy::cast_possible_truncation)] // it saturates
fn nearest(steps: f64) -> Fixed {
    Fixed::from_bits(steps.round() as i32)
}

#[test]
#[allow(clippy::cast_possible_truncation)] // on purpose
fn literals_are_rounded_to_the_nearest_number() {
    let mut random = Random(4);
    let mut literals = vec![0.0, f64::MAX, f64::MIN_POSITIVE, f64::INFINITY, 32_768.0];
    for x in edges().into_iter().map(exact) {
        for tie in [x, x + 0.5 / 65536.0] {
            literals.extend([tie, tie.next_up(), tie.next_down()]);
        }
    }
    literals.extend((0..100_000).map(|_| exact(random.fixed()) + 1e-4 * random.fraction()));
    for x in literals.into_iter().flat_map(|x| [x, -x]) {
        assert_eq!(Fixed::new(x), nearest(x * 65536.0), "{x:e}");
        assert_eq!(Fixed::of(x), Fixed::new(x));
        for single in [x as f32, (x as f32).next_up(), (x as f32).next_down()] {
            let expected = nearest(f64::from(single) * 65536.0);
            assert_eq!(Fixed::from_f32(single), expected, "{single:e}");
            assert_eq!(Fixed::of_f32(single), expected, "{single:e}");
        }
    }
    assert_eq!(Fixed::new(f64::NAN), Fixed::ZERO);
    assert_eq!(Fixed::from_f32(f32::NAN), Fixed::ZERO);
}

#[test]
#[allow(clippy::cast_possible_truncation)] // rounds to the nearest
fn numbers_convert_to_others() {
    for (x, _) in pairs() {
        let single = exact(x) as f32;
        assert_eq!(x.to_f32().to_bits(), single.to_bits());
        assert_eq!(exact(x).to_bits(), (steps(x) / 65536.0).to_bits());
    }
    let x = Fixed::from(-5_i16) / Fixed::from(4_i16);
    assert_eq!(format!("{x} {x:?} {x:.1}"), "-1.25 -1.25 -1.2");
}

/// Every step from 0 to 1 is an `f32`, whose encoding is tested elsewhere.
#[test]
fn colors_are_encoded_as_those_of_single_precision() {
    for gray in (-1..=65537).map(|bits| Rgb::gray(Fixed::from_bits(bits))) {
        #[allow(clippy::cast_possible_truncation)] // exact
        let single = gray.map(|x| exact(x) as f32);
        assert_eq!(gray.to_srgb8(), single.to_srgb8(), "{gray:?}");
        assert_eq!(gray.to_rgb565(), single.to_rgb565(), "{gray:?}");
        assert_eq!(gray.to_linear8(), single.to_linear8(), "{gray:?}");
    }
    assert_eq!(const { Rgb::WHITE.to_srgb8() }, [255; 3]);
    assert_eq!(const { Rgb::WHITE.to_rgb565() }, 0xFFFF);
}

/// By way of `f32`, whose functions are right to a unit in the last place.
#[test]
fn elementary_functions_are_those_of_single_precision() {
    for x in (-200_000..200_000).step_by(11).map(Fixed::from_bits) {
        let double = exact(x);
        let near = |actual: Fixed, expected: f64| {
            let error = exact(actual) - expected;
            assert!(
                error.abs() <= 0.5 / 65536.0 + 3e-7 * (1.0 + expected.abs()),
                "{x}: {error:e}"
            );
        };
        near(x.sin(), double.sin());
        near(x.cos(), double.cos());
        near(x.exp(), double.exp());
        near(x.at_least(Fixed::STEP).ln(), double.max(1.0 / 65536.0).ln());
    }
}

/// By the derived formulas of `Elementary`: of the steps of 2⁻¹⁶, each operation may lose one, and
/// the tangent and the power multiply an error by up to 8.
#[test]
fn derived_functions_are_near_those_of_f64() {
    let near = |actual: Fixed, expected: f64| {
        let error = f64::from(actual.to_f32()) - expected;
        assert!(error.abs() < 64.0 / 65536.0, "{expected}: {error:e}");
    };
    for (y, x) in [
        (1.0, 2.0),
        (-1.0, 2.0),
        (3.0, -0.5),
        (-0.25, -4.0),
        (5.0, 0.0_f64),
        (0.0, -1.0),
    ] {
        near(Fixed::of(y).atan2(Fixed::of(x)), y.atan2(x));
    }
    for x in [-1.0, 0.25, 1.0_f64] {
        near(Fixed::of(x).tan(), x.tan());
    }
    near(Fixed::of(2.0).powf(Fixed::of(1.5)), 2.0_f64.powf(1.5));
}

/// A sum takes a light times a cosine or a highlight within [0, 1]: a lobe that gives another
/// number, as one of your own may, counts as the nearer end.
#[test]
fn a_sum_limits_what_a_lobe_gives() {
    let light = Dimmed {
        color: Rgb::new(Fixed::ONE, Fixed::of(0.5), Fixed::MAX),
        factor: Fixed::ONE,
    };
    for x in edges().into_iter().chain([Fixed::of(0.25)]) {
        let limited = x.at_least(Fixed::ZERO).at_most(Fixed::ONE);
        let sum = <Fixed as Real>::Sum::DARK.add(light, x).total();
        assert_eq!(sum, light.color.map(|channel| channel * limited), "{x}");
    }
}
