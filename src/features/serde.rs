//! Lights and materials in files. `docs/schema.md` describes the format.
//!
//! Types with public fields derive the traits where they are defined. The types here check what
//! they read, and vectors, colors and directions also what they write, so that every value that was
//! written can be read again.

use serde::{Deserialize, Deserializer, Serialize, Serializer, de, ser};

use crate::number::{Read, Written, magnitude};
use crate::{Attenuation, Cone, Real, Rgb, Scalar, UnitVec3, Vec3};

macro_rules! list {
    ($type:ident by $read:ident) => {
        impl<T: Written> Serialize for $type<T> {
            fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
                let list = <[T; 3]>::from(*self);
                match $read(list) {
                    Ok(_) => list.serialize(to),
                    Err(reason) => Err(ser::Error::custom(reason)),
                }
            }
        }

        impl<'de, T: Read<'de>> Deserialize<'de> for $type<T> {
            fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                $read(<[T; 3]>::deserialize(from)?).map_err(de::Error::custom)
            }
        }
    };
}

list!(Vec3 by vector);
list!(Rgb by color);
list!(UnitVec3 by direction);

fn vector<T: Real + Scalar>(v: [T; 3]) -> Result<Vec3<T>, &'static str> {
    let is_finite = v.iter().all(|x| magnitude(*x) <= T::MAX);
    is_finite
        .then(|| v.into())
        .ok_or("vector: a coordinate is not finite")
}

fn color<T: Real + Scalar>(color: [T; 3]) -> Result<Rgb<T>, &'static str> {
    let is_light = color.iter().all(|x| T::ZERO <= *x && *x <= T::MAX);
    is_light
        .then(|| color.into())
        .ok_or("color: a channel is negative or not finite")
}

/// A vector of any length gives its direction. One of length 1 keeps its bits.
fn direction<T: Real + Scalar>(v: [T; 3]) -> Result<UnitVec3<T>, &'static str> {
    let v = vector(v).map_err(|_| "direction: a coordinate is not finite")?;
    UnitVec3::new(v.x, v.y, v.z)
        .ok_or("direction: the zero vector has none; a vector of any other length will do")
}

fn checked<V, E: de::Error>(value: Option<V>, reason: &str) -> Result<V, E> {
    value.ok_or_else(|| E::custom(reason))
}

/// All fields are always written, because formats without names need them.
#[derive(Serialize, Deserialize)]
#[serde(
    rename = "Attenuation",
    expecting = "an attenuation with a, b and c",
    deny_unknown_fields
)]
struct RawAttenuation<T> {
    a: T,
    b: T,
    c: T,
    #[serde(default = "Option::default")]
    limit: Option<T>,
    #[serde(default = "Option::default")]
    range: Option<T>,
    #[serde(default = "Option::default")]
    range_gltf: Option<T>,
}

impl<T: Written> Serialize for Attenuation<T> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let [a, b, c] = self.coefficients();
        let [range, range_gltf] = if self.is_gltf() {
            [None, self.range()]
        } else {
            [self.range(), None]
        };
        RawAttenuation {
            a,
            b,
            c,
            limit: self.limit(),
            range,
            range_gltf,
        }
        .serialize(to)
    }
}

impl<'de, T: Read<'de>> Deserialize<'de> for Attenuation<T> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        const INVALID: &str = "attenuation: a, b and c must be finite, 0 or more, and not all 0";
        let raw = RawAttenuation::deserialize(from)?;
        let mut attenuation = checked(Self::new(raw.a, raw.b, raw.c), INVALID)?;
        if let Some(limit) = raw.limit {
            attenuation = checked(attenuation.clamped_to(limit), "limit: it must be above 0")?;
        }
        match (raw.range, raw.range_gltf) {
            (None, None) => Ok(attenuation),
            (Some(r), None) => checked(attenuation.within(r), "range: it must be above 0"),
            (None, Some(r)) => {
                checked(attenuation.within_gltf(r), "range_gltf: it must be above 0")
            }
            (Some(_), Some(_)) => Err(de::Error::custom("range: write it or range_gltf, not both")),
        }
    }
}

/// It is written by its cosines, because half-angles would not keep the bits.
#[derive(Serialize, Deserialize)]
#[serde(rename = "Cone", rename_all = "snake_case")]
enum RawCone<T> {
    Cosine(T),
    HalfAngle(T),
    Cosines(Edges<T>),
    HalfAngles(Edges<T>),
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Edges<T> {
    inner: T,
    outer: T,
    #[serde(default)]
    smoothstep: bool,
}

impl<T: Written> Serialize for Cone<T> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let ([inner, outer], smoothstep) = (self.cosines(), self.is_smoothstep());
        let raw = if inner == outer {
            RawCone::Cosine(inner)
        } else {
            RawCone::Cosines(Edges {
                inner,
                outer,
                smoothstep,
            })
        };
        raw.serialize(to)
    }
}

const COSINE: &str = "cosine: it must be between -1 and 1";
const HALF_ANGLE: &str =
    "half_angle: it must be between 0 and π; write half of the opening angle, in radians";
const COSINES: &str =
    "cosines: they must be between -1 and 1, and the inner one not below the outer";
const HALF_ANGLES: &str =
    "half_angles: they must be between 0 and π radians, and the inner one not above the outer";

impl<'de, T: Read<'de>> Deserialize<'de> for Cone<T> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let (cone, reason, smoothstep) = match RawCone::deserialize(from)? {
            RawCone::Cosine(cosine) => (Self::from_cosine(cosine), COSINE, false),
            RawCone::HalfAngle(radians) => (Self::from_half_angle(radians), HALF_ANGLE, false),
            RawCone::Cosines(edges) => {
                let cone = Self::from_cosines(edges.inner, edges.outer);
                (cone, COSINES, edges.smoothstep)
            }
            RawCone::HalfAngles(edges) => {
                let cone = Self::from_half_angles(edges.inner, edges.outer);
                (cone, HALF_ANGLES, edges.smoothstep)
            }
        };
        let cone = checked(cone, reason)?;
        Ok(if smoothstep { cone.smoothstep() } else { cone })
    }
}
