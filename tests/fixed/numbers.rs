//! Operators, roots, powers and conversions.

use std::collections::HashSet;
use std::hash::{DefaultHasher, Hash, Hasher};

use shading::fixed::Fixed;
use shading::{Elementary, Exponent, Real};

use crate::{Random, assert_documented, edges, exact, steps};

const ONE: i128 = 1 << 16;

/// All pairs of edges, and many pairs of numbers of any magnitude.
fn pairs() -> impl Iterator<Item = (Fixed, Fixed)> {
    let edges = edges();
    let others = edges.clone();
    let of_edges = edges
        .into_iter()
        .flat_map(move |a| others.clone().into_iter().map(move |b| (a, b)));
    let mut random = Random(1);
    of_edges.chain((0..1_000_000).map(move |_| (random.fixed(), random.fixed())))
}

fn wide(number: Fixed) -> i128 {
    number.to_bits().into()
}

fn saturated(steps: i128) -> Fixed {
    let ends = i128::from(i32::MIN)..=i128::from(i32::MAX);
    let steps = steps.clamp(*ends.start(), *ends.end());
    Fixed::from_bits(i32::try_from(steps).expect("clamped"))
}

#[test]
fn sums_are_exact_or_saturate() {
    for (a, b) in pairs() {
        assert_eq!(a + b, saturated(wide(a) + wide(b)), "{a} + {b}");
        assert_eq!(a - b, saturated(wide(a) - wide(b)), "{a} − {b}");
        assert_eq!(-a, saturated(-wide(a)), "−{a}");
        assert_eq!(Real::abs(a), saturated(wide(a).abs()), "|{a}|");
    }
}

#[test]
fn products_are_rounded_once_and_a_tie_goes_up() {
    for (a, b) in pairs() {
        let exact = wide(a) * wide(b);
        assert_eq!(
            a * b,
            saturated((exact + ONE / 2).div_euclid(ONE)),
            "{a} × {b}"
        );
    }
}

/// A tie goes away from 0, as signs are set apart from the division.
#[test]
fn quotients_are_rounded_once() {
    for (a, b) in pairs() {
        let sign = wide(a).signum() * if wide(b) < 0 { -1 } else { 1 };
        let (dividend, divisor) = (wide(a).abs() * ONE, wide(b).abs());
        let expected = if divisor == 0 {
            sign * i128::MAX
        } else {
            sign * ((2 * dividend + divisor) / (2 * divisor))
        };
        assert_eq!(a / b, saturated(expected), "{a} / {b}");
    }
}

#[test]
fn roots_are_rounded_once() {
    let mut random = Random(2);
    let some = (0..1_000_000).map(|_| random.fixed());
    for x in edges().into_iter().chain(some) {
        // r ± ½ in halves of a step, so that all is whole
        let (root, square) = (2 * wide(x.sqrt()), 4 * ONE * wide(x).max(0));
        let is_nearest = (root - 1).max(0).pow(2) <= square && square < (root + 1).pow(2);
        assert!(is_nearest, "√{x} is not {}", x.sqrt());
    }
}

#[test]
fn comparisons_are_those_of_the_exact_numbers() {
    for (a, b) in pairs() {
        assert_eq!(a.cmp(&b), wide(a).cmp(&wide(b)));
        assert_eq!(a == b, wide(a) == wide(b));
        assert_eq!(
            Real::if_above(a, b, Fixed::ONE, Fixed::ZERO),
            saturated(if wide(a) > wide(b) { ONE } else { 0 })
        );
        assert_eq!(Real::at_least(a, b), a.max(b));
        assert_eq!(Real::at_most(a, b), a.min(b));
    }
    for a in edges() {
        assert_eq!(a.any_positive(), wide(a) > 0);
        assert_eq!(
            a.if_positive(Fixed::MAX, Fixed::MIN),
            if wide(a) > 0 { Fixed::MAX } else { Fixed::MIN }
        );
    }
    let hash = |x: Fixed| {
        let mut hasher = DefaultHasher::new();
        x.hash(&mut hasher);
        hasher.finish()
    };
    let hashes: HashSet<u64> = edges().into_iter().map(hash).collect();
    assert_eq!(hashes.len(), edges().len());
    assert_eq!(Fixed::default(), Fixed::ZERO);
}

/// Each of the m − 1 products loses less than 2⁻³², and with cosines of at most 1 the losses add up
/// at most; the end is rounded to half a step.
#[test]
fn powers_of_every_cosine_are_within_their_bound() {
    let mut largest = [0.0_f64; 1001];
    for bits in 1..1 << 16 {
        let cosine = Fixed::from_bits(bits);
        let mut power = 1.0;
        for m in 0..=1000_u32 {
            let error = (steps(m.raise(cosine)) - power * 65536.0).abs();
            let bound = 0.5 + f64::from(m.max(1) - 1) / 65536.0 + 1e-9;
            assert!(error <= bound, "{cosine}^{m} is off by {error} steps");
            largest[m as usize] = largest[m as usize].max(error);
            power *= exact(cosine); // off by less than 1000 · 2⁻⁵³
        }
    }
    for (m, bound) in [(32, 0.501), (128, 0.502), (1000, 0.516)] {
        let what = format!("an integer power, m = {m}");
        assert_documented(&what, largest[m], bound, "steps");
    }
}

