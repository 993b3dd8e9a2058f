//! Operations on normals with numbers of any size, checked against 150 bits.

use std::fmt::Debug;

use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use shading::{UnitVec3, Vec3, normal};
use support::number::{Float, for_f32_and_f64};

use crate::many_digits::{self as exact, Number, Vector, vector};

for_f32_and_f64!(
    transformed_normals_of_any_size_are_right,
    transformed_normal_is_that_of_the_plane_of_three_points,
    shares_of_any_size_are_right,
    mapped_normals_of_any_size_are_right,
);

/// An integer of a few bits, often 0.
fn whole() -> impl Strategy<Value = f64> {
    prop_oneof![2 => Just(0.0), 5 => (-64..=64_i32).prop_map(f64::from)]
}

/// An integer vector times a power of two, from where it is subnormal to where it almost overflows.
fn of_any_size<T: Float>() -> impl Strategy<Value = Vec3<T>> {
    let largest = T::MAX.to_f64().log2().floor() - 16.0;
    let least = T::TINIEST.log2();
    ([whole(), whole(), whole()], least..largest).prop_map(|(v, exponent)| {
        Vec3::from(v.map(|c| T::of(c)))
            // in two steps, since the power itself may be out of range
            .map(|c| c * T::of((exponent / 2.0).floor().exp2()))
            .map(|c| c * T::of((exponent / 2.0).ceil().exp2()))
    })
}

/// A matrix whose columns have one size, or each a size of its own.
fn matrix<T: Float>() -> impl Strategy<Value = [Vec3<T>; 3]> {
    let column = of_any_size::<T>;
    let whole = || [whole(), whole(), whole()].prop_map(|v| Vec3::from(v.map(|c| T::of(c))));
    let size = column().prop_map(|v| v.x);
    prop_oneof![
        [column(), column(), column()],
        ([whole(), whole(), whole()], size).prop_map(|(columns, size)| columns.map(|c| c * size)),
    ]
}

/// A direction of integers, which the formula accepts as well, with small numbers among them.
fn direction<T: Float>() -> impl Strategy<Value = UnitVec3<T>> {
    let component = || (whole(), prop_oneof![3 => Just(0), 1 => -100..0]);
    [component(), component(), component()]
        .prop_filter("no direction", |v| {
            v.iter().any(|(c, k)| *c != 0.0 && *k == 0)
        })
        .prop_map(|v| Vec3::from(v.map(|(c, k)| T::of(c / 64.0 * f64::from(k).exp2()))))
        .prop_map(UnitVec3::assume_unit)
}

/// Tries 5,000 inputs, the same in each run, and prints the largest error as a share of the
/// tolerance.
fn try_all<S: Strategy<Value: Debug>>(inputs: S, share: impl Fn(S::Value) -> f64) {
    let mut runner = TestRunner::deterministic();
    let mut largest = 0.0_f64;
    for _ in 0..5_000 {
        let input = inputs
            .new_tree(&mut runner)
            .expect("few are rejected")
            .current();
        let described = format!("{input:?}");
        let share = share(input);
        assert!(share <= 1.0, "{described}: {share} times the tolerance");
        largest = largest.max(share);
    }
    println!("at most {:.0}% of a tolerance", 100.0 * largest);
}

/// The largest error of a component as a share of `units` u.
fn share<T: Float>(computed: impl Into<[T; 3]>, expected: &Vector, units: f64) -> f64 {
    let computed = vector::<T>(computed);
    let errors = exact::subtract(&computed, expected);
    let largest = errors.map(|c| c.to_f64().value().abs());
    largest.into_iter().fold(0.0, f64::max) / (units * T::U)
}

fn is_zero(v: &Vector) -> bool {
    v.iter().all(|c| *c == Number::ZERO)
}

