//! The inputs on which the properties are tested.
//!
//! Directions are made from angles or taken from a list, so no strategy here can shrink to the zero
//! vector. Degenerate configurations are generated on purpose, not left to chance.

#![allow(clippy::must_use_candidate, clippy::return_self_not_must_use)] // users do not call these functions

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;
use shading::{
    Attenuation, Cone, DirectionalLight, Exponent, IncidentLight, Light, Material, PointLight, Rgb,
    Shaded, SpotLight, UnitVec3, Vec3, shade,
};

use super::Number;
use super::check::is_short_of_range;
use super::exact;

/// Axes, a Pythagorean direction and a diagonal.
const KNOWN: [[f64; 3]; 10] = [
    [0.0, 0.0, 1.0],
    [0.0, 1.0, 0.0],
    [1.0, 0.0, 0.0],
    [0.0, 0.0, -1.0],
    [0.0, -1.0, 0.0],
    [-1.0, 0.0, 0.0],
    [0.6, 0.0, 0.8],
    [-0.48, 0.6, 0.64],
    [
        0.577_350_269_189_625_8,
        0.577_350_269_189_625_8,
        0.577_350_269_189_625_8,
    ],
    [-0.707_106_781_186_547_5, 0.707_106_781_186_547_5, 0.0],
];

/// A direction in `f64`.
pub fn direction() -> impl Strategy<Value = [f64; 3]> {
    let of_angles = |(polar, azimuth): (f64, f64)| {
        [
            polar.sin() * azimuth.cos(),
            polar.sin() * azimuth.sin(),
            polar.cos(),
        ]
    };
    prop_oneof![
        1 => select(&KNOWN[..]),
        4 => (0.0..=PI, 0.0..=TAU).prop_map(of_angles),
    ]
}

/// Rounds a direction: each component has a relative error of u, and so does the length. In an evenly
/// spaced type, each component is off by u, and the vector and its length by √3u.
pub fn rounded<T: Number>(direction: [f64; 3]) -> UnitVec3<T> {
    // one step of Newton's method removes the errors of sine and cosine
    let excess = 0.5 * exact::square_excess(direction);
    UnitVec3::assume_unit(Vec3::from(direction.map(|c| T::of(c - c * excess))))
}

/// A direction.
pub fn unit<T: Number>() -> impl Strategy<Value = UnitVec3<T>> {
    direction().prop_map(rounded)
}

/// How a second direction is placed relative to a first.
#[derive(Clone, Copy, Debug)]
pub enum Relation {
    /// Without any relation.
    Independent([f64; 3]),
    /// At an angle (0: coincident, π: opposite), toward an azimuth.
    Angle(f64, f64),
}

impl Relation {
    pub fn to(self, n: [f64; 3]) -> [f64; 3] {
        match self {
            Self::Independent(direction) => direction,
            Self::Angle(angle, azimuth) => {
                let [s, t] = tangents(n);
                let (sin, cos) = angle.sin_cos();
                // exactly perpendicular or exactly opposite where that is intended
                let cos = if angle == FRAC_PI_2 { 0.0 } else { cos };
                let sin = if angle == PI { 0.0 } else { sin };
                [0, 1, 2].map(|i| n[i] * cos + (s[i] * azimuth.cos() + t[i] * azimuth.sin()) * sin)
            }
        }
    }
}

/// Two directions that are perpendicular to n and to each other.
fn tangents(n: [f64; 3]) -> [[f64; 3]; 2] {
    let aside = if n[0].abs() < 0.5 {
        [1.0, 0.0, 0.0]
    } else {
        [0.0, 1.0, 0.0]
    };
    let s = exact::cross(n, aside);
    let length = exact::length(s);
    let s = s.map(|c| c / length);
    [s, exact::cross(n, s)]
}

/// Any relation, often a degenerate one: coincident, opposite, perpendicular, or nearly so.
pub fn relation() -> impl Strategy<Value = Relation> {
    let special = (
        select(&[0.0, FRAC_PI_2, PI][..]),
        select(&[0.0, 1e-12, -1e-12, 1e-7, -1e-7, 1e-4, -1e-4, 0.01, -0.01][..]),
        0.0..TAU,
    );
    prop_oneof![
        3 => direction().prop_map(Relation::Independent),
        2 => special.prop_map(|(angle, off, azimuth)| Relation::Angle(angle + off, azimuth)),
        // above the surface, where light arrives
        3 => (0.0..FRAC_PI_2, 0.0..TAU).prop_map(|(a, azimuth)| Relation::Angle(a, azimuth)),
    ]
}

