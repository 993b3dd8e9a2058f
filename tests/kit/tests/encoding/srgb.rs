//! The formulas of IEC 61966-2-1 in 200 bits, which are 60 digits.
#![allow(dead_code)] // each test program uses part of it

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;

/// A number of 200 bits; the result of each operation is rounded.
pub type Number = FBig<HalfEven, 2>;

pub fn number(x: f64) -> Number {
    Number::try_from(x)
        .expect("finite")
        .with_precision(200)
        .value()
}

/// A decimal number of the standard.
fn ratio(numerator: f64, denominator: f64) -> Number {
    number(numerator) / number(denominator)
}

/// The encoding of linear light, from 0 to 1.
pub fn encoded(linear: &Number) -> Number {
    if *linear <= ratio(31_308.0, 1e7) {
        return ratio(1292.0, 100.0) * linear;
    }
    ratio(1055.0, 1e3) * linear.powf(&ratio(10.0, 24.0)) - ratio(55.0, 1e3)
}

/// The linear light of an encoded number.
pub fn decoded(encoded: &Number) -> Number {
    if *encoded <= ratio(4045.0, 1e5) {
        return encoded / ratio(1292.0, 100.0);
    }
    ((encoded + ratio(55.0, 1e3)) / ratio(1055.0, 1e3)).powf(&ratio(24.0, 10.0))
}

/// The smallest `f32` of each level from 1 up without encoding: x ≥ (l − ½)/n, where the product 2n·x is
/// exact in double precision.
#[allow(clippy::incompatible_msrv)] // tests run on the newest Rust
pub fn linear_edges(highest: u16) -> Vec<f32> {
    let edge = |level: u16| {
        let reaches = |x: f32| f64::from(2 * highest) * f64::from(x) >= f64::from(2 * level - 1);
        #[allow(clippy::cast_possible_truncation)]
        let mut least = ((f64::from(level) - 0.5) / f64::from(highest)) as f32;
        while reaches(least.next_down()) {
            least = least.next_down();
        }
        while !reaches(least) {
            least = least.next_up();
        }
        least
    };
    (1..=highest).map(edge).collect()
}

/// The smallest `f32` of each level from 1 up: the first whose encoding reaches the level minus a
/// half. The search starts at the decoded value.
pub fn edges(highest: u16) -> Vec<f32> {
    let edge = |level: u16| {
        let edge = number(f64::from(level) - 0.5) / number(highest.into());
        let reaches = |bits: u32| encoded(&number(f32::from_bits(bits).into())) >= edge;
        let mut least = decoded(&edge).to_f32().value().to_bits();
        while reaches(least) {
            least -= 1;
        }
        while !reaches(least) {
            least += 1;
        }
        f32::from_bits(least)
    };
    (1..=highest).map(edge).collect()
}
