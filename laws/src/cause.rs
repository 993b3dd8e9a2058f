//! Which mistakes explain the colors of a run.

use serde::Serialize;

use crate::bounded::Bounded;
use crate::formula::{Formula, Scope};
use crate::mistakes::Fault;
use crate::profile::Profile;
use crate::random::Random;
use crate::scene::{Scene, Triple};

/// The most scenes of each law that are kept, wrong ones and right ones.
const WRONG: usize = 24;
const RIGHT: usize = 12;

/// A share of the wrong colors that is nearly all.
const NEARLY_ALL: f64 = 0.9;

/// What may have caused the wrong colors of a run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Cause {
    /// The mistake, or the mistakes that are made together.
    pub mistakes: Vec<Fault>,
    /// The number of wrong colors that the mistakes give.
    pub explained: usize,
    /// The number of wrong colors that were compared. It is 0 for a cause that another experiment showed.
    pub of: usize,
    /// Other mistakes that give the same colors.
    pub alternatives: Vec<Vec<Fault>>,
}

impl Cause {
    /// Whether it explains nearly all wrong colors.
    #[must_use]
    pub fn is_nearly_all(&self) -> bool {
        self.explained * 10 >= self.of * 9
    }
}

/// A color, and the law that asked for it.
struct Sample {
    law: usize,
    scene: Scene,
    reply: Triple,
}

/// A sample of what a renderer answered, of a size that does not grow with the run.
pub struct Evidence {
    wrong: Vec<Sample>,
    right: Vec<Sample>,
    /// Whether the wrong colors are in random order, so that the first ones are like all.
    is_mixed: bool,
    /// For each law the number of its wrong and of its right colors.
    counts: Vec<[usize; 2]>,
    random: Random,
}

impl Evidence {
    pub fn new() -> Self {
        Self {
            wrong: Vec::new(),
            right: Vec::new(),
            is_mixed: false,
            counts: Vec::new(),
            random: Random::new(0, "evidence"),
        }
    }

    /// Notes a color of a law, each with the same chance to be kept.
    pub fn note(&mut self, law: usize, is_right: bool, scene: &Scene, reply: Triple) {
        if self.counts.len() <= law {
            self.counts.resize(law + 1, [0; 2]);
        }
        let count = &mut self.counts[law][usize::from(is_right)];
        *count += 1;
        let (samples, most) = if is_right {
            (&mut self.right, RIGHT)
        } else {
            (&mut self.wrong, WRONG)
        };
        let sample = || Sample {
            law,
            scene: scene.clone(),
            reply,
        };
        if *count <= most {
            samples.push(sample());
            return;
        }
        let place = self.random.below(*count);
        if place < most {
            let mut of_law = samples.iter_mut().filter(|sample| sample.law == law);
            if let Some(replaced) = of_law.nth(place) {
                *replaced = sample();
            }
        }
    }

    /// The causes that explain nearly all wrong colors and no right one away, the best first; else what explains half.
    pub fn cause(&mut self, profile: &Profile) -> Option<Cause> {
        if self.wrong.is_empty() {
            return None;
        }
        self.mix();
        let faults: Vec<Fault> = Fault::all().collect();
        let is_rough = |fault: &&Fault| fault.mistake.is_rough();
        let exact = || faults.iter().filter(|fault| !is_rough(fault)).copied();
        // of some lights or models alone
        let scoped =
            || exact().flat_map(|fault| Scope::OTHERS.map(|(of, _)| Fault { of, ..fault }));
        let best = |faults: &mut dyn Iterator<Item = Fault>, least| {
            self.best(profile, faults.map(|fault| vec![fault]), least)
        };
        let mut single = best(&mut exact(), NEARLY_ALL);
        if single.as_ref().is_none_or(|(errors, _)| *errors > 0) {
            let of_some = best(&mut scoped(), NEARLY_ALL);
            let errors =
                |found: &Option<(usize, Cause)>| found.as_ref().map_or(usize::MAX, |it| it.0);
            if errors(&of_some) < errors(&single) {
                single = of_some;
            }
        }
        if let Some((_, cause)) = single {
            // what one mistake does not explain, another may
            let is_all = cause.explained * 100 >= cause.of * 97;
            let left = |cause: &Cause| cause.of - cause.explained;
            let explains_more = |pair: &Cause| left(pair) * 2 < left(&cause);
            let pair = || self.pair(profile, exact()).filter(explains_more);
            let pair = if is_all { None } else { pair() };
            return Some(pair.unwrap_or(cause));
        }
        let mut rough = faults.iter().filter(is_rough);
        let rough = rough.find_map(|fault| self.roughness(profile, *fault));
        let pair = || self.pair(profile, exact());
        let half = || Some(best(&mut exact(), 0.5)?.1);
        rough.or_else(pair).or_else(half)
    }

    fn mix(&mut self) {
        if !self.is_mixed {
            for i in (1..self.wrong.len()).rev() {
                self.wrong.swap(i, self.random.below(i + 1));
            }
            for i in (1..self.right.len()).rev() {
                self.right.swap(i, self.random.below(i + 1));
            }
            self.is_mixed = true;
        }
    }

    /// The best of the candidates, and the number of colors that it gets wrong.
    fn best(
        &self,
        profile: &Profile,
        candidates: impl Iterator<Item = Vec<Fault>>,
        least: f64,
    ) -> Option<(usize, Cause)> {
        let mut ranked: Vec<(usize, [usize; 2], Vec<Fault>)> = candidates
            .filter_map(|faults| {
                let (of, errors) = self.score(profile, &faults, least)?;
                Some((errors, of, faults))
            })
            .collect();
        ranked.sort_by_key(|(errors, ..)| *errors);
        let (errors, [explained, of], mistakes) = ranked.first()?.clone();
        let alternatives = ranked
            .into_iter()
            .skip(1)
            .filter(|(others, ..)| *others == errors)
            .map(|(.., faults)| faults);
        let cause = Cause {
            mistakes,
            explained,
            of,
            alternatives: alternatives.collect(),
        };
        Some((errors, cause))
    }

