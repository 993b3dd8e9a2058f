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

/// The most broken cases of an experiment: a bit each.
pub const MOST: usize = 60;

/// Asks whether the colors of scenes are wrong, if the renderer still answers.
pub type Ask<'a> = dyn FnMut(&[Scene]) -> Option<Vec<bool>> + 'a;

/// Broken cases without one thing each.
struct Experiment {
    count: usize,
    /// For each edit the cases that it repairs, and those that it leaves broken.
    repaired: Vec<u64>,
    broken: Vec<u64>,
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

/// Where cases are broken: one place, or several where several things are wrong.
pub fn places(cases: &[Scene], profile: &Profile, ask: &mut Ask) -> Option<Vec<Place>> {
    places_of(cases, profile, ask, 2)
}

fn places_of(cases: &[Scene], profile: &Profile, ask: &mut Ask, depth: u32) -> Option<Vec<Place>> {
    let experiment = Experiment::new(cases, profile, ask)?;
    let whole = experiment.place(experiment.all());
    let is_general = whole.only_with.iter().all(|id| GENERAL.contains(id));
    if depth == 0 || !is_general {
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
        let Some(others) = places_of(&left, profile, ask, depth - 1) else {
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
        if all.len() > 1 && all.iter().all(is_told) {
            found.push(all);
        }
    }
    // few places, and particular ones
    let first = |place: &Place| {
        EDITS
            .iter()
            .position(|edit| place.only_with.first() == Some(&edit.id))
    };
    found.sort_by_key(|all| (all.len(), all.iter().filter_map(first).sum::<usize>()));
    Some(found.into_iter().next().unwrap_or(vec![whole]))
}

/// Makes one place of two that are the parts of one thing, which is wrong as a whole.
fn merge(places: &mut Vec<Place>) {
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
    fn new(cases: &[Scene], profile: &Profile, ask: &mut Ask) -> Option<Self> {
        let count = cases.len().min(MOST);
        let (mut asked, mut of) = (Vec::new(), Vec::new());
        for (k, edit) in EDITS.iter().enumerate() {
            for (i, scene) in cases[..count].iter().enumerate() {
                if let Some(edited) = edit.of(scene, profile) {
                    asked.push(edited);
                    of.push((k, i));
                }
            }
        }
        let [repaired, broken] = [(); 2].map(|()| vec![0; EDITS.len()]);
        let mut experiment = Self {
            count,
            repaired,
            broken,
        };
        for ((k, i), is_broken) in of.into_iter().zip(ask(&asked)?) {
            let answer = if is_broken {
                &mut experiment.broken
            } else {
                &mut experiment.repaired
            };
            answer[k] |= 1 << i;
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
        for (k, edit) in EDITS.iter().enumerate() {
            let (repaired, broken) = (self.repaired[k] & of, self.broken[k] & of);
            if is_nearly_all(repaired, of.count_ones(), edit.id) {
                place.only_with.push(edit.id);
            } else if broken.count_ones() > repaired.count_ones() {
                place.also_without.push(edit.id);
            }
        }
        place
    }

    /// The edits that repair some of the cases and leave others, the most helpful ones first.
    fn parts(&self) -> Vec<usize> {
        let few = (self.count / 10).max(3);
        let counts =
            |k: usize| [self.repaired[k], self.broken[k]].map(|cases| cases.count_ones() as usize);
        let is_part = |k: &usize| counts(*k).iter().all(|count| *count >= few);
        let mut parts: Vec<usize> = (0..EDITS.len()).filter(is_part).collect();
        parts.sort_by_key(|k| std::cmp::Reverse(counts(*k)[0]));
        parts.truncate(5);
        parts
    }
}
