//! Simpler cases near a case: what a failing one is made smaller by.

use crate::bounded::rounded;
use crate::edit::KNOBS;
use crate::generator::Case;
use crate::profile::{MOST_SHINY, Profile};
use crate::scene::{Light, Model, Scene, Triple, add, size, sub};

/// What three numbers of a case are.
#[derive(Clone, Copy, PartialEq)]
enum Sort {
    Any,
    /// Of length 1, or of any where the renderer has it.
    Unit,
    Direction,
    /// A position, seen from the point.
    Lamp,
}

/// The triples of a case, each with its sort. Positions are relative to the point.
fn triples(case: &mut Case) -> Vec<(Sort, &mut Triple)> {
    let (scene, ways, factors) = (&mut case.scene, &mut case.ways, &mut case.factors);
    let lamp = |color, position, attenuation| {
        [
            (Sort::Any, color),
            (Sort::Lamp, position),
            (Sort::Any, attenuation),
        ]
    };
    let mut all = vec![
        (Sort::Any, &mut scene.p),
        (Sort::Direction, &mut scene.n),
        (Sort::Direction, &mut scene.v),
        (Sort::Any, &mut scene.k_a),
        (Sort::Any, &mut scene.k_d),
        (Sort::Any, &mut scene.k_s),
        (Sort::Any, &mut scene.i_a),
        (Sort::Any, factors),
    ];
    all.extend(ways.iter_mut().map(|way| (Sort::Direction, way)));
    for light in &mut scene.lights {
        match light {
            Light::Directional { intensity, l } => {
                all.extend([(Sort::Any, intensity), (Sort::Unit, l)]);
            }
            Light::Point {
                intensity: color,
                position,
                attenuation,
            } => all.extend(lamp(color, position, attenuation)),
            Light::Spot {
                intensity: color,
                position,
                attenuation,
                axis,
                ..
            } => {
                all.extend(lamp(color, position, attenuation));
                all.push((Sort::Unit, axis));
            }
        }
    }
    all
}

