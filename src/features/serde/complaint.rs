//! The reasons why a file may not contain a value.

use core::fmt::{self, Display, Formatter};

use super::Number;
use crate::Vec3;

/// The name of a field and the problem with its value.
pub struct Complaint<T>(pub &'static str, pub Problem<T>);

pub enum Problem<T> {
    /// With the letter that says which of three numbers it is.
    NotFinite(&'static str, T),
    Negative(&'static str, T),
    AllZero,
    NotUnit([T; 3]),
    NotPositive(T),
    NotHalfAngle(T),
    NotCosine(T),
    /// With the outer half-angle or its cosine.
    NotInnerHalfAngle(T, T),
    NotInnerCosine(T, T),
}

impl<T: Number> Display for Complaint<T> {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let Self(name, problem) = self;
        write!(f, "{name}: ")?;
        match problem {
            Problem::NotFinite(letter, x) => write!(f, "{letter}{x:?} is not finite"),
            Problem::Negative(letter, x) => write!(f, "{letter}{x:?} is negative"),
            Problem::AllZero => write!(f, "all are 0; write [1, 0, 0] for no attenuation"),
            Problem::NotUnit(list) => {
                let v = Vec3::from(*list);
                write!(f, "{list:?} has length {:?}, not 1", v.length())?;
                match v.unit() {
                    Some(unit) => write!(f, "; write {:?}", <[T; 3]>::from(unit)),
                    None => Ok(()),
                }
            }
            Problem::NotHalfAngle(x) => write!(
                f,
                "{x:?} is not between 0 and π; write half of the opening angle, in radians"
            ),
            Problem::NotPositive(x) => write!(f, "{x:?} is not above 0"),
            Problem::NotCosine(x) => write!(f, "{x:?} is not between -1 and 1"),
            Problem::NotInnerHalfAngle(x, outer) => {
                write!(f, "{x:?} is not between 0 and the half_angle, {outer:?}")
            }
            Problem::NotInnerCosine(x, outer) => {
                write!(f, "{x:?} is not between the cosine, {outer:?}, and 1")
            }
        }
    }
}
