//! The scenes of a run, and what is known of their colors before any renderer gives them.

use crate::bounded::Bounded3;
use crate::corpus;
use crate::formula::Formula;
use crate::generator;
use crate::mistakes::{departures, formula};
use crate::options::Laws;
use crate::profile::Profile;
use crate::random::Random;
use crate::scene::{Light, Scene, scale};

/// One scene of so many is asked for again.
const AGAIN: usize = 8;

/// All cases of a run over renderers of one profile.
pub struct Plan {
    pub laws: Laws,
    pub profile: Profile,
    pub cases: Vec<Case>,
}

/// A scene, and the linear light that the formulas give it.
#[derive(Clone)]
pub struct Case {
    pub scene: Scene,
    pub linear: Bounded3,
    /// It is asked for again after another scene, because a renderer may remember something.
    pub is_again: bool,
    /// A light for the scene between, where that has none, so that what is remembered of lights shows.
    light: Option<Light>,
}

impl Case {
    pub fn new(scene: Scene, right: &Formula, is_again: bool) -> Self {
        let linear = right.linear(&scene);
        Self {
            scene,
            linear,
            is_again,
            light: None,
        }
    }

    /// The scenes in the order in which the renderer gets them.
    pub fn scenes(&self) -> Vec<Scene> {
        let mut scenes = vec![self.scene.clone()];
        if self.is_again {
            let mut other = self.scene.clone();
            (other.k_a, other.k_d) = ([1.0; 3], [1.0; 3]);
            other.n = scale(other.n, -1.0).map(|c| c + 0.0); // no -0
            if other.lights.is_empty() {
                other.lights.extend(self.light);
            }
            scenes.extend([other, self.scene.clone()]);
        }
        scenes
    }
}

impl Plan {
    /// The scenes of a run, or what prevents one, in one line.
    pub fn new(laws: &Laws, profile: &Profile) -> Result<Self, String> {
        let complaint = profile.complaint().or_else(|| departures(profile).err());
        if let Some(complaint) = complaint {
            return Err(format!("the profile of {}: {complaint}", profile.name));
        }
        if laws.cases == 0 {
            return Err("the number of cases is 0".into());
        }
        let mut scenes = corpus::edges(profile);
        let mut random = Random::new(laws.seed);
        let any = std::iter::repeat_with(|| generator::scene(profile, &mut random));
        scenes.extend(any.take(20 * laws.cases).flatten().take(laws.cases));
        Random::new(laws.seed).shuffle(&mut scenes);
        let light = scenes.iter().find_map(|it| it.lights.first().copied());
        let right = formula(profile, None);
        let cases = scenes.into_iter().enumerate().map(|(i, scene)| Case {
            light,
            ..Case::new(scene, &right, i % AGAIN == 0)
        });
        Ok(Self {
            laws: laws.clone(),
            profile: profile.clone(),
            cases: cases.collect(),
        })
    }
}
