//! Edits of a scene, each of which takes one thing out of it. What repairs a wrong color tells where a
//! renderer is wrong, and a smaller scene that is as wrong is easier to read.

use crate::mistakes::formula;
use crate::profile::Profile;
use crate::scene::{Kind, Light, Model, Scene, Triple};
use crate::scene::{add, cross, dot, length, mul, scale, size, sub, unit};

pub struct Edit {
    /// What no longer matters after the edit.
    pub id: &'static str,
    change: fn(&mut Scene, &Profile),
}

/// What takes light away.
pub const DARKER: [&str; 4] = ["several lights", "highlight", "diffuse", "lights"];

/// A broken scene without one thing.
pub struct Trial {
    pub edited: Scene,
    /// The scene with all of it, as dim as the other had to become. If that is right, the light was too bright for
    /// the renderer, and the trial says nothing of what was taken out.
    pub control: Option<Scene>,
}

impl Edit {
    /// A scene without what the edit takes out, if such a renderer can be given it.
    pub fn of(&self, scene: &Scene, profile: &Profile) -> Option<Scene> {
        self.trial(scene, profile).map(|trial| trial.edited)
    }

    /// The same, with what tells whether it shows anything.
    pub fn trial(&self, scene: &Scene, profile: &Profile) -> Option<Trial> {
        let mut edited = scene.clone();
        (self.change)(&mut edited, profile);
        edited.lights.retain(|light| profile.has(light.kind()));
        let right = formula(profile, None);
        let [is, was] = [&edited, scene].map(|it| size(right.linear(it).map(|c| c.value)));
        let times = |most: f64| (-(is / most).log2().ceil()).exp2();
        let mut control = None;
        match profile.range() {
            // what the edit brightens beyond the range would hide what is wrong
            Some([_, high]) if is > high && was <= high && is.is_finite() => {
                edited.scale_light(times(high));
                control.insert(scene.clone()).scale_light(times(high));
            }
            // what it darkens to 1 would be taken for repaired where only a clamp is wrong
            _ if DARKER.contains(&self.id)
                && is > 0.0
                && is <= 1.0
                && was > 1.0
                && was.is_finite() =>
            {
                let before = edited.clone();
                edited.scale_light(2.0 * times(1.0));
                if !profile.has_all_of(&edited) {
                    edited = before;
                }
            }
            _ => {}
        }
        (edited != *scene && profile.has_all_of(&edited)).then_some(Trial { edited, control })
    }
}

const fn edit(id: &'static str, change: fn(&mut Scene, &Profile)) -> Edit {
    Edit { id, change }
}

