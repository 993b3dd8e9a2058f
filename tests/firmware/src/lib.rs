//! What the firmware programs share: the board, a scene in flash, and the digest of every function.
#![no_std]

#[cfg(feature = "ball")]
pub mod ball;
#[cfg(target_os = "none")]
pub mod board;

use kit::digest::{Fnv, Function, Of};
use kit::places::places;
use kit::{Float, Number};
use shading::f32::{Attenuation, Cone, DirectionalLight, Light, PointLight, Rgb, SpotLight};
use shading::f32::{UnitVec3, Vec3};
use shading::fixed::Fixed;
use shading::{Material, Real};

/// Absorbs all functions of some sections of the table at every third place, which are places of each
/// kind: an emulated chip without an FPU is slow.
pub fn absorb_all<T: Number, const N: usize>(sections: [&[Function<T>]; N], digest: &mut Fnv) {
    for given in places().step_by(3) {
        for (_, absorb_results) in sections.into_iter().flatten() {
            absorb_results(&given, digest);
        }
    }
}

/// The digest of every function of a float.
pub fn digest<T: Float>() -> u64 {
    let mut digest = Fnv::EMPTY;
    absorb_all(Of::<T>::OF_NUMBERS, &mut digest);
    absorb_all(Of::<T>::OF_FLOATS, &mut digest);
    digest.0
}

/// The digest of every function of a fixed-point number.
pub fn digest_of_fixed() -> u64 {
    let mut digest = Fnv::EMPTY;
    absorb_all(Of::<Fixed>::OF_NUMBERS, &mut digest);
    digest.0
}

pub static AMBIENT: Rgb = Rgb::new(0.125, 0.125, 0.1875);

/// A material in any number type.
pub fn brass<T: Real, M>(m: M) -> Material<T, M> {
    let brass = Material {
        k_a: Rgb::new(0.33, 0.22, 0.03),
        k_d: Rgb::new(0.78, 0.57, 0.11),
        k_s: Rgb::new(0.99, 0.94, 0.81),
        m,
    };
    brass.cast(T::of_f32)
}

const fn lamp(x: f32, y: f32, z: f32) -> PointLight {
    PointLight {
        position: Vec3::new(x, y, z),
        intensity: Rgb::new(1.0, 0.75, 0.5),
        attenuation: Attenuation::const_new(1.0, 0.125, 0.0625).unwrap(),
    }
}

/// Four lamps, all of which light every point of [`CAP`].
pub static LAMPS: [PointLight; 4] = [
    lamp(3.0, 1.0, 4.0),
    lamp(-2.0, 2.0, 5.0),
    lamp(1.0, -3.0, 4.0),
    lamp(-1.0, -1.0, 6.0),
];

/// Points of the unit sphere, each of which is its own normal.
pub static CAP: [UnitVec3; 4] = [
    UnitVec3::Z,
    UnitVec3::const_new(0.28, 0.0, 0.96).unwrap(),
    UnitVec3::const_new(-0.224, 0.168, 0.96).unwrap(),
    UnitVec3::const_new(0.168, 0.224, 0.96).unwrap(),
];

const SPOT: SpotLight = SpotLight {
    point: PointLight {
        position: Vec3::new(-1.0, 4.0, 2.0),
        intensity: Rgb::WHITE,
        attenuation: Attenuation::const_new(0.0, 0.0, 1.0).unwrap(),
    },
    axis: UnitVec3::const_new(0.0, -0.8, -0.6).unwrap(),
    cone: Cone::const_from_half_angles(0.7, 0.9).unwrap(),
};

/// A light of each kind, and lamps far away, so far away that the way to it overflows, at a point, and nowhere.
pub static LIGHTS: [Light; 7] = [
    Light::Directional(DirectionalLight {
        l: UnitVec3::const_new(0.48, 0.6, 0.64).unwrap(),
        intensity: Rgb::WHITE,
    }),
    Light::Point(lamp(2.0, 1.5, 3.0)),
    Light::Spot(SPOT),
    Light::Point(lamp(1e25, 2e25, 3e25)),
    Light::Point(lamp(f32::MAX, -f32::MAX, f32::MAX)),
    Light::Point(lamp(0.28, 0.0, 0.96)),
    Light::Point(lamp(f32::INFINITY, f32::NAN, 0.0)),
];

/// Whether two texts are the same, for what the environment chooses at build time.
pub const fn is_same(a: &[u8], b: &[u8]) -> bool {
    let mut i = 0;
    while i < a.len() && i < b.len() && a[i] == b[i] {
        i += 1;
    }
    i == a.len() && i == b.len()
}
