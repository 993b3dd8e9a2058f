//! The scenes of a run, and what is known of their colors before any renderer gives them.

use std::ops::Range;

use serde::{Deserialize, Serialize};

use crate::bounded::Bounded3;
use crate::claim::{Broken, Seen};
use crate::corpus;
use crate::generator;
use crate::law::{LAWS, Law};
use crate::mistakes::formula;
use crate::options::Laws;
use crate::profile::Profile;
use crate::random::Random;
use crate::scene::{Scene, Triple};

/// The sizes of the batches of a law: first few cases of every law, so that a slow renderer tries them all.
const SIZES: [usize; 4] = [1, 8, 32, 256];

/// The laws of one scene share so many times the cases of another law.
const SHARED: usize = 16;

/// All cases of a run over renderers of one profile.
pub struct Plan {
    pub laws: Laws,
    pub profile: Profile,
    pub tries: Vec<Tries>,
}

/// Laws about the same scenes: all of one scene, or one of several.
pub struct Tries {
    pub laws: Vec<&'static Law>,
    pub cases: Vec<Case>,
    /// Why there are no cases, if there are none.
    pub lacks: &'static str,
}

/// The scenes of a case of a law, and for each the linear light of the formulas and its conditioning.
#[derive(Clone)]
pub struct Case {
    pub scenes: Vec<Scene>,
    pub known: Vec<(Bounded3, (f64, Triple))>,
}

/// A case of a law, as a file holds it.
#[derive(Serialize, Deserialize)]
pub struct Saved {
    pub law: String,
    pub scene: Scene,
}

impl Case {
    /// The case of a law that begins with a scene.
    ///
    /// # Errors
    ///
    /// What the renderer lacks for it, or that the law says nothing of it.
    pub fn new(law: &Law, scene: &Scene, profile: &Profile) -> Result<Self, &'static str> {
        let scenes = law
            .scenes(scene, profile)
            .ok_or("it says nothing about such a renderer")?;
        if let Some(lacks) = scenes.iter().find_map(|scene| profile.lacks(scene)) {
            return Err(lacks);
        }
        let right = formula(profile, &[]);
        let known = scenes
            .iter()
            .map(|scene| (right.linear(scene), right.conditioning(scene)));
        let known = known.collect();
        let case = Self { scenes, known };
        if case.is_exempt(law, profile) {
            return Err("it departs from the formulas there");
        }
        Ok(case)
    }

    /// How these replies break a law, if they do.
    pub fn broken(&self, law: &Law, profile: &Profile, replies: &[Triple]) -> Option<Broken> {
        let seen = replies.iter().zip(&self.known);
        let seen = seen.map(|(reply, (linear, conditioning))| {
            Seen::new(profile, *reply, *linear, *conditioning)
        });
        let seen: Vec<Seen> = seen.collect();
        law.claim(&self.scenes, profile).broken(profile, &seen)
    }

    /// Whether the formulas themselves break the law, with what the renderer departs from on purpose.
    pub fn is_exempt(&self, law: &Law, profile: &Profile) -> bool {
        let right = formula(profile, &[]);
        let replies: Vec<Triple> = self
            .known
            .iter()
            .map(|(linear, _)| right.encoded3(*linear))
            .collect();
        let is_known = replies.iter().flatten().all(|c| c.is_finite());
        is_known && self.broken(law, profile, &replies).is_some()
    }
}

impl Plan {
    /// # Errors
    ///
    /// What prevents a run, in one line.
    pub fn new(laws: &Laws, profile: &Profile) -> Result<Self, String> {
        if let Some(complaint) = laws.complaint(profile) {
            return Err(complaint);
        }
        let mut replayed = Vec::new();
        for (i, line) in laws.replay.lines().enumerate() {
            let saved: Result<Saved, _> = serde_json::from_str(line);
            let saved = saved.map_err(|why| why.to_string()).and_then(|saved| {
                let law = Law::named(&saved.law).ok_or(format!("there is no law {}", saved.law))?;
                Ok((law, saved.scene))
            });
            replayed.push(saved.map_err(|why| format!("replayed case {}: {why}", i + 1))?);
        }
        let edges = corpus::edges(profile);
        let chosen = LAWS.iter().filter(|law| laws.tries(law.name));
        let (of_one, others): (Vec<_>, Vec<_>) = chosen.partition(|law| law.is_of_one_scene());
        let groups = std::iter::once(of_one).chain(others.into_iter().map(|law| vec![law]));
        let tries = groups.filter(|group| !group.is_empty()).map(|group| {
            let of_group = replayed
                .iter()
                .filter(|(law, _)| group.iter().any(|it| it.name == law.name));
            // what is said of one scene is tried on every edge; other laws share them
            let step = if group[0].is_of_one_scene() { 1 } else { 6 };
            let place = LAWS
                .iter()
                .position(|law| law.name == group[0].name)
                .unwrap_or_default();
            let edges = edges.iter().skip(place % step).step_by(step);
            tries(
                group.clone(),
                laws,
                profile,
                of_group.map(|(_, scene)| scene),
                edges,
            )
        });
        Ok(Self {
            laws: laws.clone(),
            profile: profile.clone(),
            tries: tries.collect(),
        })
    }

