//! A row is a call and what it gives, and becomes a test for each float:
//! `terms::lambert_at_60_degrees::f32`.

#![allow(dead_code, unused_macros, unused_imports)] // each file of rows uses some

use std::fmt::Debug;

use kit::{Number, Sink, Value};

/// A row of formulas: a call, its value, and how far the call may be off; without that, it is the
/// value to the bit.
macro_rules! value {
    ($name:ident, $call:expr, $value:expr) => {
        value!($name, $call, $value, crate::row::units(0.0));
    };
    ($name:ident, $call:expr, $value:expr, $off:expr) => {
        row!($name, crate::row::assert_value($call, $value, $off, T::U));
    };
}

/// A row of totality: a call, and exactly what it gives.
macro_rules! gives {
    ($name:ident, $call:expr, $given:expr) => {
        row!($name, crate::row::assert_same([$call, $given]));
    };
}

/// A row of totality for several arguments: each gives exactly this.
macro_rules! each_gives {
    ($name:ident, $arguments:expr, $call:expr, $given:expr) => {
        row!($name, {
            for argument in $arguments {
                println!("{argument:?}");
                crate::row::assert_same([crate::row::call($call, argument), $given]);
            }
        });
    };
}

/// A test for each float, with `T` for the float.
macro_rules! row {
    ($name:ident, $check:expr) => {
        mod $name {
            use super::*;
            fn row<T: Float>() {
                $check;
            }
            #[test]
            fn f32() {
                row::<f32>();
            }
            #[test]
            fn f64() {
                row::<f64>();
            }
        }
    };
}

pub(crate) use {each_gives, gives, row, value};

/// A closure needs its argument's type before its body.
pub fn call<A, V>(function: impl FnOnce(A) -> V, argument: A) -> V {
    function(argument)
}

/// How far a call may be off.
#[derive(Clone, Copy)]
pub enum Off {
    OfTheValue(f64),
    OfOne(f64),
}

/// In units of roundoff, u, of the value, or of its longest component. A correctly rounded
/// operation is off by 1 at most.
pub fn units(count: f64) -> Off {
    Off::OfTheValue(count)
}

/// In units of roundoff of 1, where terms may cancel.
pub fn units_of_1(count: f64) -> Off {
    Off::OfOne(count)
}

#[track_caller]
pub fn assert_value(is: impl Value, should: impl Value, off: Off, u: f64) {
    let [is, should] = [numbers(is), numbers(should)];
    let tolerance = match off {
        Off::OfTheValue(units) => {
            let largest = should.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            units * u * largest
        }
        Off::OfOne(units) => units * u,
    };
    let is_near = |(a, b): (&f64, &f64)| a == b || (a - b).abs() <= tolerance;
    assert!(
        is.len() == should.len() && is.iter().zip(&should).all(is_near),
        "{is:?} instead of {should:?} ± {tolerance:e}"
    );
}

/// The numbers of a result: `None` has none, and a flag is 0 or 1.
fn numbers(value: impl Value) -> Vec<f64> {
    let mut numbers = Numbers::default();
    value.give(&mut numbers);
    numbers.0
}

#[derive(Default)]
struct Numbers(Vec<f64>);

impl Sink for Numbers {
    fn number(&mut self, number: impl Number) {
        self.0.push(number.double());
    }

    fn bytes<const N: usize>(&mut self, bytes: [u8; N]) {
        if &bytes[..] != b"none" {
            self.0.extend(bytes.map(f64::from));
        }
    }
}

/// As text, NaN equals itself, and all parts of a dual number count. The sign of a zero does not.
#[track_caller]
pub fn assert_same<V: Debug>(values: [V; 2]) {
    let signs = ["-0.0,", "-0.0 ", "-0.0]", "-0.0)"];
    let text = |value| {
        signs.iter().fold(format!("{value:?}"), |text, zero| {
            text.replace(zero, &zero[1..])
        })
    };
    let [is, should] = values.map(|value| text([value]));
    assert!(is == should, "{is} instead of {should}");
}
