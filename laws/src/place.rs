//! Where a renderer is wrong: one thing at a time is taken out of broken cases, and what repairs them is told.

use serde::Serialize;

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
}

/// Parts that make up one thing, and what else may be told of either: where both are wrong, the
/// highlight, the lamps, the lights, or everything is.
const PARTS: [([&str; 2], &[&str]); 5] = [
    (
        ["Phong", "Blinn"],
        &["highlight", "lights", "several lights"],
    ),
    (
        ["spot", "point"],
        &["cone", "lamps", "lights", "several lights"],
    ),
    (["lamps", "directional"], &["lights", "several lights"]),
    (["diffuse", "highlight"], &["lights", "several lights"]),
    (["ambient", "lights"], &["several lights"]),
];

/// What may be two things.
const GENERAL: [&str; 3] = ["highlight", "lamps", "lights"];

/// What is wrong without a whole term is not wrong only with it; other edits may change a case in
/// more ways than one.
const TERMS: [&str; 4] = ["highlight", "diffuse", "ambient", "lights"];

/// What nothing but a lamp has.
const OF_LAMPS: [&str; 3] = ["distance", "attenuation", "cone"];

/// The most things that are taken out one after the other, each because another is wrong, too.
const DEPTH: usize = 2;

/// The fewest cases that have a place.
const FEWEST: usize = 3;

/// The most broken cases of an experiment: a bit each.
pub const MOST: usize = 60;

/// Asks whether the colors of scenes are wrong, if the renderer still answers.
pub type Ask<'a> = dyn FnMut(&[Scene]) -> Option<Vec<bool>> + 'a;

/// Broken cases without one thing each.
struct Experiment {
    count: usize,
    /// For each edit the cases that it repairs, those that it leaves broken, and those of which it says nothing.
    repaired: Vec<u64>,
    broken: Vec<u64>,
    unknown: Vec<u64>,
}

/// Whether something is nearly all of a count. In some of the scenes an edit leaves what it is about as it was,
/// such as a second light that the wrong one hides, so a tenth may miss. Of 60 scenes without a whole term only
/// one may, where rounding decides. The mistakes of `tests/mistakes.txt` are placed with these numbers.
fn is_nearly_all(cases: u64, count: u32, id: &str) -> bool {
    let of = if TERMS.contains(&id) {
        [33, 32]
    } else {
        [10, 9]
    };
    count > 0 && cases.count_ones() * of[0] >= count * of[1]
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
    places_of(&some(cases, most), profile, ask, &[])
}

/// The place of cases without what another place is about, where what is wrong there may hide what repairs them.
fn alone(
    cases: &[Scene],
    other: &Place,
    before: &Place,
    profile: &Profile,
    ask: &mut Ask,
) -> Option<Place> {
    let is_new = |id: &&&str| !GENERAL.contains(id) && !before.only_with.contains(id);
    let k = number(other.only_with.iter().find(is_new)?)?;
    let without = |case: &Scene| EDITS[k].of(case, profile).unwrap_or(case.clone());
    let edited: Vec<Scene> = cases.iter().map(without).collect();
    let are_broken = ask(&edited)?.into_iter();
    let broken = edited.into_iter().zip(are_broken).filter(|(_, is)| *is);
    let broken: Vec<Scene> = broken.map(|(case, _)| case).collect();
    if broken.len() < FEWEST {
        return None;
    }
    let experiment = Experiment::new(&broken, profile, ask, &[k])?;
    let place = experiment.place(experiment.all());
    before
        .only_with
        .first()
        .filter(|id| place.only_with.contains(id))?;
    Some(place)
}

