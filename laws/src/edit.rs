//! Edits of a scene, each of which takes one thing out of it: what a wrong color is followed by, and what makes a scene
//! simpler.

use crate::profile::Profile;
use crate::scene::{Kind, Light, Model, Scene, Triple, add, dot, mul, scale, sub};

pub struct Knob {
    /// What no longer matters after the edit.
    pub id: &'static str,
    pub edit: fn(&mut Scene, &Profile),
}

const fn knob(id: &'static str, edit: fn(&mut Scene, &Profile)) -> Knob {
    Knob { id, edit }
}

/// Changes the position and the attenuation of each lamp, given the point.
fn lamps(scene: &mut Scene, change: impl Fn(&mut Triple, &mut Triple, Triple)) {
    for light in &mut scene.lights {
        if let Some((position, attenuation)) = light.lamp_mut() {
            change(position, attenuation, scene.p);
        }
    }
}

fn is_in_front(light: &Light, scene: &Scene) -> bool {
    let way = match light {
        Light::Directional { l, .. } => *l,
        other => other.lamp().map_or([0.0; 3], |(to, _)| sub(to, scene.p)),
    };
    dot(way, scene.n) > 1e-3
}

/// Turns each light of some kinds into one of another kind that gives the same, so that their number stays.
fn without(scene: &mut Scene, profile: &Profile, kinds: &[Kind]) {
    let p = scene.p;
    for light in scene
        .lights
        .iter_mut()
        .filter(|light| kinds.contains(&light.kind()))
    {
        let intensity = light.intensity();
        *light = match *light {
            Light::Directional { l, .. } => Light::point(intensity, add(p, l), [1.0, 0.0, 0.0]),
            other => {
                let (position, _) = other.lamp().unwrap_or_default();
                let l = profile.unit(sub(position, p));
                let is_lit = match other {
                    Light::Spot {
                        axis, half_angle, ..
                    } => -dot(axis, l) >= half_angle.cos(),
                    _ => true,
                };
                let left = if is_lit { other.falloff(p) } else { 0.0 };
                let intensity = scale(intensity, left).map(|c| profile.rounded(c));
                Light::Directional { intensity, l }
            }
        };
    }
    scene.lights.retain(|light| profile.has(light.kind()));
}

/// What a color may follow, from the particular to the general.
pub const KNOBS: &[Knob] = &[
    knob("length of N", |s, p| s.n = p.unit(s.n)),
    knob("length of V", |s, p| s.v = p.unit(s.v)),
    knob("position p", |s, profile| {
        lamps(s, |to, _, p| {
            *to = sub(*to, p).map(|c| profile.rounded(c));
        });
        s.p = [0.0; 3];
    }),
    knob("distance", |s, profile| {
        lamps(s, |to, _, p| {
            let near = add(p, profile.unit(sub(*to, p)));
            *to = near.map(|c| profile.rounded(c));
        });
    }),
    knob("attenuation", |s, _| {
        lamps(s, |_, abc, _| *abc = [1.0, 0.0, 0.0]);
    }),
    knob("cone", |s, profile| {
        for light in &mut s.lights {
            if let Light::Spot { position, .. } = *light {
                *light = if profile.has(Kind::Point) {
                    light.without_cone()
                } else {
                    let axis = profile.unit(sub(s.p, position));
                    light.with_cone(axis, profile.rounded(1.0))
                };
            }
        }
    }),
    knob("shininess", |s, _| s.m = 1.0),
    knob("light behind", |s, _| {
        let lights = std::mem::take(&mut s.lights);
        let in_front = lights.into_iter().filter(|light| is_in_front(light, s));
        s.lights = in_front.collect();
    }),
    knob("eye behind", |s, _| {
        s.v = scale(s.v, if dot(s.v, s.n) < 0.0 { -1.0 } else { 1.0 });
    }),
    knob("Phong", |s, _| {
        if s.model == Model::Phong {
            s.model = Model::BlinnPhong;
        }
    }),
    knob("Blinn", |s, _| {
        if s.model == Model::BlinnPhong {
            s.model = Model::Phong;
        }
    }),
    knob("lamps", |s, p| without(s, p, &[Kind::Point, Kind::Spot])),
    knob("spot", |s, p| without(s, p, &[Kind::Spot])),
    knob("point", |s, p| without(s, p, &[Kind::Point])),
    knob("directional", |s, p| without(s, p, &[Kind::Directional])),
    knob("several lights", |s, _| s.lights.truncate(1)),
    knob("colors above 1", |s, _| {
        let all = s
            .lights
            .iter()
            .map(|light| scale(light.intensity(), light.falloff(s.p)));
        let sum = all.fold([0.0; 3], add);
        let most = add(mul(s.k_a, s.i_a), mul(add(s.k_d, s.k_s), sum));
        let most = most.into_iter().fold(0.0, f64::max);
        let factor = if most > 1.0 {
            (-most.log2().ceil()).exp2()
        } else {
            1.0
        };
        s.i_a = scale(s.i_a, factor);
        for light in &mut s.lights {
            *light.intensity_mut() = scale(light.intensity(), factor);
        }
    }),
    knob("color of lights", |s, _| {
        for light in &mut s.lights {
            *light.intensity_mut() = [1.0; 3];
        }
    }),
    knob("color of the surface", |s, _| {
        (s.k_a, s.k_d, s.k_s) = ([1.0; 3], [1.0; 3], [1.0; 3]);
    }),
    knob("highlight", |s, profile| {
        s.k_s = [0.0; 3];
        if profile.models.contains(&Model::Lambert) {
            s.model = Model::Lambert;
        }
    }),
    knob("diffuse", |s, _| s.k_d = [0.0; 3]),
    knob("ambient", |s, _| s.i_a = [0.0; 3]),
    knob("lights", |s, _| s.lights.clear()),
];
