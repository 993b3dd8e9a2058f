//! Puts a renderer to the laws.

use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

use crate::claim::{Broken, Group, Seen};
use crate::generator;
use crate::law::{LAWS, Law};
use crate::mistake::Mistake;
use crate::profile::Profile;
use crate::renderer::Renderer;
use crate::report::{Counterexample, LawReport, Report, Verdict};
use crate::scene::{Light, Scene, Triple};
use crate::textbook::Textbook;

/// The most steps in which a failing case is made smaller.
const MOST_STEPS: usize = 2000;

/// A run of the laws. It is deterministic: the same seed gives the same scenes.
///
/// ```
/// use shading_laws::{Laws, Profile, from_fn};
///
/// let mut black = from_fn(Profile::default(), |_scene| [0.0; 3]);
/// let report = Laws::new().seed(7).cases(50).run(&mut black).unwrap();
/// assert!(report.is_broken()); // there is no k_a I_a
/// ```
#[derive(Clone, Debug)]
pub struct Laws {
    seed: u64,
    cases: usize,
    only: Vec<String>,
}

impl Default for Laws {
    fn default() -> Self {
        Self::new()
    }
}

/// How far a run is.
#[derive(Clone, Copy, Debug)]
pub struct Progress {
    /// The law that is being tried.
    pub law: &'static str,
    /// The number of laws that are done.
    pub done: usize,
    /// The number of laws to try.
    pub of: usize,
    /// The law is broken, and its smallest scene is being looked for.
    pub shrinking: bool,
}

impl Laws {
    /// All laws, with 256 cases of each, from seed 0.
    #[must_use]
    pub fn new() -> Self {
        Self {
            seed: 0,
            cases: 256,
            only: Vec::new(),
        }
    }

    /// The seed of the scenes.
    #[must_use]
    pub fn seed(self, seed: u64) -> Self {
        Self { seed, ..self }
    }

    /// The number of cases of each law.
    #[must_use]
    pub fn cases(self, cases: usize) -> Self {
        Self { cases, ..self }
    }

    /// Tries only this law and those of further calls. [`Laws::names`] lists the names.
    #[must_use]
    pub fn only(mut self, name: impl Into<String>) -> Self {
        self.only.push(name.into());
        self
    }

    /// The name of each law, and what it says.
    pub fn names() -> impl Iterator<Item = (&'static str, &'static str)> {
        LAWS.iter().map(|law| (law.name, law.says))
    }

    /// Puts a renderer to the laws.
    ///
    /// # Errors
    ///
    /// In one line: the renderer's own error; a wrong number of colors; a contradictory profile; the
    /// name of a law that does not exist.
    pub fn run(&self, renderer: &mut impl Renderer) -> Result<Report, String> {
        self.run_with(renderer, &mut |_| {})
    }

