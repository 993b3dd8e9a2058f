//! The laws.

use std::array::from_fn;

use shading::f64::Vec3;

use crate::claim::{Claim, Group, Relation, Term};
use crate::generator::Base;
use crate::profile::Profile;
use crate::reference;
use crate::scene::{Light, Material, Model, Scene, Triple};

/// A law: a statement, what a renderer needs to be put to it, and the scenes that show it.
#[derive(Clone, Copy)]
pub struct Law {
    pub name: &'static str,
    pub says: &'static str,
    needs: &'static [Need],
    /// The scenes and claims, or nothing if the law says nothing about this scene.
    pub group: fn(Base, &Profile) -> Option<Group>,
}

#[derive(Clone, Copy)]
enum Need {
    Ambient,
    Lamp,
    PointLight,
    SpotLight,
    PointAndSpot,
    Sun,
    TwoLights,
    Highlight,
    GatedHighlight,
    AnyLength,
}

impl Law {
    /// Why the law cannot be tried, if it cannot.
    pub fn lacks(&self, profile: &Profile) -> Option<&'static str> {
        let has_highlight = profile.models.iter().any(|model| *model != Model::Lambert);
        self.needs.iter().find_map(|need| {
            let (has, lacks) = match need {
                Need::Ambient => (
                    profile.ambient && !profile.attenuated_ambient,
                    "it has no ambient light of its own",
                ),
                Need::Lamp => (
                    profile.directional_lights || profile.point_lights,
                    "it has neither directional nor point lights",
                ),
                Need::PointLight => (profile.point_lights, "it has no point lights"),
                Need::SpotLight => (profile.spot_lights, "it has no spot lights"),
                Need::PointAndSpot => (
                    profile.point_lights && profile.spot_lights,
                    "it does not have both point and spot lights",
                ),
                Need::Sun => (
                    profile.directional_lights && profile.point_lights,
                    "it does not have both directional and point lights",
                ),
                Need::TwoLights => (profile.most_lights > 1, "it has one light at a time"),
                Need::Highlight => (has_highlight, "it has no highlights"),
                Need::GatedHighlight => (
                    has_highlight && !profile.highlight_on_the_dark_side,
                    "its highlights are not gated",
                ),
                Need::AnyLength => (!profile.unit_vectors, "it needs unit vectors"),
            };
            (!has).then_some(lacks)
        })
    }
}

