//! The laws: those of one scene, those between a scene and an edited one, and two of several scenes.

use std::sync::LazyLock;

use crate::claim::{Claim, Relation};
use crate::edit::{EDITS, Edit, Holds};
use crate::profile::Profile;
use crate::scene::{Scene, Triple, add, mul, scale};

/// A law: a statement, and the scenes between whose colors it must hold.
pub struct Law {
    pub name: &'static str,
    pub says: &'static str,
    pub of: Of,
}

/// Which scenes a law is about.
pub enum Of {
    /// One scene. All such laws judge the same ones.
    One(fn(&Scene, &Profile) -> Claim),
    /// A scene, another one, and the first again.
    Again,
    /// A scene, the same without lights, and with each light alone.
    EachLight,
    /// A scene before and after an edit.
    Edited(&'static Edit, Holds),
}

impl Law {
    /// The law of this name.
    pub fn named(name: &str) -> Option<&'static Self> {
        LAWS.iter().find(|law| law.name == name)
    }

    /// Whether it judges one scene, and so those that all such laws share.
    pub fn is_of_one_scene(&self) -> bool {
        matches!(self.of, Of::One(_))
    }

    /// Whether it is about what a renderer remembers.
    pub fn is_of_state(&self) -> bool {
        matches!(self.of, Of::Again)
    }

    /// The scenes of a case, if the law says something about it.
    pub fn scenes(&self, scene: &Scene, profile: &Profile) -> Option<Vec<Scene>> {
        let mut scenes = vec![scene.clone()];
        match self.of {
            Of::One(_) => {}
            Of::Again => {
                let mut other = scene.clone();
                (other.k_a, other.k_d) = ([1.0; 3], [1.0; 3]);
                other.n = scale(other.n, -1.0).map(|c| c + 0.0); // no -0
                scenes.extend([other, scene.clone()]);
            }
            Of::EachLight => {
                if !(2..=16).contains(&scene.lights.len()) {
                    return None;
                }
                let with = |lights| Scene {
                    lights,
                    ..scene.clone()
                };
                scenes.push(with(Vec::new()));
                scenes.extend(scene.lights.iter().map(|light| with(vec![*light])));
            }
            Of::Edited(edit, _) => {
                let edited = edit.of(scene, profile);
                if edited == *scene {
                    return None;
                }
                scenes.push(edited);
            }
        }
        Some(scenes)
    }

    /// What it says of the colors of its scenes.
    pub fn claim(&self, scenes: &[Scene], profile: &Profile) -> Claim {
        let zero = |weights: &[f64]| Claim::new(Relation::Zero, weights);
        match self.of {
            Of::One(claim) => claim(&scenes[0], profile),
            Of::Again => zero(&[1.0, 0.0, -1.0]),
            Of::EachLight => {
                // all − none = Σ (each − none)
                let count = scenes.len() - 2;
                #[allow(clippy::cast_precision_loss)] // the count of lights
                let mut weights = vec![1.0, count as f64 - 1.0];
                weights.resize(scenes.len(), -1.0);
                zero(&weights)
            }
            Of::Edited(_, Holds::Same) => zero(&[1.0, -1.0]),
            Of::Edited(_, Holds::Half) => zero(&[0.5, -1.0]),
            Of::Edited(_, Holds::Brighter) => Claim::new(Relation::NotNegative, &[-1.0, 1.0]),
            Of::Edited(_, Holds::GreenAndBlue) => Claim {
                first_channel: 1,
                ..zero(&[1.0, -1.0])
            },
            Of::Edited(_, Holds::Ambient) => {
                let Scene { k_a, i_a, .. } = scenes[0];
                Claim {
                    constant: mul(k_a, i_a).map(|c| -c),
                    ..zero(&[0.0, 1.0])
                }
            }
        }
    }
}

/// The most light that may come back, with all factors at 1: N·L, the power and the cone.
fn most(scene: &Scene) -> Triple {
    let k = add(scene.k_d, scene.k_s);
    scene
        .lights
        .iter()
        .fold(mul(scene.k_a, scene.i_a), |sum, light| {
            add(
                sum,
                scale(mul(k, light.intensity()), light.falloff(scene.p)),
            )
        })
}

fn one(name: &'static str, says: &'static str, claim: fn(&Scene, &Profile) -> Claim) -> Law {
    let of = Of::One(claim);
    Law { name, says, of }
}

/// Every law, in the order of the report.
pub static LAWS: LazyLock<Vec<Law>> = LazyLock::new(|| {
    let mut laws = vec![
        one(
            "formula",
            "the color is that of the formula, within the renderer's precision",
            |_, _| Claim::new(Relation::Right, &[1.0]),
        ),
        one("finite", "every color is finite", |_, _| {
            Claim::new(Relation::Finite, &[1.0])
        }),
        one(
            "as_said",
            "colors are in the range and the levels that the renderer promises",
            |_, _| Claim::new(Relation::AsSaid, &[1.0]),
        ),
        one("not_negative", "no light is negative", |_, _| {
            Claim::new(Relation::NotNegative, &[1.0])
        }),
        one(
            "bound",
            "no more light comes back than k_a I_a + Σ (k_d + k_s) I/(a + bq + cq²)",
            |scene, profile| {
                let most = most(scene);
                Claim {
                    constant: most,
                    slack: scale(most, 64.0 * profile.roundoff),
                    ..Claim::new(Relation::NotNegative, &[-1.0])
                }
            },
        ),
        Law {
            name: "no_memory",
            says: "a scene has the same color wherever it is in a batch",
            of: Of::Again,
        },
        Law {
            name: "additive",
            says: "the light of several lights is the sum of the light of each",
            of: Of::EachLight,
        },
    ];
    laws.extend(EDITS.iter().filter_map(|edit| {
        let (name, says, holds) = edit.law?;
        let of = Of::Edited(edit, holds);
        Some(Law { name, says, of })
    }));
    laws
});
