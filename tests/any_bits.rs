//! No function panics for any bit pattern, and none returns NaN or negative light for finite valid
//! input. `fuzz/` runs the same checks for as long as you like, and so does `PROPTEST_CASES`.

use kit::Float;
use kit::everything::{Numbers, any_bits, finite_and_valid};
use proptest::prelude::*;

kit::for_f32_and_f64!(any_bits_never_panic, finite_valid_input_gives_light);

/// Values that break formulas. Many of the wide ones are 0 or infinite in single precision.
const ADVERSARIAL: [f64; 26] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    2.0,
    1.0 + f64::EPSILON,
    1.0 - f64::EPSILON / 2.0,
    1.0 + f32::EPSILON as f64,
    1.0 - f32::EPSILON as f64 / 2.0,
    1e30,
    -1e30,
    1e-30,
    1e300,
    1e-300,
    f32::MAX as f64,
    -(f32::MAX as f64),
    f32::MIN_POSITIVE as f64,
    f32::from_bits(1) as f64,
    f64::MAX,
    -f64::MAX,
    f64::MIN_POSITIVE,
    f64::from_bits(1),
    f64::INFINITY,
    f64::NAN,
    65_536.0,
];

/// The bits of a signaling NaN; their lower half is one in single precision.
const SIGNALING: u64 = 0x7FF0_0001_7F80_0001;

fn number<T: Float>() -> impl Strategy<Value = T> {
    prop_oneof![
        2 => any::<u64>().prop_map(T::of_bits),
        1 => Just(T::of_bits(SIGNALING)),
        2 => any::<u32>().prop_map(|bits| T::of(f32::from_bits(bits).into())),
        3 => prop::sample::select(&ADVERSARIAL[..]).prop_map(T::of),
        2 => (-2.0..2.0_f64).prop_map(T::of),
    ]
}

/// Runs a check on numbers from a list that repeats endlessly.
fn with_numbers<T: Float>(check: fn(Numbers<T>)) {
    let config = ProptestConfig {
        cases: 1000,
        failure_persistence: None,
        ..<_>::default()
    };
    let m = prop_oneof![0..200_u32, any::<u32>(), Just(u32::MAX)];
    let input = (prop::collection::vec(number::<T>(), 1..150), m);
    proptest!(config, |((list, m) in input)| {
        let mut numbers = list.iter().copied().cycle();
        check(Numbers { next: &mut || numbers.next().expect("endless"), m });
    });
}

fn any_bits_never_panic<T: Float>() {
    with_numbers::<T>(any_bits);
}

fn finite_valid_input_gives_light<T: Float>() {
    with_numbers::<T>(finite_and_valid);
}