/// Every edit, from the particular to the general.
pub static EDITS: &[Edit] = &[
    edit("length of N", |s, p| {
        s.n = if p.unit_vectors { s.n } else { p.unit(s.n) }
    }),
    edit("length of V", |s, p| {
        s.v = if p.unit_vectors { s.v } else { p.unit(s.v) }
    }),
    edit("position p", |s, profile| {
        let p = std::mem::take(&mut s.p);
        let lamps = s.lights.iter_mut().filter_map(Light::lamp_mut);
        lamps.for_each(|(position, _)| *position = sub(*position, p).map(|c| profile.rounded(c)));
    }),
    edit("distance", |s, profile| {
        for light in &mut s.lights {
            let before = light.falloff(s.p);
            if let Some((position, _)) = light.lamp_mut() {
                *position = add(s.p, profile.unit(sub(*position, s.p))).map(|c| profile.rounded(c));
            }
            let ratio = light.falloff(s.p) / before;
            if let Some((_, abc)) = light.lamp_mut().filter(|_| ratio != 1.0) {
                *abc = scale(*abc, ratio).map(|c| profile.rounded(c));
            }
        }
    }),
    edit("attenuation", |s, profile| {
        for light in &mut s.lights {
            let left = light.falloff(s.p);
            if let Some((_, abc)) = light.lamp_mut().filter(|(_, abc)| **abc != [1.0, 0.0, 0.0]) {
                *abc = [1.0, 0.0, 0.0];
                *light.intensity_mut() = scale(light.intensity(), left).map(|c| profile.rounded(c));
            }
        }
    }),
    edit("cone", |s, profile| {
        let p = s.p;
        for light in &mut s.lights {
            if let (Kind::Spot, Some((position, abc))) = (light.kind(), light.lamp()) {
                let (l, arriving) = light.arriving(p);
                let is_dark = arriving == [0.0; 3];
                *light = if profile.has(Kind::Point) {
                    Light::point(light.intensity(), position, abc)
                } else {
                    light.with_cone(profile.unit(scale(l, -1.0)), profile.rounded(1.0))
                };
                if is_dark {
                    *light.intensity_mut() = [0.0; 3];
                }
            }
        }
    }),
    edit("shininess", |s, profile| {
        if s.model != Model::Lambert {
            keep_highlight(s, s.model, 1.0, profile);
        }
    }),
    edit("light behind", |s, profile| {
        let (p, n) = (s.p, s.n);
        let up = profile.unit(n);
        for light in &mut s.lights {
            if dot(light.arriving(p).0, n) > 8.0 * profile.roundoff * length(n) {
                continue;
            }
            // a dark one in front, because a renderer may look where a light is before it looks how bright it is
            *light.intensity_mut() = [0.0; 3];
            if let Some((position, _)) = light.lamp_mut() {
                let q = length(sub(*position, p));
                *position = add(p, scale(up, q)).map(|c| profile.rounded(c));
            }
            match light {
                Light::Directional { l, .. } => *l = up,
                Light::Spot { axis, .. } => *axis = scale(up, -1.0).map(|c| c + 0.0), // no -0
                Light::Point { .. } => {}
            }
        }
    }),
    edit("eye behind", |s, profile| {
        let cosine = dot(s.v, s.n) / (length(s.v) * length(s.n));
        if cosine < -1e-4 {
            let before = s.v;
            keep_highlight(s, s.model, s.m, profile);
            if dot(s.v, s.n) <= 0.0 {
                s.v = scale(before, -1.0).map(|c| c + 0.0); // no -0
            }
        } else if cosine < 1e-4 {
            s.v = add(s.v, scale(s.n, length(s.v) / length(s.n)));
        }
        s.v = profile.direction(s.v);
    }),
    edit("Phong", |s, profile| {
        if s.model == Model::Phong {
            keep_highlight(s, Model::BlinnPhong, s.m, profile);
        }
    }),
    edit("Blinn", |s, profile| {
        if s.model == Model::BlinnPhong {
            keep_highlight(s, Model::Phong, s.m, profile);
        }
    }),
    edit("lamps", |s, p| replace(s, p, &[Kind::Point, Kind::Spot])),
    edit("spot", |s, p| replace(s, p, &[Kind::Spot])),
    edit("point", |s, p| replace(s, p, &[Kind::Point])),
    edit("directional", |s, p| replace(s, p, &[Kind::Directional])),
    edit("several lights", |s, _| s.lights.truncate(1)),
    edit("colors above 1", |s, _| {
        let lights = s.lights.iter();
        let arriving = lights.map(|light| scale(light.intensity(), light.falloff(s.p)));
        let sum = arriving.fold([0.0; 3], add);
        let most = add(mul(s.k_a, s.i_a), mul(add(s.k_d, s.k_s), sum));
        let most = most.into_iter().fold(0.0, f64::max);
        if most > 1.0 {
            s.scale_light((-most.log2().ceil()).exp2());
        }
    }),
    edit("color of lights", |s, _| {
        for light in &mut s.lights {
            *light.intensity_mut() = [1.0; 3];
        }
    }),
    edit("color of the surface", |s, _| {
        (s.k_a, s.k_d, s.k_s) = ([1.0; 3], [1.0; 3], [1.0; 3]);
    }),
    edit("highlight", |s, profile| {
        s.k_s = [0.0; 3];
        if profile.models.contains(&Model::Lambert) {
            s.model = Model::Lambert;
        }
    }),
    edit("diffuse", |s, _| s.k_d = [0.0; 3]),
    edit("ambient", |s, _| s.i_a = [0.0; 3]),
    edit("lights", |s, _| s.lights.clear()),
];

