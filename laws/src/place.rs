//! Where a renderer is wrong: one thing at a time is taken out of broken cases, and what repairs them is told.

use std::cmp::Reverse;

use serde::Serialize;

use crate::cause::is_nearly_all;
use crate::edit::EDITS;
use crate::profile::Profile;
use crate::scene::Scene;

/// What wrong colors follow.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Place {
    /// Without one of these, the colors are right.
    pub only_with: Vec<&'static str>,
    /// Without one of these, they are as wrong.
    pub also_without: Vec<&'static str>,
}

impl Place {
    /// Whether it may be that of two things.
    pub(crate) fn is_general(&self) -> bool {
        self.only_with.iter().all(|id| GENERAL.contains(id))
    }

    /// An edit that tells this place beside the whole that it is found in, if one does.
    fn beside(&self, whole: &Self) -> Option<usize> {
        let is_of_whole = |id: &&str| whole.only_with.contains(id);
        if !whole.is_general() {
            let mut particular = self.only_with.iter().filter(|id| !GENERAL.contains(id));
            let first = particular.clone().next()?;
            return (!particular.any(is_of_whole)).then(|| number(first))?;
        }
        // what takes away a part of the light may take away what is wrong with it, too
        let is_told = |id: &&&str| !is_of_whole(id) && (whole.only_with.len() < 2 || !darkens(id));
        number(self.only_with.iter().find(is_told)?)
    }

    /// Whether both say the same but for what is general.
    fn is_as_particular(&self, other: &Self) -> bool {
        let particular = |place: &Self| -> Vec<&str> {
            let ids = place.only_with.iter().copied();
            ids.filter(|id| !GENERAL.contains(id)).collect()
        };
        self.only_with == other.only_with
            || !self.is_general() && particular(self) == particular(other)
    }
}

/// Parts that make up one thing, and what else may be told of either: where both are wrong, the
/// highlight, the lamps, the lights, or everything is. A surface and a light are factors of one product.
const PARTS: [([&str; 2], &[&str]); 6] = [
    (
        ["Phong", "Blinn"],
        &["highlight", "lights", "several lights"],
    ),
    (
        ["spot", "point"],
        &["cone", "lamps", "lights", "several lights"],
    ),
    (["color of the surface", "color of lights"], &[]),
    (["lamps", "directional"], &["lights", "several lights"]),
    (["diffuse", "highlight"], &["lights", "several lights"]),
    (["ambient", "lights"], &["several lights"]),
];

/// What may be two things.
const GENERAL: [&str; 3] = ["highlight", "lamps", "lights"];

/// Things of which the first is all that is left without the second.
const ALONE: [[&str; 2]; 4] = [
    ["highlight", "diffuse"],
    ["diffuse", "highlight"],
    ["point", "cone"],
    ["point", "spot"],
];

/// What nothing but a lamp has, and nothing but a highlight.
const OF_LAMPS: [&str; 3] = ["distance", "attenuation", "cone"];
const OF_HIGHLIGHTS: [&str; 4] = ["length of V", "shininess", "Phong", "Blinn"];

/// What turns the eye, as "eye behind" does, too. That cannot always keep the highlight as bright, so it
/// repairs some cases of what is wrong with some cosines alone, and these repair the others: that is one thing.
const TURNS: [&str; 3] = ["shininess", "Phong", "Blinn"];

/// The most things that are taken out one after the other, each because another is wrong, too.
const DEPTH: usize = 2;

/// The most edits by which two mistakes are told apart. Each takes two experiments, and the renderer's time.
const MOST_PARTS: usize = 5;

/// The fewest cases that show a second mistake. An edit that repairs a case as often as not repairs all of 8 by
/// chance once in 256 times, so one of all edits does in 9 of 100; of 3, about three do.
const FEW: usize = 8;

/// The most broken cases of an experiment: a bit each.
pub const MOST: usize = 60;

/// Asks whether the colors of scenes are wrong, if the renderer still answers.
pub type Ask<'a> = dyn FnMut(&[Scene]) -> Option<Vec<bool>> + 'a;

/// Broken cases without one thing each.
struct Experiment {
    count: usize,
    /// What is left alone by what was taken out already, so that nothing is left to be wrong without it.
    alone: Vec<&'static str>,
    /// For each edit the cases that it repairs, those that it leaves broken, and those of which it says nothing.
    repaired: Vec<u64>,
    broken: Vec<u64>,
    unknown: Vec<u64>,
}

/// The number of cases of a set.
fn count(cases: u64) -> usize {
    cases.count_ones() as usize
}

/// The place of an edit among all.
fn number(id: &str) -> Option<usize> {
    EDITS.iter().position(|edit| edit.id == id)
}

