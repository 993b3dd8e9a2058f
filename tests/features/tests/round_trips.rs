//! What is written is read back with the same bits, in every format, also inside a flattened struct
//! and a tagged or an untagged enum, where serde buffers what it reads. What could not be read back
//! is not written.

use std::error::Error;
use std::fmt::Debug;

use proptest::prelude::*;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use shading::{
    Attenuation, Cone, DirectionalLight, Elementary, Light, Material, PointLight, Rgb, Scalar,
    SpotLight, UnitVec3, Vec3,
};

/// What serde can read and write.
trait Stored: Serialize + DeserializeOwned + Debug + Clone {}
impl<V: Serialize + DeserializeOwned + Debug + Clone> Stored for V {}

type Back<V> = fn(&V) -> Result<V, Box<dyn Error>>;

/// The value, written and read in each format; the last cannot ask what comes next.
fn formats<V: Stored>() -> [(&'static str, Back<V>); 7] {
    [
        ("JSON", |v| {
            Ok(serde_json::from_str(&serde_json::to_string(v)?)?)
        }),
        ("RON", |v| Ok(ron::from_str(&ron::to_string(v)?)?)),
        ("TOML", |v| Ok(toml::from_str(&toml::to_string(v)?)?)),
        ("MessagePack", |v| {
            Ok(rmp_serde::from_slice(&rmp_serde::to_vec(v)?)?)
        }),
        ("named MessagePack", |v| {
            Ok(rmp_serde::from_slice(&rmp_serde::to_vec_named(v)?)?)
        }),
        ("CBOR", |v| {
            let mut bytes = Vec::new();
            ciborium::into_writer(v, &mut bytes)?;
            Ok(ciborium::from_reader(&bytes[..])?)
        }),
        ("postcard", |v| {
            Ok(postcard::from_bytes(&postcard::to_allocvec(v)?)?)
        }),
    ]
}

/// A table, because TOML has nothing else at the top.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Plain<V> {
    all: Vec<V>,
    value: V,
}

#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(untagged)]
enum Untagged<V> {
    Name(String),
    Value(V),
}

#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(tag = "kind")]
enum Tagged<V> {
    Value(V),
}

#[derive(Clone, Debug, Serialize, Deserialize)]
struct Flattened<V> {
    name: String,
    #[serde(flatten)]
    value: V,
    #[serde(flatten)]
    other: Other,
}

#[derive(Clone, Debug, Serialize, Deserialize)]
struct Other {
    fog: f32,
}

fn survives<V: Stored>(value: &V, count: usize) {
    for (format, back) in formats().into_iter().take(count) {
        let read: V = back(value).unwrap_or_else(|error| panic!("{format}, {value:?}: {error}"));
        // which shows all bits of a finite number
        assert_eq!(format!("{read:?}"), format!("{value:?}"), "{format}");
    }
}

fn plain<V: Clone>(value: &V, other: &V) -> Plain<V> {
    let all = vec![value.clone(), other.clone()];
    let value = value.clone();
    Plain { all, value }
}

fn list<V: Stored>(value: V) {
    survives(&plain(&value, &value), 7);
    let [value, name] = [Untagged::Value(value), Untagged::Name("none".into())];
    survives(&plain(&value, &name), 6);
}

fn map<V: Stored>(value: V) {
    list(value.clone());
    survives(&Tagged::Value(value.clone()), 6);
    let (name, other) = ("a name".into(), Other { fog: 0.5 });
    survives(&Flattened { name, value, other }, 6);
}

/// Any finite number, with any exponent and any last bit.
fn number<T: Elementary + Scalar + Debug>() -> impl Strategy<Value = T> {
    let parts = (any::<u32>(), 0.5..=1.0);
    let number =
        parts.prop_map(|(bits, fraction)| T::of_f32(f32::from_bits(bits)) * T::of(fraction));
    number.prop_filter("finite", |x| x.abs() <= T::MAX)
}

/// A cosine of a cone of any width, from nothing to everything.
fn cosine() -> impl Strategy<Value = f64> {
    prop_oneof![Just(-1.0), Just(1.0), -1.0..=1.0]
}

fn every_type<T: Elementary + Scalar + Stored>() {
    let numbers = proptest::array::uniform10(number::<T>());
    let config = ProptestConfig::with_cases(64);
    proptest!(config, |(numbers in numbers, m in number::<T>(), cosines in [cosine(), cosine()],
                        [clamped, ranged, gltf, hard, smoothstep] in any::<[bool; 5]>())| {
        let ([x, y, z, ..], [.., r, g, b, a_0, a_1, a_2, range]) = (numbers, numbers.map(T::abs));
        let (v, intensity) = (Vec3::new(x, y, z), Rgb::new(r, g, b));
        let axis = v.unit_or(UnitVec3::NEG_X);
        let some = Attenuation::new(a_0, a_1, a_2).unwrap_or_default();
        let some = if clamped { some.clamped() } else { some };
        let end = if gltf { some.within_gltf(range) } else { some.within(range) };
        let attenuation = end.filter(|_| ranged).unwrap_or(some);
        let [inner, outer] = [f64::max, f64::min].map(|of| T::of(of(cosines[0], cosines[1])));
        let cone = Cone::from_cosines(if hard { outer } else { inner }, outer).unwrap();
        let cone = if smoothstep { cone.smoothstep() } else { cone };
        let point = PointLight { position: v, intensity, attenuation };
        let spot = SpotLight { point, axis, cone };
        let [k_a, k_d, k_s] = [intensity; 3];
        list(v);
        list(intensity);
        list(axis);
        map(attenuation);
        map(cone);
        map(DirectionalLight { l: axis, intensity });
        map(Light::Directional(DirectionalLight { l: axis, intensity }));
        map(point);
        map(Light::Point(point));
        map(spot);
        map(Light::Spot(spot));
        map(Material { k_a, k_d, k_s, m });
        map(Material { k_a, k_d, k_s, m: 32_u32 });
    });
}

#[test]
fn every_type_survives() {
    every_type::<f32>();
    every_type::<f64>();
}

#[test]
fn what_could_not_be_read_is_not_written() {
    fn refused(value: &impl Serialize) -> String {
        serde_json::to_string(value)
            .expect_err("invalid")
            .to_string()
    }
    let nan = Vec3::new(0.0, f32::NAN, 0.0);
    assert_eq!(refused(&nan), "vector: a coordinate is not finite");
    let color = "color: a channel is negative or not finite";
    assert_eq!(refused(&Rgb::gray(-1.0)), color);
    let nowhere = UnitVec3::assume_unit(Vec3::<f32>::ZERO);
    assert!(refused(&nowhere).starts_with("direction: the zero vector has none"));
}
