//! Laws about the color of a single scene.

use std::array::from_fn;

use shading::f64::Vec3;

use crate::claim::{Claim, Group, Relation};
use crate::generator::Base;
use crate::law::part::{dot, facing, lamp, times};
use crate::profile::Profile;
use crate::reference;
use crate::scene::{Material, Model, Scene};

pub fn one(scene: Scene, relation: Relation, says: &'static str) -> Option<Group> {
    Some(Group {
        scenes: vec![scene],
        claims: vec![Claim::new(says, relation, &[(1.0, 0)])],
    })
}

pub fn finite(base: Base, _: &Profile) -> Option<Group> {
    one(base.scene, Relation::Finite, "the color is finite")
}

pub fn as_said(base: Base, profile: &Profile) -> Option<Group> {
    profile.range()?;
    one(
        base.scene,
        Relation::AsSaid,
        "the color is as the profile says",
    )
}

pub fn not_negative(base: Base, _: &Profile) -> Option<Group> {
    one(
        base.scene,
        Relation::NotNegative,
        "the color is not negative",
    )
}

pub fn ambient_alone(base: Base, profile: &Profile) -> Option<Group> {
    let mut scene = base.scene;
    scene.lights.clear();
    let mut ambient = times(scene.material.k_a, scene.i_a);
    if profile.ambient_times_diffuse {
        ambient = times(ambient, scene.material.k_d);
    }
    let claim = Claim::new("the color is k_a I_a", Relation::Zero, &[(1.0, 0)]);
    Some(Group {
        scenes: vec![scene],
        claims: vec![claim.plus(ambient.map(|c| -c), [0.0; 3])],
    })
}

pub fn bound(base: Base, profile: &Profile) -> Option<Group> {
    let mut scene = base.scene;
    if profile.unattenuated_highlight {
        scene.material.k_s = [0.0; 3];
    }
    let p = Vec3::from(scene.p);
    // all factors at 1: N·L, the power and the cone
    let Material { k_a, k_d, k_s, .. } = scene.material;
    let mut most = times(k_a, scene.i_a);
    if profile.ambient_times_diffuse {
        most = times(most, k_d);
    }
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

pub fn mirror(base: Base, profile: &Profile) -> Option<Group> {
    let mut scene = facing(base.scene, profile);
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

pub fn formula(base: Base, profile: &Profile) -> Option<Group> {
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
