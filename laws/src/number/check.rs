//! Runs a property and compares results.

use std::fmt::Debug;

use proptest::prelude::*;
use proptest::test_runner::{TestCaseResult, TestRunner};

use super::Number;

/// Runs a property on many cases, and reports the smallest case that fails. `PROPTEST_CASES` sets
/// their number.
#[track_caller] // a failure names the property
pub fn check<S: Strategy<Value: Debug>>(inputs: S, property: impl Fn(S::Value) -> TestCaseResult) {
    let mut config = ProptestConfig {
        failure_persistence: None,
        ..ProptestConfig::default()
    };
    if std::env::var_os("PROPTEST_CASES").is_none() {
        config.cases = 1000;
    }
    config.max_global_rejects = 4 * config.cases; // assumptions may reject four out of five
    config.max_local_rejects = 4 * config.cases.max(20_000); // so may the filters of generators
    if let Err(failure) = TestRunner::new(config).run(&inputs, property) {
        panic!("{failure}");
    }
}

/// What each kind of number is due: a float, whose error is u of a result, and an evenly spaced type,
/// whose error is u at any size. So a factor that comes later leaves the error of a float as it is, and
/// multiplies that of an evenly spaced type.
#[must_use]
pub fn by_spacing<T: Number>(float: f64, even: f64) -> f64 {
    if T::EVENLY_SPACED { even } else { float }
}

/// Whether numbers that are scaled down by a power of two lose bits soon: in an evenly spaced type, and in a float whose
/// range is short, such as an IEEE half, whose normal numbers begin at 2⁻¹⁴. What is exact at any scale in other floats
/// has a tolerance there.
#[must_use]
pub fn is_short_of_range<T: Number>() -> bool {
    T::EVENLY_SPACED || octaves_below_one::<T>() < 64.0
}

/// The size to which an evenly spaced type can scale vectors and still hold their cross products: 16 with 16 bits before
/// the point, and 1 with 8.
#[must_use]
pub fn scaled_size<T: Number>() -> f64 {
    (T::MAX.to_f64() / 128.0).sqrt()
}

/// How many times 1 may be halved until it loses bits.
#[must_use]
pub fn octaves_below_one<T: Number>() -> f64 {
    (2.0 * T::U / T::TINY.to_f64()).log2()
}

pub fn to_f64<T: Number>(components: impl Into<[T; 3]>) -> [f64; 3] {
    components.into().map(T::to_f64)
}

/// Compares bit for bit.
pub fn same<T: Number, V: Into<[T; 3]>>(a: V, b: V) -> TestCaseResult {
    let (a, b) = (to_f64(a), to_f64(b));
    prop_assert_eq!(
        a.map(f64::to_bits),
        b.map(f64::to_bits),
        "{:?} is not {:?}",
        a,
        b
    );
    Ok(())
}

/// Compares as numbers: bit for bit, except for the sign of a zero.
pub fn equal<T: Number, V: Into<[T; 3]>>(a: V, b: V) -> TestCaseResult {
    prop_assert_eq!(to_f64(a), to_f64(b));
    Ok(())
}

/// Compares floats bit for bit, and evenly spaced numbers within `k` times u. A float of a short range loses bits of what
/// is below its normal numbers: it is compared within 16u, and within `k` times u.
pub fn same_or_near<T: Number, V: Into<[T; 3]>>(a: V, b: V, k: f64) -> TestCaseResult {
    if T::EVENLY_SPACED {
        near(a, b, k * T::U)
    } else if is_short_of_range::<T>() {
        near(a, b, k.max(16.0) * T::U)
    } else {
        same(a, b)
    }
}

/// Compares as numbers what differs in sign before it is rounded. An evenly spaced type may round a tie
/// up on either side of 0, so it may differ by a step.
pub fn equal_but_for_ties<T: Number, V: Into<[T; 3]>>(a: V, b: V) -> TestCaseResult {
    if T::EVENLY_SPACED {
        near(a, b, 2.0 * T::U)
    } else if is_short_of_range::<T>() {
        near(a, b, 16.0 * T::U)
    } else {
        equal(a, b)
    }
}

/// Compares component by component within an absolute `tolerance`.
pub fn near<T: Number, V: Into<[T; 3]>>(a: V, b: V, tolerance: f64) -> TestCaseResult {
    let (a, b) = (to_f64(a), to_f64(b));
    for i in 0..3 {
        within(a[i] - b[i], tolerance)?;
    }
    Ok(())
}

/// Compares component by component within `k` units of roundoff of the larger number. An operation
/// that underflows loses half of the smallest number instead. In an evenly spaced type, a unit is u.
pub fn nearly<T: Number, V: Into<[T; 3]>>(a: V, b: V, k: f64) -> TestCaseResult {
    let (a, b) = (to_f64(a), to_f64(b));
    for i in 0..3 {
        let magnitude = a[i].abs().max(b[i].abs());
        let unit = by_spacing::<T>(T::U * magnitude + T::TINY.to_f64(), T::U);
        within(a[i] - b[i], k * unit)?;
    }
    Ok(())
}

/// Checks that |error| ≤ tolerance, and reports the excess.
pub fn within(error: f64, tolerance: f64) -> TestCaseResult {
    prop_assert!(
        error.abs() <= tolerance,
        "off by {error:e}, {} times the tolerance {tolerance:e}",
        error.abs() / tolerance
    );
    Ok(())
}

/// Checks that a ≥ b − `tolerance`.
pub fn at_least(a: f64, b: f64, tolerance: f64) -> TestCaseResult {
    prop_assert!(
        a >= b - tolerance,
        "{a:e} is not at least {b:e} − {tolerance:e}"
    );
    Ok(())
}
