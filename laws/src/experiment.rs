//! One thing at a time is taken out of broken cases, and what repairs them is told.

use std::cmp::Reverse;

use crate::cause::is_nearly_all;
use crate::edit::EDITS;
use crate::place::Place;
use crate::profile::Profile;
use crate::scene::Scene;

/// Things of which the first is all that is left without the second.
const ALONE: [[&str; 2]; 4] = [
    ["highlight", "diffuse"],
    ["diffuse", "highlight"],
    ["point", "cone"],
    ["point", "spot"],
];

/// What takes a whole term of the color away.
const TERMS: [&str; 4] = ["ambient", "diffuse", "highlight", "lights"];

/// What nothing but a lamp has, and nothing but a highlight.
const OF_LAMPS: [&str; 3] = ["distance", "attenuation", "cone"];
const OF_HIGHLIGHTS: [&str; 4] = ["length of V", "shininess", "Phong", "Blinn"];

/// The most edits by which two mistakes are told apart. Each takes two experiments, and the renderer's time. Of 75
/// pairs, none was told otherwise with 4 and with 7.
const MOST_PARTS: usize = 5;

/// The fewest cases that show a second mistake. An edit that repairs a case as often as not repairs all of 8 by
/// chance once in 256 times, so one of all edits does in 9 of 100; of 3, about three do.
pub const FEW: usize = 8;

/// The most broken cases of an experiment.
pub const MOST: usize = 60;

/// Asks whether the colors of scenes are wrong, if the renderer still answers.
pub type Ask<'a> = dyn FnMut(&[Scene]) -> Option<Vec<bool>> + 'a;

/// Broken cases without one thing each.
pub struct Experiment {
    count: usize,
    /// Nothing was taken out of the cases before.
    is_first: bool,
    /// What is left alone by what was taken out already, so that nothing is left to be wrong without it.
    alone: Vec<&'static str>,
    /// For each edit the number of cases that it repairs, that it leaves broken, and of which it says nothing.
    repaired: Vec<usize>,
    broken: Vec<usize>,
    unknown: Vec<usize>,
}

impl Experiment {
    /// Takes things out of the scenes of broken cases, and asks for each again, if anything answers.
    pub fn new(
        cases: &[Scene],
        profile: &Profile,
        ask: &mut Ask,
        without: &[usize],
    ) -> Option<Self> {
        let [repaired, broken, unknown] = [(); 3].map(|()| vec![0; EDITS.len()]);
        let is_out = |id: &str| without.iter().any(|k| EDITS[*k].id == id);
        let alone = ALONE.into_iter().filter(|[_, other]| is_out(other));
        let mut experiment = Self {
            count: cases.len(),
            is_first: without.is_empty(),
            alone: alone.map(|[id, _]| id).collect(),
            repaired,
            broken,
            unknown,
        };
        let (mut asked, mut of) = (Vec::new(), Vec::new());
        for (k, edit) in EDITS.iter().enumerate() {
            for scene in cases {
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
                    experiment.unknown[k] += 1;
                    continue;
                }
                of.push((k, trial.control.is_some()));
                asked.push(trial.edited);
                asked.extend(trial.control);
            }
        }
        let mut are_broken = ask(&asked)?.into_iter();
        for (k, has_control) in of {
            let is_broken = are_broken.next()?;
            let answers = if has_control && !are_broken.next()? {
                &mut experiment.unknown
            } else if is_broken {
                &mut experiment.broken
            } else {
                &mut experiment.repaired
            };
            answers[k] += 1;
        }
        Some(experiment)
    }

    /// The place of the cases.
    pub fn place(&self) -> Place {
        let mut place = Place::default();
        let is_of = |place: &Place, ids: &[&str]| place.only_with.iter().any(|id| ids.contains(id));
        for (k, edit) in EDITS.iter().enumerate() {
            let known = self.count - self.unknown[k];
            let (repaired, broken) = (self.repaired[k], self.broken[k]);
            let is_told = if known * 2 > self.count && !self.alone.contains(&edit.id) {
                // Of a term that is taken away, nothing is left to be wrong. Without it, most colors are too dark for a
                // wrong clamp, too, but not all. Where another thing was out, a few cases may be wrong by a rest of it.
                let is_strict = self.is_first && TERMS.contains(&edit.id);
                repaired == known || !is_strict && is_nearly_all(repaired, known)
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

    /// The edits that repair some of the cases and leave others, the most helpful ones first.
    pub fn parts(&self) -> Vec<usize> {
        let is_part = |k: &usize| self.repaired[*k] >= FEW && self.broken[*k] > 0;
        let mut parts: Vec<usize> = (0..EDITS.len()).filter(is_part).collect();
        parts.sort_by_key(|k| Reverse(self.repaired[*k]));
        parts.truncate(MOST_PARTS);
        parts
    }
}
