//! The scenes of a run, and what is known of their colors before any renderer gives them.

use std::ops::Range;

use crate::bounded::Bounded3;
use crate::claim::Group;
use crate::corpus;
use crate::coverage::Coverage;
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
#[derive(Clone)]
pub struct Plan {
    pub(crate) laws: Laws,
    pub(crate) profile: Profile,
    pub(crate) tries: Vec<Tries>,
    /// What all cases exercise.
    pub(crate) coverage: Coverage,
}

/// The cases of a law.
#[derive(Clone)]
pub struct Tries {
    pub law: &'static Law,
    /// Why it is not tried, if it is not.
    pub lacks: Option<&'static str>,
    pub cases: Vec<Tried>,
}

/// A case, its scenes, and for each the linear light of the formulas and its conditioning.
#[derive(Clone)]
pub struct Tried {
    pub case: Case,
    pub group: Group,
    pub known: Vec<(Bounded3, (f64, Triple))>,
}

impl Tried {
    pub fn new(law: &Law, case: Case, profile: &Profile) -> Option<Self> {
        let group = law.group(case.clone(), profile)?;
        let formula = Formula::new(profile, &[]);
        let scenes = group.scenes.iter();
        let known = scenes.map(|scene| (formula.linear(scene), formula.conditioning(scene)));
        Some(Self {
            known: known.collect(),
            case,
            group,
        })
    }
}

impl Plan {
    pub(crate) fn new(laws: &Laws, profile: &Profile, replayed: &[(&str, Case)]) -> Self {
        let edges = corpus::edges(profile);
        let chosen = LAWS.iter().filter(|law| laws.tries(law.name));
        let tries = chosen.map(|law| Tries {
            law,
            lacks: law.lacks(profile),
            cases: if law.lacks(profile).is_some() {
                Vec::new()
            } else {
                cases(law, laws, profile, &edges, replayed)
            },
        });
        let mut plan = Self {
            laws: laws.clone(),
            profile: profile.clone(),
            tries: tries.collect(),
            coverage: Coverage::default(),
        };
        let scenes = plan.tries.iter().flat_map(|tries| &tries.cases);
        for scene in scenes.flat_map(|tried| &tried.group.scenes) {
            plan.coverage.note(scene, profile);
        }
        plan
    }

    /// The batches of a run: a law and some of its cases.
    pub(crate) fn batches(&self) -> Vec<(usize, Range<usize>)> {
        let most = self.tries.iter().map(|tries| tries.cases.len()).max();
        let (mut batches, mut start, mut sizes) = (Vec::new(), 0, SIZES.iter());
        while start < most.unwrap_or(0) {
            let end = start + sizes.next().unwrap_or(&SIZES[3]);
            for (law, tries) in self.tries.iter().enumerate() {
                let count = tries.cases.len();
                if start < count {
                    batches.push((law, start..end.min(count)));
                }
            }
            start = end;
        }
        batches
    }

    /// The scenes of some cases, each once where the law asks twice.
    pub(crate) fn asked(law: &Law, cases: &[Tried]) -> Vec<Scene> {
        let of = |tried: &Tried| {
            let once = if law.asks_twice() {
                1
            } else {
                tried.group.scenes.len()
            };
            tried.group.scenes[..once].to_vec()
        };
        cases.iter().flat_map(of).collect()
    }

    /// What the renderer says of itself.
    #[must_use]
    pub fn profile(&self) -> &Profile {
        &self.profile
    }

    /// Every scene in the order in which a renderer gets it.
    pub fn scenes(&self) -> impl Iterator<Item = Scene> {
        self.batches().into_iter().flat_map(|(law, range)| {
            let Tries { law, cases, .. } = &self.tries[law];
            let scenes = Self::asked(law, &cases[range]);
            let times = if law.asks_twice() { 2 } else { 1 };
            let all = (0..times).flat_map(|_| &scenes);
            let handed = all.map(|scene| handed(scene, &self.profile));
            handed.collect::<Vec<_>>()
        })
    }
}

/// The cases of a law: those of another run, and edges and random ones.
fn cases(
    law: &Law,
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
    for i in (1..mixed.len()).rev() {
        mixed.swap(i, random.below(i + 1));
    }
    let replayed = replayed.iter().filter(|(name, _)| *name == law.name);
    let replayed = replayed.filter_map(|(_, case)| tried(case.clone()));
    replayed.chain(mixed).collect()
}

/// A scene as the renderer gets it.
pub fn handed(scene: &Scene, profile: &Profile) -> Scene {
    let mut scene = scene.clone();
    if profile.whole_angle {
        for light in &mut scene.lights {
            if let Light::Spot { half_angle, .. } = light {
                *half_angle *= 2.0;
            }
        }
    }
    scene
}
