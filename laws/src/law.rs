//! The laws, a row each: a statement, what a renderer needs for it, and the scenes that show it.

#![allow(clippy::needless_pass_by_value)] // most laws keep their case

use crate::claim::{Claim, Group, Relation};
use crate::generator::Case;
use crate::profile::Profile;
use crate::scene::{Kind, Light, Model, Scene, Triple, add, dot, mul, scale, sub, unit};

pub struct Law {
    pub name: &'static str,
    pub says: &'static str,
    needs: &'static [Need],
    /// The scenes and the claim, or nothing if the law says nothing about this case.
    group: fn(Case, &Profile) -> Option<Group>,
}

/// What a renderer must have, and what to say if it does not.
type Need = (fn(&Profile) -> bool, &'static str);

const AMBIENT: Need = (
    |of| of.ambient && !of.attenuated_ambient && !of.black_without_lights,
    "it has no ambient light of its own",
);
const LIT: Need = (|of| !of.unlit_without_lights, "without lights, it is unlit");
const LAMP: Need = (
    |of| of.has(Kind::Directional) || of.has(Kind::Point),
    "it has neither directional nor point lights",
);
const POINT: Need = (|of| of.has(Kind::Point), "it has no point lights");
const SPOT: Need = (|of| of.has(Kind::Spot), "it has no spot lights");
const SUN: Need = (
    |of| of.has(Kind::Directional),
    "it has no directional lights",
);
const TWO_LIGHTS: Need = (|of| of.most_lights > 1, "it has one light at a time");
const HIGHLIGHT: Need = (Profile::has_highlights, "it has no highlights");
const GATED: Need = (
    |of| !of.highlight_on_the_dark_side,
    "its highlights are not gated",
);
const ATTENUATION: Need = (|of| !of.unattenuated, "it has no attenuation");
const ANY_LENGTH: Need = (|of| !of.unit_vectors, "it needs unit vectors");
const RANGE: Need = (
    |of| of.range().is_some(),
    "its colors are neither clamped nor levels",
);

impl Law {
    /// The law of this name.
    pub fn named(name: &str) -> Option<&'static Self> {
        LAWS.iter().find(|law| law.name == name)
    }

    /// Its place among all laws.
    pub fn index(&self) -> usize {
        let place = LAWS.iter().position(|law| law.name == self.name);
        place.unwrap_or(0)
    }

    pub fn group(&self, case: Case, profile: &Profile) -> Option<Group> {
        let way = case.ways[0];
        let mut group = (self.group)(case, profile)?;
        for scene in &mut group.scenes {
            // what happens without lights is left to the formula
            if profile.unlit_without_lights && scene.lights.is_empty() && !self.is_of_one_scene() {
                let light = lamp(profile, scene.p, way, [0.0; 3]);
                scene.lights.push(light);
            }
        }
        let fits = |scene: &Scene| {
            scene.lights.len() <= profile.most_lights && scene.m <= profile.most_shiny
        };
        group.scenes.iter().all(fits).then_some(group)
    }

    /// Whether its scenes are those that were generated, so that no edge is to be left out.
    pub fn is_of_one_scene(&self) -> bool {
        ["finite", "as_said", "not_negative", "formula"].contains(&self.name)
    }

    /// Whether it is about what a renderer remembers.
    pub fn is_of_state(&self) -> bool {
        self.name == "no_memory"
    }

    /// Why the law cannot be tried, if it cannot.
    pub fn lacks(&self, profile: &Profile) -> Option<&'static str> {
        let mut needs = self.needs.iter();
        let (_, lacks) = needs.find(|(has, _)| !has(profile))?;
        Some(lacks)
    }
}

/// Both colors are the same.
fn same(first: Scene, second: Scene) -> Option<Group> {
    Claim::new("both colors are the same", Relation::Zero, &[1.0, -1.0]).of([first, second])
}

/// No channel of the second color is above that of the first.
fn brighter(says: &'static str, first: Scene, second: Scene) -> Option<Group> {
    Claim::new(says, Relation::NotNegative, &[1.0, -1.0]).of([first, second])
}

/// The color is this.
fn is(says: &'static str, color: Triple, scene: Scene) -> Option<Group> {
    let mut claim = Claim::new(says, Relation::Zero, &[1.0]);
    claim.constant = color.map(|c| -c);
    claim.of([scene])
}

