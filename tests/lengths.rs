//! Lengths and directions of vectors of any size, at run time and in constants.

use dashu_float::FBig;
use dashu_float::ops::Abs;
use dashu_float::round::mode::HalfEven;
use proptest::prelude::*;
use shading::{UnitVec3, Vec3};
use support::number::{Float, for_f32_and_f64};

for_f32_and_f64!(
    diagonal_of_a_box_is_exact_at_any_size,
    length_that_overflows_is_infinite,
    length_is_right_at_any_size,
    direction_has_the_same_bits_in_a_constant_and_at_run_time,
);

fn diagonal_of_a_box_is_exact_at_any_size<T: Float>() {
    // 2² + 3² + 6² = 7²: no step rounds, from the smallest number to the largest size whose
    // sevenfold is finite
    let [two, three, six, seven] = [2.0, 3.0, 6.0, 7.0].map(T::of);
    let mut size = T::of(T::TINIEST);
    while (size * seven).is_finite() {
        let sides = Vec3::new(size * two, -size * three, size * six);
        assert_eq!(sides.length(), size * seven, "{size:e}");
        size = size * two;
    }
    assert_eq!(Vec3::<T>::ZERO.length(), T::ZERO);
}

fn length_that_overflows_is_infinite<T: Float>() {
    let long = Vec3::new(T::MAX, T::ZERO, T::MAX); // √2 times the largest number
    assert_eq!(long.length(), T::INFINITY);
    assert_eq!(
        Vec3::new(T::ZERO, -T::INFINITY, T::ONE).length(),
        T::INFINITY
    );
    assert!(Vec3::new(T::ONE, T::NAN, T::ONE).length().to_f64().is_nan());
}

/// A vector of any size whose components differ by at most some binary places.
fn vector<T: Float>() -> impl Strategy<Value = Vec3<T>> {
    let largest = T::MAX.to_f64().log2().floor();
    let component = || (-2.0..2.0, 0.0..40.0_f64);
    (
        [component(), component(), component()],
        T::TINIEST.log2()..largest,
    )
        .prop_map(|(components, size)| {
            let component = |(c, places): (f64, f64)| T::of(c * (size - places).floor().exp2());
            Vec3::from(components.map(component))
        })
}

/// A number of 300 bits.
type Exact = FBig<HalfEven, 2>;

fn exact(x: f64) -> Exact {
    let x = Exact::try_from(x).expect("finite");
    x.with_precision(300).value()
}

fn config() -> ProptestConfig {
    ProptestConfig {
        cases: 20_000,
        failure_persistence: None,
        ..<_>::default()
    }
}

/// Each square rounds by u, and so does each of two sums: 3u, which the root turns into 1.5u. The
/// root itself rounds by u. Terms in u² add less than 10⁻⁶ of that. A subnormal length rounds by
/// half the smallest number.
fn length_is_right_at_any_size<T: Float>() {
    proptest!(config(), |(v in vector::<T>())| {
        let [x, y, z] = <[T; 3]>::from(v).map(|c| exact(c.to_f64()));
        let length = (&x * &x + &y * &y + &z * &z).sqrt();
        let tolerance = exact(2.500_003 * T::U) * &length + exact(T::TINIEST) / exact(2.0);
        let computed = v.length();
        if computed == T::INFINITY {
            prop_assert!(length + tolerance > exact(T::MAX.to_f64()));
        } else {
            let error = (exact(computed.to_f64()) - length).abs();
            prop_assert!(error <= tolerance, "{computed:e}, off by {error}");
        }
    });
}

/// Ordinary vectors, vectors of any size, and vectors of arbitrary numbers, finite or not.
fn direction_has_the_same_bits_in_a_constant_and_at_run_time<T: Float>() {
    let special = [0.0, -0.0, 1.0, T::TINIEST, T::MIN_POSITIVE, T::MAX.to_f64()];
    let special = special
        .map(T::of)
        .into_iter()
        .chain([T::INFINITY, -T::INFINITY, T::NAN]);
    let special = prop::sample::select(special.collect::<Vec<_>>());
    let of_any_numbers = || prop_oneof![1 => special.clone(), 4 => vector::<T>().prop_map(|v| v.x)];
    let of_any_numbers =
        [of_any_numbers(), of_any_numbers(), of_any_numbers()].prop_map(Vec3::from);
    let usual = [-1.0..1.0, -1.0..1.0, -1.0..1.0].prop_map(|v| Vec3::from(v).map(T::of));
    let bits = |direction: Option<UnitVec3<T>>| {
        direction.map(|direction| <[T; 3]>::from(direction).map(|c| c.to_f64().to_bits()))
    };
    proptest!(config(), |(v in prop_oneof![usual, vector(), of_any_numbers])| {
        prop_assert_eq!(bits(T::normalized(v.x, v.y, v.z)), bits(v.unit()));
    });
}
