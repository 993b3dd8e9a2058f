//! Random scenes of short numbers.
//!
//! Everything is made of small integers, so a scene is exact in `f32`, special positions
//! (perpendicular, opposite, mirrored) are hit exactly and often, and a failing scene shrinks to
//! zeros and ones.

use std::array::from_fn;

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;

use crate::bounded;
use crate::profile::Profile;
use crate::scene::{Light, Material, Scene, Triple};

type Integers = [i32; 3];

/// A scene, and what the laws vary it by.
#[derive(Clone, Debug)]
pub struct Base {
    pub scene: Scene,
    /// Three vectors like those to the lights, each short enough to be added to another.
    pub ways: [Triple; 3],
    /// Three factors of 1, 2, … 8.
    pub factors: [f64; 3],
}

/// How a vector lies relative to the normal.
#[derive(Clone, Copy, Debug)]
enum Way {
    /// Within 90° of the normal.
    InFront(Integers),
    Anywhere(Integers),
    Perpendicular(Integers),
    Along,
    Against,
    /// Where the first light is mirrored. It is for the eye.
    Mirrored,
}

impl Way {
    fn of(self, n: Integers, first: Integers) -> Integers {
        let way = match self {
            Self::InFront(way) if dot(way, n) < 0 => way.map(|c| -c),
            Self::InFront(way) | Self::Anywhere(way) => way,
            Self::Perpendicular(way) => from_fn(|i| {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                way[j] * n[k] - way[k] * n[j]
            }),
            Self::Along => n,
            Self::Against => n.map(|c| -c),
            Self::Mirrored => {
                let (twice, square) = (2 * dot(n, first), dot(n, n));
                from_fn(|i| twice * n[i] - square * first[i])
            }
        };
        if way == [0; 3] { n } else { way }
    }
}

fn dot(a: Integers, b: Integers) -> i32 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

/// The integers as a vector whose largest component is from 1 to 2, by a power of two.
fn vector(integers: Integers) -> Triple {
    let largest = integers.map(i32::unsigned_abs).into_iter().max();
    let scale = f64::from(1_u32 << largest.unwrap_or(1).max(1).ilog2());
    integers.map(|c| f64::from(c) / scale)
}

pub fn unit(v: Triple) -> Triple {
    let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
    v.map(|c| c / length)
}

impl Profile {
    /// The number of the renderer that is nearest to x.
    pub(crate) fn rounded(&self, x: f64) -> f64 {
        bounded::rounded(x, self.roundoff)
    }

    /// A direction of length 1, in the numbers of the renderer.
    pub(crate) fn unit(&self, v: Triple) -> Triple {
        unit(v).map(|c| self.rounded(c))
    }

    /// N or V: of any length, or of length 1 if the renderer needs that.
    pub(crate) fn direction(&self, v: Triple) -> Triple {
        if self.unit_vectors { self.unit(v) } else { v }
    }
}

/// An integer vector that is not 0.
fn integers() -> BoxedStrategy<Integers> {
    let component = || prop_oneof![3 => -4..=4, 1 => -60..=60];
    let integers = [component(), component(), component()];
    let integers = integers.prop_map(|v| if v == [0; 3] { [0, 0, 1] } else { v });
    integers.boxed() // otherwise all of a scene's alternatives overflow the stack of a test
}

fn way() -> BoxedStrategy<Way> {
    prop_oneof![
        10 => integers().prop_map(Way::InFront),
        4 => integers().prop_map(Way::Anywhere),
        1 => integers().prop_map(Way::Perpendicular),
        1 => Just(Way::Along),
        1 => Just(Way::Against),
    ]
    .boxed()
}

/// A multiple of 1/8 from 0 to `most`.
fn eighths(most: i32) -> impl Strategy<Value = f64> {
    (0..=8 * most).prop_map(|i| f64::from(i) / 8.0)
}

fn color(most: i32) -> impl Strategy<Value = Triple> {
    [eighths(most), eighths(most), eighths(most)]
}

#[derive(Clone, Debug)]
struct Lamp {
    kind: usize,
    way: Way,
    distance: f64,
    intensity: Triple,
    attenuation: Triple,
    aim: Integers,
    degrees: i32,
}

