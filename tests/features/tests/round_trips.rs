//! A value that is written is read back with the same bits, in every format. A value that could not
//! be read back is not written.

use std::fmt::Debug;

use serde::Serialize;
use serde::de::DeserializeOwned;
use shading::{
    Attenuation, Cone, DirectionalLight, Light, Material, PointLight, Ranged, Rgb, SoftCone,
    SpotLight, UnitVec3, Vec3,
};

/// `{:?}` shows all bits of a finite number.
fn survives<V: Serialize + DeserializeOwned + Debug>(value: &V) {
    let expected = format!("{value:?}");
    let same = |read: V, text: &dyn Debug| assert_eq!(format!("{read:?}"), expected, "{text:?}");

    let json = serde_json::to_string(value).unwrap();
    same(serde_json::from_str(&json).unwrap(), &json);
    let ron = ron::to_string(value).unwrap();
    same(ron::from_str(&ron).unwrap(), &ron);
    let postcard = postcard::to_allocvec(value).unwrap();
    same(postcard::from_bytes(&postcard).unwrap(), &postcard);
    let mut cbor = Vec::new();
    ciborium::into_writer(value, &mut cbor).unwrap();
    same(ciborium::from_reader(cbor.as_slice()).unwrap(), &cbor);
}

macro_rules! round_trips {
    ($float:ident, $bits:ident) => {
        mod $float {
            use super::*;

            /// Any finite number; every exponent is equally likely.
            fn finite(random: &mut fastrand::Rng) -> $float {
                loop {
                    let x = $float::from_bits(random.$bits(..));
                    if x.is_finite() {
                        return x;
                    }
                }
            }

            fn three(random: &mut fastrand::Rng) -> [$float; 3] {
                [(); 3].map(|()| finite(random))
            }

            fn direction(random: &mut fastrand::Rng) -> UnitVec3<$float> {
                Vec3::from(three(random)).unit_or(UnitVec3::NEG_X)
            }

            fn attenuation(random: &mut fastrand::Rng) -> Attenuation<$float> {
                let [a, b, c] = three(random).map($float::abs);
                let attenuation = Attenuation::<$float>::new(a, b, c).unwrap_or_default();
                if random.bool() {
                    attenuation.clamped()
                } else {
                    attenuation
                }
            }

            /// A cone of any width, from nothing to everything.
            fn cone(random: &mut fastrand::Rng) -> Cone<$float> {
                let cosine = match random.u8(..8) {
                    0 => 1.0,
                    1 => -1.0,
                    _ => 2.0 * random.$float() - 1.0,
                };
                Cone::<$float>::from_cosine(cosine).unwrap()
            }

            fn ranged(random: &mut fastrand::Rng) -> Ranged<$float> {
                let attenuation = attenuation(random);
                let ranged = attenuation.within(finite(random));
                let ranged = ranged.unwrap_or(attenuation.into());
                if random.bool() {
                    ranged.unsquared()
                } else {
                    ranged
                }
            }

            fn soft_cone(random: &mut fastrand::Rng) -> SoftCone<$float> {
                let (a, b) = (cone(random).cosine(), cone(random).cosine());
                let soft = SoftCone::<$float>::from_cosines(a.max(b), a.min(b)).unwrap();
                match random.u8(..3) {
                    0 => cone(random).into(),
                    1 => soft,
                    _ => soft.smoothstep(),
                }
            }

            fn light<C, A>(
                random: &mut fastrand::Rng,
                cone: impl Fn(&mut fastrand::Rng) -> C,
                attenuation: impl Fn(&mut fastrand::Rng) -> A,
            ) -> Light<$float, C, A> {
                let intensity = Rgb::from(three(random));
                let (position, attenuation) = (Vec3::from(three(random)), attenuation(random));
                let point = PointLight {
                    position,
                    intensity,
                    attenuation,
                };
                let l = direction(random);
                match random.u8(..3) {
                    0 => Light::Directional(DirectionalLight { l, intensity }),
                    1 => Light::Point(point),
                    _ => Light::Spot(SpotLight {
                        point,
                        axis: l,
                        cone: cone(random),
                    }),
                }
            }

            fn material<M>(random: &mut fastrand::Rng, m: M) -> Material<$float, M> {
                let [k_a, k_d, k_s] = [(); 3].map(|()| Rgb::from(three(random)));
                Material { k_a, k_d, k_s, m }
            }

            #[test]
            fn lights_keep_their_bits() {
                let random = &mut fastrand::Rng::with_seed(13);
                for _ in 0..3_000 {
                    survives(&light(random, cone, attenuation));
                    survives(&light(random, soft_cone, attenuation));
                    survives(&light(random, cone, ranged));
                    survives(&light(random, soft_cone, ranged));
                }
            }

            #[test]
            fn materials_keep_their_bits() {
                let random = &mut fastrand::Rng::with_seed(14);
                for _ in 0..3_000 {
                    let (whole, real) = (random.u32(..), finite(random));
                    survives(&material(random, whole));
                    survives(&material(random, real));
                }
            }

            #[test]
            fn direction_normalized_elsewhere_is_read() {
                let random = &mut fastrand::Rng::with_seed(15);
                for _ in 0..3_000 {
                    survives(&direction(random));
                    // a direction of single precision, in double precision
                    #[allow(clippy::cast_possible_truncation)]
                    let single = direction(random).cast(|x| x as f32);
                    survives(&single.cast($float::from));
                    // a direction with six decimals
                    let [x, y, z] = direction(random).into();
                    let text = format!("[{x:.6}, {y:.6}, {z:.6}]");
                    survives(&serde_json::from_str::<UnitVec3<$float>>(&text).unwrap());
                }
            }
        }
    };
}