/// A light from this direction that is not attenuated.
fn lamp(profile: &Profile, p: Triple, way: Triple, intensity: Triple) -> Light {
    let point = Light::point(intensity, add(p, way), [1.0, 0.0, 0.0]);
    if profile.has(Kind::Directional) {
        let l = profile.unit(way);
        Light::Directional { intensity, l }
    } else if profile.has(Kind::Point) {
        point
    } else {
        point.with_cone(profile.unit(scale(way, -1.0)), profile.rounded(1.0))
    }
}

/// The scene with N on the side of the eye, where the renderer turns it there.
fn facing(mut scene: Scene, profile: &Profile) -> Scene {
    if profile.normal_faces_eye && dot(scene.n, scene.v) < 0.0 {
        scene.n = scene.n.map(|c| -c);
    }
    scene
}

/// The vector, or its opposite, that points away from the surface's other side.
fn away(way: Triple, n: Triple) -> Triple {
    scale(way, if dot(way, n) > 0.0 { -1.0 } else { 1.0 })
}

/// The same scene with its points and directions changed.
fn moved(
    scene: &Scene,
    point: impl Fn(Triple) -> Triple,
    direction: impl Fn(Triple) -> Triple,
) -> Scene {
    let mut scene = scene.clone();
    scene.p = point(scene.p);
    scene.n = direction(scene.n);
    scene.v = direction(scene.v);
    for light in &mut scene.lights {
        match light {
            Light::Directional { l, .. } => *l = direction(*l),
            Light::Point { position, .. } => *position = point(*position),
            Light::Spot { position, axis, .. } => {
                (*position, *axis) = (point(*position), direction(*axis));
            }
        }
    }
    scene
}

/// The scene with this light alone, and no ambient light if none comes without others.
fn lit(scene: &Scene, light: Option<Light>) -> Scene {
    Scene {
        lights: light.into_iter().collect(),
        ..scene.clone()
    }
}

/// A white light along the way, and no ambient one.
fn white(scene: &Scene, profile: &Profile, way: Triple) -> Scene {
    Scene {
        i_a: [0.0; 3],
        ..lit(scene, Some(lamp(profile, scene.p, way, [1.0; 3])))
    }
}

/// The ambient term.
fn ambient(scene: &Scene, profile: &Profile) -> Triple {
    let ambient = mul(scene.k_a, scene.i_a);
    if profile.ambient_times_diffuse {
        mul(ambient, scene.k_d)
    } else {
        ambient
    }
}

/// The color of the lights in tests of laws, each channel another.
const COLORED: Triple = [1.0, 0.5, 0.25];

fn no_memory(case: Case, profile: &Profile) -> Option<Group> {
    let scene = case.scene;
    let mut other = lit(&scene, Some(lamp(profile, scene.p, case.ways[0], [1.0; 3])));
    other.k_d = [1.0; 3];
    let says = "the first color is the third";
    let claim = Claim::new(says, Relation::Zero, &[1.0, 0.0, -1.0]);
    claim.of([scene.clone(), other, scene])
}

fn ambient_alone(case: Case, profile: &Profile) -> Option<Group> {
    let scene = lit(&case.scene, None);
    is("the color is k_a I_a", ambient(&scene, profile), scene)
}

fn additive(case: Case, profile: &Profile) -> Option<Group> {
    let mut all = case.scene;
    if profile.black_without_lights {
        all.i_a = [0.0; 3]; // it comes with the first light
    }
    if all.lights.len() < 2 || all.lights.len() > 16 {
        return None;
    }
    // all − none = Σ (each − none)
    #[allow(clippy::cast_precision_loss)] // the count of lights
    let mut weights = vec![1.0, all.lights.len() as f64 - 1.0];
    weights.resize(2 + all.lights.len(), -1.0);
    let mut scenes = vec![all.clone(), lit(&all, None)];
    scenes.extend(all.lights.iter().map(|light| lit(&all, Some(*light))));
    let says = "the first color is the sum of those with one light each, with the ambient light (second scene) counted once";
    let claim = Claim::new(says, Relation::Zero, &weights);
    Some(Group { scenes, claim })
}

