//! Simpler scenes near a scene: what a failing case is made smaller by.

use std::array::from_fn;

use crate::generator::{Base, MOST_SHINY};
use crate::profile::Profile;
use crate::scene::{Light, Model, Scene, Triple};

const AXES: [Triple; 6] = [
    [0.0, 0.0, 1.0],
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, -1.0],
    [-1.0, 0.0, 0.0],
    [0.0, -1.0, 0.0],
];

/// How much there is to read in a case.
pub fn cost(base: &Base) -> u32 {
    let scene = &base.scene;
    let material = &scene.material;
    let mut cost = match scene.model {
        Model::Lambert => 0,
        Model::BlinnPhong => 1,
        Model::Phong => 2,
    };
    for triple in [
        scene.p,
        scene.n,
        scene.v,
        material.k_a,
        material.k_d,
        material.k_s,
        scene.i_a,
    ] {
        cost += of_triple(triple);
    }
    cost += of_number(material.m);
    for light in &scene.lights {
        cost += 200 + of_triple(light.intensity());
        cost += match *light {
            Light::Directional { l, .. } => of_triple(l),
            Light::Point {
                position,
                attenuation,
                ..
            } => 40 + of_triple(position) + of_triple(attenuation),
            Light::Spot {
                position,
                attenuation,
                axis,
                half_angle,
                ..
            } => {
                80 + of_triple(position)
                    + of_triple(attenuation)
                    + of_triple(axis)
                    + of_number(half_angle)
            }
        };
    }
    cost + base
        .ways
        .into_iter()
        .chain([base.factors])
        .map(of_triple)
        .sum::<u32>()
}

fn of_triple(triple: Triple) -> u32 {
    triple.into_iter().map(of_number).sum()
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
pub fn simpler(base: &Base, profile: &Profile) -> Vec<Base> {
    let mut edits = Edits {
        base,
        profile,
        found: Vec::new(),
    };
    edits.lights();
    edits.surface();
    for i in 0..base.scene.lights.len().min(8) {
        edits.light(i);
    }
    edits.variations();
    let limit = cost(base);
    let mut found: Vec<(u32, Base)> = edits
        .found
        .into_iter()
        .map(|base| (cost(&base), base))
        .filter(|(cost, base)| *cost < limit && is_valid(&base.scene, profile))
        .collect();
    found.sort_by_key(|(cost, _)| *cost);
    found.dedup_by(|a, b| a.1 == b.1);
    found.into_iter().map(|(_, base)| base).collect()
}

/// Whether the scene is one of those that the format allows.
pub fn is_valid(scene: &Scene, profile: &Profile) -> bool {
    let has = |triple: Triple| triple != [0.0; 3];
    let is_lit = |light: &Light| match *light {
        Light::Directional { l, .. } => has(l) && profile.directional_lights,
        Light::Point {
            attenuation: [a, b, c],
            ..
        } => a + b + c > 0.0 && profile.point_lights,
        Light::Spot {
            attenuation: [a, b, c],
            axis,
            ..
        } => a + b + c > 0.0 && has(axis) && profile.spot_lights,
    };
    let is_lost = |light| scene.has_lamp_at_the_point(light, profile.roundoff);
    has(scene.n)
        && has(scene.v)
        && profile.models.contains(&scene.model)
        && scene.lights.len() <= profile.most_lights
        && (1.0..=profile.most_shiny.min(MOST_SHINY)).contains(&scene.material.m)
        && (!profile.integer_shininess || scene.material.m.fract() == 0.0)
        && scene.lights.iter().all(is_lit)
        && !scene.lights.iter().any(is_lost)
}

struct Edits<'a> {
    base: &'a Base,
    profile: &'a Profile,
    found: Vec<Base>,
}

