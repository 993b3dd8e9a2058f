//! A renderer on trial: tries laws, makes failing cases smaller, and looks for the mistake.

use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;

use crate::claim::{Broken, Group, Seen};
use crate::generator;
use crate::law::Law;
use crate::mistake::Mistake;
use crate::profile::Profile;
use crate::renderer::Renderer;
use crate::report::{Counterexample, Verdict};
use crate::scene::{Light, Scene, Triple};
use crate::textbook::Textbook;

/// The most steps in which a failing case is made smaller.
const MOST_STEPS: usize = 2000;

/// A renderer on trial, and everything that it answered.
pub struct Trial<'a, R> {
    renderer: &'a mut R,
    pub profile: Profile,
    seen: Vec<(Scene, Triple)>,
}

impl<'a, R: Renderer> Trial<'a, R> {
    pub fn new(renderer: &'a mut R, profile: Profile) -> Self {
        Self {
            renderer,
            profile,
            seen: Vec::new(),
        }
    }

    /// Puts the renderer to one law, and calls `shrinking` if it is broken.
    pub fn of(
        &mut self,
        law: &Law,
        wanted: usize,
        mut runner: TestRunner,
        shrinking: &mut dyn FnMut(),
    ) -> Result<Verdict, String> {
        if let Some(lacks) = law.lacks(&self.profile) {
            return Ok(Verdict::NotTried { because: lacks });
        }
        let strategy = generator::base(&self.profile);
        let (mut trees, mut groups) = (Vec::new(), Vec::new());
        for _ in 0..100 * wanted {
            if groups.len() == wanted {
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
    pub fn causes(&self) -> Vec<Vec<Mistake>> {
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