fn scaled(case: Case, profile: &Profile) -> Option<Group> {
    let factor = match profile.range() {
        Some(_) => 0.5, // twice as much would often be clamped
        None => case.factors[0],
    };
    let mut other = case.scene.clone();
    other.i_a = scale(other.i_a, factor);
    for light in &mut other.lights {
        *light.intensity_mut() = scale(light.intensity(), factor);
    }
    let says = "the color of the second scene is the factor of its light times that of the first";
    Claim::new(says, Relation::Zero, &[factor, -1.0]).of([case.scene, other])
}

fn channels_apart(case: Case, profile: &Profile) -> Option<Group> {
    let mut other = case.scene.clone();
    for color in [&mut other.k_a, &mut other.k_d, &mut other.i_a] {
        color[0] = 0.0;
    }
    if !profile.gray_highlight {
        other.k_s[0] = 0.0;
    }
    for light in &mut other.lights {
        light.intensity_mut()[0] = 0.0;
    }
    let says = "green and blue are the same";
    let mut claim = Claim::new(says, Relation::Zero, &[1.0, -1.0]);
    claim.first_channel = 1;
    claim.of([case.scene, other])
}

fn bound(case: Case, profile: &Profile) -> Option<Group> {
    let mut scene = case.scene;
    if profile.unattenuated_highlight {
        scene.k_s = [0.0; 3];
    }
    // all factors at 1: N·L, the power and the cone
    let falloffs = scene.lights.iter().map(|light| light.falloff(scene.p));
    let mut most = ambient(&scene, profile);
    if profile.attenuated_ambient {
        most = scale(most, falloffs.clone().sum());
    }
    let k = add(scene.k_d, scene.k_s);
    for (light, left) in scene.lights.iter().zip(falloffs) {
        most = add(most, scale(mul(k, light.intensity()), left));
    }
    let says = "the color is at most k_a I_a + Σ (k_d + k_s) I/(a + bq + cq²)";
    let mut claim = Claim::new(says, Relation::NotNegative, &[-1.0]);
    (claim.constant, claim.slack) = (most, scale(most, 64.0 * profile.roundoff));
    claim.of([scene])
}

fn behind(case: Case, profile: &Profile) -> Option<Group> {
    let mut scene = facing(case.scene, profile);
    if profile.attenuated_ambient || profile.black_without_lights {
        scene.i_a = [0.0; 3];
    }
    if profile.highlight_on_the_dark_side {
        scene.k_s = [0.0; 3];
    }
    let way = away(case.ways[0], scene.n);
    let mut other = scene.clone();
    other.lights.push(lamp(profile, scene.p, way, [1.0; 3]));
    same(scene, other)
}

fn eye(case: Case, profile: &Profile) -> Option<Group> {
    let mut scene = case.scene;
    scene.k_s = [0.0; 3];
    let mut v = case.ways[0];
    if profile.normal_faces_eye {
        let sides = [scene.v, v].map(|v| dot(scene.n, v));
        if sides[0].abs() < 0.01 || sides[1].abs() < 0.01 {
            return None; // rounding decides on which side the eye is
        }
        v = scale(v, (sides[0] * sides[1]).signum());
    }
    let v = profile.direction(v);
    let other = Scene { v, ..scene.clone() };
    same(scene, other)
}

fn length_of_n(case: Case, _: &Profile) -> Option<Group> {
    let mut other = case.scene.clone();
    other.n = scale(other.n, (case.factors[0] + 1.0) / 8.0);
    same(case.scene, other)
}

fn length_of_v(case: Case, _: &Profile) -> Option<Group> {
    let mut other = case.scene.clone();
    other.v = scale(other.v, (case.factors[0] + 1.0) / 4.0);
    same(case.scene, other)
}

fn mirror(case: Case, profile: &Profile) -> Option<Group> {
    let mut scene = facing(case.scene, profile);
    let (way, n) = (case.ways[0], scene.n);
    let (twice, square) = (2.0 * dot(n, way), dot(n, n));
    if twice <= 0.0 || scene.model == Model::Lambert {
        return None;
    }
    scene.v = profile.direction(sub(scale(n, twice), scale(way, square)));
    (scene.k_d, scene.i_a) = ([0.0; 3], [0.0; 3]);
    scene.lights = vec![lamp(profile, scene.p, way, COLORED)];
    is("the color is k_s I", mul(scene.k_s, COLORED), scene)
}