/// How much there is to read in a case.
pub fn cost(case: &Case) -> u32 {
    let scene = &case.scene;
    let of_light = |light: &Light| match *light {
        Light::Directional { .. } => 200,
        Light::Point { .. } => 240,
        Light::Spot { half_angle, .. } => 280 + of_number(half_angle),
    };
    let model = [0, 2, 1][scene.model as usize];
    let lights: u32 = scene.lights.iter().map(of_light).sum();
    let mut case = case.clone();
    let triples = triples(&mut case)
        .into_iter()
        .flat_map(|(_, triple)| *triple);
    model + lights + of_number(scene.m) + triples.map(of_number).sum::<u32>()
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

/// Simpler cases, the simplest first.
pub fn simpler(case: &Case, profile: &Profile) -> Vec<Case> {
    let mut found = Vec::new();
    let mut of_scene = |edit: &dyn Fn(&mut Scene)| {
        let mut case = case.clone();
        edit(&mut case.scene);
        found.push(case);
    };
    for knob in KNOBS {
        of_scene(&|scene| (knob.edit)(scene, profile));
    }
    for model in Model::ALL {
        of_scene(&|scene| scene.model = model);
    }
    let m = case.scene.m;
    for m in [
        1.0,
        2.0,
        8.0,
        32.0,
        128.0,
        m.round(),
        (m * 4.0).round() / 4.0,
    ] {
        of_scene(&|scene| scene.m = m);
    }
    // all but one of the terms at once
    for keep in 0..3 {
        of_scene(&|scene| {
            let terms = [&mut scene.k_a, &mut scene.k_d, &mut scene.k_s];
            for (_, k) in terms.into_iter().enumerate().filter(|(i, _)| *i != keep) {
                *k = [0.0; 3];
            }
            if keep > 0 {
                scene.i_a = [0.0; 3];
            }
        });
    }
    let count = case.scene.lights.len();
    of_scene(&|scene| scene.lights.truncate(count.div_ceil(2)));
    of_scene(&|scene| drop(scene.lights.drain(..count / 2)));
    for i in 0..count.min(32) {
        of_scene(&|scene| {
            scene.lights.remove(i);
        });
        of_scene(&|scene| scene.lights = vec![scene.lights[i]]);
        of_scene(&|scene| scene.lights[i] = demoted(scene.lights[i], scene.p, profile));
        let Light::Spot { half_angle, .. } = case.scene.lights[i] else {
            continue;
        };
        let degrees = half_angle.to_degrees().round().to_radians();
        for angle in [0.5, 1.0, 0.25, 1.5, profile.rounded(degrees)] {
            of_scene(&|scene| {
                if let Light::Spot { half_angle, .. } = &mut scene.lights[i] {
                    *half_angle = angle;
                }
            });
        }
    }
    let p = case.scene.p;
    for i in 0..triples(&mut case.clone()).len().min(40) {
        let mut edited = case.clone();
        let (sort, old) = triples(&mut edited).swap_remove(i);
        let old = *old;
        let old = if sort == Sort::Lamp { sub(old, p) } else { old };
        for new in shorter(old) {
            let new = match sort {
                Sort::Unit if new != [0.0; 3] => profile.unit(new),
                Sort::Direction if new != [0.0; 3] => profile.direction(new),
                Sort::Lamp => add(new, p),
                _ => new,
            };
            let mut edited = case.clone();
            *triples(&mut edited).swap_remove(i).1 = new;
            found.push(edited);
        }
    }
    let limit = cost(case);
    let mut found: Vec<(u32, Case)> = found
        .into_iter()
        .map(|case| (cost(&case), case))
        .filter(|(cost, case)| *cost < limit && is_valid(case, profile))
        .collect();
    found.sort_by_key(|(cost, _)| *cost);
    found.dedup_by(|a, b| a.1 == b.1);
    found.into_iter().map(|(_, case)| case).collect()
}

/// A simpler light from the same direction.
fn demoted(light: Light, p: Triple, profile: &Profile) -> Light {
    match light {
        Light::Spot { .. } => light.without_cone(),
        Light::Point {
            intensity,
            position,
            ..
        } => Light::Directional {
            intensity,
            l: profile.unit(sub(position, p)),
        },
        Light::Directional { .. } => light,
    }
}

/// Simple values, and shorter ones near the old, all at once and each alone.
fn shorter(old: Triple) -> Vec<Triple> {
    let mut found = vec![[0.0; 3], [1.0; 3], [0.5; 3]];
    for axis in 0..3 {
        let sizes = [
            1.0,
            -1.0,
            0.5,
            2.0,
            4.0,
            1024.0,
            16384.0,
            1.0 / 128.0,
            old[axis],
        ];
        found.extend(sizes.map(|c| with([0.0; 3], axis, c)));
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

fn with(mut v: Triple, i: usize, c: f64) -> Triple {
    v[i] = c;
    v
}

/// Whether the case is one of those that the format allows, of a renderer like this.
pub fn is_valid(case: &Case, profile: &Profile) -> bool {
    let scene = &case.scene;
    let has = |triple: Triple| triple != [0.0; 3];
    let is_lit = |light: &Light| {
        let is_attenuated = light.lamp().is_none_or(|(_, abc)| {
            abc.iter().sum::<f64>() > 0.0
                && abc.iter().all(|c| *c >= 0.0)
                && (!profile.unattenuated || abc == [1.0, 0.0, 0.0])
        });
        let is_aimed = match *light {
            Light::Directional { l, .. } => has(l),
            Light::Point { .. } => true,
            Light::Spot { axis, .. } => has(axis),
        };
        is_attenuated && is_aimed && profile.has(light.kind())
    };
    let is_lost = |light| scene.has_lamp_at_the_point(light, profile.roundoff);
    // a lamp at the origin divides by 0 where p is forgotten
    let is_at_origin = |light: &Light| light.lamp().is_some_and(|(position, _)| !has(position));
    let colors = [scene.k_a, scene.k_d, scene.k_s, scene.i_a];
    let lights = scene.lights.iter();
    let mut colors = colors
        .into_iter()
        .chain(lights.map(|light| light.intensity()))
        .flatten();
    has(scene.n)
        && has(scene.v)
        && case.ways.into_iter().all(has)
        && case
            .factors
            .iter()
            .all(|factor| (1.0..=8.0).contains(factor))
        && colors.all(|c| (0.0..=16.0).contains(&c))
        && (!profile.gray_highlight || scene.k_s == [scene.k_s[0]; 3])
        && profile.models.contains(&scene.model)
        && scene.lights.len() <= profile.most_lights
        && (1.0..=profile.most_shiny.min(MOST_SHINY)).contains(&scene.m)
        && (!profile.integer_shininess || scene.m.fract() == 0.0)
        && scene.lights.iter().all(is_lit)
        && !scene
            .lights
            .iter()
            .any(|light| is_lost(light) || is_at_origin(light))
}
