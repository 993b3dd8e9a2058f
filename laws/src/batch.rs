//! The cases of a law that are asked for at once.

use crate::bounded::Bounded3;
use crate::claim::Group;
use crate::generator::{self, Base};
use crate::law::Law;
use crate::profile::Profile;
use crate::random::Random;
use crate::scene::{Scene, Triple};
use crate::textbook::Textbook;

/// The most cases of a batch.
const MOST: usize = 256;

/// Some cases of a law, and what is known of their colors before any renderer gives them.
pub struct Batch {
    pub bases: Vec<Base>,
    pub groups: Vec<Group>,
    /// The scenes of all groups, or the first of each if they are asked for twice.
    pub asked: Vec<Scene>,
    /// For each scene of the groups, the linear light of the formulas and its conditioning.
    pub known: Vec<(Bounded3, (f64, Triple))>,
}

impl Batch {
    pub fn new(law: &Law, profile: &Profile, bases: Vec<Base>, groups: Vec<Group>) -> Self {
        let textbook = Textbook::new(profile, &[]);
        let scenes = || groups.iter().flat_map(|group| &group.scenes);
        let know = |scene| (textbook.linear(scene), textbook.conditioning(scene));
        let asked = if law.asks_twice() {
            // the scenes of a group are the same
            groups.iter().map(|group| group.scenes[0].clone()).collect()
        } else {
            scenes().cloned().collect()
        };
        Self {
            known: scenes().map(know).collect(),
            bases,
            groups,
            asked,
        }
    }
}

/// The batches of a law: of fixed cases, and of random ones after them.
pub struct Batches<'a, F> {
    law: &'a Law,
    profile: &'a Profile,
    fixed: F,
    random: Random,
    /// The number of random cases that are left, and of scenes of which the law says nothing.
    cases: usize,
    tries: usize,
}

impl<'a, F: Iterator<Item = Base>> Batches<'a, F> {
    pub fn new(law: &'a Law, profile: &'a Profile, fixed: F, random: Random, cases: usize) -> Self {
        Self {
            law,
            profile,
            fixed,
            random,
            cases,
            tries: 100 * cases,
        }
    }
}

impl<F: Iterator<Item = Base>> Iterator for Batches<'_, F> {
    type Item = Batch;

    fn next(&mut self) -> Option<Batch> {
        let (mut bases, mut groups) = (Vec::new(), Vec::new());
        while groups.len() < MOST {
            let fixed = self.fixed.next();
            let is_random = fixed.is_none();
            let base = match fixed {
                Some(base) => base,
                None if self.cases > 0 && self.tries > 0 => {
                    self.tries -= 1;
                    generator::base(self.profile, &mut self.random)
                }
                None => break,
            };
            if let Some(group) = self.law.group(base.clone(), self.profile) {
                self.cases -= usize::from(is_random);
                bases.push(base);
                groups.push(group);
            }
        }
        (!groups.is_empty()).then(|| Batch::new(self.law, self.profile, bases, groups))
    }
}