#[test]
fn powers_end_at_the_ends_of_the_cosine() {
    for m in [0, 1, 2, 3, 128, 1000, u32::MAX] {
        for dark in [Fixed::ZERO, -Fixed::STEP, Fixed::NEG_ONE, Fixed::MIN] {
            assert_eq!(m.raise(dark), Fixed::ZERO, "{dark}^{m}");
        }
        for full in [Fixed::ONE, Fixed::ONE + Fixed::STEP, Fixed::MAX] {
            assert_eq!(m.raise(full), Fixed::ONE, "{full}^{m}");
        }
    }
    assert_eq!(u32::MAX.raise(Fixed::ONE - Fixed::STEP), Fixed::ZERO);
}

/// The steps nearest to a number of steps, where a tie goes away from 0.
#[allow(clippy::cast_possible_truncation)] // it saturates
fn nearest(steps: f64) -> Fixed {
    Fixed::from_bits(steps.round() as i32)
}

#[test]
fn literals_are_rounded_to_the_nearest_number() {
    let mut random = Random(3);
    let mut literals = vec![0.0, f64::MAX, f64::MIN_POSITIVE, f64::INFINITY, 32_768.0];
    for x in edges().into_iter().map(exact) {
        for tie in [x, x + 0.5 / 65536.0] {
            literals.extend([tie, tie.next_up(), tie.next_down()]);
        }
    }
    literals.extend((0..100_000).map(|_| exact(random.fixed()) + random.within(0.0, 1e-4)));
    for x in literals.into_iter().flat_map(|x| [x, -x]) {
        assert_eq!(Fixed::new(x), nearest(x * 65536.0), "{x:e}");
        assert_eq!(Fixed::of(x), Fixed::new(x));
        #[allow(clippy::cast_possible_truncation)] // on purpose
        let single = x as f32;
        for single in [single, single.next_up(), single.next_down()] {
            let expected = nearest(f64::from(single) * 65536.0);
            assert_eq!(Fixed::from_f32(single), expected, "{single:e}");
            assert_eq!(Fixed::of_f32(single), expected, "{single:e}");
        }
    }
    assert_eq!(Fixed::new(f64::NAN), Fixed::ZERO);
    assert_eq!(Fixed::from_f32(f32::NAN), Fixed::ZERO);
}

#[test]
fn numbers_convert_to_others() {
    let mut random = Random(4);
    let some = (0..100_000).map(|_| random.fixed());
    for x in edges().into_iter().chain(some) {
        let bits = x.to_bits();
        assert_eq!(Fixed::from_bits(bits), x);
        let double = f64::from(bits) / 65536.0;
        assert_eq!(f64::from(x).to_bits(), double.to_bits());
        #[allow(clippy::cast_possible_truncation)] // rounds to the nearest
        let single = double as f32;
        assert_eq!(x.to_f32().to_bits(), single.to_bits());
        assert_eq!(
            format!("{x} {x:?} {x:.2}"),
            format!("{double} {double:?} {double:.2}")
        );
    }
    for whole in i16::MIN..=i16::MAX {
        assert_eq!(
            exact(Fixed::from(whole)).to_bits(),
            f64::from(whole).to_bits()
        );
    }
    assert_eq!(format!("{}", Fixed::new(-1.25)), "-1.25");
}

/// The argument is rounded to `f32`, the result to `f32` and then to a step. `libm` is off by less
/// than one unit in the last place.
#[test]
fn elementary_functions_are_those_of_single_precision() {
    const U: f64 = 1.0 / (1 << 24) as f64;
    let check = |name, x: Fixed, actual: Fixed, expected: f64, slope: f64| {
        let bound = 0.5 / 65536.0 + U * (exact(x) * slope).abs() + 3.0 * U * expected.abs();
        let end = exact(Fixed::MAX);
        let error = exact(actual) - expected.clamp(-32_768.0, end);
        assert!(error.abs() <= bound, "{name} {x} is off by {error:e}");
    };
    let mut random = Random(5);
    for _ in 0..100_000 {
        let fixed = random.fixed();
        let x = exact(fixed);
        check("sin", fixed, fixed.sin(), x.sin(), 1.0);
        check("cos", fixed, fixed.cos(), x.cos(), 1.0);
        check("exp", fixed, fixed.exp(), x.exp(), x.exp());
        if x > 0.0 {
            check("ln", fixed, fixed.ln(), x.ln(), 1.0 / x);
        }
    }
}

#[test]
fn integer_powers_of_any_number() {
    let x = Fixed::new;
    assert_eq!(x(-3.0).powi(5), x(-243.0));
    assert_eq!(x(2.0).powi(-2), x(0.25));
    assert_eq!(x(0.5).powi(16), Fixed::STEP);
    assert_eq!(x(-2.0).powi(15), Fixed::MIN);
    assert_eq!(x(2.0).powi(15), Fixed::MAX);
    assert_eq!(x(0.0).powi(0), x(1.0));
    assert_eq!(x(0.0).powi(-1), Fixed::MAX);
}

/// What the formulas need of a number type, in numbers of 16 bits after the point.
#[test]
fn constants_are_the_numbers_they_name() {
    assert_eq!(exact(Fixed::ZERO).to_bits(), 0.0_f64.to_bits());
    assert_eq!(Fixed::ONE, Fixed::from(1_i16));
    assert_eq!(Fixed::NEG_ONE, Fixed::from(-1_i16));
    assert_eq!(<Fixed as Real>::MAX, Fixed::MAX);
    assert_eq!(Fixed::EXTREME, Fixed::from(512_i16));
    assert_eq!(Fixed::MAX.to_bits(), i32::MAX);
    assert_eq!(Fixed::MIN.to_bits(), i32::MIN);
    assert_eq!(Fixed::STEP.to_bits(), 1);
}
