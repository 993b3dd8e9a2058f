//! A renderer on trial: tries laws, and makes failing cases smaller.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use crate::cause::Evidence;
use crate::claim::{Broken, Group, Seen};
use crate::corpus;
use crate::coverage::Coverage;
use crate::generator::{self, Base};
use crate::law::Law;
use crate::profile::Profile;
use crate::random::Random;
use crate::renderer::Renderer;
use crate::report::{Counterexample, Verdict};
use crate::scene::{Light, Scene, Triple};
use crate::smaller;
use crate::textbook::Textbook;

/// The cases that are asked for at once.
const BATCH: usize = 256;
/// The simpler cases that are asked for at once.
const SIMPLER: usize = 32;

/// How much a run may ask for.
#[derive(Clone, Copy, Debug)]
pub struct Budget {
    /// The random cases of each law.
    pub cases: usize,
    /// The batches of a law in which its smallest case is looked for, and the time.
    pub shrinks: usize,
    pub shrinking: Duration,
    /// When the run ends.
    pub deadline: Option<Instant>,
}

/// A law among others.
pub struct Tried<'a> {
    pub law: &'a Law,
    pub index: usize,
    /// Cases that are tried beside the fixed and the random ones.
    pub replayed: Vec<Base>,
    pub random: Random,
    pub seed: u64,
}

/// A renderer on trial, and a sample of what it answered.
pub struct Trial<'a, R> {
    renderer: &'a mut R,
    pub profile: Profile,
    pub evidence: Evidence,
    pub coverage: Coverage,
    edges: Vec<Base>,
}

/// A case in which a law does not hold.
struct Failure {
    base: Base,
    group: Group,
    broken: Broken,
    replies: Vec<Triple>,
}

/// For a group the claim that does not hold, and the colors.
type Judged = Option<(Broken, Vec<Triple>)>;

impl<'a, R: Renderer> Trial<'a, R> {
    pub fn new(renderer: &'a mut R, profile: Profile) -> Self {
        Self {
            renderer,
            edges: corpus::edges(&profile),
            profile,
            evidence: Evidence::new(),
            coverage: Coverage::default(),
        }
    }

    /// Puts the renderer to one law, and calls `shrinking` with the number of batches if it is broken.
    pub fn of(
        &mut self,
        mut tried: Tried,
        budget: Budget,
        shrinking: &mut dyn FnMut(usize),
    ) -> Result<Verdict, String> {
        if let Some(because) = tried.law.lacks(&self.profile) {
            return Ok(Verdict::NotTried { because });
        }
        // what is said of one scene is tried on every edge; other laws share them
        let step = if tried.law.is_of_one_scene() { 1 } else { 8 };
        let edges = self.edges.iter().skip(tried.index % step).step_by(step);
        let mut fixed = edges
            .chain(&tried.replayed)
            .cloned()
            .collect::<Vec<_>>()
            .into_iter();
        let (mut cases, mut random_cases, mut tries, mut failures) = (0, 0, 0, 0);
        let mut smallest: Option<Failure> = None;
        loop {
            if budget.is_over() {
                return Ok(Verdict::NotTried {
                    because: "the time is up",
                });
            }
            let (mut bases, mut groups) = (Vec::new(), Vec::new());
            while groups.len() < BATCH {
                let base = match fixed.next() {
                    Some(base) => base,
                    None if random_cases < budget.cases && tries < 100 * budget.cases => {
                        tries += 1;
                        generator::base(&self.profile, &mut tried.random)
                    }
                    None => break,
                };
                if let Some(group) = tried.law.group(base.clone(), &self.profile) {
                    random_cases += usize::from(tries > 0);
                    bases.push(base);
                    groups.push(group);
                }
            }
            if groups.is_empty() {
                break;
            }
            cases += groups.len();
            let judged = self.judge(&tried, &groups, true)?;
            for ((judged, base), group) in judged.into_iter().zip(bases).zip(groups) {
                let Some((broken, replies)) = judged else {
                    continue;
                };
                failures += 1;
                let least = smallest.as_ref().map(|least| smaller::cost(&least.base));
                if least.is_none_or(|least| smaller::cost(&base) < least) {
                    smallest = Some(Failure {
                        base,
                        group,
                        broken,
                        replies,
                    });
                }
            }
        }
        if cases == 0 {
            let because = "it says nothing about such a renderer";
            return Ok(Verdict::NotTried { because });
        }
        let Some(failure) = smallest else {
            return Ok(Verdict::Holds { cases });
        };
        let smallest = self.smaller(&tried, failure, budget, shrinking)?;
        Ok(Verdict::Broken {
            cases,
            failures,
            smallest: Box::new(self.counterexample(smallest)),
        })
    }

