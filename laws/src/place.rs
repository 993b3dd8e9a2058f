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

/// What became of a broken case when a thing was taken out.
#[derive(Clone, Copy, PartialEq)]
enum Outcome {
    /// There was no such thing in it.
    Same,
    Broken,
    Repaired,
}

/// The edits of broken cases: for each what is asked, with the place of the edit and of the case.
pub struct Edits {
    cases: usize,
    pub edited: Vec<Case>,
    of: Vec<(usize, usize)>,
}

impl Edits {
    pub fn new(broken: &[Case], profile: &Profile) -> Self {
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
        Self {
            cases: broken.len(),
            edited,
            of,
        }
    }

    /// The broken case of an edit.
    pub fn case_of(&self, edit: usize) -> usize {
        self.of[edit].1
    }

    /// The places, if these of the edited cases are still broken: one, or two where no single thing repairs nearly all.
    pub fn places(&self, still_broken: &[bool]) -> Vec<Place> {
        let mut table = vec![vec![Outcome::Same; self.cases]; KNOBS.len()];
        for ((knob, case), broken) in self.of.iter().zip(still_broken) {
            table[*knob][*case] = if *broken {
                Outcome::Broken
            } else {
                Outcome::Repaired
            };
        }
        let all: Vec<usize> = (0..self.cases).collect();
        let whole = place(&table, &all);
        if !whole.only_with.is_empty() || all.len() < 4 {
            return vec![whole];
        }
        // two things may be wrong: what repairs many of the cases splits them
        let repairs = |knob: &usize| {
            let row = table[*knob].iter();
            row.filter(|outcome| **outcome == Outcome::Repaired).count()
        };
        let best = (0..KNOBS.len()).rev().max_by_key(repairs).unwrap_or(0);
        let (repaired, left): (Vec<usize>, Vec<usize>) = all
            .iter()
            .partition(|case| table[best][**case] == Outcome::Repaired);
        let places = [repaired, left].map(|cases| (cases.len(), place(&table, &cases)));
        let is_told = |(count, place): &(usize, Place)| {
            *count * 5 >= all.len() && !place.only_with.is_empty()
        };
        if places.iter().all(is_told) {
            places.map(|(_, place)| place).into()
        } else {
            vec![whole]
        }
    }
}

fn place(table: &[Vec<Outcome>], cases: &[usize]) -> Place {
    let mut place = Place::default();
    for (knob, row) in KNOBS.iter().zip(table) {
        let count = |of| cases.iter().filter(|case| row[**case] == of).count();
        let (repaired, broken) = (count(Outcome::Repaired), count(Outcome::Broken));
        if repaired > 0 && repaired * 10 >= cases.len() * 9 {
            place.only_with.push(knob.id);
        } else if broken > repaired {
            place.also_without.push(knob.id);
        }
    }
    place
}