impl Edits<'_> {
    fn scene(&mut self, edit: impl FnOnce(&mut Scene)) {
        let mut base = self.base.clone();
        edit(&mut base.scene);
        self.found.push(base);
    }

    fn lights(&mut self) {
        let count = self.base.scene.lights.len();
        if count > 2 {
            self.scene(|scene| scene.lights.truncate(count / 2));
            self.scene(|scene| drop(scene.lights.drain(..count / 2)));
        }
        for i in 0..count.min(32) {
            self.scene(|scene| {
                scene.lights.remove(i);
            });
            self.scene(|scene| scene.lights = vec![scene.lights[i]]);
        }
    }

    fn surface(&mut self) {
        let (scene, profile) = (&self.base.scene, self.profile);
        for model in Model::ALL {
            self.scene(|scene| scene.model = model);
        }
        let origin = scene.p;
        self.scene(|scene| {
            for light in &mut scene.lights {
                if let Some((position, _)) = light.lamp_mut() {
                    *position = from_fn(|i| profile.rounded(position[i] - origin[i]));
                }
            }
            scene.p = [0.0; 3];
        });
        for p in shorter(scene.p) {
            self.scene(|scene| scene.p = p);
        }
        for n in directions(scene.n) {
            self.scene(|scene| scene.n = profile.direction(n));
        }
        for v in directions(scene.v) {
            self.scene(|scene| scene.v = profile.direction(v));
        }
        let material = scene.material;
        for k in colors(material.k_a) {
            self.scene(|scene| scene.material.k_a = k);
        }
        for k in colors(material.k_d) {
            self.scene(|scene| scene.material.k_d = k);
        }
        for k in colors(material.k_s) {
            if !profile.gray_highlight || k[0] == k[1] && k[1] == k[2] {
                self.scene(|scene| scene.material.k_s = k);
            }
        }
        for i_a in colors(scene.i_a) {
            self.scene(|scene| scene.i_a = i_a);
        }
        // all but one of the terms at once
        for keep in 0..3 {
            self.scene(|scene| {
                let material = &mut scene.material;
                let terms = [&mut material.k_a, &mut material.k_d, &mut material.k_s];
                for (i, k) in terms.into_iter().enumerate() {
                    if i != keep {
                        *k = [0.0; 3];
                    }
                }
                if keep > 0 {
                    scene.i_a = [0.0; 3];
                }
            });
        }
        let m = material.m;
        for m in [
            1.0,
            2.0,
            4.0,
            8.0,
            16.0,
            32.0,
            64.0,
            128.0,
            m.round(),
            m.floor(),
            (m * 4.0).round() / 4.0,
        ] {
            self.scene(|scene| scene.material.m = m);
        }
    }

    fn light(&mut self, i: usize) {
        let (light, p, profile) = (self.base.scene.lights[i], self.base.scene.p, self.profile);
        for intensity in colors(light.intensity()) {
            self.scene(|scene| scene.lights[i] = light.with_intensity(intensity));
        }
        let intensity = light.intensity();
        match light {
            Light::Directional { l, .. } => {
                for l in directions(l) {
                    let l = profile.unit(l);
                    self.scene(|scene| scene.lights[i] = Light::Directional { l, intensity });
                }
            }
            Light::Point {
                position,
                attenuation,
                ..
            } => {
                let l = profile.unit(from_fn(|i| position[i] - p[i]));
                self.scene(|scene| scene.lights[i] = Light::Directional { l, intensity });
                self.lamp(i, p, position, attenuation);
            }
            Light::Spot {
                position,
                attenuation,
                axis,
                half_angle,
                ..
            } => {
                self.scene(|scene| {
                    scene.lights[i] = Light::Point {
                        position,
                        intensity,
                        attenuation,
                    };
                });
                self.lamp(i, p, position, attenuation);
                let l = from_fn(|i| p[i] - position[i]);
                for new in directions(axis).into_iter().chain([l]) {
                    self.scene(|scene| {
                        if let Light::Spot { axis, .. } = &mut scene.lights[i] {
                            *axis = profile.unit(new);
                        }
                    });
                }
                let degrees = half_angle.to_degrees().round().to_radians();
                for new in [0.5, 1.0, 0.25, 0.75, 1.5, profile.rounded(degrees)] {
                    self.scene(|scene| {
                        if let Light::Spot { half_angle, .. } = &mut scene.lights[i] {
                            *half_angle = new;
                        }
                    });
                }
            }
        }
    }

    fn lamp(&mut self, i: usize, p: Triple, at: Triple, coefficients: Triple) {
        let is_attenuated = !self.profile.unattenuated;
        let mut edit = |new_position: Triple, new: Triple| {
            self.scene(|scene| {
                if let Some((position, attenuation)) = scene.lights[i].lamp_mut() {
                    (*position, *attenuation) = (new_position, new);
                }
            });
        };
        let way: Triple = from_fn(|i| at[i] - p[i]);
        for way in directions(way) {
            edit(from_fn(|i| p[i] + way[i]), coefficients);
        }
        for axis in [AXES[0], AXES[1], AXES[2]] {
            for q in [
                2.0,
                0.5,
                4.0,
                1024.0,
                4096.0,
                16384.0,
                1.0 / 128.0,
                1.0 / 1024.0,
            ] {
                edit(from_fn(|i| p[i] + q * axis[i]), coefficients);
            }
        }
        if !is_attenuated {
            return;
        }
        let mut edit = |new| edit(at, new);
        for simple in [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]] {
            edit(simple);
        }
        shorter(coefficients).into_iter().for_each(edit);
    }

    /// What the law varies the scene by.
    fn variations(&mut self) {
        for i in 0..3 {
            for way in directions(self.base.ways[i]) {
                let mut base = self.base.clone();
                base.ways[i] = way;
                self.found.push(base);
            }
            for factor in [1.0, 2.0, 4.0] {
                let mut base = self.base.clone();
                base.factors[i] = factor;
                self.found.push(base);
            }
        }
    }
}

/// Shorter numbers, each alone and all at once.
fn shorter(v: Triple) -> Vec<Triple> {
    let roundings: [fn(f64) -> f64; 5] = [
        |_| 0.0,
        f64::round,
        |c| (2.0 * c).round() / 2.0,
        |c| (8.0 * c).round() / 8.0,
        |c| (256.0 * c).round() / 256.0,
    ];
    let mut found = Vec::new();
    for rounding in roundings {
        found.push(v.map(rounding));
        for i in 0..3 {
            let mut one = v;
            one[i] = rounding(one[i]);
            found.push(one);
        }
    }
    // one or two significant bits, for numbers that are very small or large
    for bits in [1.0, 2.0, 4.0] {
        found.push(v.map(|c| crate::bounded::rounded(c, (-f64::max(bits, 1.0)).exp2())));
    }
    found
}

fn colors(color: Triple) -> Vec<Triple> {
    let mut found = vec![[1.0; 3], [0.5; 3], [0.25; 3]];
    for i in 0..3 {
        for alone in [1.0, 0.5, color[i]] {
            let mut channel = [0.0; 3];
            channel[i] = alone;
            found.push(channel);
        }
    }
    found.extend(shorter(color));
    found.retain(|color| color.iter().all(|c| *c >= 0.0));
    found
}

fn directions(v: Triple) -> Vec<Triple> {
    let largest = v.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
    let scale = if largest > 0.0 {
        largest.log2().floor().exp2()
    } else {
        1.0
    };
    let scaled = v.map(|c| c / scale);
    AXES.into_iter()
        .chain(shorter(v))
        .chain(shorter(scaled))
        .filter(|v| *v != [0.0; 3])
        .map(|v| v.map(|c| c + 0.0)) // no -0
        .collect()
}
