//! The search for places: for one, or for several where several things are wrong.

use crate::edit::EDITS;
use crate::experiment::{Ask, Experiment, FEW};
use crate::place::{Place, merge, number};
use crate::profile::Profile;
use crate::scene::Scene;

/// The most things that are taken out one after the other, each because another is wrong, too.
const DEPTH: usize = 2;

/// At most so many of all, from the first to the last.
pub fn some<T: Clone>(all: &[T], count: usize) -> Vec<T> {
    let count = count.min(all.len());
    let some = (0..count).map(|i| all[i * all.len() / count].clone());
    some.collect()
}

/// A search for places. Nothing is found once the renderer does not answer.
pub struct Search<'a, 'b> {
    /// The most cases of an experiment.
    pub most: usize,
    pub profile: &'a Profile,
    pub ask: &'a mut Ask<'b>,
}

impl Search<'_, '_> {
    fn experiment(&mut self, cases: &[Scene], without: &[usize]) -> Option<Experiment> {
        Experiment::new(&some(cases, self.most), self.profile, self.ask, without)
    }

    /// The cases that are still broken without some things.
    fn left(&mut self, cases: &[Scene], edits: &[usize]) -> Option<Vec<Scene>> {
        let without = |case: &Scene| {
            edits.iter().fold(case.clone(), |case, k| {
                EDITS[*k].of(&case, self.profile).unwrap_or(case)
            })
        };
        let edited: Vec<Scene> = cases.iter().map(without).collect();
        let are_broken = (self.ask)(&edited)?.into_iter();
        let broken = edited.into_iter().zip(are_broken).filter(|(_, is)| *is);
        Some(broken.map(|(case, _)| case).collect())
    }

    /// Where cases are broken, from which some edits have taken things out already: one place, or several where
    /// several things are wrong. As many cases as an experiment may have are taken of all.
    pub fn places(&mut self, cases: &[Scene], without: &[usize]) -> Option<Vec<Place>> {
        let experiment = self.experiment(cases, without)?;
        let whole = experiment.place();
        if without.len() >= DEPTH {
            return Some(vec![whole]);
        }
        // without what nearly all need, something else may be wrong with the others
        let firsts = whole.particular().map(|k| vec![k]);
        let firsts = firsts.unwrap_or_else(|| experiment.parts());
        let cases = some(cases, 10 * self.most);
        let apart = |k| self.apart(&cases, &whole, k, without);
        let found = firsts.into_iter().map_while(apart); // until the time is up
        let several = found.filter(|all| all.len() > 1);
        // few places, and particular ones
        let first = |place: &Place| number(place.only_with.first()?);
        let numbers = |all: &Vec<Place>| all.iter().filter_map(first).sum::<usize>();
        let best = several.min_by_key(|all| (all.len(), numbers(all)));
        Some(best.unwrap_or(vec![whole]))
    }

    /// The places, if one thing is wrong with what an edit takes out and another without it: each is the place of
    /// the cases that are left without the other. None if these do not need what they were told apart by.
    fn apart(
        &mut self,
        cases: &[Scene],
        whole: &Place,
        k: usize,
        without: &[usize],
    ) -> Option<Vec<Place>> {
        let none = Some(Vec::new());
        let left = self.left(cases, &[k])?;
        if left.len() < FEW {
            return none;
        }
        let without_first = [without, &[k]].concat();
        let others = if whole.only_with.len() < 2 {
            self.places(&left, &without_first)?
        } else {
            vec![self.experiment(&left, &without_first)?.place()]
        };
        let edits: Vec<usize> = others.iter().filter_map(|it| it.beside(whole)).collect();
        if edits.len() < others.len() {
            return none;
        }
        let of_first = self.left(cases, &edits)?;
        if of_first.len() < FEW {
            return none;
        }
        let without_others = [without, &edits].concat();
        let first = self.experiment(&of_first, &without_others)?.place();
        let is_told = !whole.is_general() || first.beside(whole).is_some();
        if !first.only_with.contains(&EDITS[k].id) || !is_told {
            return none;
        }
        let mut all = vec![first];
        for other in others {
            if all.iter().all(|place| place.only_with != other.only_with) {
                all.push(other);
            }
        }
        merge(&mut all);
        Some(all)
    }
}