/// N and L, in `f64`.
pub fn two_directions() -> impl Strategy<Value = [[f64; 3]; 2]> {
    (direction(), relation()).prop_map(|(n, l)| [n, l.to(n)])
}

/// N and L.
pub fn pair<T: Number>() -> impl Strategy<Value = [UnitVec3<T>; 2]> {
    two_directions().prop_map(|pair| pair.map(rounded))
}

/// N, L, and V, in `f64`: L and V are each related to N, or V to L, or V is the mirrored L.
pub fn three_directions() -> impl Strategy<Value = [[f64; 3]; 3]> {
    (two_directions(), relation(), 0..4).prop_map(|([n, l], relation, to)| {
        let cosine = exact::dot(n, l);
        let v = match to {
            0 | 1 => relation.to(n),
            2 => relation.to(l),
            _ => [0, 1, 2].map(|i| 2.0 * cosine * n[i] - l[i]),
        };
        [n, l, v]
    })
}

/// N, L and V.
pub fn triple<T: Number>() -> impl Strategy<Value = [UnitVec3<T>; 3]> {
    three_directions().prop_map(|triple| triple.map(rounded))
}

/// A shininess: an integer, passed as an integer or as a real number, or a real number. It is a
/// multiple of ¼, which every type can hold.
#[derive(Clone, Copy, Debug)]
pub struct Shine {
    pub m: f64,
    pub whole: bool,
}

impl<T: Number> Exponent<T> for Shine {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    fn raise(self, cosine: T) -> T {
        if self.whole {
            (self.m as u32).raise(cosine)
        } else {
            T::shininess(self.m).raise(cosine)
        }
    }

    fn half(self) -> Option<Self> {
        // a type without real powers has only an integer shininess
        let is_integer = self.whole || T::EVENLY_SPACED || T::POWER_ERROR == 0.0;
        let m = if is_integer { self.m.floor() } else { self.m } / 2.0;
        (!is_integer || m.fract() == 0.0).then_some(Self { m, ..self })
    }
}

impl From<Shine> for f64 {
    fn from(shine: Shine) -> f64 {
        shine.m
    }
}

impl Shine {
    /// The largest error of a power of a given cosine, in units of u: m roundings for an integer
    /// power, and the type's own bound for a real one. An error of the cosine itself counts m
    /// times.
    pub fn error<T: Number>(self) -> f64 {
        let is_multiplied = self.whole && !T::EVENLY_SPACED;
        if is_multiplied || T::POWER_ERROR == 0.0 {
            self.m
        } else {
            T::POWER_ERROR
        }
    }
}

/// A shininess up to `most`, or in an evenly spaced type up to 128.
pub fn shine<T: Number>(most: u32) -> impl Strategy<Value = Shine> {
    any_shine(if T::EVENLY_SPACED {
        most.min(128)
    } else {
        most
    })
}

fn any_shine(most: u32) -> impl Strategy<Value = Shine> {
    let m = prop_oneof![
        1 => select(&[0.0, 1.0, 2.0, 3.0, 5.0, 32.0][..]),
        1 => (0..=4 * most).prop_map(|quarters| f64::from(quarters) / 4.0),
    ];
    (m, any::<bool>()).prop_map(|(m, whole)| Shine {
        m: if whole { m.floor() } else { m },
        whole,
    })
}

/// The three models of the sum over lights.
#[derive(Clone, Copy, Debug)]
pub enum Model {
    Lambert,
    Phong,
    BlinnPhong,
}

pub const MODELS: [Model; 3] = [Model::Lambert, Model::Phong, Model::BlinnPhong];

pub fn model() -> impl Strategy<Value = Model> {
    select(&MODELS[..])
}

/// Everything that the sum over lights takes.
#[derive(Clone, Debug)]
pub struct Scene<T> {
    pub n: UnitVec3<T>,
    pub v: UnitVec3<T>,
    pub material: Material<T, Shine>,
    pub i_a: Rgb<T>,
    pub lights: Vec<IncidentLight<T>>,
}

impl<T: Number> Scene<T> {
    pub fn shade(&self, model: Model) -> Shaded<T> {
        self.lit_by(model, &self.lights)
    }

    /// The same surface under other lights.
    pub fn lit_by(&self, model: Model, lights: &[IncidentLight<T>]) -> Shaded<T> {
        let (n, v, material, i_a) = (self.n, self.v, &self.material, self.i_a);
        let lights = lights.iter().copied();
        match model {
            Model::Lambert => shade::lambert(n, material, i_a, lights),
            Model::Phong => shade::phong(n, v, material, i_a, lights),
            Model::BlinnPhong => shade::blinn_phong(n, v, material, i_a, lights),
        }
    }

