//! Laws about N, L and V.

use std::array::from_fn;

use crate::claim::{Claim, Group};
use crate::generator::Base;
use crate::law::part::{dot, facing, lamp, pair};
use crate::profile::Profile;
use crate::scene::{Model, Scene};

pub fn eye(base: Base, profile: &Profile) -> Option<Group> {
    let mut scene = base.scene;
    scene.material.k_s = [0.0; 3];
    let mut v = base.ways[0];
    if profile.normal_faces_eye {
        let sides = [scene.v, v].map(|v| dot(scene.n, v));
        if sides[0].abs() < 0.01 || sides[1].abs() < 0.01 {
            return None; // rounding decides on which side the eye is
        }
        if sides[0] * sides[1] < 0.0 {
            v = v.map(|c| -c);
        }
    }
    let other = Scene {
        v: profile.direction(v),
        ..scene.clone()
    };
    Some(pair(scene, other, Claim::same("both colors are the same")))
}

pub fn toward_the_normal(base: Base, profile: &Profile) -> Option<Group> {
    let mut scene = facing(base.scene, profile);
    let [way, ..] = base.ways;
    scene.material.k_s = [0.0; 3];
    scene.i_a = [0.0; 3];
    let tilted = from_fn(|i| way[i] + scene.n[i] * base.factors[0]);
    if tilted == [0.0; 3] {
        return None;
    }
    let other = Scene {
        lights: vec![lamp(profile, scene.p, way, [1.0; 3])],
        ..scene.clone()
    };
    scene.lights = vec![lamp(profile, scene.p, tilted, [1.0; 3])];
    Some(pair(
        scene,
        other,
        Claim::brighter("the first color, of the tilted light, is the brighter"),
    ))
}

pub fn both_reversed(base: Base, profile: &Profile) -> Option<Group> {
    let mut scene = base.scene;
    let [way, ..] = base.ways;
    scene.material.k_s = [0.0; 3];
    scene.lights = vec![lamp(profile, scene.p, way, [1.0; 3])];
    let other = Scene {
        n: scene.n.map(|c| -c),
        lights: vec![lamp(profile, scene.p, way.map(|c| -c), [1.0; 3])],
        ..scene.clone()
    };
    Some(pair(scene, other, Claim::same("both colors are the same")))
}

pub fn length_of_n(base: Base, _: &Profile) -> Option<Group> {
    let mut other = base.scene.clone();
    let factor = (base.factors[0] + 1.0) / 8.0;
    other.n = other.n.map(|c| c * factor);
    Some(pair(
        base.scene,
        other,
        Claim::same("both colors are the same"),
    ))
}

pub fn length_of_v(base: Base, _: &Profile) -> Option<Group> {
    let mut other = base.scene.clone();
    let factor = (base.factors[0] + 1.0) / 4.0;
    other.v = other.v.map(|c| c * factor);
    Some(pair(
        base.scene,
        other,
        Claim::same("both colors are the same"),
    ))
}

pub fn eye_for_light(base: Base, profile: &Profile) -> Option<Group> {
    let mut scene = base.scene;
    let [way, eye, _] = base.ways;
    let in_front = dot(way, scene.n) > 0.0 && dot(eye, scene.n) > 0.0;
    if scene.model == Model::Lambert || !in_front {
        return None;
    }
    scene.material.k_d = [0.0; 3];
    let mut other = scene.clone();
    (scene.v, scene.lights) = (
        profile.direction(eye),
        vec![lamp(profile, scene.p, way, [1.0; 3])],
    );
    (other.v, other.lights) = (
        profile.direction(way),
        vec![lamp(profile, other.p, eye, [1.0; 3])],
    );
    Some(pair(scene, other, Claim::same("both colors are the same")))
}
