//! Calls every public function with numbers from any source, for the tests with arbitrary bits and
//! for the fuzzer. Bits that are not valid input must not cause a panic, and whatever the table of
//! functions promises for them holds. Finite valid input gives neither NaN nor negative light.

use std::vec::Vec;

use shading::{Rgb, UnitVec3, Vec3};

use crate::promise::{self, Promise};
use crate::{Float, Given, Input, Number, Sink, Value, row};

/// The source of the numbers.
pub struct Numbers<'a, T> {
    pub next: &'a mut dyn FnMut() -> T,
    /// An integer m.
    pub m: u32,
}

impl<T: Float> Numbers<'_, T> {
    fn number(&mut self) -> T {
        (self.next)()
    }

    fn vector(&mut self) -> Vec3<T> {
        Vec3::new(self.number(), self.number(), self.number())
    }

    fn input(&mut self) -> Input<T> {
        let rgb = |v: Vec3<T>| Rgb::new(v.x, v.y, v.z);
        Input {
            is_valid: false,
            p: self.vector(),
            a: self.vector(),
            b: self.vector(),
            c: self.vector(),
            n: self.vector(),
            l: self.vector(),
            v: self.vector(),
            axis: self.vector(),
            x: self.number(),
            y: self.number(),
            cosine: self.number(),
            rgb: rgb(self.vector()),
            k_a: rgb(self.vector()),
            k_d: rgb(self.vector()),
            k_s: rgb(self.vector()),
            intensity: rgb(self.vector()),
            coefficients: self.vector(),
            range: self.number(),
            edge: self.number(),
            edges: [self.number(), self.number()],
            integer_m: self.m,
            real_m: self.number(),
            bits: self.m,
        }
    }
}

/// The numbers of a result.
#[derive(Default)]
struct Result(Vec<f64>);

impl Sink for Result {
    fn number(&mut self, number: impl Number) {
        self.0.push(number.double());
    }

    fn bytes<const N: usize>(&mut self, _: [u8; N]) {}
}

/// Every row of the table: its name, its call, and what holds of the result.
struct Of<T>(T);

type Row<T> = (&'static str, fn(&Given<T>, &mut Result), Promise<T>);

macro_rules! rows {
    ($($section:ident: $bound:ident {
        $($row:ident $name:literal |$given:ident| $call:expr => $promise:ident;)*
    })*) => {
        impl<T: Float> Of<T> {
            const ROWS: &[Row<T>] = &[$($(
                ($name, |given, result| row::$row(given).give(result), promise::$promise)
            ),*),*];
        }
    };
}
for_each_function!(rows);

fn keeps_promises<T: Float>(given: &Given<T>) {
    for (name, call, promise) in Of::<T>::ROWS {
        let mut result = Result::default();
        call(given, &mut result);
        assert!(promise(given, &result.0), "{name}: {:?}", result.0);
    }
}

/// Calls every public function with numbers of arbitrary bits.
pub fn any_bits<T: Float>(mut numbers: Numbers<T>) {
    let given = Given::new(&numbers.input());
    keeps_promises(&given);

    let single = given.rgb.map(T::single);
    let bytes = single.to_srgb8();
    assert_eq!(Rgb::<f32>::from_srgb8(bytes).to_srgb8(), bytes);
    assert_eq!(single.clamped().to_rgb565(), single.to_rgb565());
    assert_eq!(
        Rgb::<f32>::from_rgb565(single.to_rgb565()).to_rgb565(),
        single.to_rgb565()
    );
    assert_eq!(single.clamped().to_linear8(), single.to_linear8());
}

/// Runs everything on finite valid input made from any finite numbers. Light is never negative and
/// never NaN, and whatever is promised to be finite is finite.
pub fn finite_and_valid<T: Float>(numbers: Numbers<T>) {
    let Numbers { next, m } = numbers;
    let mut finite = || {
        let x = next();
        if x.double().is_finite() { x } else { T::ONE }
    };
    let next = &mut finite;
    let input = Numbers { next, m }.input();
    keeps_promises(&Given::new(&valid(input)));
}

/// Directions of length 1, and nothing negative that must not be.
fn valid<T: Float>(input: Input<T>) -> Input<T> {
    let unit = |v: Vec3<T>| *v.unit_or(UnitVec3::Z);
    // −0 is not negative, so it is kept
    let positive = |x: T| if x < T::ZERO { -x } else { x };
    let Input { n, l, v, axis, .. } = input;
    let Input {
        rgb,
        k_a,
        k_d,
        k_s,
        intensity,
        ..
    } = input;
    let [n, l, v, axis] = [n, l, v, axis].map(unit);
    let [rgb, k_a, k_d, k_s, intensity] =
        [rgb, k_a, k_d, k_s, intensity].map(|color| color.map(positive));
    Input {
        is_valid: true,
        n,
        l,
        v,
        axis,
        rgb,
        k_a,
        k_d,
        k_s,
        intensity,
        cosine: positive(input.cosine).at_most(T::ONE),
        coefficients: input.coefficients.map(positive),
        range: positive(input.range),
        real_m: positive(input.real_m),
        ..input
    }
}
