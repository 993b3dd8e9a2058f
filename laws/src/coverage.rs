//! What a run exercised of what the renderer says it has.

use crate::profile::Profile;
use crate::scene::{Light, Material, Model, Scene};
use crate::textbook::Textbook;

/// Something that a renderer says it has, and how much of it was exercised.
#[derive(Clone, Debug, PartialEq)]
pub struct Exercised {
    /// What the renderer says it has.
    pub what: &'static str,
    /// How much of it a scene showed.
    pub exercised: f64,
    /// How much it says it has.
    pub declared: f64,
}

impl Exercised {
    /// Whether all of it was exercised.
    #[must_use]
    pub fn is_all(&self) -> bool {
        self.exercised >= self.declared
    }
}

#[derive(Default)]
pub struct Coverage {
    models: [bool; 3],
    kinds: [bool; 3],
    lights: usize,
    shininess: f64,
    is_ambient: bool,
    beyond_the_range: bool,
}

impl Coverage {
    pub fn note(&mut self, scene: &Scene, profile: &Profile) {
        let has_highlight =
            scene.model != Model::Lambert && scene.material.k_s.iter().any(|k| *k > 0.0);
        let counts = |lights: &[Light]| {
            let alone = Scene {
                lights: lights.to_vec(),
                material: Material {
                    k_a: [0.0; 3],
                    ..scene.material
                },
                ..scene.clone()
            };
            let color = Textbook::new(profile, &[]).linear(&alone);
            color.iter().any(|c| c.value > c.error)
        };
        if scene.lights.len() > self.lights {
            let all = scene.lights.chunks(1).filter(|light| counts(light)).count();
            self.lights = self.lights.max(all);
        }
        for light in &scene.lights {
            let kind = match light {
                Light::Directional { .. } => 0,
                Light::Point { .. } => 1,
                Light::Spot { .. } => 2,
            };
            self.kinds[kind] = self.kinds[kind] || counts(&[*light]);
        }
        let is_new = has_highlight && scene.material.m > self.shininess;
        let is_shown = is_new || !self.models[scene.model as usize];
        if is_shown && !scene.lights.is_empty() && counts(&scene.lights) {
            self.models[scene.model as usize] = true;
            if is_new {
                self.shininess = scene.material.m;
            }
        }
        let ambient = (0..3).any(|i| scene.material.k_a[i] * scene.i_a[i] > 0.0);
        self.is_ambient = self.is_ambient || ambient;
        if let (false, Some([_, high])) = (self.beyond_the_range, profile.range()) {
            let color = Textbook::new(profile, &[]).linear(scene);
            self.beyond_the_range = color.iter().any(|c| c.value > high);
        }
    }

    /// What was declared, a line each.
    #[allow(clippy::cast_precision_loss)] // small counts
    pub fn of(&self, profile: &Profile) -> Vec<Exercised> {
        let once = |what, declared: bool, exercised: bool| {
            let exercised = f64::from(u8::from(exercised));
            declared.then_some(Exercised {
                what,
                exercised,
                declared: 1.0,
            })
        };
        let has = |model| profile.models.contains(&model);
        let has_highlight = profile.models.iter().any(|model| *model != Model::Lambert);
        let lines = [
            once("Lambert's model", has(Model::Lambert), self.models[0]),
            once("Phong's model", has(Model::Phong), self.models[1]),
            once("Blinn's model", has(Model::BlinnPhong), self.models[2]),
            once("ambient light", profile.ambient, self.is_ambient),
            once(
                "directional lights",
                profile.directional_lights,
                self.kinds[0],
            ),
            once("point lights", profile.point_lights, self.kinds[1]),
            once("spot lights", profile.spot_lights, self.kinds[2]),
            once(
                "colors beyond the range",
                profile.range().is_some_and(|[_, high]| high <= 2.0),
                self.beyond_the_range,
            ),
            Some(Exercised {
                what: "lights in a scene",
                exercised: self.lights as f64,
                declared: profile.most_lights as f64,
            }),
            has_highlight.then(|| Exercised {
                what: "shininess",
                exercised: self.shininess,
                declared: if profile.integer_shininess {
                    profile.most_shiny.floor()
                } else {
                    profile.rounded(profile.most_shiny).min(profile.most_shiny)
                },
            }),
        ];
        lines.into_iter().flatten().collect()
    }
}
