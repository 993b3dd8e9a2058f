//! Attenuation and cone: maps with entries that may be left out.

use core::fmt::{self, Formatter};
use core::marker::PhantomData;

use serde_core::de::value::SeqAccessDeserializer;
use serde_core::de::{Error, MapAccess, SeqAccess, Visitor};
use serde_core::ser::SerializeStruct;
use serde_core::{Deserialize, Deserializer, Serialize, Serializer};

use super::Number;
use super::complaint::{Complaint, Problem};
use super::record::{Field, Form, Key, Named, entries, next, required};
use super::triple::Coefficients;
use crate::{Attenuation, Cone};

fn attenuation<T: Number, E: Error>(
    Coefficients(abc): Coefficients<T>,
    clamped: bool,
) -> Result<Attenuation<T>, E> {
    // there is one, as the coefficients were checked
    let attenuation = required(T::attenuation(abc), "coefficients")?;
    Ok(if clamped {
        attenuation.clamped()
    } else {
        attenuation
    })
}

impl<'de, T: Number> Visitor<'de> for Form<Attenuation<T>>
where
    Coefficients<T>: Field,
{
    type Value = Attenuation<T>;

    fn expecting(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str("a list of 3 numbers, or a map, for attenuation")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
        if self.has_names {
            let list = SeqAccessDeserializer::new(list);
            return attenuation(Coefficients::read("attenuation", list)?, false);
        }
        let coefficients = next(&mut list, "coefficients")?;
        attenuation(coefficients, next(&mut list, "clamped")?)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        entries!(map: coefficients, clamped);
        let coefficients = required(coefficients, "coefficients")?;
        attenuation(coefficients, clamped.unwrap_or(false))
    }
}

fn cone_of_cosine<T: Number, E: Error>(cosine: T) -> Result<Cone<T>, E> {
    T::cone_of_cosine(cosine)
        .ok_or_else(|| E::custom(Complaint("cosine", Problem::NotCosine(cosine))))
}

fn cone_of_half_angle<T: Number, E: Error>(angle: T) -> Result<Cone<T>, E> {
    T::cone_of_half_angle(angle)
        .ok_or_else(|| E::custom(Complaint("half_angle", Problem::NotHalfAngle(angle))))
}

impl<'de, T: Number> Visitor<'de> for Form<Cone<T>> {
    type Value = Cone<T>;

    fn expecting(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str("a map of `half_angle` or `cosine` for cone")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
        self.check_list()?;
        cone_of_cosine(next(&mut list, "cosine")?)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        entries!(map: half_angle, cosine);
        match (half_angle, cosine) {
            (Some(angle), None) => cone_of_half_angle(angle),
            (None, Some(cosine)) => cone_of_cosine(cosine),
            (None, None) => Err(A::Error::missing_field("half_angle")),
            (Some(_), Some(_)) => Err(A::Error::custom(
                "cone: half_angle and cosine cannot both be given",
            )),
        }
    }
}

macro_rules! checked {
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

        impl Field for Cone<$float> {}

        impl Serialize for Cone<$float> {
            fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
                // a half-angle would not come back to the bit
                let mut record = to.serialize_struct("Cone", 1)?;
                record.serialize_field("cosine", &self.cosine())?;
                record.end()
            }
        }

        impl<'de> Deserialize<'de> for Cone<$float> {
            fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                let form = Form::<Self>::of(&from);
                from.deserialize_struct("Cone", &["half_angle", "cosine"], form)
            }
        }
    };
}

checked!(f32);
checked!(f64);