/// So many cases of all, from the first to the last.
fn some(cases: &[Scene], count: usize) -> Vec<Scene> {
    let count = count.min(cases.len());
    let some = (0..count).map(|i| cases[i * cases.len() / count].clone());
    some.collect()
}

/// Where cases are broken: one place, or several where several things are wrong. As many cases as an
/// experiment may have are taken of all.
pub fn places(
    cases: &[Scene],
    most: usize,
    profile: &Profile,
    ask: &mut Ask,
) -> Option<Vec<Place>> {
    Search { most, profile, ask }.places(cases, &[])
}

/// A search for places. Nothing is found once the renderer does not answer.
struct Search<'a, 'b> {
    /// The most cases of an experiment.
    most: usize,
    profile: &'a Profile,
    ask: &'a mut Ask<'b>,
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

    /// The places of cases from which some edits have taken things out already.
    fn places(&mut self, cases: &[Scene], without: &[usize]) -> Option<Vec<Place>> {
        let experiment = self.experiment(cases, without)?;
        let whole = experiment.place();
        if without.len() >= DEPTH {
            return Some(vec![whole]);
        }
        // without what nearly all need, something else may be wrong with the others
        let particular = whole.only_with.iter().find(|id| !GENERAL.contains(id));
        let firsts = match particular.and_then(|id| number(id)) {
            Some(k) => vec![k],
            None => experiment.parts(),
        };
        let cases = some(cases, 10 * self.most);
        let mut found = Vec::new();
        for k in firsts {
            match self.apart(&cases, (&experiment, &whole), k, without) {
                Some(all) if all.len() > 1 => found.push(all),
                Some(_) => {}
                None => break, // the time is up
            }
        }
        // few places, and particular ones
        let first = |place: &Place| number(place.only_with.first()?);
        found.sort_by_key(|all| (all.len(), all.iter().filter_map(first).sum::<usize>()));
        Some(found.into_iter().next().unwrap_or(vec![whole]))
    }

    /// The places, if one thing is wrong with what an edit takes out and another without it: each is the place of
    /// the cases that are left without the other. None if these do not need what they were told apart by.
    fn apart(
        &mut self,
        cases: &[Scene],
        (experiment, whole): (&Experiment, &Place),
        k: usize,
        without: &[usize],
    ) -> Option<Vec<Place>> {
        let none = Some(Vec::new());
        let left = self.left(cases, &[k])?;
        if left.len() < FEW {
            return none;
        }
        let without_first = [without, &[k]].concat();
        let mut others = if whole.only_with.len() < 2 {
            self.places(&left, &without_first)?
        } else {
            let of_others = self.experiment(&left, &without_first)?;
            vec![of_others.place()]
        };
        let edits: Vec<usize> = others.iter().filter_map(|it| it.beside(whole)).collect();
        let both = [&edits[..], &[k]].concat();
        let turns = |id: &&str| *id == "eye behind" || TURNS.contains(id);
        let is_one = both.iter().all(|k| turns(&EDITS[*k].id))
            && both.iter().any(|k| EDITS[*k].id == "eye behind");
        if edits.len() < others.len() || is_one {
            return none;
        }
        let of_first = self.left(cases, &edits)?;
        if of_first.len() < FEW {
            return none;
        }
        let of_first = self.experiment(&of_first, &[without, &edits].concat())?;
        let mut first = of_first.place();
        let is_told = !whole.is_general() || first.beside(whole).is_some();
        if !first.only_with.contains(&EDITS[k].id) || !is_told {
            return none;
        }
        experiment.settle(&mut first, k, &edits);
        for (other, edit) in others.iter_mut().zip(&edits) {
            experiment.settle(other, *edit, &[k]);
        }
        let mut all = vec![first];
        for other in others {
            if all.iter().all(|place| !place.is_as_particular(&other)) {
                all.push(other);
            }
        }
        merge(&mut all);
        Some(all)
    }
}

/// Whether an edit takes away a part of the light.
fn darkens(id: &str) -> bool {
    EDITS.iter().any(|edit| edit.id == id && edit.darkens)
}

/// Makes one place of two that are the parts of one thing, which is wrong as a whole.
pub fn merge(places: &mut Vec<Place>) {
    'merged: loop {
        for (parts, too) in PARTS {
            let of_part = |part| {
                places
                    .iter()
                    .position(|place| place.only_with.contains(&part))
            };
            let [Some(a), Some(b)] = parts.map(of_part) else {
                continue;
            };
            let others = |place: &Place| -> Vec<&str> {
                let others = place.only_with.iter().copied();
                others
                    .filter(|id| !parts.contains(id) && !too.contains(id))
                    .collect()
            };
            if a != b && others(&places[a]) == others(&places[b]) {
                let other = places[b].clone();
                places[a]
                    .only_with
                    .retain(|id| other.only_with.contains(id));
                places.remove(b);
                continue 'merged;
            }
        }
        return;
    }
}