/// The same, where some edits have taken things out of the cases already.
fn places_of(
    cases: &[Scene],
    profile: &Profile,
    ask: &mut Ask,
    without: &[usize],
) -> Option<Vec<Place>> {
    let experiment = Experiment::new(cases, profile, ask, without)?;
    let whole = experiment.place(experiment.all());
    if without.len() >= DEPTH || !whole.is_general() {
        return Some(vec![whole]);
    }
    let mut found = Vec::new();
    // what is left without one thing is wrong for another reason
    for k in experiment.parts() {
        let is_left = |i: &usize| experiment.broken[k] >> i & 1 == 1;
        let left = (0..experiment.count).filter(is_left);
        let left = left.filter_map(|i| EDITS[k].of(&cases[i], profile));
        let left: Vec<Scene> = left.collect();
        let mut all = vec![experiment.place(experiment.repaired[k])];
        let Some(others) = places_of(&left, profile, ask, &[without, &[k]].concat()) else {
            break; // the time is up
        };
        for other in others {
            if all.iter().all(|place| place.only_with != other.only_with) {
                all.push(other);
            }
        }
        merge(&mut all);
        // what takes away a part of the light may take away what is wrong with it, and tells of no
        // place of its own
        let darkens = |id: &str| EDITS.iter().any(|edit| edit.id == id && edit.darkens);
        let is_more = |id: &&str| {
            !whole.only_with.contains(id) && (whole.only_with.len() < 2 || !darkens(id))
        };
        let is_told = |place: &Place| place.only_with.iter().any(is_more);
        let of_first = experiment.repaired[k];
        let is_apart = |place: &Place| experiment.is_apart(of_first, place);
        if all.len() > 1 && all.iter().all(is_told) && all[1..].iter().all(is_apart) {
            if let [first, other] = &mut all[..] {
                let of_first = (0..experiment.count).filter(|i| of_first >> i & 1 == 1);
                let of_first: Vec<Scene> = of_first.map(|i| cases[i].clone()).collect();
                if let Some(alone) = alone(&of_first, other, first, profile, ask) {
                    *first = alone;
                }
            }
            found.push(all);
        }
    }
    // few places, and particular ones
    let first = |place: &Place| number(place.only_with.first()?);
    found.sort_by_key(|all| (all.len(), all.iter().filter_map(first).sum::<usize>()));
    Some(found.into_iter().next().unwrap_or(vec![whole]))
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
        let mut experiment = Self {
            count,
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

    /// Every case.
    fn all(&self) -> u64 {
        u64::MAX >> (64 - self.count.clamp(1, 64))
    }

    /// The place of some of the cases.
    fn place(&self, of: u64) -> Place {
        let mut place = Place::default();
        let is_of_lamps = |place: &Place| place.only_with.iter().any(|id| OF_LAMPS.contains(id));
        for (k, edit) in EDITS.iter().enumerate() {
            let (repaired, broken) = (self.repaired[k] & of, self.broken[k] & of);
            let known = of & !self.unknown[k];
            let is_known = known.count_ones() * 2 > of.count_ones();
            let is_told = if is_known {
                is_nearly_all(repaired, known.count_ones(), edit.id)
            } else {
                edit.id == "lamps" && is_of_lamps(&place)
            };
            if is_told {
                place.only_with.push(edit.id);
            } else if broken.count_ones() > repaired.count_ones() {
                place.also_without.push(edit.id);
            }
        }
        place
    }

    /// Whether something that another place is only with repairs few of some cases. What repairs a part of both
    /// tells nothing apart.
    fn is_apart(&self, of: u64, other: &Place) -> bool {
        let few = |id: &&'static str| {
            let repaired = number(id).map_or(0, |k| self.repaired[k] & of);
            repaired.count_ones() * 4 <= of.count_ones()
        };
        other.only_with.iter().any(few)
    }

    /// The edits that repair some of the cases and leave others, the most helpful ones first.
    fn parts(&self) -> Vec<usize> {
        let few = (self.count / 10).max(FEWEST);
        let counts =
            |k: usize| [self.repaired[k], self.broken[k]].map(|cases| cases.count_ones() as usize);
        let is_part = |k: &usize| counts(*k).iter().all(|count| *count >= few);
        let mut parts: Vec<usize> = (0..EDITS.len()).filter(is_part).collect();
        parts.sort_by_key(|k| std::cmp::Reverse(counts(*k)[0]));
        parts.truncate(5);
        parts
    }
}
