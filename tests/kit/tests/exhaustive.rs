//! Checks every `f32` of a domain.
//!
//! Checking all of them takes minutes: `cargo test --release -p kit --test exhaustive --
//! --ignored`. Without `--ignored`, the tests take every 2039th, or every n-th with
//! `SHADING_STRIDE=n`. An odd stride reaches every pattern of low-order bits.

use std::env;
use std::ops::RangeInclusive;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::thread;

use shading::{Attenuation, Cone, Lobe, Real, Rgb, UnitVec3, Vec3, attenuation};

#[path = "encoding/srgb.rs"]
mod srgb;

/// u, the unit roundoff of `f32`.
const U: f64 = 1.0 / 16_777_216.0;

/// The shininess m: integers, and other real numbers.
const WHOLE: [u32; 14] = [0, 1, 2, 3, 4, 5, 7, 8, 31, 32, 100, 1000, 9_999, 10_000];
const REAL: [f32; 15] = [
    0.0, 0.1, 0.5, 1.0, 1.5, 2.0, 2.2, 5.0, 10.3, 32.5, 100.0, 250.7, 1000.1, 4096.0, 10_000.0,
];

/// Runs each test on some numbers, and on all with `--ignored`.
macro_rules! on_some_and_all {
    ($($test:ident: |$stride:ident| $run:expr;)*) => {
        $(#[test]
        fn $test() {
            let $stride = stride();
            $run;
        })*

        mod all {
            use super::*;

            $(#[test]
            #[ignore = "takes minutes"]
            fn $test() {
                let $stride = 1;
                $run;
            })*
        }
    };
}

on_some_and_all! {
    whole_powers: |stride| in_parallel(&WHOLE, |&m| whole_power(m, stride));
    real_powers: |stride| in_parallel(&REAL, |&m| real_power(m, stride));
    attenuations: |stride| in_parallel(&COEFFICIENTS, |&abc| attenuation_falls(abc, stride));
    unit_vectors: |stride| in_parallel(&DIRECTIONS, |&direction| unit_is_right(direction, stride));
    roots: |stride| root_is_rounded_correctly(stride);
    smoothsteps: |stride| smoothstep_rises(stride);
    levels: |stride| levels_are_rounded_correctly(stride);
}

/// As the cosine rises, a smoothstep never falls by more than one unit in the last place. The edge
/// is from 0 to ½, so that t is twice the cosine, exactly.
fn smoothstep_rises(stride: u32) {
    let cone = Cone::from_cosines(0.5, 0.0).expect("cosines").smoothstep();
    let mut highest = 0.0_f32;
    for cosine in floats(0.5, stride) {
        let l = UnitVec3::assume_unit(Vec3::new(0.0, 0.0, cosine));
        let factor = cone.factor(UnitVec3::NEG_Z, l);
        assert!(
            factor.to_bits() + 1 >= highest.to_bits(),
            "{factor} at {cosine}, after {highest}"
        );
        highest = highest.max(factor);
    }
}

/// A run of consecutive bit patterns, and the level that their numbers are encoded as.
struct Run {
    bits: RangeInclusive<u32>,
    level: u16,
}

/// The numbers from one edge up to the next have the level that begins at the first of the two.
/// Negative numbers and NaN have level 0, and infinity has the highest.
fn runs(edges: Vec<f32>) -> Vec<Run> {
    let mut ends = vec![0];
    ends.extend(edges.into_iter().map(f32::to_bits));
    ends.push(f32::INFINITY.to_bits() + 1);
    let positive = (0..).zip(ends.windows(2)).map(|(level, ends)| Run {
        bits: ends[0]..=ends[1] - 1,
        level,
    });
    let nan = f32::INFINITY.to_bits() + 1..=u32::MAX >> 1;
    let negative = 1 << 31..=u32::MAX;
    let none = [nan, negative].map(|bits| Run { bits, level: 0 });
    positive.chain(none).collect()
}

/// The levels of a color whose channels are the same number.
type Levels = fn(f32) -> [u16; 3];

fn bytes(bytes: [u8; 3]) -> [u16; 3] {
    bytes.map(u16::from)
}

