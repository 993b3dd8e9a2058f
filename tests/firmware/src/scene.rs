//! A scene as firmware stores it: constants in flash.

use shading::{
    Attenuation, Cone, DirectionalLight, Light, Material, PointLight, Rgb, SpotLight, UnitVec3,
    Vec3,
};

/// The ambient light.
pub static AMBIENT: Rgb<f32> = Rgb::new(0.125, 0.125, 0.1875);

/// A material that reflects light in every channel, with a shininess of `m`.
#[must_use]
pub const fn brass<M: Copy>(m: M) -> Material<f32, M> {
    Material {
        k_a: Rgb::new(0.33, 0.22, 0.03),
        k_d: Rgb::new(0.78, 0.57, 0.11),
        k_s: Rgb::new(0.99, 0.94, 0.81),
        m,
    }
}

/// One light of each kind, and one whose attenuation is clamped.
pub static LIGHTS: [Light<f32>; 4] = [
    Light::Directional(DirectionalLight {
        l: UnitVec3::<f32>::new(0.48, 0.6, 0.64).unwrap(),
        intensity: Rgb::new(0.9, 0.85, 0.7),
    }),
    Light::Point(PointLight {
        position: Vec3::new(2.0, 1.5, 3.0),
        intensity: Rgb::new(1.0, 0.5, 0.25),
        attenuation: Attenuation::<f32>::new(1.0, 0.1, 0.05).unwrap(),
    }),
    Light::Spot(SpotLight {
        point: PointLight {
            position: Vec3::new(-1.0, 4.0, 2.0),
            intensity: Rgb::new(4.0, 4.0, 6.0),
            attenuation: Attenuation::<f32>::new(0.0, 0.0, 1.0).unwrap(),
        },
        axis: UnitVec3::<f32>::new(0.0, -0.8, -0.6).unwrap(),
        cone: Cone::<f32>::from_half_angle(0.9).unwrap(),
    }),
    Light::Point(PointLight {
        position: Vec3::new(0.5, -3.0, 1.0),
        intensity: Rgb::new(0.3, 0.6, 0.9),
        attenuation: Attenuation::<f32>::new(0.0, 0.25, 0.5).unwrap().clamped(),
    }),
];

/// Four point lights with attenuation, all of which light every point of [`CAP`].
pub static LAMPS: [PointLight<f32>; 4] = [
    lamp(3.0, 1.0, 4.0),
    lamp(-2.0, 2.0, 5.0),
    lamp(1.0, -3.0, 4.0),
    lamp(-1.0, -1.0, 6.0),
];

const fn lamp(x: f32, y: f32, z: f32) -> PointLight<f32> {
    PointLight {
        position: Vec3::new(x, y, z),
        intensity: Rgb::new(1.0, 0.75, 0.5),
        attenuation: Attenuation::<f32>::new(1.0, 0.125, 0.0625).unwrap(),
    }
}

/// Eight points of the unit sphere, each of which is its own normal, around the pole that faces the
/// [`LAMPS`] and the eye at (0, 0, ∞).
pub static CAP: [UnitVec3<f32>; 8] = [
    UnitVec3::<f32>::new(0.0, 0.0, 1.0).unwrap(),
    UnitVec3::<f32>::new(0.28, 0.0, 0.96).unwrap(),
    UnitVec3::<f32>::new(-0.28, 0.0, 0.96).unwrap(),
    UnitVec3::<f32>::new(0.0, 0.28, 0.96).unwrap(),
    UnitVec3::<f32>::new(0.0, -0.28, 0.96).unwrap(),
    UnitVec3::<f32>::new(0.168, 0.224, 0.96).unwrap(),
    UnitVec3::<f32>::new(-0.224, 0.168, 0.96).unwrap(),
    UnitVec3::<f32>::new(0.224, -0.168, 0.96).unwrap(),
];