    /// The same scene with each number of its light and its material changed by `f`.
    pub fn map_intensities(&self, f: impl Fn(Rgb<T>) -> Rgb<T>) -> Self {
        let lights = self.lights.iter();
        let lights = lights.map(|light| IncidentLight {
            intensity: f(light.intensity),
            ..*light
        });
        Self {
            i_a: f(self.i_a),
            lights: lights.collect(),
            ..self.clone()
        }
    }

    /// The same scene with each direction changed by `f`.
    pub fn map_directions(&self, f: impl Fn(UnitVec3<T>) -> UnitVec3<T>) -> Self {
        let lights = self.lights.iter();
        let lights = lights.map(|light| IncidentLight {
            l: f(light.l),
            ..*light
        });
        Self {
            n: f(self.n),
            v: f(self.v),
            lights: lights.collect(),
            ..self.clone()
        }
    }
}

/// A share in [0, 1]; both ends are included on purpose.
fn share<T: Number>() -> impl Strategy<Value = T> {
    prop_oneof![1 => Just(0.0), 1 => Just(1.0), 4 => 0.0..1.0].prop_map(T::of)
}

/// An ordinary intensity, or 0.
fn usual<T: Number>() -> impl Strategy<Value = T> {
    prop_oneof![1 => Just(0.0), 1 => Just(1.0), 4 => 0.001..4.0].prop_map(T::of)
}

/// A finite number that is not negative: one that breaks formulas, or one of any size in between.
pub fn adversarial<T: Number>() -> impl Strategy<Value = T> {
    let largest = T::MAX.to_f64();
    let exponent = largest.log2().floor();
    let special = [
        T::ZERO,
        -T::ZERO,
        T::TINY,
        T::TINY * T::of(3.0),
        T::ONE / T::EXTREME,
        T::of(1.0 - T::U),
        T::ONE,
        T::of(1.0 + 2.0 * T::U),
        T::EXTREME,
        T::of(1e30_f64.min(largest)),
        T::of(1e38_f64.min(largest)),
        T::MAX,
    ];
    prop_oneof![
        2 => select(special.to_vec()),
        1 => (-exponent..exponent, 1.0..2.0).prop_map(|(e, f)| T::of(f * e.floor().exp2())),
        1 => (0.0..1.0).prop_map(T::of),
    ]
}

/// The same with either sign.
pub fn adversarial_signed<T: Number>() -> impl Strategy<Value = T> {
    (adversarial(), any::<bool>())
        .prop_map(|(x, negative): (T, bool)| if negative { -x } else { x })
}

/// A point or vector of such numbers, or a direction times one of them.
pub fn adversarial_vector<T: Number>() -> impl Strategy<Value = Vec3<T>> {
    let component = adversarial_signed::<T>;
    prop_oneof![
        [component(), component(), component()].prop_map(Vec3::from),
        (unit::<T>(), component()).prop_map(|(direction, size)| *direction * size),
    ]
}

fn color<T: Number, S: Strategy<Value = T>>(channel: fn() -> S) -> impl Strategy<Value = Rgb<T>> {
    [channel(), channel(), channel()].prop_map(Rgb::from)
}

/// A color of ordinary brightness.
pub fn light_color<T: Number>() -> impl Strategy<Value = Rgb<T>> {
    color(usual)
}

/// A reflectance.
pub fn reflectance<T: Number>() -> impl Strategy<Value = Rgb<T>> {
    color(share)
}

/// A color made of the numbers that break formulas.
pub fn adversarial_color<T: Number>() -> impl Strategy<Value = Rgb<T>> {
    color(adversarial)
}

fn scene_of<T: Number, A, B>(
    reflectance: fn() -> A,
    light: fn() -> B,
    most_shiny: u32,
) -> impl Strategy<Value = Scene<T>>
where
    A: Strategy<Value = Rgb<T>>,
    B: Strategy<Value = Rgb<T>>,
{
    let material = (
        reflectance(),
        reflectance(),
        reflectance(),
        any_shine(most_shiny),
    );
    // zero to many lights, and often enough V is the mirror direction of the first
    let lights = vec((relation(), light()), 0..9);
    (three_directions(), material, light(), lights).prop_map(
        |([n, l, v], (k_a, k_d, k_s, m), i_a, mut lights)| {
            if let Some((first, _)) = lights.first_mut() {
                *first = Relation::Independent(l);
            }
            let incident = |(relation, intensity): (Relation, _)| IncidentLight {
                l: rounded(relation.to(n)),
                intensity,
                distance: T::MAX,
            };
            Scene {
                n: rounded(n),
                v: rounded(v),
                material: Material { k_a, k_d, k_s, m },
                i_a,
                lights: lights.into_iter().map(incident).collect(),
            }
        },
    )
}