/// A number gets the level nearest to its exact encoding, or to itself.
fn levels_are_rounded_correctly(stride: u32) {
    let encoded: [(u16, Levels); 3] = [
        (255, |x| bytes(Rgb::gray(x).to_srgb8())),
        (63, |x| [Rgb::gray(x).to_rgb565() >> 5 & 63; 3]),
        (31, |x| fives(Rgb::gray(x).to_rgb565())),
    ];
    let linear: [(u16, Levels); 1] = [(255, |x| bytes(Rgb::gray(x).to_linear8()))];
    let encoded = encoded.map(|(highest, levels)| (srgb::edges(highest), levels));
    let linear = linear.map(|(highest, levels)| (srgb::linear_edges(highest), levels));
    for (edges, levels) in encoded.into_iter().chain(linear) {
        in_parallel(&runs(edges), |Run { bits, level }| {
            let some = bits.clone().step_by(stride as usize).chain([*bits.end()]);
            for x in some.map(f32::from_bits) {
                assert!(levels(x) == [*level; 3], "{x:e} is not {level}");
            }
        });
    }
}

/// Red, and blue twice.
fn fives(bits: u16) -> [u16; 3] {
    [bits >> 11, bits & 31, bits & 31]
}

/// √x is the nearest `f32`: the root in double precision has more than twice as many digits, so
/// rounding it again does no harm. A root for constants takes part in a direction.
fn root_is_rounded_correctly(stride: u32) {
    for x in floats(f32::MAX, stride) {
        let root = f64::from(x).sqrt();
        #[allow(clippy::cast_possible_truncation)]
        let nearest = root as f32;
        assert!(Real::sqrt(x).to_bits() == nearest.to_bits(), "√{x:e}");
        // the root is hardest to round next to the square of a midpoint between two doubles
        let next = f64::from_bits(root.to_bits() + 1);
        let square = (root * next).to_bits();
        for x in (square.saturating_sub(2)..square + 3).map(f64::from_bits) {
            assert!(Real::sqrt(x).to_bits() == x.sqrt().to_bits(), "√{x:e}");
        }
        let v = Vec3::new(nearest, 1.0, 0.0);
        let constant = UnitVec3::<f32>::const_new(v.x, v.y, v.z);
        assert_eq!(constant, UnitVec3::new(v.x, v.y, v.z), "{v:?}");
    }
}

/// cosineᵐ is right to m − 1 roundings, and never falls as the cosine rises: each multiplication is
/// monotone. If m is even, (√square)ᵐ is a power with half of m; otherwise, the rounding of the
/// root counts m times in addition. A result that would be subnormal may be 0.
fn whole_power(m: u32, stride: u32) {
    let negligible = f64::from(f32::MIN_POSITIVE);
    let roundings = |m: u32| f64::from(m.saturating_sub(1));
    let of_root_roundings = if m % 2 == 0 {
        roundings(m / 2)
    } else {
        roundings(m) + f64::from(m)
    };
    let mut largest = 0.0;
    for cosine in floats(1.0, stride).skip(1) {
        let (power, expected) = (m.raise(cosine), f64::from(cosine).powf(f64::from(m)));
        let error = (f64::from(power) - expected).abs();
        let tolerance = (roundings(m) * U * expected).max(negligible);
        assert!(error <= tolerance, "{cosine:e}^{m} = {power:e}");
        assert!(power >= largest, "{cosine:e}^{m} falls");
        // squaring never goes far into the subnormal numbers, which are slow
        assert!(
            power == 0.0 || f64::from(power) > negligible / 32.0,
            "{cosine:e}^{m}"
        );
        largest = power;

        let of_root = m.raise_root(cosine);
        let expected = f64::from(cosine).powf(0.5 * f64::from(m));
        let error = (f64::from(of_root) - expected).abs();
        let tolerance = (of_root_roundings * U * expected).max(negligible);
        assert!(error <= tolerance, "√{cosine:e}^{m} = {of_root:e}");
    }
}