fn lamp(most_bright: i32) -> impl Strategy<Value = Lamp> {
    let attenuation = (select(vec![1.0, 0.5, 2.0]), eighths(1), eighths(1));
    (
        0..3_usize,
        way(),
        select(vec![1.0, 2.0, 0.5, 4.0]),
        color(most_bright),
        attenuation,
        [-2..=2, -2..=2, -2..=2],
        5..=90,
    )
        .prop_map(
            |(kind, way, distance, intensity, (a, b, c), aim, degrees)| Lamp {
                kind,
                way,
                distance,
                intensity,
                attenuation: [a, b, c],
                aim,
                degrees,
            },
        )
}

impl Lamp {
    fn at(&self, profile: &Profile, p: Triple, n: Integers) -> Light {
        let way = vector(self.way.of(n, n));
        let intensity = self.intensity;
        let attenuation = self.attenuation;
        let position = from_fn(|i| p[i] + self.distance * way[i]);
        let kinds = [
            profile.directional_lights,
            profile.point_lights,
            profile.spot_lights,
        ];
        let kind = (self.kind..self.kind + 3).find(|kind| kinds[kind % 3]);
        match kind.unwrap_or(0) % 3 {
            0 => Light::Directional {
                l: profile.unit(way),
                intensity,
            },
            1 => Light::Point {
                position,
                intensity,
                attenuation,
            },
            _ => {
                // aimed at about the point, so that its cone decides often
                let aim: Triple = from_fn(|i| f64::from(self.aim[i]) / 4.0 - way[i]);
                let aim = if aim == [0.0; 3] { way } else { aim };
                Light::Spot {
                    position,
                    intensity,
                    attenuation,
                    axis: profile.unit(aim),
                    half_angle: profile.rounded(f64::from(self.degrees).to_radians()),
                }
            }
        }
    }
}

fn material(profile: &Profile) -> impl Strategy<Value = Material> + use<> {
    let (most, is_integer) = (profile.most_shiny, profile.integer_shininess);
    #[allow(clippy::cast_possible_truncation)] // the limit is small
    let quarters = (4.0 * most.min(1000.0)) as i32;
    let m = prop_oneof![1 => 4..=4 * 10, 1 => 4..=quarters.max(4)].prop_map(move |quarters| {
        let m = f64::from(quarters) / 4.0;
        let m = if is_integer { m.floor() } else { m };
        m.min(most).max(1.0)
    });
    (color(1), color(1), color(1), m).prop_map(|(k_a, k_d, k_s, m)| Material { k_a, k_d, k_s, m })
}

pub fn base(profile: &Profile) -> impl Strategy<Value = Base> + use<> {
    let profile = profile.clone();
    // light that a clamped color mostly has room for
    let bright = if profile.range().is_some() { 1 } else { 2 };
    let eye = prop_oneof![4 => way(), 1 => Just(Way::Mirrored)];
    let quarters = || (-8..=8).prop_map(|i| f64::from(i) / 4.0);
    (
        select(profile.models.clone()),
        [quarters(), quarters(), quarters()],
        integers(),
        (eye, select(vec![1.0, 2.0, 0.25, 8.0])),
        material(&profile),
        color(bright),
        vec(lamp(bright), 0..=profile.most_lights.min(4)),
        [way(), way(), way()],
        [1..=8, 1..=8, 1..=8],
    )
        .prop_map(
            move |(model, p, n, (eye, far), material, i_a, lamps, ways, factors)| {
                let first = lamps.first().map_or(n, |lamp| lamp.way.of(n, n));
                let v = vector(eye.of(n, first)).map(|c| c * far);
                let lights = lamps.iter().map(|lamp| lamp.at(&profile, p, n));
                let scene = Scene {
                    model,
                    p,
                    n: profile.direction(vector(n).map(|c| c / 2.0)),
                    v: profile.direction(v),
                    material,
                    i_a: if profile.ambient { i_a } else { [0.0; 3] },
                    lights: lights.collect(),
                };
                Base {
                    scene,
                    ways: ways.map(|way| vector(way.of(n, n))),
                    factors: factors.map(f64::from),
                }
            },
        )
}