    /// The numbers of wrong colors that the mistakes give and of those that are known, and that of errors, if the first is at least
    /// this share of the wrong ones and nearly no right color is contradicted.
    fn score(
        &self,
        profile: &Profile,
        faults: &[Fault],
        least: f64,
    ) -> Option<([usize; 2], usize)> {
        let formula = Formula::new(profile, faults);
        #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation)]
        #[allow(clippy::cast_sign_loss)] // a part of a small count
        let misses = |count: usize, share: f64| (count as f64 * share) as usize;
        let most = misses(self.wrong.len(), 1.0 - least);
        let (mut unexplained, mut unknown) = (0, 0);
        for (i, sample) in self.wrong.iter().enumerate() {
            let fits = formula.fits(&sample.scene, sample.reply);
            if fits.is_none() {
                // such as that of the eye in the surface, which has no direction
                unknown += 1;
                if unknown * 4 > self.wrong.len() * 3 {
                    return None;
                }
            } else if fits == Some(false) {
                unexplained += 1;
                // what fails so often at the beginning hardly ever explains enough in the end
                let most_so_far = misses(i, 2.0 * (1.0 - least)) + 3;
                if unexplained > most.min(most_so_far) {
                    return None;
                }
            }
        }
        let most = misses(self.right.len(), 0.02);
        let mut contradicted = 0;
        for sample in &self.right {
            if formula.fits(&sample.scene, sample.reply) == Some(false) {
                contradicted += 1;
                if contradicted > most {
                    return None;
                }
            }
        }
        let known = self.wrong.len() - unknown;
        let errors = unexplained + unknown + contradicted;
        Some(([known - unexplained, known], errors))
    }

    /// The cause if the colors are as if they were rounded so: nearly all of them, and, where not each of them shows it,
    /// some too bright and some too dark.
    fn roughness(&self, profile: &Profile, fault: Fault) -> Option<Cause> {
        let (faults, right) = ([fault], Formula::new(profile, &[]));
        let rough = Formula::new(profile, &faults);
        let shows = fault.mistake.id == "InBits";
        let (mut explained, mut of, mut brighter) = (0, 0, 0);
        for sample in &self.wrong {
            let is_explained = rough.fits(&sample.scene, sample.reply);
            let is_vague = |c: &Bounded| c.error * 2.0 > c.value;
            // with so few bits, hardly anything is known of some colors
            let is_known = !rough.linear(&sample.scene).iter().all(is_vague);
            let Some(is_explained) = is_explained.filter(|fits| is_known || !fits) else {
                continue;
            };
            of += 1;
            explained += usize::from(is_explained);
            if (of - explained) * 50 > self.wrong.len() {
                return None;
            }
            let mut channels = right.linear(&sample.scene).into_iter().zip(sample.reply);
            let is_brighter =
                channels.any(|(linear, c)| right.ends(linear).is_some_and(|[_, high]| c > high));
            brighter += usize::from(is_brighter);
        }
        let balance = brighter.min(of - brighter) * 8;
        let is_so = explained * 50 >= of * 49 && of * 2 >= self.wrong.len();
        (is_so && (shows || balance >= of)).then(|| Cause {
            mistakes: vec![fault],
            explained,
            of,
            alternatives: Vec::new(),
        })
    }

    /// Two mistakes together, each of which gives some of the wrong colors alone.
    fn pair(&self, profile: &Profile, faults: impl Iterator<Item = Fault>) -> Option<Cause> {
        let gives_some = |fault: &Fault| {
            let formula = Formula::new(profile, std::slice::from_ref(fault));
            let first = &self.wrong[..self.wrong.len().min(80)];
            let gives = |sample: &&Sample| formula.fits(&sample.scene, sample.reply) == Some(true);
            let (few, others) = first.split_at(first.len() / 2);
            // what gives none of the first few hardly ever gives enough
            let of_few = few.iter().filter(gives).count();
            let is_some = || (of_few + others.iter().filter(gives).count()) * 20 >= first.len();
            !fault.mistake.is_loose() && (of_few > 0 || few.len() < 40) && is_some()
        };
        let some: Vec<Fault> = faults.filter(gives_some).collect();
        let some = &some;
        let pairs = some.iter().enumerate().flat_map(|(i, a)| {
            let others = some[..i].iter().filter(|b| b.mistake.id != a.mistake.id);
            others.map(move |b| vec![*b, *a])
        });
        Some(self.best(profile, pairs, 0.97)?.1)
    }

    /// Keeps the wrong colors that these mistakes do not give, and returns the law of each.
    pub fn leave(&mut self, profile: &Profile, faults: &[Fault]) -> Vec<usize> {
        let formula = Formula::new(profile, faults);
        self.wrong
            .retain(|sample| formula.fits(&sample.scene, sample.reply) == Some(false));
        self.wrong.iter().map(|sample| sample.law).collect()
    }

    /// Whether a cause gives nearly all wrong colors of a law.
    pub fn explains(&self, profile: &Profile, faults: &[Fault], law: usize) -> bool {
        let formula = Formula::new(profile, faults);
        let of_law = self.wrong.iter().filter(|sample| sample.law == law);
        let (mut explained, mut of) = (0, 0);
        for sample in of_law {
            of += 1;
            explained += usize::from(formula.fits(&sample.scene, sample.reply) == Some(true));
        }
        explained * 10 >= of * 8
    }
}