    /// The same, and reports its progress.
    ///
    /// # Errors
    ///
    /// As [`run`](Laws::run).
    pub fn run_with(
        &self,
        renderer: &mut impl Renderer,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<Report, String> {
        let profile = renderer.profile();
        if let Some(complaint) = profile.complaint() {
            return Err(format!("the profile of {}: {complaint}", profile.name));
        }
        let is_known = |name: &&String| LAWS.iter().any(|law| law.name == **name);
        if let Some(name) = self.only.iter().find(|name| !is_known(name)) {
            return Err(format!("there is no law {name}"));
        }
        let is_chosen =
            |law: &&Law| self.only.is_empty() || self.only.iter().any(|name| name == law.name);
        let laws: Vec<&Law> = LAWS.iter().filter(is_chosen).collect();

        let mut trial = Trial {
            renderer,
            profile,
            seen: Vec::new(),
        };
        let mut reports = Vec::new();
        for (done, law) in laws.iter().enumerate() {
            let mut report = |shrinking| {
                progress(Progress {
                    law: law.name,
                    done,
                    of: laws.len(),
                    shrinking,
                });
            };
            report(false);
            let verdict = trial.of(law, self, &mut || report(true))?;
            reports.push(LawReport {
                name: law.name,
                says: law.says,
                verdict,
            });
        }
        let causes = if reports.iter().any(LawReport::is_broken) {
            trial.causes()
        } else {
            Vec::new()
        };
        Ok(Report {
            profile: trial.profile,
            seed: self.seed,
            laws: reports,
            causes,
        })
    }

    fn runner(&self, law: &Law) -> TestRunner {
        // every law has scenes of its own, whichever others are tried
        let mut seed = [0; 32];
        seed[..8].copy_from_slice(&self.seed.to_le_bytes());
        for (byte, letter) in seed[8..].iter_mut().zip(law.name.bytes()) {
            *byte = letter;
        }
        TestRunner::new_with_rng(
            Config::default(),
            TestRng::from_seed(RngAlgorithm::ChaCha, &seed),
        )
    }
}

/// Puts a renderer to the laws, and panics with the report if one is broken.
///
/// ```should_panic
/// let black = shading_laws::from_fn(shading_laws::Profile::default(), |_scene| [0.0; 3]);
/// shading_laws::check(black);
/// ```
///
/// # Panics
///
/// If a law is broken, or the renderer cannot answer.
#[track_caller]
pub fn check(mut renderer: impl Renderer) {
    match Laws::new().run(&mut renderer) {
        Ok(report) if report.is_broken() => panic!("{report}"),
        Ok(_) => {}
        Err(error) => panic!("{error}"),
    }
}

/// A renderer on trial, and everything that it answered.
struct Trial<'a, R> {
    renderer: &'a mut R,
    profile: Profile,
    seen: Vec<(Scene, Triple)>,
}

