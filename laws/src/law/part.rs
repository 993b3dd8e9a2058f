//! Parts of the scenes of laws.

use std::array::from_fn;

use crate::claim::{Claim, Group};
use crate::profile::Profile;
use crate::scene::{Light, Scene, Triple};

pub fn pair(first: Scene, second: Scene, claim: Claim) -> Group {
    Group {
        scenes: vec![first, second],
        claims: vec![claim],
    }
}

/// A light from this direction that is not attenuated.
pub fn lamp(profile: &Profile, p: Triple, way: Triple, intensity: Triple) -> Light {
    let position = from_fn(|i| p[i] + way[i]);
    let attenuation = [1.0, 0.0, 0.0];
    if profile.directional_lights {
        Light::Directional {
            l: profile.unit(way),
            intensity,
        }
    } else if profile.point_lights {
        Light::Point {
            position,
            intensity,
            attenuation,
        }
    } else {
        Light::Spot {
            position,
            intensity,
            attenuation,
            axis: profile.unit(way.map(|c| -c)),
            half_angle: profile.rounded(1.0),
        }
    }
}

/// The scene with N on the side of the eye, where the renderer turns it there.
pub fn facing(mut scene: Scene, profile: &Profile) -> Scene {
    if profile.normal_faces_eye && dot(scene.n, scene.v) < 0.0 {
        scene.n = scene.n.map(|c| -c);
    }
    scene
}

/// Nothing if the scene is beyond what the renderer has.
pub fn fits(scene: &Scene, profile: &Profile) -> Option<()> {
    let fits = scene.lights.len() <= profile.most_lights && scene.material.m <= profile.most_shiny;
    fits.then_some(())
}

pub fn dot(a: Triple, b: Triple) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn times(a: Triple, b: Triple) -> Triple {
    from_fn(|i| a[i] * b[i])
}