/// Gives a scene another model and another shininess, and turns the eye so that the highlight stays as
/// bright: that of the light with the brightest one. Otherwise an edit of the shininess would repair
/// whatever is wrong with dark highlights alone.
fn keep_highlight(s: &mut Scene, model: Model, m: f64, profile: &Profile) {
    let (n, v) = (unit(s.n), unit(s.v));
    let ways = s.lights.iter().map(|light| light.arriving(s.p).0);
    let lit = ways.filter(|l| dot(*l, n) > 0.0);
    let with_cosine = lit.map(|l| {
        let (a, b) = compared(s.model, [n, l, v]);
        (dot(a, b), l)
    });
    let brightest = with_cosine.max_by(|a, b| a.0.total_cmp(&b.0));
    let before = s.m;
    (s.model, s.m) = (model, m);
    let Some((cosine, l)) = brightest else {
        return;
    };
    if cosine <= 0.0 && m < before {
        // it has no highlight with any shininess, unless the sign of its power is lost, as with 2
        s.m = before.min(2.0);
        return;
    }
    let cosine = cosine.abs().min(1.0).powf(before / m).copysign(cosine);
    if let Some(turned) = turned(model, [n, l, v], cosine) {
        let long = scale(turned, length(s.v)).map(|c| profile.rounded(c));
        s.v = profile.direction(long);
    }
}

/// What a highlight is a power of the cosine between: R and V, or N and H.
fn compared(model: Model, [n, l, v]: [Triple; 3]) -> (Triple, Triple) {
    match model {
        Model::Phong => (mirrored(l, n), v),
        _ => (n, unit(add(l, v))),
    }
}

/// A vector on the other side of an axis.
fn mirrored(v: Triple, axis: Triple) -> Triple {
    sub(scale(axis, 2.0 * dot(axis, v)), v)
}

/// The direction of an eye that sees this cosine, above the surface if there is one.
fn turned(model: Model, [n, l, v]: [Triple; 3], cosine: f64) -> Option<Triple> {
    let (axis, other) = compared(model, [n, l, v]);
    let off = sub(other, scale(axis, dot(axis, other)));
    let off = if length(off) > 1e-6 { off } else { sub(v, l) };
    if length(off) <= 1e-6 {
        return None; // at its peak, a highlight is as bright with any shininess
    }
    let off = unit(sub(off, scale(axis, dot(axis, off))));
    let across = cross(axis, off);
    let sine = (1.0 - cosine * cosine).sqrt();
    let ways = [off, across, scale(off, -1.0), scale(across, -1.0)];
    let found = ways.map(|way| add(scale(axis, cosine), scale(way, sine)));
    let found = found.into_iter().filter_map(|way| match model {
        Model::Phong => Some(way),
        // otherwise H is on the other side
        _ => (dot(way, l) > 0.01).then(|| mirrored(l, way)),
    });
    found.max_by(|v, w| dot(*v, n).total_cmp(&dot(*w, n)))
}

/// Turns each light of some kinds into one of another kind that gives the same, so that their number stays.
fn replace(scene: &mut Scene, profile: &Profile, kinds: &[Kind]) {
    let p = scene.p;
    let lights = scene.lights.iter_mut();
    for light in lights.filter(|light| kinds.contains(&light.kind())) {
        let (l, intensity) = light.arriving(p);
        *light = if light.kind() == Kind::Directional {
            Light::point(intensity, add(p, l), [1.0, 0.0, 0.0])
        } else {
            let intensity = intensity.map(|c| profile.rounded(c));
            Light::Directional {
                intensity,
                l: profile.unit(l),
            }
        };
    }
}
