//! Inside an untagged enum and in a flattened struct, where serde buffers what it reads, every type is read back with
//! the same bits, in every format that can ask what comes next.

use std::fmt::Debug;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use shading::{
    Attenuation, Cone, DirectionalLight, Light, Material, PointLight, Ranged, Rgb, SoftCone,
    SpotLight, UnitVec3, Vec3,
};

const PAGE: &str = include_str!("../../../docs/schema.md");

/// The types of the page's table.
fn types_of_the_page() -> Vec<&'static str> {
    let rows = PAGE
        .lines()
        .skip_while(|line| !line.starts_with("| type |"))
        .skip(2);
    let rows = rows.take_while(|line| line.starts_with("| `"));
    rows.map(|row| row.split('`').nth(1).expect("a name"))
        .collect()
}

/// The value, of any type, and how the page's formats write and read it.
trait Format {
    fn reads_back<V: Serialize + DeserializeOwned + Debug>(value: &V) -> Result<V, String>;
}

macro_rules! formats {
    ($($name:ident: |$value:ident| $back:expr;)+) => {
        $(
            struct $name;
            impl Format for $name {
                fn reads_back<V: Serialize + DeserializeOwned + Debug>($value: &V) -> Result<V, String> {
                    $back
                }
            }
        )+
    };
}

#[allow(clippy::needless_pass_by_value)] // what `map_err` calls
fn said(error: impl ToString) -> String {
    error.to_string()
}

formats! {
    Json: |value| serde_json::from_str(&serde_json::to_string(value).map_err(said)?).map_err(said);
    Ron: |value| ron::from_str(&ron::to_string(value).map_err(said)?).map_err(said);
    Toml: |value| toml::from_str(&toml::to_string(value).map_err(said)?).map_err(said);
    Cbor: |value| {
        let mut bytes = Vec::new();
        ciborium::into_writer(value, &mut bytes).map_err(said)?;
        ciborium::from_reader(bytes.as_slice()).map_err(said)
    };
    MessagePack: |value| rmp_serde::from_slice(&rmp_serde::to_vec(value).map_err(said)?).map_err(said);
    NamedMessagePack: |value| rmp_serde::from_slice(&rmp_serde::to_vec_named(value).map_err(said)?).map_err(said);
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(untagged)]
enum Untagged<V> {
    Name(String),
    Value(V),
}

/// A document, because TOML has nothing but tables.
#[derive(Debug, Serialize, Deserialize)]
struct Document<V> {
    name: String,
    value: Untagged<V>,
    all: Vec<Untagged<V>>,
}

#[derive(Debug, Serialize, Deserialize)]
struct Flattened<V> {
    name: String,
    #[serde(flatten)]
    value: V,
}

/// `{:?}` shows all bits of a finite number.
fn same<F: Format, V: Serialize + DeserializeOwned + Debug>(value: &V) {
    let read = F::reads_back(value).unwrap_or_else(|error| panic!("{value:?}: {error}"));
    assert_eq!(format!("{read:?}"), format!("{value:?}"));
}

fn untagged<F: Format, V: Serialize + DeserializeOwned + Debug + Clone>(value: &V) {
    same::<F, _>(&Document {
        name: "a name".into(),
        value: Untagged::Value(value.clone()),
        all: vec![
            Untagged::Value(value.clone()),
            Untagged::Name("none".into()),
        ],
    });
}

/// Whether the type is a list, which serde cannot flatten.
fn is_list<V: Serialize>(value: &V) -> bool {
    serde_json::to_value(value).expect("a value").is_array()
}

fn in_every_format<V: Serialize + DeserializeOwned + Debug + Clone>(value: &V) {
    untagged::<Json, V>(value);
    untagged::<Ron, V>(value);
    untagged::<Toml, V>(value);
    untagged::<Cbor, V>(value);
    untagged::<MessagePack, V>(value);
    untagged::<NamedMessagePack, V>(value);
    if !is_list(value) {
        let value = Flattened {
            name: "a name".into(),
            value: value.clone(),
        };
        same::<Json, _>(&value);
        same::<Ron, _>(&value);
        same::<Toml, _>(&value);
        same::<Cbor, _>(&value);
        same::<MessagePack, _>(&value);
        same::<NamedMessagePack, _>(&value);
    }
}

macro_rules! every_type {
    ($test:ident, $float:ident) => {
        #[test]
        fn $test() {
            let mut tried = vec![];
            macro_rules! tried {
                ($name:literal: $value:expr) => {
                    tried.push($name);
                    in_every_format(&$value);
                };
            }
            let v = Vec3::<$float>::new(0.1, -2.5, 3.0);
            let color = Rgb::<$float>::new(0.1, 2.0, 0.0);
            let direction = UnitVec3::<$float>::normalized(1.0, 2.0, -3.0).unwrap();
            let attenuation = Attenuation::<$float>::new(0.1, 0.0, 2.0).unwrap();
            let clamped = attenuation.clamped();
            let ranged = clamped.within(7.3).unwrap();
            let cone = Cone::<$float>::from_half_angle(0.4).unwrap();
            let soft = SoftCone::<$float>::from_half_angles(0.2, 0.4).unwrap();
            tried!("Vec3": v);
            tried!("Rgb": color);
            tried!("UnitVec3": direction);
            tried!("Attenuation": attenuation);
            tried!("Attenuation": clamped);
            tried!("Ranged": ranged);
            tried!("Ranged": attenuation.within(0.5).unwrap());
            tried!("Ranged": Ranged::from(attenuation));
            tried!("Ranged": Ranged::from(clamped));
            tried!("Ranged": ranged.unsquared());
            tried!("Ranged": Ranged::from(attenuation).unsquared());
            tried!("Cone": cone);
            tried!("SoftCone": soft);
            tried!("SoftCone": soft.smoothstep());
            tried!("SoftCone": SoftCone::from(cone));

            let sun = DirectionalLight { l: direction, intensity: color };
            let lamp = PointLight { position: v, intensity: color, attenuation };
            let near = PointLight { position: v, intensity: color, attenuation: ranged };
            let spot = SpotLight { point: lamp, axis: direction, cone };
            let soft_spot = SpotLight { point: near, axis: direction, cone: soft };
            tried!("DirectionalLight": sun);
            tried!("PointLight": lamp);
            tried!("PointLight": near);
            tried!("SpotLight": spot);
            tried!("SpotLight": soft_spot);
            tried!("Light": Light::<$float>::from(sun));
            tried!("Light": Light::<$float>::from(lamp));
            tried!("Light": Light::<$float>::from(spot));
            tried!("Light": Light::<$float, SoftCone<$float>, Ranged<$float>>::from(near));
            tried!("Light": Light::<$float, SoftCone<$float>, Ranged<$float>>::from(soft_spot));

            let [k_a, k_d, k_s] = [color, color * 0.5, color * 0.3];
            tried!("Material": Material { k_a, k_d, k_s, m: 32_u32 });
            tried!("Material": Material { k_a, k_d, k_s, m: 32.5 as $float });

            tried.dedup();
            assert_eq!(tried, types_of_the_page());
        }
    };
}

every_type!(single_precision_survives_where_serde_buffers, f32);
every_type!(double_precision_survives_where_serde_buffers, f64);
