//! Edits of a scene, each of which takes one thing out of it. One table has three uses: what repairs a wrong color tells
//! where a renderer is wrong; a smaller scene that is as wrong is easier to read; and between the colors before and after
//! an edit, a law holds.

use crate::formula::Formula;
use crate::profile::Profile;
use crate::scene::{Kind, Light, Model, Scene, Triple, add, dot, length, mul, scale, sub};

pub struct Edit {
    /// What no longer matters after the edit. What has no name is a law alone.
    pub id: &'static str,
    change: fn(&mut Scene, &Profile),
    /// The name of the law, what it says, and what it says of the colors.
    pub law: Option<(&'static str, &'static str, Holds)>,
    /// It takes light away. Where there is more than 1, ambient light makes up for it, because a color that is no longer
    /// clamped would be mistaken for one that the edit repairs.
    darkens: bool,
}

/// What holds between the color of a scene and that of the edited one.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Holds {
    Same,
    /// The edited scene is at least as bright.
    Brighter,
    /// The edited scene has half of the light.
    Half,
    /// Green and blue are the same.
    GreenAndBlue,
    /// The edited scene has the color k_a I_a.
    Ambient,
}

impl Edit {
    /// The scene after the edit.
    pub fn of(&self, scene: &Scene, profile: &Profile) -> Scene {
        let mut edited = scene.clone();
        (self.change)(&mut edited, profile);
        // where ambient light is wrong itself, more of it helps nobody
        if self.darkens && scene.i_a != [0.0; 3] {
            brighten(&mut edited, scene, profile);
        }
        edited
    }
}

/// Gives a scene so much ambient light that its color is again that of another, if that is above 1.
fn brighten(scene: &mut Scene, other: &Scene, profile: &Profile) {
    let right = Formula::new(profile, Vec::new(), false);
    let [is, was] = [&*scene, other].map(|scene| right.linear(scene).map(|c| c.value));
    let (mut k_a, mut i_a) = (scene.k_a, scene.i_a);
    for i in 0..3 {
        if was[i] > 1.0 && was[i].is_finite() {
            let sum = k_a[i] * i_a[i] + was[i] - is[i];
            k_a[i] = if k_a[i] == 0.0 { 1.0 } else { k_a[i] };
            i_a[i] = profile.rounded(sum / k_a[i]);
        }
    }
    if i_a.iter().all(|c| (0.0..=16.0).contains(c)) {
        (scene.k_a, scene.i_a) = (k_a, i_a);
    }
}

const fn edit(id: &'static str, change: fn(&mut Scene, &Profile)) -> Edit {
    let (law, darkens) = (None, false);
    Edit {
        id,
        change,
        law,
        darkens,
    }
}

impl Edit {
    const fn law(mut self, name: &'static str, says: &'static str, holds: Holds) -> Self {
        self.law = Some((name, says, holds));
        self
    }

    const fn darkens(mut self) -> Self {
        self.darkens = true;
        self
    }
}