impl Experiment {
    /// Takes things out of the scenes of broken cases, and asks for each again, if anything answers.
    fn new(cases: &[Scene], profile: &Profile, ask: &mut Ask, without: &[usize]) -> Option<Self> {
        let count = cases.len().min(MOST);
        let [repaired, broken, unknown] = [(); 3].map(|()| vec![0; EDITS.len()]);
        let is_out = |id: &str| without.iter().any(|k| EDITS[*k].id == id);
        let alone = ALONE.into_iter().filter(|[_, other]| is_out(other));
        let mut experiment = Self {
            count,
            alone: alone.map(|[id, _]| id).collect(),
            repaired,
            broken,
            unknown,
        };
        let (mut asked, mut of) = (Vec::new(), Vec::new());
        for (k, edit) in EDITS.iter().enumerate() {
            for (i, scene) in cases[..count].iter().enumerate() {
                let Some(mut trial) = edit.trial(scene, profile) else {
                    continue;
                };
                // a lamp may become a sun where suns were taken out because they are wrong, too
                for &k in without {
                    if EDITS[k].of(scene, profile).is_none() {
                        let again = EDITS[k].of(&trial.edited, profile);
                        trial.edited = again.unwrap_or(trial.edited);
                    }
                }
                if trial.edited == *scene {
                    experiment.unknown[k] |= 1 << i;
                    continue;
                }
                asked.push(trial.edited);
                of.push((k, i, false));
                if let Some(control) = trial.control {
                    asked.push(control);
                    of.push((k, i, true));
                }
            }
        }
        for ((k, i, is_control), is_broken) in of.into_iter().zip(ask(&asked)?) {
            let answer = match (is_control, is_broken) {
                (true, true) => continue,
                (true, false) => &mut experiment.unknown,
                (false, true) => &mut experiment.broken,
                (false, false) => &mut experiment.repaired,
            };
            answer[k] |= 1 << i;
        }
        for k in 0..EDITS.len() {
            experiment.repaired[k] &= !experiment.unknown[k];
            experiment.broken[k] &= !experiment.unknown[k];
        }
        Some(experiment)
    }

    /// The place of the cases.
    fn place(&self) -> Place {
        let of = u64::MAX >> (64 - self.count.clamp(1, 64));
        let mut place = Place::default();
        let is_of = |place: &Place, ids: &[&str]| place.only_with.iter().any(|id| ids.contains(id));
        for (k, edit) in EDITS.iter().enumerate() {
            let known = count(of & !self.unknown[k]);
            let [repaired, broken] = self.counts(k);
            let is_told = if known * 2 > count(of) && !self.alone.contains(&edit.id) {
                is_nearly_all(repaired, known)
            } else {
                edit.id == "lamps" && is_of(&place, &OF_LAMPS)
                    || edit.id == "highlight" && is_of(&place, &OF_HIGHLIGHTS)
            };
            if is_told {
                place.only_with.push(edit.id);
            } else if broken > repaired {
                place.also_without.push(edit.id);
            }
        }
        place
    }

    /// Tells of a place what it could not show where something was out: whether it is of highlights alone, or of
    /// point lights alone. The cases that its edit repairs have the other, too.
    fn settle(&self, place: &mut Place, edit: usize, out: &[usize]) {
        // without a highlight, the model is another, too, which says nothing of diffuse light
        for [id, other] in ALONE.into_iter().filter(|[id, _]| *id != "diffuse") {
            let other = number(other).filter(|k| out.contains(k));
            let (Some(k), Some(other)) = (number(id), other) else {
                continue;
            };
            let of = self.repaired[edit] & self.broken[other];
            let is_known = count(of) >= FEW && !place.only_with.contains(&id);
            if is_known && is_nearly_all(count(self.repaired[k] & of), count(of)) {
                place.also_without.retain(|it| *it != id);
                place.only_with.push(id);
                place.only_with.sort_by_key(|id| number(id));
            }
        }
    }

    /// The edits that repair some of the cases and leave others, the most helpful ones first.
    fn parts(&self) -> Vec<usize> {
        let is_part = |k: &usize| {
            let [repaired, broken] = self.counts(*k);
            repaired >= FEW && broken > 0
        };
        let mut parts: Vec<usize> = (0..EDITS.len()).filter(is_part).collect();
        parts.sort_by_key(|k| Reverse(self.counts(*k)[0]));
        parts.truncate(MOST_PARTS);
        parts
    }

    /// The number of cases that an edit repairs, and that of those that it leaves broken.
    fn counts(&self, k: usize) -> [usize; 2] {
        [self.repaired[k], self.broken[k]].map(count)
    }
}