    /// For each group the claim that does not hold, and the colors.
    fn judge(
        &mut self,
        tried: &Tried,
        groups: &[Group],
        keep: bool,
    ) -> Result<Vec<Judged>, String> {
        let law = tried.law;
        let scenes = groups.iter().flat_map(|group| &group.scenes);
        let replies = if law.asks_twice() {
            // the scenes of a group are the same
            let once: Vec<Scene> = groups.iter().map(|group| group.scenes[0].clone()).collect();
            let (first, second) = (self.ask(tried, &once)?, self.ask(tried, &once)?);
            let pairs = first.into_iter().zip(second);
            pairs.flat_map(|(first, second)| [first, second]).collect()
        } else {
            let scenes: Vec<Scene> = scenes.cloned().collect();
            self.ask(tried, &scenes)?
        };
        let profile = &self.profile;
        let textbook = Textbook::new(profile, &[]);
        let mut rest = &replies[..];
        let mut found = Vec::new();
        for group in groups {
            let (replies, others) = rest.split_at(group.scenes.len());
            rest = others;
            let mut seen = Vec::with_capacity(replies.len());
            for (scene, reply) in group.scenes.iter().zip(replies) {
                let linear = textbook.linear(scene);
                let conditioning = textbook.conditioning(scene);
                seen.push(Seen::new(profile, *reply, linear, conditioning));
                if keep {
                    let is_right = textbook.fits_linear(linear, *reply) != Some(false);
                    self.evidence.note(tried.index, is_right, scene, *reply);
                    self.coverage.note(scene, profile);
                }
            }
            let broken = group.broken(profile, &seen);
            found.push(broken.map(|broken| (broken, replies.to_vec())));
        }
        Ok(found)
    }

    /// The colors of scenes, as the renderer gets them.
    pub fn ask(&mut self, tried: &Tried, scenes: &[Scene]) -> Result<Vec<Triple>, String> {
        let answer = if self.profile.whole_angle {
            let handed: Vec<Scene> = scenes.iter().map(|s| handed(s, &self.profile)).collect();
            self.caught(&handed)
        } else {
            self.caught(scenes)
        };
        let replies = match answer {
            Ok(replies) => replies?,
            Err(message) => return Err(self.panicked(tried, scenes, &message)),
        };
        if replies.len() != scenes.len() {
            let (colors, scenes) = (replies.len(), scenes.len());
            return Err(format!("{colors} colors for {scenes} scenes"));
        }
        Ok(replies)
    }

    /// The answer, or the words with which the renderer panicked.
    fn caught(&mut self, scenes: &[Scene]) -> Result<Result<Vec<Triple>, String>, String> {
        catch_unwind(AssertUnwindSafe(|| self.renderer.shade(scenes))).map_err(|panic| {
            let text = panic.downcast_ref::<&str>().map(ToString::to_string);
            let text = text.or_else(|| panic.downcast_ref::<String>().cloned());
            text.unwrap_or_else(|| "without a message".into())
        })
    }

    /// Says how a renderer panicked, with the smallest scene that makes it.
    fn panicked(&mut self, tried: &Tried, scenes: &[Scene], message: &str) -> String {
        let profile = self.profile.clone();
        let panics =
            |trial: &mut Self, scene: &Scene| trial.caught(&[handed(scene, &profile)]).is_err();
        let Some(scene) = scenes.iter().find(|scene| panics(self, scene)) else {
            return format!(
                "the renderer panicked in law {}, seed {}, but with no scene alone: {message}",
                tried.law.name, tried.seed
            );
        };
        let mut base = Base {
            scene: scene.clone(),
            ways: [[0.0; 3]; 3],
            factors: [0.0; 3],
        };
        for _ in 0..SIMPLER {
            let simpler = smaller::simpler(&base, &self.profile);
            let found = simpler.into_iter().find(|base| panics(self, &base.scene));
            match found {
                Some(found) => base = found,
                None => break,
            }
        }
        format!(
            "the renderer panicked in law {}, seed {}: {message}\nthe smallest scene that was found:\n{}\n{}",
            tried.law.name,
            tried.seed,
            handed(&base.scene, &self.profile),
            handed(&base.scene, &self.profile).to_json()
        )
    }

    /// The smallest case that is still broken.
    fn smaller(
        &mut self,
        tried: &Tried,
        mut failure: Failure,
        budget: Budget,
        shrinking: &mut dyn FnMut(usize),
    ) -> Result<Failure, String> {
        let (start, mut batches) = (Instant::now(), 0);
        'smaller: loop {
            let simpler = smaller::simpler(&failure.base, &self.profile);
            let mut cases = simpler
                .into_iter()
                .filter_map(|base| {
                    let group = tried.law.group(base.clone(), &self.profile)?;
                    Some((base, group))
                })
                .collect::<Vec<_>>()
                .into_iter();
            loop {
                let (bases, groups): (Vec<Base>, Vec<Group>) = cases.by_ref().take(SIMPLER).unzip();
                if groups.is_empty() {
                    return Ok(failure);
                }
                let is_late = start.elapsed() >= budget.shrinking || budget.is_over();
                if batches >= budget.shrinks || is_late {
                    return Ok(failure);
                }
                batches += 1;
                shrinking(batches);
                let judged = self.judge(tried, &groups, false)?;
                let found = judged.into_iter().zip(bases).zip(groups).find_map(
                    |((judged, base), group)| {
                        let (broken, replies) = judged?;
                        Some(Failure {
                            base,
                            group,
                            broken,
                            replies,
                        })
                    },
                );
                if let Some(found) = found {
                    failure = found;
                    continue 'smaller;
                }
            }
        }
    }

    fn counterexample(&self, failure: Failure) -> Counterexample {
        let scenes = failure.group.scenes.iter();
        Counterexample {
            suspects: Vec::new(),
            case: failure.base,
            scenes: scenes.map(|scene| handed(scene, &self.profile)).collect(),
            colors: failure.replies,
            claim: failure.broken.says,
            channel: failure.broken.channel,
            off: failure.broken.off,
            allowed: failure.broken.allowed,
        }
    }
}

impl Budget {
    pub fn is_over(&self) -> bool {
        self.deadline.is_some_and(|end| Instant::now() >= end)
    }
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
