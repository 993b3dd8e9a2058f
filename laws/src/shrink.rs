//! Simpler scenes near a scene: what a failing case is made smaller by.

use std::slice;

use crate::bounded::rounded;
use crate::edit::EDITS;
use crate::profile::Profile;
use crate::scene::{Light, Model, Scene, Triple, size};

/// How much there is to read in a scene: zeros are nothing, and a highlight is something.
pub fn cost(scene: &Scene) -> u32 {
    let of_byte = |byte| match byte {
        b'0' => 0,
        b'1'..=b'9' => 8 + u32::from(byte - b'0'),
        _ => 4,
    };
    let shown: u32 = scene.to_json().bytes().map(of_byte).sum();
    shown + if scene.model == Model::Lambert { 0 } else { 16 }
}

/// Simpler scenes, the simplest first.
pub fn simpler(scene: &Scene, profile: &Profile) -> Vec<Scene> {
    let edited = EDITS.iter().filter_map(|edit| edit.of(scene, profile));
    let mut found: Vec<Scene> = edited.collect();
    // one light, or all but one
    for i in 0..scene.lights.len().min(32) {
        let others = [&scene.lights[..i], &scene.lights[i + 1..]].concat();
        for lights in [vec![scene.lights[i]], others] {
            let unlit = scene.clone();
            found.push(Scene { lights, ..unlit });
        }
    }
    let mut old = scene.clone();
    for (i, part) in parts(&mut old).into_iter().take(48).enumerate() {
        for new in shorter(part) {
            let mut edited = scene.clone();
            parts(&mut edited)[i].copy_from_slice(&new);
            found.push(edited);
        }
    }
    let limit = cost(scene);
    let found = found.into_iter().filter_map(|it| profile.fitted(it));
    let found = found.map(|scene| (cost(&scene), scene));
    let mut found: Vec<_> = found.filter(|(cost, _)| *cost < limit).collect();
    found.sort_by_key(|(cost, _)| *cost);
    found.dedup_by(|a, b| a.1 == b.1);
    found.into_iter().map(|(_, scene)| scene).collect()
}

/// The vectors and numbers of a scene.
fn parts(scene: &mut Scene) -> Vec<&mut [f64]> {
    let colors = [
        &mut scene.i_a,
        &mut scene.k_a,
        &mut scene.k_d,
        &mut scene.k_s,
    ];
    let mut all: Vec<&mut [f64]> = colors.map(|color| &mut color[..]).into();
    all.push(slice::from_mut(&mut scene.m));
    all.extend([&mut scene.n[..], &mut scene.p, &mut scene.v]);
    for light in &mut scene.lights {
        match light {
            Light::Directional { intensity, l } => all.extend([&mut intensity[..], l]),
            Light::Point {
                intensity,
                position,
                attenuation,
            } => all.extend([&mut attenuation[..], intensity, position]),
            Light::Spot {
                intensity,
                position,
                attenuation,
                axis,
                half_angle,
            } => {
                let half_angle = slice::from_mut(half_angle);
                all.extend([attenuation, axis, half_angle, intensity, position]);
            }
        }
    }
    all
}

/// Simpler vectors, and vectors with a simpler coordinate.
fn shorter(old: &[f64]) -> Vec<Vec<f64>> {
    let simple = Triple::try_from(old).map(|old| vectors(old).map(Vec::from).collect());
    let mut found: Vec<Vec<f64>> = simple.unwrap_or_default();
    for (i, c) in old.iter().enumerate() {
        for simple in numbers(*c) {
            let mut new = old.to_vec();
            new[i] = simple;
            found.push(new);
        }
    }
    found
}

/// Simple numbers, and the old one with fewer digits.
fn numbers(old: f64) -> Vec<f64> {
    let mut found = vec![0.0, 0.25, 0.5, 1.0, 1.5, 2.0, 8.0, 32.0, 128.0];
    found.extend([1.0, 2.0, 8.0, 256.0].map(|steps| (old * steps).round() / steps));
    // few significant bits, for numbers that are very small or large
    found.extend([1.0, 2.0, 4.0, 8.0].map(|bits: f64| rounded(old, (-bits).exp2())));
    found.into_iter().map(|c| c + 0.0).collect() // no -0
}

/// Simple vectors, and the old one along one axis or with fewer digits.
fn vectors(old: Triple) -> impl Iterator<Item = Triple> {
    let on_axes = (0..3).flat_map(move |axis| {
        let lengths = [1.0, -1.0, 2.0, 1024.0, 1.0 / 128.0, old[axis]];
        lengths.map(|c| [0, 1, 2].map(|i| if i == axis { c } else { 0.0 }))
    });
    let largest = size(old).max(f64::MIN_POSITIVE).log2().floor().exp2();
    let of_few = [1.0, 2.0, 8.0, 256.0]
        .map(|steps| old.map(|c| (c / largest * steps).round() * largest / steps));
    let simple = [[0.0; 3], [0.5; 3], [1.0; 3]].into_iter();
    let all = simple.chain(on_axes).chain(of_few);
    all.map(|v| v.map(|c| c + 0.0)) // no -0
}
