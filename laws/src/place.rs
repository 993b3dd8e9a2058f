//! Where a renderer is wrong: one thing at a time is taken out of broken cases, and what repairs them is told.

use serde::Serialize;

use crate::edit::KNOBS;
use crate::generator::Case;
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

/// Broken cases, from each of which one thing at a time is taken out.
pub struct Edits {
    broken: Vec<Case>,
    /// What is asked, with the edit and the place of the broken case.
    pub edited: Vec<Case>,
    pub of: Vec<(usize, usize)>,
}

impl Edits {
    pub fn new(broken: Vec<Case>, profile: &Profile) -> Self {
        let (mut edited, mut of) = (Vec::new(), Vec::new());
        for (k, knob) in KNOBS.iter().enumerate() {
            for (i, case) in broken.iter().enumerate() {
                let mut other = case.clone();
                (knob.edit)(&mut other.scene, profile);
                if other != *case && is_valid(&other, profile) {
                    edited.push(other);
                    of.push((k, i));
                }
            }
        }
        Self { broken, edited, of }
    }

    /// The place of some of the broken cases, if these of the edited ones are still broken.
    pub fn place(&self, still_broken: &[bool], is_meant: impl Fn(usize) -> bool) -> Place {
        let mut place = Place::default();
        let meant = (0..self.broken.len())
            .filter(|case| is_meant(*case))
            .count();
        for (k, knob) in KNOBS.iter().enumerate() {
            let count = |broken: bool| {
                let edits = self.of.iter().zip(still_broken);
                edits
                    .filter(|((of, case), is)| *of == k && **is == broken && is_meant(*case))
                    .count()
            };
            let repaired = count(false);
            if repaired > 0 && repaired * 10 >= meant * 9 {
                place.only_with.push(knob.id);
            } else if count(true) > repaired {
                place.also_without.push(knob.id);
            }
        }
        place
    }

    /// The edit that repairs the most cases, those that it repairs, and the others after it: two things may be wrong.
    pub fn split(&self, still_broken: &[bool]) -> Option<(Vec<usize>, Vec<usize>)> {
        let by = |k: usize, broken: bool| {
            let edits = self.of.iter().zip(still_broken).enumerate();
            edits.filter(move |(_, ((of, _), is))| *of == k && **is == broken)
        };
        let best = (0..KNOBS.len())
            .rev()
            .max_by_key(|k| by(*k, false).count())?;
        let repaired: Vec<usize> = by(best, false).map(|(_, ((_, case), _))| *case).collect();
        let left = by(best, true).map(|(edit, _)| edit).collect();
        (repaired.len() * 5 >= self.broken.len()).then_some((repaired, left))
    }
}
