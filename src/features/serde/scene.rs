//! Lights and materials as records; a light names its kind.

use core::fmt::{self, Formatter};
use core::marker::PhantomData;

use serde_core::de::{EnumAccess, Error as _, MapAccess, SeqAccess, VariantAccess, Visitor};
use serde_core::ser::{Error as _, SerializeStruct};
use serde_core::{Deserialize, Deserializer, Serialize, Serializer};

use super::record::{Field, Form, Key, Named, entries, next, record, required};
use crate::{
    Attenuation, Cone, DirectionalLight, Light, Material, PointLight, Ranged, SoftCone, SpotLight,
};

const KINDS: &[&str] = &["directional", "point", "spot"];

macro_rules! scene {
    ($float:ident) => {
        record!(DirectionalLight<$float> { l, intensity });
        record!(Material<$float, u32> { k_a, k_d, k_s, m });
        record!(Material<$float, f32> { k_a, k_d, k_s, m });
        record!(Material<$float, f64> { k_a, k_d, k_s, m });

        scene!($float, Attenuation<$float>);
        scene!($float, Ranged<$float>);
    };
    ($float:ident, $falloff:ty) => {
        record!(PointLight<$float, $falloff> { position, intensity, attenuation });
        scene!($float, Cone<$float>, $falloff);
        scene!($float, SoftCone<$float>, $falloff);
    };
    ($float:ident, $cone:ty, $falloff:ty) => {
        record!(SpotLight<$float, $cone, $falloff> { point, axis, cone });

        impl Serialize for Light<$float, $cone, $falloff> {
            fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
                match self {
                    Self::Directional(light) => {
                        to.serialize_newtype_variant("Light", 0, KINDS[0], light)
                    }
                    Self::Point(light) => to.serialize_newtype_variant("Light", 1, KINDS[1], light),
                    Self::Spot(light) => to.serialize_newtype_variant("Light", 2, KINDS[2], light),
                }
            }
        }

        impl<'de> Visitor<'de> for Form<Light<$float, $cone, $falloff>> {
            type Value = Light<$float, $cone, $falloff>;

            fn expecting(&self, f: &mut Formatter) -> fmt::Result {
                write!(f, "a light, one of {KINDS:?}")
            }

            fn visit_enum<A: EnumAccess<'de>>(self, light: A) -> Result<Self::Value, A::Error> {
                match light.variant_seed(Key::Variant(KINDS))? {
                    ("directional", light) => light.newtype_variant().map(Light::Directional),
                    ("point", light) => light.newtype_variant().map(Light::Point),
                    (_, light) => light.newtype_variant().map(Light::Spot),
                }
            }
        }

        impl<'de> Deserialize<'de> for Light<$float, $cone, $falloff> {
            fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                let form = Form::<Self>::of(&from);
                from.deserialize_enum("Light", KINDS, form)
            }
        }
    };
}

scene!(f32);
scene!(f64);