/// Every law, in the order of the report.
pub const LAWS: &[Law] = &[
    Law {
        name: "finite",
        says: "every color is finite",
        needs: &[],
        group: |base, _| one(base.scene, Relation::Finite, "the color is finite"),
    },
    Law {
        name: "as_said",
        says: "colors are in the range and the levels that the renderer promises",
        needs: &[],
        group: |base, profile| {
            profile.range()?;
            one(
                base.scene,
                Relation::AsSaid,
                "the color is as the profile says",
            )
        },
    },
    Law {
        name: "not_negative",
        says: "no light is negative",
        needs: &[],
        group: |base, _| {
            one(
                base.scene,
                Relation::NotNegative,
                "the color is not negative",
            )
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
        needs: &[Need::Ambient],
        group: ambient_alone,
    },
    Law {
        name: "additive",
        says: "the light of several lights is the sum of the light of each",
        needs: &[Need::TwoLights],
        group: additive,
    },
    Law {
        name: "order",
        says: "the order of the lights does not matter",
        needs: &[Need::TwoLights],
        group: order,
    },
    Law {
        name: "black_light",
        says: "a black light changes nothing",
        needs: &[Need::TwoLights],
        group: black_light,
    },
    Law {
        name: "scale",
        says: "twice the light gives twice the color",
        needs: &[],
        group: scale,
    },
    Law {
        name: "terms",
        says: "ambient, diffuse and specular light add up",
        needs: &[],
        group: terms,
    },
    Law {
        name: "channels_alike",
        says: "red, green and blue are computed alike",
        needs: &[],
        group: channels_alike,
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
        needs: &[Need::TwoLights],
        group: behind,
    },
    Law {
        name: "eye",
        says: "diffuse light does not depend on the eye",
        needs: &[],
        group: eye,
    },
    Law {
        name: "toward_the_normal",
        says: "a light that is tilted toward the normal does not darken a diffuse surface",
        needs: &[Need::Lamp],
        group: toward_the_normal,
    },
    Law {
        name: "both_reversed",
        says: "with N and every L reversed, a diffuse surface looks the same",
        needs: &[Need::Lamp],
        group: both_reversed,
    },
    Law {
        name: "length_of_n",
        says: "the length of the vector along N does not matter",
        needs: &[Need::AnyLength],
        group: length_of_n,
    },
    Law {
        name: "length_of_v",
        says: "the distance of the eye does not matter",
        needs: &[Need::AnyLength],
        group: length_of_v,
    },
    Law {
        name: "mirror",
        says: "seen in the mirror direction, the highlight is k_s I",
        needs: &[Need::Highlight, Need::Lamp],
        group: mirror,
    },
    Law {
        name: "eye_for_light",
        says: "the highlight is the same with eye and light exchanged",
        needs: &[Need::Highlight, Need::Lamp],
        group: eye_for_light,
    },
    Law {
        name: "shininess",
        says: "a higher shininess does not brighten",
        needs: &[Need::Highlight],
        group: shininess,
    },
    Law {
        name: "dark_side",
        says: "a highlight needs N·L > 0",
        needs: &[Need::GatedHighlight],
        group: dark_side,
    },
    Law {
        name: "distance",
        says: "a lamp farther away in the same direction does not brighten",
        needs: &[Need::PointLight],
        group: distance,
    },
    Law {
        name: "far_lamp",
        says: "a lamp far away that is not attenuated is a directional light",
        needs: &[Need::Sun],
        group: far_lamp,
    },
    Law {
        name: "unit_of_length",
        says: "the unit of length does not matter",
        needs: &[],
        group: unit_of_length,
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
        needs: &[Need::PointAndSpot],
        group: cone,
    },
    Law {
        name: "wider_cone",
        says: "a wider cone does not darken",
        needs: &[Need::SpotLight],
        group: wider_cone,
    },
    Law {
        name: "formula",
        says: "the color is that of the formula, within the renderer's precision",
        needs: &[],
        group: formula,
    },
];

// ---- one scene

fn one(scene: Scene, relation: Relation, says: &'static str) -> Option<Group> {
    Some(Group {
        scenes: vec![scene],
        claims: vec![Claim::new(says, relation, &[(1.0, 0)])],
    })
}

fn ambient_alone(base: Base, _: &Profile) -> Option<Group> {
    let mut scene = base.scene;
    scene.lights.clear();
    let ambient = times(scene.material.k_a, scene.i_a);
    let claim = Claim::new("the color is k_a I_a", Relation::Zero, &[(1.0, 0)]);
    Some(Group {
        scenes: vec![scene],
        claims: vec![claim.plus(ambient.map(|c| -c), [0.0; 3])],
    })
}

fn bound(base: Base, profile: &Profile) -> Option<Group> {
    let mut scene = base.scene;
    if profile.unattenuated_highlight {
        scene.material.k_s = [0.0; 3];
    }
    let p = Vec3::from(scene.p);
    // all factors at 1: N·L, the power and the cone
    let Material { k_a, k_d, k_s, .. } = scene.material;
    let mut most = times(k_a, scene.i_a);
    if profile.attenuated_ambient {
        let sum: f64 = scene
            .lights
            .iter()
            .map(|light| reference::falloff(light, p))
            .sum();
        most = most.map(|c| c * sum);
    }
    for light in &scene.lights {
        let (intensity, factor) = (light.intensity(), reference::falloff(light, p));
        most = from_fn(|i| most[i] + (k_d[i] + k_s[i]) * intensity[i] * factor);
    }
    let slack = most.map(|c| 64.0 * profile.roundoff * c);
    let claim = Claim::new(
        "the color is at most k_a I_a + Σ (k_d + k_s) I/(a + bq + cq²)",
        Relation::NotNegative,
        &[(-1.0, 0)],
    );
    Some(Group {
        scenes: vec![scene],
        claims: vec![claim.plus(most, slack)],
    })
}

fn mirror(base: Base, profile: &Profile) -> Option<Group> {
    let mut scene = base.scene;
    let way = base.ways[0];
    let n = scene.n;
    let (twice, square) = (2.0 * dot(n, way), dot(n, n));
    if twice <= 0.0 {
        return None;
    }
    let intensity = [1.0, 0.5, 0.25];
    scene.v = profile.direction(from_fn(|i| twice * n[i] - square * way[i]));
    scene.material.k_d = [0.0; 3];
    scene.i_a = [0.0; 3];
    scene.lights = vec![lamp(profile, scene.p, way, intensity)];
    if scene.model == Model::Lambert {
        return None;
    }
    let highlight = times(scene.material.k_s, intensity);
    let claim = Claim::new("the color is k_s I", Relation::Zero, &[(1.0, 0)]);
    Some(Group {
        scenes: vec![scene],
        claims: vec![claim.plus(highlight.map(|c| -c), [0.0; 3])],
    })
}

fn formula(base: Base, profile: &Profile) -> Option<Group> {
    let color = reference::color(&base.scene, profile);
    let claim = Claim::new(
        "the color is that of the formula",
        Relation::Zero,
        &[(1.0, 0)],
    );
    Some(Group {
        scenes: vec![base.scene],
        claims: vec![claim.plus(color.map(|c| -c), color.map(|c| 1e-15 * c))],
    })
}

// ---- lights

fn no_memory(base: Base, profile: &Profile) -> Option<Group> {
    let mut other = base.scene.clone();
    other.lights = vec![lamp(profile, other.p, base.ways[0], [1.0; 3])];
    other.material.k_d = [1.0; 3];
    Some(Group {
        scenes: vec![base.scene.clone(), other, base.scene],
        claims: vec![Claim::new(
            "the first color is the third",
            Relation::Zero,
            &[(1.0, 0), (-1.0, 2)],
        )],
    })
}

fn additive(base: Base, _: &Profile) -> Option<Group> {
    let all = base.scene;
    if all.lights.len() < 2 {
        return None;
    }
    let with = |lights: &[Light]| Scene {
        lights: lights.to_vec(),
        ..all.clone()
    };
    let mut scenes = vec![all.clone(), with(&[])];
    scenes.extend(all.lights.chunks(1).map(with));
    // all − none = Σ (each − none)
    #[allow(clippy::cast_precision_loss)] // the count of lights
    let mut terms = vec![(1.0, 0), (all.lights.len() as f64 - 1.0, 1)];
    terms.extend((2..scenes.len()).map(|each| (-1.0, each)));
    let says = "the first color is the sum of those with one light each, with the ambient light (second scene) counted once";
    Some(Group {
        scenes,
        claims: vec![Claim::new(says, Relation::Zero, &terms)],
    })
}

fn order(base: Base, _: &Profile) -> Option<Group> {
    let mut other = base.scene.clone();
    other.lights.reverse();
    (other.lights.len() > 1)
        .then(|| pair(base.scene, other, Claim::same("both colors are the same")))
}

fn black_light(base: Base, profile: &Profile) -> Option<Group> {
    let (way, mut scene) = (base.ways[0], base.scene);
    if profile.attenuated_ambient {
        scene.i_a = [0.0; 3]; // even a black light brings it along
    }
    let mut other = scene.clone();
    let black = match scene.lights.first() {
        Some(light) => light.with_intensity([0.0; 3]),
        None => lamp(profile, scene.p, way, [0.0; 3]),
    };
    other.lights.push(black);
    fits(&other, profile)?;
    Some(pair(scene, other, Claim::same("both colors are the same")))
}

fn behind(base: Base, profile: &Profile) -> Option<Group> {
    let (way, mut scene) = (base.ways[0], base.scene);
    if profile.attenuated_ambient {
        scene.i_a = [0.0; 3];
    }
    if profile.highlight_on_the_dark_side {
        scene.material.k_s = [0.0; 3];
    }
    let way = if dot(way, scene.n) > 0.0 {
        way.map(|c| -c)
    } else {
        way
    };
    let mut other = scene.clone();
    other.lights.push(lamp(profile, scene.p, way, [1.0; 3]));
    fits(&other, profile)?;
    Some(pair(scene, other, Claim::same("both colors are the same")))
}

fn dark_side(base: Base, profile: &Profile) -> Option<Group> {
    let mut scene = base.scene;
    let way = base.ways[0];
    if scene.model == Model::Lambert {
        return None;
    }
    let way = if dot(way, scene.n) > 0.0 {
        way.map(|c| -c)
    } else {
        way
    };
    scene.material = Material {
        k_d: [0.0; 3],
        k_s: [1.0; 3],
        m: scene.material.m.min(2.0),
        ..scene.material
    };
    scene.i_a = [0.0; 3];
    scene.lights = vec![lamp(profile, scene.p, way, [1.0; 3])];
    one(scene, Relation::Zero, "the color is black")
}

fn distance(base: Base, _: &Profile) -> Option<Group> {
    let (way, mut scene) = (base.ways[0], base.scene);
    scene.lights = vec![point(&scene, way, base.factors)];
    scene.i_a = [0.0; 3];
    let mut other = scene.clone();
    let way = way.map(|c| c * (1.0 + base.factors[0] / 4.0));
    other.lights = vec![point(&other, way, base.factors)];
    Some(pair(
        scene,
        other,
        Claim::brighter("the first color, of the lamp nearby, is the brighter"),
    ))
}

/// A white point light on the way, attenuated by factors of 1 to 8.
fn point(scene: &Scene, way: Triple, [a, b, c]: Triple) -> Light {
    Light::Point {
        position: from_fn(|i| scene.p[i] + way[i]),
        intensity: [1.0; 3],
        attenuation: [a / 4.0, (b - 1.0) / 8.0, (c - 1.0) / 8.0],
    }
}

fn far_lamp(base: Base, profile: &Profile) -> Option<Group> {
    let (way, mut scene) = (base.ways[0], base.scene);
    scene.i_a = [0.0; 3];
    let mut other = scene.clone();
    let intensity = [1.0, 0.5, 0.25];
    scene.lights = vec![Light::Directional {
        l: profile.unit(way),
        intensity,
    }];
    other.lights = vec![Light::Point {
        // a power of two so large, so that the sum with p is still exact in f32
        position: from_fn(|i| scene.p[i] + 256.0 * way[i]),
        intensity,
        attenuation: [1.0, 0.0, 0.0],
    }];
    Some(pair(scene, other, Claim::same("both colors are the same")))
}

fn cone(base: Base, profile: &Profile) -> Option<Group> {
    let mut scene = base.scene;
    let way = base.ways[0];
    let [side, degrees, _] = base.factors;
    let position: Triple = from_fn(|i| scene.p[i] + way[i]);
    let intensity = [1.0, 0.5, 0.25];
    let attenuation = [1.0, 0.0, 0.25];
    // a way off the axis by an angle that is far from the edge of the cone
    let aim = base.ways[1].map(|c| c * side / 4.0);
    let axis = profile.unit(from_fn(
        |i| if aim == way { -way[i] } else { aim[i] - way[i] },
    ));
    let half_angle = profile.rounded((10.0 * degrees).to_radians());
    let l = crate::generator::unit(way);
    let off = (-dot(axis, l)).clamp(-1.0, 1.0).acos() - half_angle;
    if off.abs() < 0.05 {
        return None;
    }
    let mut other = scene.clone();
    scene.lights = vec![Light::Spot {
        position,
        intensity,
        attenuation,
        axis,
        half_angle,
    }];
    let lit = Light::Point {
        position,
        intensity,
        attenuation,
    };
    if off < 0.0 {
        other.lights = vec![lit];
    } else if profile.attenuated_ambient {
        return None;
    } else {
        other.lights = vec![];
    }
    let says =
        "the spot (first scene) gives the color of the point light, or of no light (second scene)";
    Some(pair(scene, other, Claim::same(says)))
}

fn wider_cone(base: Base, profile: &Profile) -> Option<Group> {
    let mut scene = base.scene;
    let light = scene
        .lights
        .iter()
        .find(|light| matches!(light, Light::Spot { .. }))?;
    let (mut narrow, mut wide) = (*light, *light);
    if let (
        Light::Spot {
            half_angle: narrow, ..
        },
        Light::Spot {
            half_angle: wide, ..
        },
    ) = (&mut narrow, &mut wide)
    {
        let [first, second, _] = base.factors;
        *narrow = profile.rounded((5.0 * first).to_radians());
        *wide = profile.rounded((5.0 * (first + second)).to_radians());
    }
    scene.lights = vec![wide];
    let other = Scene {
        lights: vec![narrow],
        ..scene.clone()
    };
    Some(pair(
        scene,
        other,
        Claim::brighter("the first color, of the wider cone, is the brighter"),
    ))
}

// ---- light and material

fn scale(base: Base, profile: &Profile) -> Option<Group> {
    let factor = match profile.range() {
        Some(_) => 0.5, // twice as much would often be clamped
        None => base.factors[0],
    };
    let mut other = base.scene.clone();
    other.i_a = other.i_a.map(|c| c * factor);
    for light in &mut other.lights {
        *light = light.with_intensity(light.intensity().map(|c| c * factor));
    }
    let says = "the color of the second scene is the factor of its light times that of the first";
    let claim = Claim::new(says, Relation::Zero, &[(factor, 0), (-1.0, 1)]);
    Some(pair(base.scene, other, claim))
}

fn terms(base: Base, _: &Profile) -> Option<Group> {
    let scene = base.scene;
    let black = [0.0; 3];
    let with = |k_a, k_d, k_s| Scene {
        material: Material {
            k_a,
            k_d,
            k_s,
            ..scene.material
        },
        ..scene.clone()
    };
    let Material { k_a, k_d, k_s, .. } = scene.material;
    let scenes = vec![
        scene.clone(),
        with(k_a, black, black),
        with(black, k_d, black),
        with(black, black, k_s),
    ];
    let says = "the first color is the sum of those with only k_a, only k_d and only k_s";
    let claim = Claim::new(
        says,
        Relation::Zero,
        &[(1.0, 0), (-1.0, 1), (-1.0, 2), (-1.0, 3)],
    );
    Some(Group {
        scenes,
        claims: vec![claim],
    })
}

fn shininess(base: Base, profile: &Profile) -> Option<Group> {
    let mut scene = base.scene;
    if scene.model == Model::Lambert {
        return None;
    }
    scene.material.k_d = [0.0; 3];
    scene.i_a = [0.0; 3];
    let mut other = scene.clone();
    other.material.m += base.factors[0];
    fits(&other, profile)?;
    Some(pair(
        scene,
        other,
        Claim::brighter("the first color, of the lower shininess, is the brighter"),
    ))
}

fn channels_alike(base: Base, _: &Profile) -> Option<Group> {
    let shifted = |c: Triple| [c[2], c[0], c[1]];
    let mut other = map_colors(&base.scene, shifted);
    other.i_a = shifted(other.i_a);
    let mut claim =
        Claim::same("the second color has the channels of the first, each one place on");
    claim.terms[1] = Term {
        shift: 1,
        ..claim.terms[1]
    };
    Some(pair(base.scene, other, claim))
}

fn channels_apart(base: Base, _: &Profile) -> Option<Group> {
    // a surface and lights that are not red
    let without = |c: Triple| [0.0, c[1], c[2]];
    let mut other = map_colors(&base.scene, without);
    other.i_a = without(other.i_a);
    let mut claim = Claim::same("green and blue are the same");
    claim.channels = [false, true, true];
    Some(pair(base.scene, other, claim))
}

fn map_colors(scene: &Scene, f: impl Fn(Triple) -> Triple) -> Scene {
    let mut scene = scene.clone();
    let Material { k_a, k_d, k_s, m } = scene.material;
    scene.material = Material {
        k_a: f(k_a),
        k_d: f(k_d),
        k_s: f(k_s),
        m,
    };
    for light in &mut scene.lights {
        *light = light.with_intensity(f(light.intensity()));
    }
    scene
}

// ---- directions

fn eye(base: Base, profile: &Profile) -> Option<Group> {
    let mut scene = base.scene;
    scene.material.k_s = [0.0; 3];
    let other = Scene {
        v: profile.direction(base.ways[0]),
        ..scene.clone()
    };
    Some(pair(scene, other, Claim::same("both colors are the same")))
}

fn toward_the_normal(base: Base, profile: &Profile) -> Option<Group> {
    let mut scene = base.scene;
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

fn both_reversed(base: Base, profile: &Profile) -> Option<Group> {
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

fn length_of_n(base: Base, _: &Profile) -> Option<Group> {
    let mut other = base.scene.clone();
    let factor = (base.factors[0] + 1.0) / 8.0;
    other.n = other.n.map(|c| c * factor);
    Some(pair(
        base.scene,
        other,
        Claim::same("both colors are the same"),
    ))
}

fn length_of_v(base: Base, _: &Profile) -> Option<Group> {
    let mut other = base.scene.clone();
    let factor = (base.factors[0] + 1.0) / 4.0;
    other.v = other.v.map(|c| c * factor);
    Some(pair(
        base.scene,
        other,
        Claim::same("both colors are the same"),
    ))
}

fn eye_for_light(base: Base, profile: &Profile) -> Option<Group> {
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

// ---- motion

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
                *position = point(*position);
                *axis = direction(*axis);
            }
        }
    }
    scene
}

