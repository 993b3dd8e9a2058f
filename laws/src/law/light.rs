//! Laws about lights and where they are.

use std::array::from_fn;

use crate::claim::{Claim, Group, Relation};
use crate::generator::Base;
use crate::law::part::{dot, facing, fits, lamp, pair};
use crate::law::single::one;
use crate::profile::Profile;
use crate::scene::{Light, Material, Model, Scene, Triple};

pub fn no_memory(base: Base, profile: &Profile) -> Option<Group> {
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

pub fn repeatable(base: Base, _: &Profile) -> Option<Group> {
    let scenes = vec![base.scene.clone(), base.scene];
    let says = "both answers are the same";
    Some(Group {
        scenes,
        claims: vec![Claim::same(says)],
    })
}

pub fn additive(base: Base, profile: &Profile) -> Option<Group> {
    let mut all = base.scene;
    if profile.black_without_lights {
        all.i_a = [0.0; 3]; // it comes with the first light
    }
    if all.lights.len() < 2 || all.lights.len() > 16 {
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

pub fn order(base: Base, _: &Profile) -> Option<Group> {
    let mut other = base.scene.clone();
    other.lights.reverse();
    (other.lights.len() > 1)
        .then(|| pair(base.scene, other, Claim::same("both colors are the same")))
}

pub fn black_light(base: Base, profile: &Profile) -> Option<Group> {
    let (way, mut scene) = (base.ways[0], base.scene);
    if profile.attenuated_ambient || profile.black_without_lights {
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

pub fn behind(base: Base, profile: &Profile) -> Option<Group> {
    let (way, mut scene) = (base.ways[0], facing(base.scene, profile));
    if profile.attenuated_ambient || profile.black_without_lights {
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

pub fn dark_side(base: Base, profile: &Profile) -> Option<Group> {
    let mut scene = facing(base.scene, profile);
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

pub fn distance(base: Base, _: &Profile) -> Option<Group> {
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

pub fn far_lamp(base: Base, profile: &Profile) -> Option<Group> {
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

pub fn cone(base: Base, profile: &Profile) -> Option<Group> {
    let mut scene = base.scene;
    let way = base.ways[0];
    let [side, degrees, _] = base.factors;
    let position: Triple = from_fn(|i| scene.p[i] + way[i]);
    let intensity = [1.0, 0.5, 0.25];
    let attenuation = [1.0, 0.0, if profile.unattenuated { 0.0 } else { 0.25 }];
    // a way off the axis by an angle that is far from the edge of the cone
    let aim = base.ways[1].map(|c| c * side / 4.0);
    let axis = profile.unit(from_fn(
        |i| if aim == way { -way[i] } else { aim[i] - way[i] },
    ));
    let half_angle = profile.rounded((10.0 * degrees).to_radians());
    let l = crate::generator::unit(way);
    let off = (-dot(axis, l)).clamp(-1.0, 1.0).acos() - half_angle;
    if off.abs() < 0.05 || profile.spot_exponent > 0.0 && off < 0.0 {
        return None;
    }
    if profile.black_without_lights {
        scene.i_a = [0.0; 3];
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

pub fn wider_cone(base: Base, profile: &Profile) -> Option<Group> {
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
