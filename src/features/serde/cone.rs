//! Cones with a hard or a soft edge.

use core::fmt::{self, Formatter};
use core::marker::PhantomData;

use serde_core::de::{Error, MapAccess, SeqAccess, Visitor};
use serde_core::ser::SerializeStruct;
use serde_core::{Deserialize, Deserializer, Serialize, Serializer};

use super::Number;
use super::complaint::{Complaint, Problem};
use super::record::{Field, Form, Key, Named, entries, next};
use crate::{Cone, SoftCone};

const EXPECTED: &str = "a map with `half_angle` or `cosine` for cone";
const BOTH: &str = "cone: half-angles and cosines cannot both be given";

fn of_half_angle<T: Number, E: Error>(angle: T) -> Result<Cone<T>, E> {
    let complaint = || Complaint("half_angle", Problem::NotHalfAngle(angle));
    Cone::of_half_angle(angle).ok_or_else(|| E::custom(complaint()))
}

fn of_cosine<T: Number, E: Error>(cosine: T) -> Result<Cone<T>, E> {
    let complaint = || Complaint("cosine", Problem::NotCosine(cosine));
    Cone::of_cosine(cosine).ok_or_else(|| E::custom(complaint()))
}

fn of_half_angles<T: Number, E: Error>(outer: T, inner: T) -> Result<SoftCone<T>, E> {
    of_half_angle(outer)?;
    let complaint = || Complaint("inner_half_angle", Problem::NotInnerHalfAngle(inner, outer));
    SoftCone::of_half_angles(inner, outer).ok_or_else(|| E::custom(complaint()))
}

fn of_cosines<T: Number, E: Error>(outer: T, inner: T) -> Result<SoftCone<T>, E> {
    of_cosine(outer)?;
    let complaint = || Complaint("inner_cosine", Problem::NotInnerCosine(inner, outer));
    SoftCone::from_cosines(inner, outer).ok_or_else(|| E::custom(complaint()))
}

fn smoothed<T: Number>(cone: SoftCone<T>, smoothstep: bool) -> SoftCone<T> {
    if smoothstep { cone.smoothstep() } else { cone }
}

impl<'de, T: Number> Visitor<'de> for Form<Cone<T>> {
    type Value = Cone<T>;

    fn expecting(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str(EXPECTED)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
        of_cosine(next(&mut list, "cosine")?)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        entries!(map: half_angle, cosine);
        match (half_angle, cosine) {
            (Some(angle), None) => of_half_angle(angle),
            (None, Some(cosine)) => of_cosine(cosine),
            (None, None) => Err(A::Error::missing_field("half_angle")),
            (Some(_), Some(_)) => Err(A::Error::custom(BOTH)),
        }
    }
}

impl<'de, T: Number> Visitor<'de> for Form<SoftCone<T>> {
    type Value = SoftCone<T>;

    fn expecting(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str(EXPECTED)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
        let outer = next(&mut list, "cosine")?;
        let cone = of_cosines(outer, next(&mut list, "inner_cosine")?)?;
        Ok(smoothed(cone, next(&mut list, "smoothstep")?))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        entries!(map: half_angle, cosine, inner_half_angle, inner_cosine, smoothstep);
        let cone = match (half_angle, inner_half_angle, cosine, inner_cosine) {
            (Some(outer), inner, None, None) => of_half_angles(outer, inner.unwrap_or(outer)),
            (None, None, Some(outer), inner) => of_cosines(outer, inner.unwrap_or(outer)),
            (None, None, None, Some(_)) => Err(A::Error::missing_field("cosine")),
            (None, _, None, None) => Err(A::Error::missing_field("half_angle")),
            _ => Err(A::Error::custom(BOTH)),
        };
        Ok(smoothed(cone?, smoothstep.unwrap_or(false)))
    }
}

// Cones are written as cosines, because half-angles would not keep the bits.
macro_rules! cone {
    ($float:ident) => {
        impl Field for Cone<$float> {}

        impl Serialize for Cone<$float> {
            fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
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

        impl Field for SoftCone<$float> {}

        impl Serialize for SoftCone<$float> {
            fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
                let [inner, outer] = self.cosines();
                let has_all = !to.is_human_readable();
                let has_inner = has_all || inner > outer;
                let has_smoothstep = has_all || self.is_smoothstep();
                let count = 1 + usize::from(has_inner) + usize::from(has_smoothstep);
                let mut record = to.serialize_struct("SoftCone", count)?;
                record.serialize_field("cosine", &outer)?;
                if has_inner {
                    record.serialize_field("inner_cosine", &inner)?;
                }
                if has_smoothstep {
                    record.serialize_field("smoothstep", &self.is_smoothstep())?;
                }
                record.end()
            }
        }

        impl<'de> Deserialize<'de> for SoftCone<$float> {
            fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                let form = Form::<Self>::of(&from);
                let fields = &[
                    "half_angle",
                    "cosine",
                    "inner_half_angle",
                    "inner_cosine",
                    "smoothstep",
                ];
                from.deserialize_struct("SoftCone", fields, form)
            }
        }
    };
}

cone!(f32);
cone!(f64);