/// The products of a cofactor and their difference are off by 2u of the product of two lengths, the
/// factor by 1u, and the two sums by 2u; the unit vector is off by 4u. If the sum is zero, there is
/// no normal; if rounding may make it zero, there need not be one.
fn check_transformed<T: Float>(n: UnitVec3<T>, columns: [Vec3<T>; 3], expected: &Vector) -> f64 {
    let transformed = normal::transformed(n, columns);
    if is_zero(expected) {
        // the terms cancel exactly only if the products are exact
        return transformed.map_or(0.0, |_| 0.5);
    }
    let conditioning = exact::conditioning(&columns.map(vector), &vector(n));
    let units = 5.0 * conditioning + 4.0;
    if units * T::U > 0.1 {
        return 0.0;
    }
    let transformed = transformed.unwrap_or_else(|| panic!("no normal: {n:?}, {columns:?}"));
    share(transformed, &exact::unit(expected), units)
}

fn transformed_normals_of_any_size_are_right<T: Float>() {
    try_all((direction::<T>(), matrix::<T>()), |(n, columns)| {
        let expected = exact::cofactors(&columns.map(vector), &vector(n));
        check_transformed(n, columns, &expected)
    });
}

/// Integer points transformed without rounding: the expected normal is that of the plane through
/// them.
fn transformed_normal_is_that_of_the_plane_of_three_points<T: Float>() {
    let point = || [whole(), whole(), whole()].prop_map(|v| Vec3::from(v.map(|c| T::of(c))));
    try_all(
        ([point(), point(), point()], matrix::<T>()),
        |(points, columns)| {
            let plane = |[a, b, c]: [Vector; 3]| {
                exact::cross(&exact::subtract(&b, &a), &exact::subtract(&c, &a))
            };
            let n = plane(points.map(vector));
            if is_zero(&n) {
                return 0.0;
            }
            // as many bits as lie between the largest and the smallest number
            let exactly = |v: Vec3<T>| vector(v).map(|c| c.with_precision(5000).value());
            let exact_columns = columns.map(exactly);
            let moved = points.map(|p| exact::product(&exact_columns, &exactly(p)));
            let expected = plane(moved).map(|c| c.with_precision(150).value());
            // at most 16 bits, so it is exact in the type
            let n = Vec3::from(n.map(|c| T::of(c.to_f64().value())));
            check_transformed(UnitVec3::assume_unit(n), columns, &expected)
        },
    );
}

/// The edges are exact. The product is off by 2u of the product of their lengths, the unit vector
/// by 4u, and the angle by 16u.
fn shares_of_any_size_are_right<T: Float>() {
    try_all([of_any_size::<T>(), of_any_size()], |[e1, e2]| {
        let share_of_triangle = normal::corner(Vec3::ZERO, e1, e2);
        let (e1, e2) = (vector(e1), vector(e2));
        let product = exact::cross(&e1, &e2);
        if is_zero(&product) {
            return if share_of_triangle == Vec3::ZERO {
                0.0
            } else {
                2.0
            };
        }
        let (angle, size) = (exact::angle(&e1, &e2), exact::length(&product));
        let conditioning = (exact::length(&e1) * exact::length(&e2) / size)
            .to_f64()
            .value();
        let expected = exact::scale(&exact::unit(&product), &angle);
        share(share_of_triangle, &expected, 4.0 * conditioning + 24.0)
    });
}

/// The tolerance is derived in `laws/src/number/derived.rs`.
fn mapped_normals_of_any_size_are_right<T: Float>() {
    let handedness = prop_oneof![Just(1.0), Just(-1.0)];
    let direction = of_any_size::<T>().prop_filter_map("zero", Vec3::unit);
    let inputs = (
        direction,
        of_any_size::<T>(),
        handedness,
        of_any_size::<T>(),
    );
    try_all(inputs, |(n, tangent, h, sample)| {
        let mapped = normal::mapped(n, tangent, T::of(h), sample);
        let (n, tangent, sample) = (vector(n), vector(tangent), vector(sample));
        let side = exact::cross(&n, &tangent);
        if is_zero(&side) || is_zero(&sample) {
            return if mapped.is_none() { 0.0 } else { 2.0 };
        }
        let conditioning = (exact::length(&tangent) / exact::length(&side))
            .to_f64()
            .value();
        let units = 6.0 * conditioning + 18.0;
        if units * T::U > 0.1 {
            return 0.0;
        }
        let expected = exact::mapped(&n, &tangent, &exact::number(h), &sample);
        share(mapped.expect("a frame"), &exact::unit(&expected), units)
    });
}
