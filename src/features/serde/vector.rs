//! Vectors, colors, directions and coefficients as lists of three numbers.

use core::fmt::{self, Display, Formatter};
use core::marker::PhantomData;

use serde_core::de::{Error as _, SeqAccess, Visitor};
use serde_core::ser::Error as _;
use serde_core::{Deserialize, Deserializer, Serialize, Serializer};

use super::Number;
use super::complaint::{Complaint, Problem};
use super::record::{Field, Named};
use crate::{Attenuation, Rgb, UnitVec3, Vec3};

const XYZ: [&str; 3] = ["x = ", "y = ", "z = "];
const RGB: [&str; 3] = ["r = ", "g = ", "b = "];
const ABC: [&str; 3] = ["a = ", "b = ", "c = "];

/// The coefficients of an attenuation.
#[derive(Clone, Copy)]
pub struct Coefficients<T>(pub [T; 3]);

impl<T> From<Coefficients<T>> for [T; 3] {
    fn from(Coefficients(abc): Coefficients<T>) -> Self {
        abc
    }
}

impl<'de, T: Number> Visitor<'de> for Named<[T; 3]> {
    type Value = [T; 3];

    fn expecting(&self, f: &mut Formatter) -> fmt::Result {
        write!(f, "a list of 3 numbers for {}", self.0)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<[T; 3], A::Error> {
        let mut numbers = [T::ZERO; 3];
        for (i, number) in numbers.iter_mut().enumerate() {
            let next = list.next_element()?;
            *number = next.ok_or_else(|| A::Error::invalid_length(i, &self))?;
        }
        match list.next_element::<T>()? {
            Some(_) => Err(A::Error::invalid_length(4, &self)),
            None => Ok(numbers),
        }
    }
}

/// The problem with three numbers: one of them is not finite, or `other` finds another problem.
fn problem<T: Number>(
    numbers: [T; 3],
    letters: [&'static str; 3],
    other: impl Fn([T; 3]) -> Option<Problem<T>>,
) -> Option<Problem<T>> {
    let mut letters = letters.into_iter().zip(numbers);
    match letters.find(|(_, x)| !x.is_finite()) {
        Some((letter, x)) => Some(Problem::NotFinite(letter, x)),
        None => other(numbers),
    }
}

fn not_unit<T: Number>(xyz: [T; 3]) -> Option<Problem<T>> {
    // Six decimals must suffice. They change each number by 10⁻⁶/2 and |v|² by √3 · 10⁻⁶ < 2⁻¹⁹.
    // The rounding of single precision adds less than 2⁻²¹.
    let slack = T::of_f32(1.0 / 262_144.0); // 2⁻¹⁸
    let v = Vec3::from(xyz);
    let is_unit = (v.dot(v) - T::ONE).abs() <= slack;
    (!is_unit).then_some(Problem::NotUnit(xyz))
}

fn not_coefficients<T: Number>(abc: [T; 3]) -> Option<Problem<T>> {
    let [a, b, c] = abc;
    if Attenuation::of(a, b, c).is_some() {
        return None;
    }
    let mut letters = ABC.into_iter().zip(abc);
    let negative = letters.find(|(_, x)| *x < T::ZERO);
    Some(negative.map_or(Problem::AllZero, |(letter, x)| Problem::Negative(letter, x)))
}

macro_rules! triple {
    ($type:ident<$float:ident>: $name:literal, $letters:ident, $of:expr, $other:expr) => {
        impl Field for $type<$float> {
            fn check(&self, name: &'static str) -> Result<(), impl Display> {
                match problem((*self).into(), $letters, $other) {
                    Some(problem) => Err(Complaint(name, problem)),
                    None => Ok(()),
                }
            }

            fn read<'de, D: Deserializer<'de>>(
                name: &'static str,
                from: D,
            ) -> Result<Self, D::Error> {
                let numbers = from.deserialize_tuple(3, Named::<[$float; 3]>(name, PhantomData))?;
                let value = $of(numbers);
                value.check(name).map_err(D::Error::custom)?;
                Ok(value)
            }
        }

        impl<'de> Deserialize<'de> for $type<$float> {
            fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                Self::read($name, from)
            }
        }

        impl Serialize for $type<$float> {
            fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
                self.check($name).map_err(S::Error::custom)?;
                <[$float; 3]>::from(*self).serialize(to)
            }
        }
    };
    ($float:ident) => {
        triple!(Vec3<$float>: "vector", XYZ, Vec3::from, |_| None);
        triple!(Rgb<$float>: "color", RGB, Rgb::from, |_| None);
        triple!(UnitVec3<$float>: "direction", XYZ, |v| Self::assume_unit(Vec3::from(v)), not_unit);
        triple!(Coefficients<$float>: "attenuation", ABC, Coefficients, not_coefficients);
    };
}

triple!(f32);
triple!(f64);
