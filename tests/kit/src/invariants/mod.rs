//! What holds of every number type: 59 properties, each with one reason to exist, and one for each function.
//!
//! - *Agreement*: what T computes is within the error that [`Tracked`] derives from the formula;
//!   one row for each function.
//! - *Equality*: two computations give the same number, to the bit.
//! - *Truth*: a result is in its range, in order, or left out.
//!
//! [`check`] runs all that the precision of a type allows.

mod agreement;
mod case;
mod exact;
mod tracked;

use core::fmt::Debug;
use std::collections::BTreeMap;
use std::format;
use std::string::String;
use std::vec::Vec;

use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use shading::{Dual, Real, Rgb, Shaded, UnitVec3, Vec3};

pub use case::Case;
pub use tracked::Tracked;

/// A number type to try.
pub trait Tried: Real + PartialOrd + Debug + 'static {
    const NAME: &str;
    /// The largest error of a rounding, relative to the result.
    const U: f64;
    /// The largest error of a rounding where that is not relative: half the spacing next to 0, or a step of
    /// fixed point.
    const STEP: f64;
    /// The smallest number above 0.
    const SMALLEST: f64;
    /// `MAX` and `EXTREME`, for constants.
    const LARGEST: f64;
    const LARGE: f64;
    /// Whether multiplying by a power of two is exact, and no method is replaced.
    const IS_FLOAT: bool;
    /// The laws that it does not promise.
    const EXCEPT: &[&str] = &[];

    fn exact(self) -> f64;
}

macro_rules! floats {
    ($($name:literal $number:ty: $float:ident, $exact:expr;)*) => {$(
        #[allow(clippy::cast_lossless)]
        impl Tried for $number {
            const NAME: &str = $name;
            const U: f64 = $float::EPSILON as f64 / 2.0;
            const STEP: f64 = $float::from_bits(1) as f64 / 2.0;
            const SMALLEST: f64 = $float::from_bits(1) as f64;
            const LARGEST: f64 = $float::MAX as f64;
            const LARGE: f64 = <$float as Real>::EXTREME as f64;
            const IS_FLOAT: bool = true;

            fn exact(self) -> f64 {
                $exact(self)
            }
        }
    )*};
}

floats! {
    "f32" f32: f32, f64::from;
    "f64" f64: f64, f64::from;
    "Dual<f64>" Dual<f64>: f64, |x: Self| x.value;
}

#[cfg(feature = "fixed")]
impl Tried for shading::fixed::Fixed {
    const NAME: &str = "Fixed";
    const U: f64 = <Self as Tried>::STEP;
    const STEP: f64 = Self::SMALLEST / 2.0;
    const SMALLEST: f64 = 1.0 / 65_536.0;
    const LARGEST: f64 = 32_768.0 - Self::SMALLEST;
    const LARGE: f64 = 512.0;
    const IS_FLOAT: bool = false;
    // ties go up
    const EXCEPT: &[&str] = &["half_a_turn_turns_normals"];

    fn exact(self) -> f64 {
        self.into()
    }
}

/// What a law says of a case.
pub enum Verdict {
    Holds,
    /// Rounding may decide the result, or it is out of range.
    Open,
    Fails(String),
}

/// A result, taken apart into numbers.
pub trait Parts<T> {
    fn parts(self) -> Vec<T>;
}

impl<T> Parts<T> for Vec<T> {
    fn parts(self) -> Vec<T> {
        self
    }
}

/// Plain numbers; `Parts` cannot tell an array of any number from an array of vectors.
pub fn n<T, const N: usize>(numbers: [T; N]) -> Vec<T> {
    numbers.into()
}

macro_rules! parts {
    ($($type:ty: |$value:ident| $parts:expr;)*) => {$(
        impl<T: Real> Parts<T> for $type {
            fn parts(self) -> Vec<T> {
                let $value = self;
                $parts
            }
        }
    )*};
}

parts! {
    Vec3<T>: |v| <[T; 3]>::from(v).into();
    UnitVec3<T>: |v| <[T; 3]>::from(v).into();
    Rgb<T>: |rgb| <[T; 3]>::from(rgb).into();
    Shaded<T>: |s| [s.ambient, s.diffuse, s.specular].parts();
}

impl<T, P: Parts<T>> Parts<T> for Option<P> {
    fn parts(self) -> Vec<T> {
        self.into_iter().flat_map(P::parts).collect()
    }
}

impl<T, P: Parts<T>, const N: usize> Parts<T> for [P; N] {
    fn parts(self) -> Vec<T> {
        self.into_iter().flat_map(P::parts).collect()
    }
}

pub type Law<T> = (&'static str, fn(&Case<T>) -> Verdict);

/// Tries every law on as many cases, and names each that does not hold, with the first case that shows it.
/// Each must be decided in a third of the cases at least, so that none holds for want of a tolerance.
pub fn check<T: Tried>(cases: u32) {
    let config = Config {
        failure_persistence: None,
        ..<_>::default()
    };
    let mut runner =
        TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha));
    let strategy = case::numbers::<T>();
    let laws: Vec<Law<T>> = [agreement::laws(), exact::laws()].concat();
    let mut found: BTreeMap<&str, (u32, Option<String>)> = BTreeMap::new();
    for _ in 0..cases {
        let numbers = strategy.new_tree(&mut runner).expect("numbers").current();
        let case = Case::<T>::new(&numbers);
        for (name, law) in laws.iter().filter(|(name, _)| !T::EXCEPT.contains(name)) {
            let (decided, failure) = found.entry(name).or_default();
            match law(&case) {
                Verdict::Holds => *decided += 1,
                Verdict::Open => {}
                Verdict::Fails(why) => {
                    failure.get_or_insert_with(|| format!("{why}\n    {numbers:?}"));
                }
            }
        }
    }
    let mut failures = String::new();
    for (name, (decided, failure)) in found {
        let too_few = || format!("decided in {decided} of {cases} cases");
        if let Some(why) = failure.or_else(|| (3 * decided < cases).then(too_few)) {
            failures = format!("{failures}{} {name}: {why}\n", T::NAME);
        }
    }
    assert!(failures.is_empty(), "{failures}");
}
