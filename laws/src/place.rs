//! Where a renderer is wrong: one thing at a time is taken out of broken cases, and what repairs them is told.

use serde::Serialize;

use crate::edit::KNOBS;
use crate::plan::Tried;
use crate::profile::Profile;
use crate::shrink::is_valid;

/// What wrong colors follow.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Place {
    /// Without one of these, the colors are right.
    pub only_with: Vec<&'static str>,
    /// Without one of these, they are as wrong.
    pub also_without: Vec<&'static str>,
}

/// Broken cases without one thing each.
pub struct Edits {
    /// The number of broken cases.
    count: usize,
    pub cases: Vec<Tried>,
    /// For each the edit, the broken case, and whether it is still broken.
    of: Vec<(usize, usize, bool)>,
}

impl Edits {
    /// Takes things out of cases, and asks which ones are still broken, if anything answers.
    pub fn new(
        broken: &[Tried],
        profile: &Profile,
        ask: &mut impl FnMut(&[Tried]) -> Option<Vec<bool>>,
    ) -> Option<Self> {
        let (mut cases, mut of) = (Vec::new(), Vec::new());
        for (k, knob) in KNOBS.iter().enumerate() {
            for (i, tried) in broken.iter().enumerate() {
                let mut case = tried.case.clone();
                (knob.edit)(&mut case.scene, profile);
                if case != tried.case && is_valid(&case, profile) {
                    if let Some(tried) = Tried::new(tried.law, case, profile) {
                        cases.push(tried);
                        of.push((k, i));
                    }
                }
            }
        }
        let is_broken = ask(&cases)?;
        let of = of.into_iter().zip(is_broken);
        Some(Self {
            count: broken.len(),
            of: of.map(|((knob, case), is)| (knob, case, is)).collect(),
            cases,
        })
    }

    fn count(&self, knob: usize, is_broken: bool, is_meant: impl Fn(usize) -> bool) -> usize {
        let edits = self.of.iter();
        let meant = edits.filter(|(k, i, is)| (*k, *is) == (knob, is_broken) && is_meant(*i));
        meant.count()
    }

    /// The place of some of the broken cases.
    pub fn place(&self, is_meant: impl Fn(usize) -> bool) -> Place {
        let mut place = Place::default();
        let meant = (0..self.count).filter(|case| is_meant(*case)).count();
        for (k, knob) in KNOBS.iter().enumerate() {
            let repaired = self.count(k, false, &is_meant);
            if repaired > 0 && repaired * 10 >= meant * 9 {
                place.only_with.push(knob.id);
            } else if self.count(k, true, &is_meant) > repaired {
                place.also_without.push(knob.id);
            }
        }
        place
    }

    /// The cases that the most helpful edit repairs, and the others after it: two things may be wrong.
    pub fn split(&self) -> Option<(Vec<usize>, Vec<Tried>)> {
        let knobs = (0..KNOBS.len()).rev();
        let best = knobs.max_by_key(|k| self.count(*k, false, |_| true))?;
        let of_best = self.of.iter().zip(&self.cases);
        let of_best = of_best.filter(|((k, ..), _)| *k == best);
        let (left, repaired): (Vec<_>, Vec<_>) = of_best.partition(|((.., is), _)| *is);
        let repaired: Vec<usize> = repaired.iter().map(|((_, i, _), _)| *i).collect();
        let left = left.into_iter().map(|(_, tried)| tried.clone()).collect();
        (repaired.len() * 5 >= self.count).then_some((repaired, left))
    }
}