/// A scene with ordinary lights.
pub fn scene<T: Number>() -> impl Strategy<Value = Scene<T>> {
    scene_of(reflectance, light_color, 128)
}

/// A scene made of the numbers that break formulas.
pub fn adversarial_scene<T: Number>() -> impl Strategy<Value = Scene<T>> {
    scene_of(adversarial_color, adversarial_color, 10_000)
}

/// A multiple of 1/16 in [−2, 2]. Differences of these, products of two differences, and the sum of
/// three such products fit in 16 bits, and are exact.
pub fn dyadic<T: Number>() -> impl Strategy<Value = T> {
    (-32..=32).prop_map(|i| T::of(f64::from(i) / 16.0))
}

/// A point on the dyadic grid.
pub fn dyadic_point<T: Number>() -> impl Strategy<Value = Vec3<T>> {
    [dyadic(), dyadic(), dyadic()].prop_map(Vec3::from)
}

/// k, for points 2^k times as large or as small, nearly to the ends of the range. In an evenly spaced
/// type they are only larger, because smaller ones lose bits.
pub fn octaves<T: Number>() -> impl Strategy<Value = f64> {
    // coordinates up to 6 stay in the range
    let shares = if is_short_of_range::<T>() {
        0.0..0.75
    } else {
        -0.9..0.9
    };
    let range = T::MAX.to_f64().log2();
    shares.prop_map(move |share: f64| f64::floor((share * range).min(range - 3.5)))
}

/// k from −`most` to `most`, for numbers 2^k times as large. In an evenly spaced type of 15 bits before the point it is
/// from 0 to `most_even`: smaller numbers lose bits, and larger ones leave the range. With fewer bits, k is as far from the
/// end of the range. In a float of a short range, it is up to a quarter of it, as products of several numbers are scaled.
#[allow(clippy::cast_possible_truncation)] // up to 128
pub fn exponent<T: Number>(most: i32, most_even: i32) -> impl Strategy<Value = i32> {
    let range = T::MAX.to_f64().log2().round() as i32;
    if T::EVENLY_SPACED {
        0..=(most_even * range / 15).min(1.max(most_even - 15 + range))
    } else if is_short_of_range::<T>() {
        0..=most.min(range / 4)
    } else {
        -most..=most
    }
}

/// A point within a cube of side 2.
pub fn point<T: Number>() -> impl Strategy<Value = Vec3<T>> {
    let coordinate = || (-1.0..1.0).prop_map(T::of);
    [coordinate(), coordinate(), coordinate()].prop_map(Vec3::from)
}

/// An attenuation, clamped to 1 or not; many of its coefficients are 0, but not all.
pub fn coefficients<T: Number>() -> impl Strategy<Value = Attenuation<T>> {
    let coefficient = || prop_oneof![1 => Just(0.0), 2 => 0.0..2.0];
    let abc = [coefficient(), coefficient(), coefficient()];
    (abc, any::<bool>()).prop_filter_map("all zero", |(abc, clamped)| {
        let attenuation = coefficients_of(abc)?;
        Some(if clamped {
            attenuation.clamped()
        } else {
            attenuation
        })
    })
}

/// A valid attenuation with the coefficients nearest to these.
pub fn coefficients_of<T: Number>(abc: [f64; 3]) -> Option<Attenuation<T>> {
    let [a, b, c] = abc.map(T::of);
    Attenuation::of(a, b, c)
}

/// A cone from its cosine.
pub fn cone<T: Number>(cosine: f64) -> Cone<T> {
    Cone::of_cosine(T::of(cosine)).expect("the property expects a cosine, and there is none")
}

/// A light of any kind, at one of the given places.
pub fn light<T: Number, P: Strategy<Value = Vec3<T>>>(
    places: P,
) -> impl Strategy<Value = Light<T>> {
    let parts = (
        places,
        light_color(),
        coefficients(),
        unit(),
        unit(),
        -1.0..=1.0,
        0..3,
    );
    parts.prop_map(
        |(position, intensity, attenuation, l, axis, cosine, kind)| {
            let point = PointLight {
                position,
                intensity,
                attenuation,
            };
            let cone = cone(cosine);
            match kind {
                0 => Light::Directional(DirectionalLight { l, intensity }),
                1 => Light::Point(point),
                _ => Light::Spot(SpotLight { point, axis, cone }),
            }
        },
    )
}
