//! Simpler scenes near a scene: what a failing case is made smaller by.

use crate::bounded::rounded;
use crate::edit::EDITS;
use crate::place::edited;
use crate::profile::Profile;
use crate::scene::{Light, Model, Scene, Triple, add, size, sub};

const ZERO: Triple = [0.0; 3];

/// The triples of a scene, and whether each is a position, which is made simpler as it is seen from the point.
fn triples(scene: &mut Scene) -> Vec<(bool, &mut Triple)> {
    let surface = [
        &mut scene.p,
        &mut scene.n,
        &mut scene.v,
        &mut scene.k_a,
        &mut scene.k_d,
        &mut scene.k_s,
        &mut scene.i_a,
    ];
    let mut all: Vec<_> = surface.into_iter().map(|triple| (false, triple)).collect();
    for light in &mut scene.lights {
        match light {
            Light::Directional { intensity: i, l } => all.extend([(false, i), (false, l)]),
            Light::Point {
                intensity: i,
                position,
                attenuation: abc,
            } => all.extend([(false, i), (true, position), (false, abc)]),
            Light::Spot {
                intensity: i,
                position,
                attenuation: abc,
                axis,
                ..
            } => all.extend([(false, i), (true, position), (false, abc), (false, axis)]),
        }
    }
    all
}

/// The scene with directions of the length that the renderer needs.
fn directed(mut scene: Scene, profile: &Profile) -> Scene {
    let unit = |v: &mut Triple| {
        if *v != ZERO {
            *v = profile.unit(*v);
        }
    };
    if profile.unit_vectors {
        unit(&mut scene.n);
        unit(&mut scene.v);
    }
    for light in &mut scene.lights {
        match light {
            Light::Directional { l: axis, .. } | Light::Spot { axis, .. } => unit(axis),
            Light::Point { .. } => {}
        }
    }
    scene
}

/// How much there is to read in a scene.
pub fn cost(scene: &Scene) -> u32 {
    let of_light = |light: &Light| match *light {
        Light::Directional { .. } => 200,
        Light::Point { .. } => 240,
        Light::Spot { half_angle, .. } => 280 + of_number(half_angle),
    };
    let model = [0, 2, 1][scene.model as usize];
    let lights: u32 = scene.lights.iter().map(of_light).sum();
    let mut scene = scene.clone();
    let m = of_number(scene.m);
    let numbers = triples(&mut scene).into_iter().flat_map(|(_, of)| *of);
    model + lights + m + numbers.map(of_number).sum::<u32>()
}

/// The bits of a number, and the zeros on its other side of the point.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // exponents are small
fn of_number(x: f64) -> u32 {
    if x == 0.0 {
        return 0;
    }
    let bits = 53 - (x.to_bits() | 1 << 52).trailing_zeros().min(52);
    let exponent = x.abs().log2().floor().abs() as u32;
    u32::from(x < 0.0) + 2 * bits + exponent
}

/// Simpler scenes, the simplest first.
pub fn simpler(scene: &Scene, profile: &Profile) -> Vec<Scene> {
    let without = EDITS.iter().filter_map(|edit| edited(edit, scene, profile));
    let mut found: Vec<Scene> = without.collect();
    let mut of_scene = |edit: &dyn Fn(&mut Scene)| {
        let mut scene = scene.clone();
        edit(&mut scene);
        found.push(scene);
    };
    for model in Model::ALL {
        of_scene(&|scene| scene.model = model);
    }
    let m = scene.m;
    let whole = [m.round(), (m * 4.0).round() / 4.0];
    for m in [1.0, 2.0, 8.0, 32.0, 128.0].into_iter().chain(whole) {
        of_scene(&|scene| scene.m = m);
    }
    // all but one of the terms at once
    for keep in 0..3 {
        of_scene(&|scene| {
            let terms = [&mut scene.k_a, &mut scene.k_d, &mut scene.k_s];
            for (_, k) in terms.into_iter().enumerate().filter(|(i, _)| *i != keep) {
                *k = ZERO;
            }
            if keep > 0 {
                scene.i_a = ZERO;
            }
        });
    }
    let count = scene.lights.len();
    of_scene(&|scene| scene.lights.truncate(count.div_ceil(2)));
    of_scene(&|scene| drop(scene.lights.drain(..count / 2)));
    for i in 0..count.min(32) {
        of_scene(&|scene| _ = scene.lights.remove(i));
        of_scene(&|scene| scene.lights = vec![scene.lights[i]]);
        of_scene(&|scene| scene.lights[i] = demoted(scene.lights[i], scene.p));
        if let Light::Spot { half_angle, .. } = scene.lights[i] {
            let degrees = half_angle.to_degrees().round().to_radians();
            for angle in [0.5, 1.0, 0.25, 1.5, profile.rounded(degrees)] {
                of_scene(&|scene| {
                    if let Light::Spot { half_angle, .. } = &mut scene.lights[i] {
                        *half_angle = angle;
                    }
                });
            }
        }
    }
    let mut old = scene.clone();
    let old = triples(&mut old).into_iter().take(40);
    for (i, (is_position, old)) in old.enumerate() {
        let origin = if is_position { scene.p } else { ZERO };
        for new in shorter(sub(*old, origin)) {
            let mut edited = scene.clone();
            *triples(&mut edited).swap_remove(i).1 = add(new, origin);
            found.push(edited);
        }
    }
    let limit = cost(scene);
    let found = found.into_iter().map(|scene| directed(scene, profile));
    let found = found.map(|scene| (cost(&scene), scene));
    let is_simpler = |(cost, scene): &(u32, Scene)| *cost < limit && profile.lacks(scene).is_none();
    let mut found: Vec<_> = found.filter(is_simpler).collect();
    found.sort_by_key(|(cost, _)| *cost);
    found.dedup_by(|a, b| a.1 == b.1);
    found.into_iter().map(|(_, scene)| scene).collect()
}

/// A simpler light from the same direction.
fn demoted(light: Light, p: Triple) -> Light {
    match light {
        Light::Point {
            intensity,
            position,
            ..
        } => Light::Directional {
            intensity,
            l: sub(position, p),
        },
        other => other.without_cone(),
    }
}

/// Simple values, and shorter ones near the old, all at once and each alone.
fn shorter(old: Triple) -> Vec<Triple> {
    let with = |mut v: Triple, i: usize, c: f64| {
        v[i] = c;
        v
    };
    let mut found = vec![ZERO, [1.0; 3], [0.5; 3]];
    for axis in 0..3 {
        let sizes = [1.0, -1.0, 0.5, 2.0, 4.0, 1024.0, 16384.0, 1.0 / 128.0];
        let sizes = sizes.into_iter().chain([old[axis]]);
        found.extend(sizes.map(|c| with(ZERO, axis, c)));
        found.extend([0.0, 1.0, 2.0].map(|c| with(old, axis, c)));
    }
    let largest = size(old).max(f64::MIN_POSITIVE);
    for unit in [1.0, largest.log2().floor().exp2()] {
        for steps in [1.0, 2.0, 8.0, 256.0] {
            let short = old.map(|c| (c / unit * steps).round() / steps);
            found.push(short);
            found.extend([0, 1, 2].map(|i| with(old, i, short[i])));
        }
    }
    // few significant bits, for numbers that are very small or large
    found.extend([1.0, 2.0, 4.0].map(|bits: f64| old.map(|c| rounded(c, (-bits).exp2()))));
    found.into_iter().map(|v| v.map(|c| c + 0.0)).collect() // no -0
}
