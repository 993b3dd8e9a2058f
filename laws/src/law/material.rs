//! Laws about the colors of lights and materials.

use crate::claim::{Claim, Group, Relation, Term};
use crate::generator::Base;
use crate::law::part::{fits, pair};
use crate::profile::Profile;
use crate::scene::{Material, Model, Scene, Triple};

pub fn scale(base: Base, profile: &Profile) -> Option<Group> {
    let factor = match profile.range() {
        Some(_) => 0.5, // twice as much would often be clamped
        None => base.factors[0],
    };
    let mut other = base.scene.clone();
    other.i_a = other.i_a.map(|c| c * factor);
    for light in &mut other.lights {
        *light = light.with_intensity(light.intensity().map(|c| c * factor));
    }
    let says = "the color of the second scene is the factor of its light times that of the first";
    let claim = Claim::new(says, Relation::Zero, &[(factor, 0), (-1.0, 1)]);
    Some(pair(base.scene, other, claim))
}

pub fn terms(base: Base, profile: &Profile) -> Option<Group> {
    let mut scene = base.scene;
    if profile.ambient_times_diffuse {
        scene.i_a = [0.0; 3];
    }
    let black = [0.0; 3];
    let with = |k_a, k_d, k_s| Scene {
        material: Material {
            k_a,
            k_d,
            k_s,
            ..scene.material
        },
        ..scene.clone()
    };
    let Material { k_a, k_d, k_s, .. } = scene.material;
    let scenes = vec![
        scene.clone(),
        with(k_a, black, black),
        with(black, k_d, black),
        with(black, black, k_s),
    ];
    let says = "the first color is the sum of those with only k_a, only k_d and only k_s";
    let claim = Claim::new(
        says,
        Relation::Zero,
        &[(1.0, 0), (-1.0, 1), (-1.0, 2), (-1.0, 3)],
    );
    Some(Group {
        scenes,
        claims: vec![claim],
    })
}

pub fn shininess(base: Base, profile: &Profile) -> Option<Group> {
    let mut scene = base.scene;
    if scene.model == Model::Lambert {
        return None;
    }
    scene.material.k_d = [0.0; 3];
    scene.i_a = [0.0; 3];
    let mut other = scene.clone();
    other.material.m += base.factors[0];
    fits(&other, profile)?;
    Some(pair(
        scene,
        other,
        Claim::brighter("the first color, of the lower shininess, is the brighter"),
    ))
}

pub fn channels_alike(base: Base, _: &Profile) -> Option<Group> {
    let shifted = |c: Triple| [c[2], c[0], c[1]];
    let mut other = map_colors(&base.scene, shifted);
    other.i_a = shifted(other.i_a);
    let mut claim =
        Claim::same("the second color has the channels of the first, each one place on");
    claim.terms[1] = Term {
        shift: 1,
        ..claim.terms[1]
    };
    Some(pair(base.scene, other, claim))
}

pub fn channels_apart(base: Base, profile: &Profile) -> Option<Group> {
    // a surface and lights that are not red
    let without = |c: Triple| [0.0, c[1], c[2]];
    let mut other = map_colors(&base.scene, without);
    other.i_a = without(other.i_a);
    if profile.gray_highlight {
        other.material.k_s = base.scene.material.k_s;
    }
    let mut claim = Claim::same("green and blue are the same");
    claim.channels = [false, true, true];
    Some(pair(base.scene, other, claim))
}

fn map_colors(scene: &Scene, f: impl Fn(Triple) -> Triple) -> Scene {
    let mut scene = scene.clone();
    let Material { k_a, k_d, k_s, m } = scene.material;
    scene.material = Material {
        k_a: f(k_a),
        k_d: f(k_d),
        k_s: f(k_s),
        m,
    };
    for light in &mut scene.lights {
        *light = light.with_intensity(f(light.intensity()));
    }
    scene
}
