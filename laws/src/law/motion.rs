//! Laws about moving everything.

use std::array::from_fn;

use crate::claim::{Claim, Group};
use crate::generator::Base;
use crate::law::part::pair;
use crate::profile::Profile;
use crate::scene::{Light, Scene, Triple};

/// The same scene with its points and directions changed.
fn moved(
    scene: &Scene,
    point: impl Fn(Triple) -> Triple,
    direction: impl Fn(Triple) -> Triple,
) -> Scene {
    let mut scene = scene.clone();
    scene.p = point(scene.p);
    scene.n = direction(scene.n);
    scene.v = direction(scene.v);
    for light in &mut scene.lights {
        match light {
            Light::Directional { l, .. } => *l = direction(*l),
            Light::Point { position, .. } => *position = point(*position),
            Light::Spot { position, axis, .. } => {
                *position = point(*position);
                *axis = direction(*axis);
            }
        }
    }
    scene
}

pub fn unit_of_length(base: Base, _: &Profile) -> Option<Group> {
    // a power of two, so that the numbers stay exact
    let unit = (base.factors[0] - 4.0).exp2();
    let mut other = moved(&base.scene, |p| p.map(|c| c * unit), |d| d);
    for light in &mut other.lights {
        if let Some((_, attenuation)) = light.lamp_mut() {
            let [a, b, c] = *attenuation;
            *attenuation = [a, b / unit, c / (unit * unit)];
        }
    }
    Some(pair(
        base.scene,
        other,
        Claim::same("both colors are the same"),
    ))
}

pub fn translation(base: Base, profile: &Profile) -> Option<Group> {
    let offset = base.factors.map(|c| c - 4.0);
    let add = |p: Triple| from_fn(|i| p[i] + offset[i]);
    let other = moved(&base.scene, add, |d| d);
    // long numbers would be others after the sum
    let same = |p: Triple, moved: Triple| {
        (0..3).all(|i| moved[i] - offset[i] == p[i] && profile.rounded(moved[i]) == moved[i])
    };
    let place = |light: &Light| Some(light.lamp()?.0);
    let lamps = base.scene.lights.iter().zip(&other.lights);
    let mut places = lamps.filter_map(|(light, moved)| Some((place(light)?, place(moved)?)));
    if !same(base.scene.p, other.p) || !places.all(|(p, moved)| same(p, moved)) {
        return None;
    }
    Some(pair(
        base.scene,
        other,
        Claim::same("both colors are the same"),
    ))
}

pub fn rotation(base: Base, _: &Profile) -> Option<Group> {
    // one of the 24 rotations of the cube, which are exact
    let [first, second, third] = base.factors;
    let turn = |v: Triple| [v[0], -v[2], v[1]]; // by 90° about x
    let cycle = |v: Triple| [v[2], v[0], v[1]]; // by 120° about the diagonal
    let turns = move |mut v: Triple| {
        for (rotate, times) in [
            (&turn as &dyn Fn(Triple) -> Triple, first),
            (&cycle, second),
            (&turn, third),
        ] {
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // 1 to 8
            for _ in 0..times as u32 {
                v = rotate(v);
            }
        }
        v
    };
    let other = moved(&base.scene, turns, turns);
    Some(pair(
        base.scene,
        other,
        Claim::same("both colors are the same"),
    ))
}
