//! Simpler cases near a case: what a failing one is made smaller by.

use crate::bounded::rounded;
use crate::edit::KNOBS;
use crate::generator::Case;
use crate::profile::Profile;
use crate::scene::{Light, Model, Scene, Triple, add, size, sub};

const ZERO: Triple = [0.0; 3];

/// The triples of a case, and whether each is a position, which is made simpler as it is seen from the point.
fn triples(case: &mut Case) -> Vec<(bool, &mut Triple)> {
    let scene = &mut case.scene;
    let colors = [
        &mut scene.k_a,
        &mut scene.k_d,
        &mut scene.k_s,
        &mut scene.i_a,
    ];
    let places = [&mut scene.p, &mut scene.n, &mut scene.v, &mut case.factors];
    let all = places.into_iter().chain(colors).chain(&mut case.ways);
    let mut all: Vec<_> = all.map(|triple| (false, triple)).collect();
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

/// The case with directions of the length that the renderer needs.
fn directed(mut case: Case, profile: &Profile) -> Case {
    let unit = |v: &mut Triple| {
        if *v != ZERO {
            *v = profile.unit(*v);
        }
    };
    let scene = &mut case.scene;
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
    case
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
    let numbers = triples(&mut case).into_iter().flat_map(|(_, of)| *of);
    model + lights + of_number(scene.m) + numbers.map(of_number).sum::<u32>()
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
    let count = case.scene.lights.len();
    of_scene(&|scene| scene.lights.truncate(count.div_ceil(2)));
    of_scene(&|scene| drop(scene.lights.drain(..count / 2)));
    for i in 0..count.min(32) {
        of_scene(&|scene| _ = scene.lights.remove(i));
        of_scene(&|scene| scene.lights = vec![scene.lights[i]]);
        of_scene(&|scene| scene.lights[i] = demoted(scene.lights[i], scene.p));
        if let Light::Spot { half_angle, .. } = case.scene.lights[i] {
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
    let mut old = case.clone();
    let old = triples(&mut old).into_iter().take(40);
    for (i, (is_position, old)) in old.enumerate() {
        let origin = if is_position { case.scene.p } else { ZERO };
        for new in shorter(sub(*old, origin)) {
            let mut edited = case.clone();
            *triples(&mut edited).swap_remove(i).1 = add(new, origin);
            found.push(edited);
        }
    }
    let limit = cost(case);
    let found = found.into_iter().map(|case| directed(case, profile));
    let found = found.map(|case| (cost(&case), case));
    let is_simpler = |(cost, case): &(u32, Case)| *cost < limit && is_valid(case, profile);
    let mut found: Vec<_> = found.filter(is_simpler).collect();
    found.sort_by_key(|(cost, _)| *cost);
    found.dedup_by(|a, b| a.1 == b.1);
    found.into_iter().map(|(_, case)| case).collect()
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

/// Whether the case is one of those that the format allows, of a renderer like this.
pub fn is_valid(case: &Case, profile: &Profile) -> bool {
    let scene = &case.scene;
    let is_lit = |light: &Light| {
        let is_attenuated = light.lamp().is_none_or(|(position, abc)| {
            abc.iter().sum::<f64>() > 0.0
                && abc.iter().all(|c| *c >= 0.0)
                && (!profile.unattenuated || abc == [1.0, 0.0, 0.0])
                && position != ZERO // a lamp at the origin divides by 0 where p is forgotten
        });
        let is_aimed = match *light {
            Light::Directional { l: axis, .. } | Light::Spot { axis, .. } => axis != ZERO,
            Light::Point { .. } => true,
        };
        let is_lost = scene.has_lamp_at_the_point(light, profile.roundoff);
        is_attenuated && is_aimed && !is_lost && profile.has(light.kind())
    };
    let intensities = scene.lights.iter().map(|light| light.intensity());
    let colors = [scene.k_a, scene.k_d, scene.k_s, scene.i_a].into_iter();
    let mut colors = colors.chain(intensities).flatten();
    let mut factors = case.factors.iter();
    scene.n != ZERO
        && scene.v != ZERO
        && !case.ways.contains(&ZERO)
        && factors.all(|factor| (1.0..=8.0).contains(factor))
        && colors.all(|c| (0.0..=16.0).contains(&c))
        && (!profile.gray_highlight || scene.k_s == [scene.k_s[0]; 3])
        && profile.models.contains(&scene.model)
        && scene.lights.len() <= profile.most_lights
        && (1.0..=profile.most_shiny).contains(&scene.m)
        && (!profile.integer_shininess || scene.m.fract() == 0.0)
        && scene.lights.iter().all(is_lit)
}
