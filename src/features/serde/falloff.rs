//! Attenuations with or without a range.

use core::fmt::{self, Display, Formatter};
use core::marker::PhantomData;

use serde_core::de::{Error, MapAccess, SeqAccess, Visitor};
use serde_core::ser::{Error as _, SerializeStruct};
use serde_core::{Deserialize, Deserializer, Serialize, Serializer};

use super::Number;
use super::complaint::{Complaint, Problem};
use super::record::{Field, Form, Key, Named, entries, next, required};
use super::vector::{Coefficients, First};
use crate::{Attenuation, Ranged};

const EXPECTED: &str = "a list of 3 numbers, or a map, for attenuation";

fn attenuation<T: Number, E: Error>(
    Coefficients([a, b, c]): Coefficients<T>,
    clamped: bool,
) -> Result<Attenuation<T>, E> {
    // the coefficients were checked, so this cannot fail
    let attenuation = required(Attenuation::of(a, b, c), "coefficients")?;
    Ok(if clamped {
        attenuation.clamped()
    } else {
        attenuation
    })
}

/// The range of an attenuation. ∞ means no range.
#[derive(Clone, Copy)]
struct Range<T>(T);

/// The names of the fields of an attenuation with a range.
const FIELDS: &[&str] = &["coefficients", "clamped", "range", "unsquared"];

impl<T: Number> Range<T> {
    fn none() -> Self {
        Self(T::ONE / T::ZERO)
    }

    /// The attenuation that ends at this range.
    fn limit<E: Error>(self, attenuation: Attenuation<T>, unsquared: bool) -> Result<Ranged<T>, E> {
        // the range was checked, so this cannot fail
        let ranged = required(Ranged::of(attenuation, self.0), "range")?;
        Ok(if unsquared {
            ranged.unsquared()
        } else {
            ranged
        })
    }
}

impl<'de, T: Number> Visitor<'de> for Form<Attenuation<T>>
where
    Coefficients<T>: Field,
{
    type Value = Attenuation<T>;

    fn expecting(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str(EXPECTED)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
        match First::of(&mut list, self.has_names)? {
            First::Number(a) => attenuation(a.and(list)?, false),
            First::Coefficients(abc) => attenuation(abc, next(&mut list, "clamped")?),
        }
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        entries!(map: coefficients, clamped);
        let coefficients = required(coefficients, "coefficients")?;
        attenuation(coefficients, clamped.unwrap_or(false))
    }
}

impl<'de, T: Number> Visitor<'de> for Form<Ranged<T>>
where
    Coefficients<T>: Field,
    Range<T>: Field,
{
    type Value = Ranged<T>;

    fn expecting(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str(EXPECTED)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
        match First::of(&mut list, self.has_names)? {
            First::Number(a) => Range::none().limit(attenuation(a.and(list)?, false)?, false),
            First::Coefficients(abc) => {
                let attenuation = attenuation(abc, next(&mut list, "clamped")?)?;
                let range = next::<Range<T>, _>(&mut list, "range")?;
                range.limit(attenuation, next(&mut list, "unsquared")?)
            }
        }
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        entries!(map: coefficients, clamped, range, unsquared);
        let coefficients = required(coefficients, "coefficients")?;
        let attenuation = attenuation(coefficients, clamped.unwrap_or(false))?;
        let range = range.unwrap_or_else(Range::none);
        range.limit(attenuation, unsquared.unwrap_or(false))
    }
}

macro_rules! falloff {
    ($float:ident) => {
        impl Field for Attenuation<$float> {}

        impl Serialize for Attenuation<$float> {
            fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
                let coefficients = Coefficients(self.coefficients());
                if to.is_human_readable() && !self.is_clamped() {
                    return coefficients.serialize(to);
                }
                let mut record = to.serialize_struct("Attenuation", 2)?;
                record.serialize_field("coefficients", &coefficients)?;
                record.serialize_field("clamped", &self.is_clamped())?;
                record.end()
            }
        }

        impl<'de> Deserialize<'de> for Attenuation<$float> {
            fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                let form = Form::<Self>::of(&from);
                if form.has_names {
                    return from.deserialize_any(form);
                }
                from.deserialize_struct("Attenuation", &["coefficients", "clamped"], form)
            }
        }

        impl Field for Range<$float> {
            fn check(&self, name: &'static str) -> Result<(), impl Display> {
                if self.0 > 0.0 {
                    Ok(())
                } else {
                    Err(Complaint(name, Problem::NotPositive(self.0)))
                }
            }
        }

        impl<'de> Deserialize<'de> for Range<$float> {
            fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                <$float>::deserialize(from).map(Self)
            }
        }

        impl Field for Ranged<$float> {}

        impl Serialize for Ranged<$float> {
            fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
                let (attenuation, range) = (self.attenuation(), self.range());
                // with names, what a reader would assume is left out
                let is_full = !to.is_human_readable();
                let has_clamped = is_full || attenuation.is_clamped();
                let has_range = is_full || range != <$float>::INFINITY;
                let has_unsquared = is_full || self.is_unsquared();
                if !has_range && !has_unsquared {
                    return attenuation.serialize(to);
                }
                Range(range).check("range").map_err(S::Error::custom)?;
                let entries = [true, has_clamped, has_range, has_unsquared];
                let count = entries.into_iter().filter(|has_entry| *has_entry).count();
                let mut record = to.serialize_struct("Ranged", count)?;
                record
                    .serialize_field("coefficients", &Coefficients(attenuation.coefficients()))?;
                if has_clamped {
                    record.serialize_field("clamped", &attenuation.is_clamped())?;
                }
                if has_range {
                    record.serialize_field("range", &range)?;
                }
                if has_unsquared {
                    record.serialize_field("unsquared", &self.is_unsquared())?;
                }
                record.end()
            }
        }

        impl<'de> Deserialize<'de> for Ranged<$float> {
            fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                let form = Form::<Self>::of(&from);
                if form.has_names {
                    return from.deserialize_any(form);
                }
                from.deserialize_struct("Ranged", FIELDS, form)
            }
        }
    };
}

falloff!(f32);
falloff!(f64);
