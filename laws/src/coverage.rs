//! What a run exercised of what the renderer says it has.

use std::fmt;

use serde::Serialize;

use crate::formula::Formula;
use crate::profile::Profile;
use crate::scene::{Kind, Light, Model, Scene};

/// Something that a renderer says it has, and how much of it was exercised.
#[derive(Clone, Debug, PartialEq, Serialize)]
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

impl fmt::Display for Exercised {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self {
            what,
            exercised,
            declared,
        } = self;
        match *what {
            "lights in a scene" => write!(f, "{exercised} of {declared} {what}"),
            "shininess" => write!(f, "{what} up to {exercised} of {declared}"),
            _ => write!(f, "{what}"),
        }
    }
}

#[derive(Clone, Default)]
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
        let formula = Formula::new(profile, &[]);
        let counts = |lights: &[Light]| {
            let alone = Scene {
                lights: lights.to_vec(),
                k_a: [0.0; 3],
                ..scene.clone()
            };
            formula.linear(&alone).iter().any(|c| c.value > c.error)
        };
        if scene.lights.len() > self.lights {
            let all = scene.lights.iter().filter(|light| counts(&[**light]));
            self.lights = self.lights.max(all.count());
        }
        for light in &scene.lights {
            let kind = light.kind() as usize;
            self.kinds[kind] = self.kinds[kind] || counts(&[*light]);
        }
        let has_highlight = scene.model != Model::Lambert && scene.k_s.iter().any(|k| *k > 0.0);
        let is_new = has_highlight && scene.m > self.shininess;
        let is_shown = is_new || !self.models[scene.model as usize];
        if is_shown && !scene.lights.is_empty() && counts(&scene.lights) {
            self.models[scene.model as usize] = true;
            if is_new {
                self.shininess = scene.m;
            }
        }
        let ambient = (0..3).any(|i| scene.k_a[i] * scene.i_a[i] > 0.0);
        self.is_ambient = self.is_ambient || ambient;
        if let (false, Some([_, high])) = (self.beyond_the_range, profile.range()) {
            self.beyond_the_range = formula.linear(scene).iter().any(|c| c.value > high);
        }
    }

    /// What was declared, a line each.
    #[allow(clippy::cast_precision_loss)] // small counts
    pub fn of(&self, profile: &Profile) -> Vec<Exercised> {
        let models = ["Lambert's model", "Phong's model", "Blinn's model"];
        let kinds = ["directional lights", "point lights", "spot lights"];
        let models = Model::ALL.into_iter().zip(models).zip(self.models);
        let kinds = Kind::ALL.into_iter().zip(kinds).zip(self.kinds);
        let range = profile.range().is_some_and(|[_, high]| high <= 2.0);
        let parts = models
            .map(|((model, what), is_shown)| (what, profile.models.contains(&model), is_shown))
            .chain(kinds.map(|((kind, what), is_shown)| (what, profile.has(kind), is_shown)))
            .chain([
                ("ambient light", profile.ambient, self.is_ambient),
                ("colors beyond the range", range, self.beyond_the_range),
            ])
            .map(|(what, has, is_shown)| {
                (
                    what,
                    f64::from(u8::from(is_shown)),
                    f64::from(u8::from(has)),
                )
            });
        let m = if profile.has_highlights() {
            profile.shininess(profile.most_shiny)
        } else {
            0.0
        };
        let sizes = [
            (
                "lights in a scene",
                self.lights as f64,
                profile.most_lights as f64,
            ),
            ("shininess", self.shininess, m),
        ];
        parts
            .chain(sizes)
            .filter(|(.., declared)| *declared > 0.0)
            .map(|(what, exercised, declared)| Exercised {
                what,
                exercised,
                declared,
            })
            .collect()
    }
}