fn shininess(case: Case, _: &Profile) -> Option<Group> {
    let mut scene = case.scene;
    if scene.model == Model::Lambert {
        return None;
    }
    (scene.k_d, scene.i_a) = ([0.0; 3], [0.0; 3]);
    let mut other = scene.clone();
    other.m += case.factors[0];
    let says = "the first color, of the lower shininess, is the brighter";
    brighter(says, scene, other)
}

fn dark_side(case: Case, profile: &Profile) -> Option<Group> {
    let scene = facing(case.scene, profile);
    if scene.model == Model::Lambert {
        return None;
    }
    let mut scene = white(&scene, profile, away(case.ways[0], scene.n));
    (scene.k_d, scene.k_s, scene.m) = ([0.0; 3], [1.0; 3], scene.m.min(2.0));
    is("the color is black", [0.0; 3], scene)
}

fn distance(case: Case, _: &Profile) -> Option<Group> {
    let (p, way, [a, b, c]) = (case.scene.p, case.ways[0], case.factors);
    let attenuation = [a / 4.0, (b - 1.0) / 8.0, (c - 1.0) / 8.0];
    let at = |times: f64| {
        let lamp = Light::point([1.0; 3], add(p, scale(way, times)), attenuation);
        let mut scene = lit(&case.scene, Some(lamp));
        scene.i_a = [0.0; 3];
        scene
    };
    let says = "the first color, of the lamp nearby, is the brighter";
    brighter(says, at(1.0), at(1.0 + a / 4.0))
}

fn far_lamp(case: Case, profile: &Profile) -> Option<Group> {
    let (way, mut scene) = (case.ways[0], case.scene);
    scene.i_a = [0.0; 3];
    let (intensity, l) = (COLORED, profile.unit(way));
    // a power of two so large, so that the sum with p is still exact in f32
    let position = add(scene.p, scale(way, 256.0));
    let far = Light::point(intensity, position, [1.0, 0.0, 0.0]);
    let other = lit(&scene, Some(far));
    same(
        lit(&scene, Some(Light::Directional { intensity, l })),
        other,
    )
}

fn translation(case: Case, profile: &Profile) -> Option<Group> {
    let offset = case.factors.map(|c| c - 4.0);
    let other = moved(&case.scene, |p| add(p, offset), |d| d);
    // long numbers would be others after the sum
    let back = moved(&other, |p| sub(p, offset), |d| d);
    let held = moved(&other, |p| p.map(|c| profile.rounded(c)), |d| d);
    let is_exact = back == case.scene && held == other;
    same(case.scene, other).filter(|_| is_exact)
}

fn rotation(case: Case, _: &Profile) -> Option<Group> {
    // one of the 24 rotations of the cube, which are exact
    let turn = |v: Triple| [v[0], -v[2], v[1]]; // by 90° about x
    let cycle = |v: Triple| [v[2], v[0], v[1]]; // by 120° about the diagonal
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // 1 to 8
    let [first, second, third] = case.factors.map(|times| times as u32);
    let turns = |v: Triple| {
        let v = (0..first).fold(v, |v, _| turn(v));
        let v = (0..second).fold(v, |v, _| cycle(v));
        (0..third).fold(v, |v, _| turn(v))
    };
    let other = moved(&case.scene, turns, turns);
    same(case.scene, other)
}

fn cone(case: Case, profile: &Profile) -> Option<Group> {
    let mut scene = case.scene;
    let [way, aim, _] = case.ways;
    let [side, degrees, _] = case.factors;
    let attenuation = [1.0, 0.0, if profile.unattenuated { 0.0 } else { 0.25 }];
    // a way off the axis by an angle that is far from the edge of the cone
    let aim = scale(aim, side / 4.0);
    let axis = sub(if aim == way { [0.0; 3] } else { aim }, way);
    let axis = profile.unit(axis);
    let half_angle = profile.rounded((10.0 * degrees).to_radians());
    let off = (-dot(axis, unit(way))).clamp(-1.0, 1.0).acos() - half_angle;
    let is_vague = off.abs() < 0.05 || profile.spot_exponent > 0.0 && off < 0.0;
    if is_vague || profile.attenuated_ambient && off > 0.0 {
        return None;
    }
    if profile.black_without_lights {
        scene.i_a = [0.0; 3];
    }
    let point = Light::point(COLORED, add(scene.p, way), attenuation);
    let spot = point.with_cone(axis, half_angle);
    let says =
        "the spot (first scene) gives the color of the point light, or of no light (second scene)";
    let other = lit(&scene, (off < 0.0).then_some(point));
    let claim = Claim::new(says, Relation::Zero, &[1.0, -1.0]);
    claim.of([lit(&scene, Some(spot)), other])
}

