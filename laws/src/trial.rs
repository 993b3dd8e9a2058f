//! A renderer on trial: tries laws, and makes failing cases smaller.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::time::{Duration, Instant};

use crate::batch::Batch;
use crate::cause::Evidence;
use crate::claim::{Broken, Group, Seen};
use crate::coverage::Coverage;
use crate::generator::Base;
use crate::law::Law;
use crate::profile::Profile;
use crate::renderer::Renderer;
use crate::report::{Counterexample, Verdict};
use crate::scene::{Light, Scene, Triple};
use crate::smaller;
use crate::textbook::Textbook;

/// The simpler cases that are asked for at once.
const SIMPLER: usize = 32;

/// The scenes of a batch after which those before the batch no longer leak into a color.
const SETTLED: usize = 32;

/// How much a run may ask for.
#[derive(Clone, Copy, Debug)]
pub struct Budget {
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
    pub seed: u64,
}

/// A renderer on trial, and a sample of what it answered.
pub struct Trial<'a> {
    renderer: &'a mut dyn Renderer,
    pub profile: Profile,
    pub evidence: Evidence,
    /// What the scenes exercise, if it is not known already.
    pub coverage: Option<Coverage>,
    /// Whether a scene had another color when it was asked again, long after what was asked before the batch.
    pub is_fickle: bool,
}

/// A case in which a law does not hold.
struct Failure {
    /// What there is to read in it.
    cost: u32,
    base: Base,
    group: Group,
    broken: Broken,
    replies: Vec<Triple>,
}

/// For a group the claim that does not hold, and the colors.
type Judged = Option<(Broken, Vec<Triple>)>;

impl<'a> Trial<'a> {
    pub fn new(
        renderer: &'a mut dyn Renderer,
        profile: Profile,
        coverage: Option<Coverage>,
    ) -> Self {
        Self {
            renderer,
            profile,
            evidence: Evidence::new(),
            coverage,
            is_fickle: false,
        }
    }

    /// Puts the renderer to one law, and calls `shrinking` with the number of batches if it is broken.
    pub fn of(
        &mut self,
        tried: &Tried,
        mut batches: impl Iterator<Item = Arc<Batch>>,
        budget: Budget,
        shrinking: &mut dyn FnMut(usize),
    ) -> Result<Verdict, String> {
        if let Some(because) = tried.law.lacks(&self.profile) {
            return Ok(Verdict::NotTried { because });
        }
        let (mut cases, mut failures) = (0, 0);
        let mut smallest: Option<Failure> = None;
        loop {
            if budget.is_over() {
                return Ok(Verdict::NotTried {
                    because: "the time is up",
                });
            }
            let Some(batch) = batches.next() else {
                break;
            };
            cases += batch.groups.len();
            for (i, judged) in self.judge(tried, &batch, true)?.into_iter().enumerate() {
                let Some((broken, replies)) = judged else {
                    continue;
                };
                failures += 1;
                self.is_fickle |= tried.law.asks_twice() && i >= SETTLED;
                let cost = smaller::cost(&batch.bases[i]);
                if smallest.as_ref().is_none_or(|least| cost < least.cost) {
                    smallest = Some(Failure {
                        cost,
                        base: batch.bases[i].clone(),
                        group: batch.groups[i].clone(),
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
        let smallest = self.smaller(tried, failure, budget, shrinking)?;
        Ok(Verdict::Broken {
            cases,
            failures,
            smallest: Box::new(self.counterexample(smallest)),
        })
    }

    /// For each group the claim that does not hold, and the colors.
    fn judge(&mut self, tried: &Tried, batch: &Batch, keep: bool) -> Result<Vec<Judged>, String> {
        let mut replies = self.ask(tried, &batch.asked)?;
        if tried.law.asks_twice() {
            let again = self.ask(tried, &batch.asked)?;
            let pairs = replies.into_iter().zip(again);
            replies = pairs.flat_map(|(first, second)| [first, second]).collect();
        }
        let profile = &self.profile;
        let textbook = Textbook::new(profile, &[]);
        let mut colors = replies.iter().zip(&batch.known);
        let mut found = Vec::with_capacity(batch.groups.len());
        let mut seen = Vec::new();
        for group in &batch.groups {
            seen.clear();
            for (scene, (reply, &(linear, conditioning))) in group.scenes.iter().zip(&mut colors) {
                seen.push(Seen::new(profile, *reply, linear, conditioning));
                if keep {
                    let is_right = textbook.fits_linear(linear, *reply) != Some(false);
                    self.evidence.note(tried.index, is_right, scene, *reply);
                    if let Some(coverage) = &mut self.coverage {
                        coverage.note(scene, profile);
                    }
                }
            }
            let broken = group.broken(profile, &seen);
            found.push(broken.map(|broken| {
                let replies = seen.iter().map(|seen| seen.reply);
                (broken, replies.collect())
            }));
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
                let batch = Batch::new(tried.law, &self.profile, bases, groups);
                let judged = self.judge(tried, &batch, false)?;
                let found = judged.into_iter().enumerate().find_map(|(i, judged)| {
                    let (broken, replies) = judged?;
                    Some(Failure {
                        cost: 0,
                        base: batch.bases[i].clone(),
                        group: batch.groups[i].clone(),
                        broken,
                        replies,
                    })
                });
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