    /// The batches of a run: the place of the laws, and some of their cases.
    pub fn batches(&self) -> Vec<(usize, Range<usize>)> {
        let most = self.tries.iter().map(|tries| tries.cases.len()).max();
        let (mut batches, mut start, mut sizes) = (Vec::new(), 0, SIZES.iter());
        while start < most.unwrap_or(0) {
            let end = start + sizes.next().unwrap_or(&SIZES[3]);
            for (i, tries) in self.tries.iter().enumerate() {
                let count = tries.cases.len();
                if start < count {
                    batches.push((i, start..end.min(count)));
                }
            }
            start = end;
        }
        batches
    }

    /// The number of scenes of the whole run.
    pub fn scenes(&self) -> usize {
        let cases = self.tries.iter().flat_map(|tries| &tries.cases);
        cases.map(|case| case.scenes.len()).sum()
    }
}

/// The cases of laws: those of another run, and edges and random ones.
fn tries<'a>(
    group: Vec<&'static Law>,
    laws: &Laws,
    profile: &Profile,
    replayed: impl Iterator<Item = &'a Scene>,
    edges: impl Iterator<Item = &'a Scene>,
) -> Tries {
    // every law has scenes of its own, whichever others are tried
    let first = group[0];
    let is_of_one_scene = first.is_of_one_scene();
    let name = if is_of_one_scene {
        "one scene"
    } else {
        first.name
    };
    let mut random = Random::new(laws.seed, name);
    let mut lacks = None;
    let mut case = |scene: &Scene| {
        // the laws of one scene are exempt one by one, when a color breaks them
        let law = if is_of_one_scene {
            Law::named("finite").unwrap_or(first)
        } else {
            first
        };
        let case = Case::new(law, scene, profile);
        case.map_err(|why| *lacks.get_or_insert(why)).ok()
    };
    let replayed: Vec<Case> = replayed.filter_map(&mut case).collect();
    let mut mixed: Vec<Case> = edges.filter_map(&mut case).collect();
    let count = if is_of_one_scene {
        SHARED * laws.cases
    } else {
        laws.cases
    };
    let scenes = (0..20 * count).map(|_| generator::scene(profile, &mut random));
    mixed.extend(scenes.filter_map(|scene| case(&scene)).take(count));
    random.shuffle(&mut mixed);
    let cases: Vec<Case> = replayed.into_iter().chain(mixed).collect();
    let lacks = lacks.unwrap_or_default();
    let laws = group;
    Tries { laws, cases, lacks }
}

/// The scenes of some cases, in the order in which the renderer gets them.
pub fn handed(cases: &[Case]) -> Vec<Scene> {
    cases
        .iter()
        .flat_map(|case| &case.scenes)
        .cloned()
        .collect()
}

impl Laws {
    /// Every scene in the order in which a renderer gets it that says this of itself. They do not depend on its answers; what
    /// else it is asked for, in search of smaller scenes and of places, does.
    ///
    /// # Errors
    ///
    /// In one line: a contradictory profile; the name of a law that does not exist; no cases at all; a line that is no case.
    pub fn scenes(&self, profile: &Profile) -> Result<Vec<Scene>, String> {
        let plan = Plan::new(self, profile)?;
        let batches = plan.batches().into_iter();
        Ok(batches
            .flat_map(|(i, of)| handed(&plan.tries[i].cases[of]))
            .collect())
    }
}