/// Every law, in the order of the report.
pub const LAWS: &[Law] = &[
    Law {
        name: "finite",
        says: "every color is finite",
        needs: &[],
        group: |case, _| {
            Claim::new("the color is finite", Relation::Finite, &[1.0]).of([case.scene])
        },
    },
    Law {
        name: "as_said",
        says: "colors are in the range and the levels that the renderer promises",
        needs: &[RANGE],
        group: |case, _| {
            Claim::new("the color is as the profile says", Relation::AsSaid, &[1.0])
                .of([case.scene])
        },
    },
    Law {
        name: "not_negative",
        says: "no light is negative",
        needs: &[],
        group: |case, _| {
            Claim::new("the color is not negative", Relation::NotNegative, &[1.0]).of([case.scene])
        },
    },
    Law {
        name: "no_memory",
        says: "a scene has the same color wherever it is in a batch",
        needs: &[],
        group: no_memory,
    },
    Law {
        name: "ambient_alone",
        says: "without lights there is k_a I_a",
        needs: &[AMBIENT, LIT],
        group: ambient_alone,
    },
    Law {
        name: "additive",
        says: "the light of several lights is the sum of the light of each",
        needs: &[TWO_LIGHTS],
        group: additive,
    },
    Law {
        name: "scale",
        says: "twice the light gives twice the color",
        needs: &[],
        group: scaled,
    },
    Law {
        name: "channels_apart",
        says: "red does not change green and blue",
        needs: &[],
        group: channels_apart,
    },
    Law {
        name: "bound",
        says: "no more light comes back than k_a I_a + Σ (k_d + k_s) I/(a + bq + cq²)",
        needs: &[],
        group: bound,
    },
    Law {
        name: "behind",
        says: "a light behind the surface adds nothing",
        needs: &[TWO_LIGHTS],
        group: behind,
    },
    Law {
        name: "eye",
        says: "diffuse light does not depend on the eye",
        needs: &[],
        group: eye,
    },
    Law {
        name: "length_of_n",
        says: "the length of the vector along N does not matter",
        needs: &[ANY_LENGTH],
        group: length_of_n,
    },
    Law {
        name: "length_of_v",
        says: "the distance of the eye does not matter",
        needs: &[ANY_LENGTH],
        group: length_of_v,
    },
    Law {
        name: "mirror",
        says: "seen in the mirror direction, the highlight is k_s I",
        needs: &[HIGHLIGHT, LAMP],
        group: mirror,
    },
    Law {
        name: "shininess",
        says: "a higher shininess does not brighten",
        needs: &[HIGHLIGHT],
        group: shininess,
    },
    Law {
        name: "dark_side",
        says: "a highlight needs N·L > 0",
        needs: &[HIGHLIGHT, GATED],
        group: dark_side,
    },
    Law {
        name: "distance",
        says: "a lamp farther away in the same direction does not brighten",
        needs: &[POINT, ATTENUATION],
        group: distance,
    },
    Law {
        name: "far_lamp",
        says: "a lamp far away that is not attenuated is a directional light",
        needs: &[POINT, SUN],
        group: far_lamp,
    },
    Law {
        name: "translation",
        says: "moving everything changes nothing",
        needs: &[],
        group: translation,
    },
    Law {
        name: "rotation",
        says: "turning everything changes nothing",
        needs: &[],
        group: rotation,
    },
    Law {
        name: "cone",
        says: "a spot is a point light within its cone, and dark outside",
        needs: &[POINT, SPOT],
        group: cone,
    },
    Law {
        name: "formula",
        says: "the color is that of the formula, within the renderer's precision",
        needs: &[],
        group: |case, _| {
            Claim::new("the color is that of the formula", Relation::Right, &[1.0]).of([case.scene])
        },
    },
];