/// A real power is right to 2⁻²², is 1 for m = 0 and for a cosine of 1, and falls by at most one
/// unit in the last place as the cosine rises. A cosine of 0 is left out: the highlight ends there.
fn real_power(m: f32, stride: u32) {
    let tolerance = 1.0 / f64::from(1 << 22);
    let mut largest = 0.0_f32;
    for cosine in floats(1.0, stride).skip(1) {
        let (power, expected) = (m.raise(cosine), f64::from(cosine).powf(m.into()));
        let error = (f64::from(power) - expected).abs();
        assert!(
            error <= tolerance,
            "{cosine:e}^{m} = {power:e}, off by {error:e}"
        );
        let is_monotone = power.to_bits() + 1 >= largest.to_bits();
        assert!(
            is_monotone,
            "{cosine:e}^{m} = {power:e} falls from {largest:e}"
        );
        largest = largest.max(power);

        let of_root = m.raise_root(cosine);
        let error = (f64::from(of_root) - f64::from(cosine).powf(0.5 * f64::from(m))).abs();
        assert!(
            error <= tolerance,
            "√{cosine:e}^{m} = {of_root:e}, off by {error:e}"
        );
        assert!(
            m > 0.0 || power.to_bits() == 1.0_f32.to_bits(),
            "{cosine:e}^0 = {power:e}"
        );
    }
    assert!(m.raise(1.0).to_bits() == 1.0_f32.to_bits());
}

/// The coefficients of an attenuation.
const COEFFICIENTS: [[f32; 3]; 7] = [
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [1.0, 0.1, 0.01],
    [0.3, 1e-20, 7e20],
    [f32::MAX, 1.0, f32::MAX],
    [f32::from_bits(1), f32::from_bits(1), f32::from_bits(1)],
];

/// The attenuation never rises with the distance, not even by one bit, and the clamped attenuation
/// is the smaller of it and 1.
fn attenuation_falls([a, b, c]: [f32; 3], stride: u32) {
    let checked = Attenuation::new(a, b, c).expect("coefficients");
    let clamped = checked.clamped();
    let mut smallest = f32::INFINITY;
    for q in floats(f32::MAX, stride) {
        let factor = attenuation(a, b, c, q);
        assert!(factor <= smallest, "({a}, {b}, {c}) rises at {q:e}");
        assert!(checked.at(q).to_bits() == factor.to_bits(), "{q:e}");
        assert!(
            clamped.at(q).to_bits() == factor.min(1.0).to_bits(),
            "{q:e}"
        );
        smallest = factor;
    }
}

/// Directions whose components are multiples of the length.
const DIRECTIONS: [[f32; 3]; 4] = [
    [1.0, 0.0, 0.0],
    [1.0, -1.0, 1.0],
    [0.3, -1.0, 0.8],
    [1e-4, 0.7, -1e-20],
];

/// v/|v| has an error of at most 3.5u: the sum of squares is off by 3u and its root by half of
/// that, and the root and the division round.
fn unit_is_right(direction: [f32; 3], stride: u32) {
    for length in floats(f32::MAX, stride).skip(1) {
        let v = direction.map(|c| c * length);
        let expected = v.map(f64::from);
        let square: f64 = expected.iter().map(|c| c * c).sum();
        let Some(unit) = Vec3::from(v).unit() else {
            assert!(square == 0.0, "no direction at {length:e}");
            continue;
        };
        let reciprocal = 1.0 / square.sqrt();
        for (c, expected) in <[f32; 3]>::from(unit).into_iter().zip(expected) {
            let expected = expected * reciprocal;
            let tolerance = 3.5 * U * expected.abs() + TINY;
            assert!(
                (f64::from(c) - expected).abs() <= tolerance,
                "{v:?} gives {unit:?}"
            );
        }
    }
}

/// The smallest `f32`, which is the most that an operation loses when it underflows.
#[allow(clippy::cast_lossless)] // From is not const
const TINY: f64 = f32::from_bits(1) as f64;

/// The stride of the tests that are not ignored.
fn stride() -> u32 {
    match env::var("SHADING_STRIDE") {
        Ok(stride) => stride.parse().expect("SHADING_STRIDE is a whole number"),
        Err(_) => 2039,
    }
}

/// Every `stride`-th number from 0 to `last`, and `last` itself.
fn floats(last: f32, stride: u32) -> impl Iterator<Item = f32> {
    let bits = (0..last.to_bits()).step_by(stride as usize);
    bits.chain([last.to_bits()]).map(f32::from_bits)
}

/// Runs a check for each input, on as many threads as there are cores.
fn in_parallel<I: Sync>(inputs: &[I], check: impl Fn(&I) + Sync) {
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let next = AtomicUsize::new(0);
    thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some(input) = inputs.get(next.fetch_add(1, Relaxed)) {
                    check(input);
                }
            });
        }
    });
}