/// Every edit, from the particular to the general.
pub static EDITS: &[Edit] = &[
    edit("length of N", |s, p| {
        s.n = if p.unit_vectors { s.n } else { p.unit(s.n) }
    })
    .law(
        "length_of_n",
        "the length of the vector along N does not matter",
        Holds::Same,
    ),
    edit("length of V", |s, p| {
        s.v = if p.unit_vectors { s.v } else { p.unit(s.v) }
    })
    .law(
        "length_of_v",
        "the distance of the eye does not matter",
        Holds::Same,
    ),
    edit("position p", |s, profile| {
        let p = std::mem::take(&mut s.p);
        let lamps = s.lights.iter_mut().filter_map(Light::lamp_mut);
        lamps.for_each(|(position, _)| *position = sub(*position, p).map(|c| profile.rounded(c)));
    })
    .law(
        "translation",
        "moving everything changes nothing",
        Holds::Same,
    ),
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
    })
    .law(
        "distance",
        "a lamp gives the same from another distance, if its attenuation makes up for that",
        Holds::Same,
    ),
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
            if light.kind() == Kind::Spot {
                let (l, arriving) = light.arriving(p);
                let is_dark = arriving == [0.0; 3];
                *light = if profile.has(Kind::Point) {
                    light.without_cone()
                } else {
                    light.with_cone(profile.unit(scale(l, -1.0)), profile.rounded(1.0))
                };
                if is_dark {
                    *light.intensity_mut() = [0.0; 3];
                }
            }
        }
    })
    .law(
        "cone",
        "a spot is a point light within its cone, and dark outside",
        Holds::Same,
    ),
    edit("shininess", |s, _| {
        s.m = if s.model == Model::Lambert { s.m } else { 1.0 }
    })
    .law(
        "shininess",
        "a higher shininess does not brighten",
        Holds::Brighter,
    ),
    edit("light behind", |s, profile| {
        let (p, n) = (s.p, s.n);
        for light in &mut s.lights {
            if dot(light.arriving(p).0, n) <= 8.0 * profile.roundoff * length(n) {
                *light.intensity_mut() = [0.0; 3];
            }
        }
    })
    .law(
        "behind",
        "a light behind the surface adds nothing",
        Holds::Same,
    ),
    edit("eye behind", |s, profile| {
        let cosine = dot(s.v, s.n) / (length(s.v) * length(s.n));
        if cosine < -1e-4 {
            s.v = scale(s.v, -1.0).map(|c| c + 0.0); // no -0
        } else if cosine < 1e-4 {
            s.v = add(s.v, scale(s.n, length(s.v) / length(s.n)));
        }
        s.v = profile.direction(s.v);
    }),
    edit("Phong", |s, _| {
        if s.model == Model::Phong {
            s.model = Model::BlinnPhong;
        }
    }),
    edit("Blinn", |s, _| {
        if s.model == Model::BlinnPhong {
            s.model = Model::Phong;
        }
    }),
    edit("lamps", |s, p| replace(s, p, &[Kind::Point, Kind::Spot])).law(
        "far_lamp",
        "a lamp is a directional light with the light that arrives",
        Holds::Same,
    ),
    edit("spot", |s, p| replace(s, p, &[Kind::Spot])),
    edit("point", |s, p| replace(s, p, &[Kind::Point])),
    edit("directional", |s, p| replace(s, p, &[Kind::Directional])),
    edit("several lights", |s, _| s.lights.truncate(1)).darkens(),
    edit("colors above 1", |s, _| {
        let arriving = s
            .lights
            .iter()
            .map(|light| scale(light.intensity(), light.falloff(s.p)));
        let sum = arriving.fold([0.0; 3], add);
        let most = add(mul(s.k_a, s.i_a), mul(add(s.k_d, s.k_s), sum));
        let most = most.into_iter().fold(0.0, f64::max);
        if most > 1.0 {
            dim(s, (-most.log2().ceil()).exp2());
        }
    }),
    edit("", |s, _| dim(s, 0.5)).law("scale", "half the light gives half the color", Holds::Half),
    edit("color of lights", |s, _| {
        s.lights
            .iter_mut()
            .for_each(|light| *light.intensity_mut() = [1.0; 3]);
    }),
    edit("color of the surface", |s, _| {
        (s.k_a, s.k_d, s.k_s) = ([1.0; 3], [1.0; 3], [1.0; 3]);
    }),
    edit("", |s, profile| {
        for color in [&mut s.k_a, &mut s.k_d, &mut s.i_a] {
            color[0] = 0.0;
        }
        if !profile.gray_highlight {
            s.k_s[0] = 0.0;
        }
        s.lights
            .iter_mut()
            .for_each(|light| light.intensity_mut()[0] = 0.0);
    })
    .law(
        "channels_apart",
        "red does not change green and blue",
        Holds::GreenAndBlue,
    ),
    edit("highlight", |s, profile| {
        s.k_s = [0.0; 3];
        if profile.models.contains(&Model::Lambert) {
            s.model = Model::Lambert;
        }
    })
    .darkens(),
    edit("", |s, profile| {
        if s.k_s == [0.0; 3] || s.model == Model::Lambert {
            s.v = profile.direction(turned(s.v));
        }
    })
    .law(
        "eye",
        "diffuse light does not depend on the eye",
        Holds::Same,
    ),
    edit("diffuse", |s, _| s.k_d = [0.0; 3]).darkens(),
    edit("ambient", |s, _| s.i_a = [0.0; 3]),
    edit("lights", |s, _| s.lights.clear()).darkens(),
    edit("", |s, _| s.lights.clear()).law(
        "ambient_alone",
        "without lights there is k_a I_a",
        Holds::Ambient,
    ),
    edit("", |s, _| {
        (s.p, s.n, s.v) = (turned(s.p), turned(s.n), turned(s.v));
        for light in &mut s.lights {
            match light {
                Light::Directional { l: way, .. } | Light::Point { position: way, .. } => {
                    *way = turned(*way);
                }
                Light::Spot { position, axis, .. } => {
                    (*position, *axis) = (turned(*position), turned(*axis));
                }
            }
        }
    })
    .law(
        "rotation",
        "turning everything changes nothing",
        Holds::Same,
    ),
];

/// By one of the 24 rotations of the cube, which are exact.
fn turned([x, y, z]: Triple) -> Triple {
    [-y, z, -x].map(|c| c + 0.0) // no -0
}

fn dim(scene: &mut Scene, factor: f64) {
    scene.i_a = scale(scene.i_a, factor);
    for light in &mut scene.lights {
        *light.intensity_mut() = scale(light.intensity(), factor);
    }
}

/// Turns each light of some kinds into one of another kind that gives the same, so that their number stays.
fn replace(scene: &mut Scene, profile: &Profile, kinds: &[Kind]) {
    let p = scene.p;
    for light in scene
        .lights
        .iter_mut()
        .filter(|light| kinds.contains(&light.kind()))
    {
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
