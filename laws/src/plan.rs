//! The scenes of a run, and what is known of their colors before any renderer gives them.

use std::ops::Range;

use crate::bounded::Bounded3;
use crate::claim::Group;
use crate::corpus;
use crate::formula::Formula;
use crate::generator::{self, Case};
use crate::law::{LAWS, Law};
use crate::profile::Profile;
use crate::random::Random;
use crate::run::Laws;
use crate::scene::{Light, Scene, Triple};

/// The sizes of the batches of a law: first few cases of every law, so that a slow renderer tries them all.
const SIZES: [usize; 4] = [1, 4, 32, 256];

/// All cases of a run over renderers of one profile.
pub struct Plan {
    pub laws: Laws,
    pub profile: Profile,
    pub tries: Vec<Tries>,
}

/// The cases of a law.
pub struct Tries {
    pub law: &'static Law,
    /// Why it is not tried, if it is not.
    pub lacks: Option<&'static str>,
    pub cases: Vec<Tried>,
}

/// A case of a law, its scenes, and for each the linear light of the formulas and its conditioning.
#[derive(Clone)]
pub struct Tried {
    pub law: &'static Law,
    pub case: Case,
    pub group: Group,
    pub known: Vec<(Bounded3, (f64, Triple))>,
}

impl Tried {
    pub fn new(law: &'static Law, case: Case, profile: &Profile) -> Option<Self> {
        let group = law.group(case.clone(), profile)?;
        let formula = Formula::new(profile, &[]);
        let scenes = group.scenes.iter();
        let known = scenes.map(|scene| (formula.linear(scene), formula.conditioning(scene)));
        Some(Self {
            law,
            known: known.collect(),
            case,
            group,
        })
    }
}

impl Plan {
    pub fn new(laws: &Laws, profile: &Profile, replayed: &[(&str, Case)]) -> Self {
        let edges = corpus::edges(profile);
        let chosen = LAWS.iter().filter(|law| laws.tries(law.name));
        let tries = chosen.map(|law| {
            let lacks = law.lacks(profile);
            let cases = || cases(law, laws, profile, &edges, replayed);
            let cases = lacks.map_or_else(cases, |_| Vec::new());
            Tries { law, lacks, cases }
        });
        Self {
            laws: laws.clone(),
            profile: profile.clone(),
            tries: tries.collect(),
        }
    }

    /// The batches of a run: a law and some of its cases.
    pub fn batches(&self) -> Vec<(usize, Range<usize>)> {
        let most = self.tries.iter().map(|tries| tries.cases.len()).max();
        let (mut batches, mut start, mut sizes) = (Vec::new(), 0, SIZES.iter());
        while start < most.unwrap_or(0) {
            let end = start + sizes.next().unwrap_or(&SIZES[3]);
            // backward, so that the formula judges the first scene, which a renderer may not be ready for
            for (law, tries) in self.tries.iter().enumerate().rev() {
                let count = tries.cases.len();
                if start < count {
                    batches.push((law, start..end.min(count)));
                }
            }
            start = end;
        }
        batches
    }
}

/// The cases of a law: those of another run, and edges and random ones.
fn cases(
    law: &'static Law,
    laws: &Laws,
    profile: &Profile,
    edges: &[Case],
    replayed: &[(&str, Case)],
) -> Vec<Tried> {
    // every law has scenes of its own, whichever others are tried
    let mut random = Random::new(laws.seed, law.name);
    // what is said of one scene is tried on every edge; other laws share them
    let step = if law.is_of_one_scene() { 1 } else { 8 };
    let edges = edges.iter().skip(law.index() % step).step_by(step).cloned();
    let tried = |case: Case| Tried::new(law, case, profile);
    let mut mixed: Vec<Tried> = edges.filter_map(tried).collect();
    let of_random = (0..100 * laws.cases).map(|_| generator::case(profile, &mut random));
    mixed.extend(of_random.filter_map(tried).take(laws.cases));
    random.shuffle(&mut mixed);
    let replayed = replayed.iter().filter(|(name, _)| *name == law.name);
    let replayed = replayed.filter_map(|(_, case)| tried(case.clone()));
    replayed.chain(mixed).collect()
}

/// The scenes of some cases, as the renderer gets them.
pub fn handed(cases: &[Tried], profile: &Profile) -> Vec<Scene> {
    let scenes = cases.iter().flat_map(|tried| &tried.group.scenes);
    let mut scenes: Vec<Scene> = scenes.cloned().collect();
    let lights = scenes.iter_mut().flat_map(|scene| &mut scene.lights);
    for light in lights.filter(|_| profile.whole_angle) {
        if let Light::Spot { half_angle, .. } = light {
            *half_angle *= 2.0;
        }
    }
    scenes
}