fn unit_of_length(base: Base, _: &Profile) -> Option<Group> {
    // a power of two, so that the numbers stay exact
    let unit = (base.factors[0] - 4.0).exp2();
    let mut other = moved(&base.scene, |p| p.map(|c| c * unit), |d| d);
    for light in &mut other.lights {
        if let Light::Point { attenuation, .. } | Light::Spot { attenuation, .. } = light {
            let [a, b, c] = *attenuation;
            *attenuation = [a, b / unit, c / (unit * unit)];
        }
    }
    Some(pair(
        base.scene,
        other,
        Claim::same("both colors are the same"),
    ))
}

fn translation(base: Base, _: &Profile) -> Option<Group> {
    let offset = base.factors.map(|c| c - 4.0);
    let add = |p: Triple| from_fn(|i| p[i] + offset[i]);
    let other = moved(&base.scene, add, |d| d);
    Some(pair(
        base.scene,
        other,
        Claim::same("both colors are the same"),
    ))
}

fn rotation(base: Base, _: &Profile) -> Option<Group> {
    // one of the 24 rotations of the cube, which are exact
    let [first, second, third] = base.factors;
    let turn = |v: Triple| [v[0], -v[2], v[1]]; // by 90° about x
    let cycle = |v: Triple| [v[2], v[0], v[1]]; // by 120° about the diagonal
    let turns = move |mut v: Triple| {
        for (rotate, times) in [
            (&turn as &dyn Fn(Triple) -> Triple, first),
            (&cycle, second),
            (&turn, third),
        ] {
            for _ in 0..times as u32 {
                v = rotate(v);
            }
        }
        v
    };
    let other = moved(&base.scene, turns, turns);
    Some(pair(
        base.scene,
        other,
        Claim::same("both colors are the same"),
    ))
}

// ---- parts

fn pair(first: Scene, second: Scene, claim: Claim) -> Group {
    Group {
        scenes: vec![first, second],
        claims: vec![claim],
    }
}

/// A light from this direction that is not attenuated.
fn lamp(profile: &Profile, p: Triple, way: Triple, intensity: Triple) -> Light {
    let position = from_fn(|i| p[i] + way[i]);
    let attenuation = [1.0, 0.0, 0.0];
    if profile.directional_lights {
        Light::Directional {
            l: profile.unit(way),
            intensity,
        }
    } else if profile.point_lights {
        Light::Point {
            position,
            intensity,
            attenuation,
        }
    } else {
        Light::Spot {
            position,
            intensity,
            attenuation,
            axis: profile.unit(way.map(|c| -c)),
            half_angle: profile.rounded(1.0),
        }
    }
}

/// Nothing if the scene is beyond what the renderer has.
fn fits(scene: &Scene, profile: &Profile) -> Option<()> {
    let fits = scene.lights.len() <= profile.most_lights && scene.material.m <= profile.most_shiny;
    fits.then_some(())
}

fn dot(a: Triple, b: Triple) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn times(a: Triple, b: Triple) -> Triple {
    from_fn(|i| a[i] * b[i])
}