round_trips!(f32, u32);
round_trips!(f64, u64);

/// The error for a value that could not be read back.
fn complaint(value: &impl Serialize) -> String {
    let message = serde_json::to_string(value).unwrap_err().to_string();
    assert_eq!(
        ron::to_string(value).unwrap_err().to_string(),
        message,
        "every format fails in the same way"
    );
    assert!(postcard::to_allocvec(value).is_err());
    message
}

#[test]
fn numbers_that_are_not_finite_are_not_written() {
    let lamp = PointLight {
        position: Vec3::<f32>::ZERO,
        intensity: Rgb::new(1.0, f32::INFINITY, 1.0),
        attenuation: Attenuation::NONE,
    };
    assert_eq!(complaint(&lamp), "intensity: g = inf is not finite");
    let lamp = Light::<f32>::Point(PointLight {
        position: Vec3::new(0.0, 0.0, f32::NAN),
        ..lamp
    });
    assert_eq!(complaint(&lamp), "position: z = NaN is not finite");

    let [k_a, k_d, k_s] = [Rgb::<f32>::BLACK; 3];
    let material = Material {
        k_a,
        k_d,
        k_s,
        m: f32::NAN,
    };
    assert_eq!(complaint(&material), "m: NaN is not finite");
    assert_eq!(
        complaint(&Vec3::new(f64::NEG_INFINITY, 0.0, 0.0)),
        "vector: x = -inf is not finite"
    );
    assert_eq!(
        complaint(&Rgb::gray(f64::NAN)),
        "color: r = NaN is not finite"
    );
}

#[test]
fn invalid_values_are_not_written() {
    let sun = DirectionalLight {
        l: UnitVec3::assume_unit(Vec3::new(0.0_f32, 3.0, 4.0)),
        intensity: Rgb::WHITE,
    };
    assert_eq!(
        complaint(&sun),
        "l: [0.0, 3.0, 4.0] has length 5.0, not 1; write [0.0, 0.6, 0.8]"
    );
    // (0, 0, 10⁻³⁰⁰) in doubles becomes 0 in single precision
    let weak = Attenuation::<f64>::new(0.0, 0.0, 1e-300).unwrap();
    #[allow(clippy::cast_possible_truncation)]
    let none = weak.cast(|x| x as f32);
    assert_eq!(
        complaint(&none),
        "attenuation: all are 0; write [1, 0, 0] for no attenuation"
    );
}