impl<R: Renderer> Trial<'_, R> {
    fn of(
        &mut self,
        law: &Law,
        laws: &Laws,
        shrinking: &mut dyn FnMut(),
    ) -> Result<Verdict, String> {
        if let Some(lacks) = law.lacks(&self.profile) {
            return Ok(Verdict::NotTried { because: lacks });
        }
        let strategy = generator::base(&self.profile);
        let mut runner = laws.runner(law);
        let (mut trees, mut groups) = (Vec::new(), Vec::new());
        for _ in 0..100 * laws.cases {
            if groups.len() == laws.cases {
                break;
            }
            let tree = strategy.new_tree(&mut runner).map_err(|e| e.to_string())?;
            if let Some(group) = (law.group)(tree.current(), &self.profile) {
                trees.push(tree);
                groups.push(group);
            }
        }
        if groups.is_empty() {
            let because = "it says nothing about such a renderer";
            return Ok(Verdict::NotTried { because });
        }

        let broken = self.broken(&groups, true)?;
        let failures = broken.iter().flatten().count();
        let cases = groups.len();
        let first = broken.into_iter().zip(trees).zip(groups);
        let first = first.filter_map(|((broken, tree), group)| Some((broken?, tree, group)));
        let Some(((broken, replies), tree, group)) = first.min_by_key(|(_, _, group)| size(group))
        else {
            return Ok(Verdict::Holds { cases });
        };
        shrinking();
        let smallest = self.smaller(law, tree, group, broken, replies)?;
        Ok(Verdict::Broken {
            cases,
            failures,
            smallest: Box::new(smallest),
        })
    }

    /// For each group the claim that does not hold, and the colors.
    #[allow(clippy::type_complexity)]
    fn broken(
        &mut self,
        groups: &[Group],
        keep: bool,
    ) -> Result<Vec<Option<(Broken, Vec<Triple>)>>, String> {
        let profile = &self.profile;
        let scenes = groups.iter().flat_map(|group| &group.scenes);
        let scenes: Vec<Scene> = scenes.map(|scene| handed(scene, profile)).collect();
        let replies = self.renderer.shade(&scenes)?;
        if replies.len() != scenes.len() {
            let (colors, scenes) = (replies.len(), scenes.len());
            return Err(format!("{colors} colors for {scenes} scenes"));
        }
        let textbook = Textbook {
            profile,
            mistakes: &[],
        };
        let mut rest = &replies[..];
        let mut found = Vec::new();
        for group in groups {
            let (replies, others) = rest.split_at(group.scenes.len());
            rest = others;
            let seen: Vec<Seen> = group
                .scenes
                .iter()
                .zip(replies)
                .map(|(scene, reply)| Seen::new(profile, *reply, textbook.linear(scene)))
                .collect();
            let broken = group.broken(profile, &seen);
            found.push(broken.map(|broken| (broken, replies.to_vec())));
        }
        if keep {
            let scenes = groups.iter().flat_map(|group| &group.scenes).cloned();
            self.seen.extend(scenes.zip(replies));
        }
        Ok(found)
    }

    /// The smallest case that is still broken.
    fn smaller(
        &mut self,
        law: &Law,
        mut tree: impl ValueTree<Value = generator::Base>,
        mut group: Group,
        mut broken: Broken,
        mut replies: Vec<Triple>,
    ) -> Result<Counterexample, String> {
        let mut goes_on = tree.simplify();
        for _ in 0..MOST_STEPS {
            if !goes_on {
                break;
            }
            let smaller = (law.group)(tree.current(), &self.profile);
            let found = match &smaller {
                Some(group) => self
                    .broken(std::slice::from_ref(group), false)?
                    .pop()
                    .flatten(),
                None => None,
            };
            goes_on = if let (Some(smaller), Some(found)) = (smaller, found) {
                group = smaller;
                (broken, replies) = found;
                tree.simplify()
            } else {
                tree.complicate()
            };
        }
        let suspects = Mistake::ALL.iter().copied();
        let suspects = suspects.filter(|mistake| self.explains(*mistake, &group.scenes, &replies));
        Ok(Counterexample {
            suspects: suspects.collect(),
            scenes: group
                .scenes
                .iter()
                .map(|scene| handed(scene, &self.profile))
                .collect(),
            colors: replies,
            claim: broken.says,
            channel: broken.channel,
            off: broken.off,
            allowed: broken.allowed,
        })
    }

    /// The mistake, or the two, that explain every color of the run.
    fn causes(&self) -> Vec<Vec<Mistake>> {
        let seen = || self.seen.iter().map(|(scene, reply)| (scene, reply));
        if self.agrees(&[], seen()) {
            return Vec::new();
        }
        let fit = |mistakes: &Vec<Mistake>| self.agrees(mistakes, seen());
        let single: Vec<_> = Mistake::ALL.iter().map(|a| vec![*a]).filter(fit).collect();
        if !single.is_empty() {
            return single;
        }
        let pairs = Mistake::ALL.iter().enumerate();
        let pairs = pairs.flat_map(|(i, a)| Mistake::ALL[..i].iter().map(|b| vec![*b, *a]));
        pairs.filter(fit).collect()
    }

    /// Whether these are the colors that a renderer with the mistakes gives.
    fn agrees<'s>(
        &self,
        mistakes: &[Mistake],
        mut seen: impl Iterator<Item = (&'s Scene, &'s Triple)>,
    ) -> bool {
        let textbook = Textbook {
            profile: &self.profile,
            mistakes,
        };
        seen.all(|(scene, reply)| {
            let expected = textbook.reply(scene).into_iter().zip(reply);
            expected
                .into_iter()
                .all(|(ends, reply)| ends.is_none_or(|[low, high]| (low..=high).contains(reply)))
        })
    }

    /// Whether the mistake gives these colors, and the formulas do not.
    fn explains(&self, mistake: Mistake, scenes: &[Scene], replies: &[Triple]) -> bool {
        let textbook = Textbook {
            profile: &self.profile,
            mistakes: &[mistake],
        };
        let seen = || scenes.iter().zip(replies);
        let has_answer = |scene| textbook.reply(scene).iter().all(Option::is_some);
        scenes.iter().all(has_answer)
            && self.agrees(&[mistake], seen())
            && !self.agrees(&[], seen())
    }
}

/// How much there is to read.
fn size(group: &Group) -> usize {
    group.scenes.iter().map(|scene| scene.lights.len()).sum()
}

/// A scene as the renderer gets it.
fn handed(scene: &Scene, profile: &Profile) -> Scene {
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
