//! The laws.

#![allow(clippy::unnecessary_wraps)] // a law may say nothing about a scene, and some always say something

mod direction;
mod light;
mod material;
mod motion;
mod part;
mod single;

use crate::claim::Group;
use crate::generator::Base;
use crate::profile::Profile;
use crate::scene::Model;

/// A law: a statement, what a renderer needs to be put to it, and the scenes that show it.
#[derive(Clone, Copy)]
pub struct Law {
    pub name: &'static str,
    pub says: &'static str,
    needs: &'static [Need],
    group: fn(Base, &Profile) -> Option<Group>,
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
    OneSide,
    Attenuation,
    Lit,
}

impl Law {
    const fn new(
        name: &'static str,
        says: &'static str,
        needs: &'static [Need],
        group: fn(Base, &Profile) -> Option<Group>,
    ) -> Self {
        Self {
            name,
            says,
            needs,
            group,
        }
    }

    /// The scenes and claims, or nothing if the law says nothing about this scene.
    pub fn group(&self, base: Base, profile: &Profile) -> Option<Group> {
        let way = base.ways[0];
        let mut group = (self.group)(base, profile)?;
        // what happens without lights is left to the formula
        if profile.unlit_without_lights && !self.is_of_one_scene() {
            for scene in &mut group.scenes {
                if scene.lights.is_empty() {
                    scene
                        .lights
                        .push(part::lamp(profile, scene.p, way, [0.0; 3]));
                }
            }
        }
        Some(group)
    }

    /// Its place among all laws.
    pub fn index(&self) -> usize {
        let place = LAWS.iter().position(|law| law.name == self.name);
        place.unwrap_or(0)
    }

    /// Whether its scenes are those that were generated, so that no edge is to be left out.
    pub fn is_of_one_scene(&self) -> bool {
        ["finite", "as_said", "not_negative", "formula"].contains(&self.name)
    }

    /// Whether its scenes are asked for in two batches.
    pub fn asks_twice(&self) -> bool {
        self.name == "repeatable"
    }

    /// Why the law cannot be tried, if it cannot.
    pub fn lacks(&self, profile: &Profile) -> Option<&'static str> {
        let has_highlight = profile.models.iter().any(|model| *model != Model::Lambert);
        self.needs.iter().find_map(|need| {
            let (has, lacks) = match need {
                Need::Ambient => (
                    profile.ambient && !profile.attenuated_ambient && !profile.black_without_lights,
                    "it has no ambient light of its own",
                ),
                Need::Lit => (!profile.unlit_without_lights, "without lights, it is unlit"),
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
                Need::OneSide => (!profile.normal_faces_eye, "its normals face the eye"),
                Need::Attenuation => (!profile.unattenuated, "it has no attenuation"),
                Need::AnyLength => (!profile.unit_vectors, "it needs unit vectors"),
            };
            (!has).then_some(lacks)
        })
    }
}

/// Every law, in the order of the report.
pub const LAWS: &[Law] = &[
    Law::new("finite", "every color is finite", &[], single::finite),
    Law::new(
        "as_said",
        "colors are in the range and the levels that the renderer promises",
        &[],
        single::as_said,
    ),
    Law::new(
        "not_negative",
        "no light is negative",
        &[],
        single::not_negative,
    ),
    Law::new(
        "no_memory",
        "a scene has the same color wherever it is in a batch",
        &[],
        light::no_memory,
    ),
    Law::new(
        "repeatable",
        "a batch that is asked again has the same colors",
        &[],
        light::repeatable,
    ),
    Law::new(
        "ambient_alone",
        "without lights there is k_a I_a",
        &[Need::Ambient, Need::Lit],
        single::ambient_alone,
    ),
    Law::new(
        "additive",
        "the light of several lights is the sum of the light of each",
        &[Need::TwoLights],
        light::additive,
    ),
    Law::new(
        "order",
        "the order of the lights does not matter",
        &[Need::TwoLights],
        light::order,
    ),
    Law::new(
        "black_light",
        "a black light changes nothing",
        &[Need::TwoLights],
        light::black_light,
    ),
    Law::new(
        "scale",
        "twice the light gives twice the color",
        &[],
        material::scale,
    ),
    Law::new(
        "terms",
        "ambient, diffuse and specular light add up",
        &[],
        material::terms,
    ),
    Law::new(
        "channels_alike",
        "red, green and blue are computed alike",
        &[],
        material::channels_alike,
    ),
    Law::new(
        "channels_apart",
        "red does not change green and blue",
        &[],
        material::channels_apart,
    ),
    Law::new(
        "bound",
        "no more light comes back than k_a I_a + Σ (k_d + k_s) I/(a + bq + cq²)",
        &[],
        single::bound,
    ),
    Law::new(
        "behind",
        "a light behind the surface adds nothing",
        &[Need::TwoLights],
        light::behind,
    ),
    Law::new(
        "eye",
        "diffuse light does not depend on the eye",
        &[],
        direction::eye,
    ),
    Law::new(
        "toward_the_normal",
        "a light that is tilted toward the normal does not darken a diffuse surface",
        &[Need::Lamp],
        direction::toward_the_normal,
    ),
    Law::new(
        "both_reversed",
        "with N and every L reversed, a diffuse surface looks the same",
        &[Need::Lamp, Need::OneSide],
        direction::both_reversed,
    ),
    Law::new(
        "length_of_n",
        "the length of the vector along N does not matter",
        &[Need::AnyLength],
        direction::length_of_n,
    ),
    Law::new(
        "length_of_v",
        "the distance of the eye does not matter",
        &[Need::AnyLength],
        direction::length_of_v,
    ),
    Law::new(
        "mirror",
        "seen in the mirror direction, the highlight is k_s I",
        &[Need::Highlight, Need::Lamp],
        single::mirror,
    ),
    Law::new(
        "eye_for_light",
        "the highlight is the same with eye and light exchanged",
        &[Need::Highlight, Need::Lamp],
        direction::eye_for_light,
    ),
    Law::new(
        "shininess",
        "a higher shininess does not brighten",
        &[Need::Highlight],
        material::shininess,
    ),
    Law::new(
        "dark_side",
        "a highlight needs N·L > 0",
        &[Need::GatedHighlight],
        light::dark_side,
    ),
    Law::new(
        "distance",
        "a lamp farther away in the same direction does not brighten",
        &[Need::PointLight, Need::Attenuation],
        light::distance,
    ),
    Law::new(
        "far_lamp",
        "a lamp far away that is not attenuated is a directional light",
        &[Need::Sun],
        light::far_lamp,
    ),
    Law::new(
        "unit_of_length",
        "the unit of length does not matter",
        &[],
        motion::unit_of_length,
    ),
    Law::new(
        "translation",
        "moving everything changes nothing",
        &[],
        motion::translation,
    ),
    Law::new(
        "rotation",
        "turning everything changes nothing",
        &[],
        motion::rotation,
    ),
    Law::new(
        "cone",
        "a spot is a point light within its cone, and dark outside",
        &[Need::PointAndSpot],
        light::cone,
    ),
    Law::new(
        "wider_cone",
        "a wider cone does not darken",
        &[Need::SpotLight],
        light::wider_cone,
    ),
    Law::new(
        "formula",
        "the color is that of the formula, within the renderer's precision",
        &[],
        single::formula,
    ),
];
