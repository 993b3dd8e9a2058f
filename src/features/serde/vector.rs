//! Vectors, colors, directions and coefficients as lists of three numbers.

use core::fmt::{self, Display, Formatter};
use core::marker::PhantomData;

use serde_core::de::{DeserializeSeed, Error, IntoDeserializer, SeqAccess, Visitor};
use serde_core::ser::Error as _;
use serde_core::{Deserialize, Deserializer, Serialize, Serializer};

use super::Number;
use super::complaint::{Complaint, Problem};
use super::record::{Field, Named};
use crate::{Attenuation, Rgb, UnitVec3, Vec3};

const ATTENUATION: &str = "attenuation";
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

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<[T; 3], A::Error> {
        self.visit_rest(None, list)
    }
}

impl<T: Number> Named<[T; 3]> {
    /// Reads the numbers of which the first may have been read.
    fn visit_rest<'de, A: SeqAccess<'de>>(
        self,
        mut first: Option<T>,
        mut list: A,
    ) -> Result<[T; 3], A::Error> {
        let mut numbers = [T::ZERO; 3];
        for (i, number) in numbers.iter_mut().enumerate() {
            let next = match first.take() {
                None => list.next_element()?,
                first => first,
            };
            *number = next.ok_or_else(|| A::Error::invalid_length(i, &self))?;
        }
        match list.next_element::<T>()? {
            Some(_) => Err(A::Error::invalid_length(4, &self)),
            None => Ok(numbers),
        }
    }
}

/// What a list for an attenuation begins with: the first of its coefficients, or all of them.
pub enum First<T> {
    Number(FirstNumber<T>),
    Coefficients(Coefficients<T>),
}

/// The first of three numbers.
pub struct FirstNumber<T>(T);

/// Reads it. A format that cannot say what comes next has the list of all coefficients.
struct ReadFirst<T> {
    can_ask: bool,
    number: PhantomData<T>,
}

impl<T: Number> First<T>
where
    Coefficients<T>: Field,
{
    pub fn of<'de, A: SeqAccess<'de>>(list: &mut A, can_ask: bool) -> Result<Self, A::Error> {
        let number = PhantomData;
        let first = list.next_element_seed(ReadFirst { can_ask, number })?;
        first.ok_or_else(|| A::Error::invalid_length(0, &Named::<[T; 3]>(ATTENUATION, PhantomData)))
    }
}

impl<T: Number> FirstNumber<T>
where
    Coefficients<T>: Field,
{
    /// The coefficients of which this is the first.
    pub fn and<'de, A: SeqAccess<'de>>(self, list: A) -> Result<Coefficients<T>, A::Error> {
        let numbers = Named::<[T; 3]>(ATTENUATION, PhantomData).visit_rest(Some(self.0), list)?;
        checked(Coefficients(numbers), ATTENUATION)
    }
}

impl<'de, T: Number> DeserializeSeed<'de> for ReadFirst<T>
where
    Coefficients<T>: Field,
{
    type Value = First<T>;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<First<T>, D::Error> {
        if self.can_ask {
            from.deserialize_any(self)
        } else {
            from.deserialize_tuple(3, self)
        }
    }
}

impl<'de, T: Number> Visitor<'de> for ReadFirst<T>
where
    Coefficients<T>: Field,
{
    type Value = First<T>;

    fn expecting(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str("a number or a list of 3 numbers")
    }

    fn visit_f64<E: Error>(self, a: f64) -> Result<First<T>, E> {
        Ok(First::Number(FirstNumber(T::deserialize(
            a.into_deserializer(),
        )?)))
    }

    fn visit_u64<E: Error>(self, a: u64) -> Result<First<T>, E> {
        Ok(First::Number(FirstNumber(T::deserialize(
            a.into_deserializer(),
        )?)))
    }

    fn visit_i64<E: Error>(self, a: i64) -> Result<First<T>, E> {
        Ok(First::Number(FirstNumber(T::deserialize(
            a.into_deserializer(),
        )?)))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<First<T>, A::Error> {
        let numbers = Named::<[T; 3]>("coefficients", PhantomData).visit_seq(list)?;
        checked(Coefficients(numbers), "coefficients").map(First::Coefficients)
    }
}

/// A value that a file may contain.
fn checked<F: Field, E: Error>(value: F, name: &'static str) -> Result<F, E> {
    value.check(name).map_err(E::custom)?;
    Ok(value)
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
    ($type:ident<$float:ident>: $name:expr, $letters:ident, $of:expr, $other:expr) => {
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
                checked($of(numbers), name)
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
        triple!(Coefficients<$float>: ATTENUATION, ABC, Coefficients, not_coefficients);
    };
}

triple!(f32);
triple!(f64);
