//! Which mistakes explain the colors of a run.

use serde::Serialize;

use crate::bounded::Bounded;
use crate::formula::Formula;
use crate::law::LAWS;
use crate::mistakes::{Fault, SCOPES};
use crate::profile::Profile;
use crate::random::Random;
use crate::scene::{Scene, Triple};

/// The most scenes that are kept, wrong ones and right ones, of all laws together.
const WRONG: usize = 600;
const RIGHT: usize = 300;

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
    /// The number of colors, wrong or right, that the mistakes do not give.
    #[serde(skip)]
    pub(crate) errors: usize,
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

/// What a renderer answered, and a sample of it, of a size that does not grow with the run.
#[derive(Default)]
pub struct Evidence {
    all: [Vec<Sample>; 2],
    wrong: Vec<Sample>,
    right: Vec<Sample>,
}

impl Evidence {
    /// Notes a color of a law.
    pub fn note(&mut self, law: usize, is_right: bool, scene: &Scene, reply: Triple) {
        let scene = scene.clone();
        self.all[usize::from(is_right)].push(Sample { law, scene, reply });
    }

    /// Takes some colors of each of so many laws, in random order, so that the first ones are like all.
    pub fn sample(&mut self, laws: usize) {
        let mut random = Random::new(0, "evidence");
        let [wrong, right] = std::mem::take(&mut self.all);
        [self.wrong, self.right] = [(wrong, WRONG), (right, RIGHT)].map(|(mut samples, most)| {
            random.shuffle(&mut samples);
            let mut counts = [0; LAWS.len()];
            samples.retain(|sample| {
                counts[sample.law] += 1;
                counts[sample.law] <= most.div_ceil(laws)
            });
            samples
        });
    }

    /// The causes that explain nearly all wrong colors and no right one away, the best first; else what explains half.
    pub fn cause(&self, profile: &Profile) -> Option<Cause> {
        if self.wrong.is_empty() {
            return None;
        }
        let (rough, exact): (Vec<Fault>, Vec<Fault>) =
            Fault::all().partition(|fault| fault.mistake.is_rough());
        let alone = |least| self.best(profile, exact.iter().map(|fault| vec![*fault]), least);
        let single = alone(NEARLY_ALL);
        // of some lights or models alone
        let scoped = exact.iter().flat_map(|fault| {
            let of_some = SCOPES[1..].iter();
            of_some.map(|of| vec![Fault { of, ..*fault }])
        });
        // what is not known of some colors, no mistake explains
        let is_exact = |cause: &Cause| cause.errors + cause.of == self.wrong.len();
        let is_clear = single.as_ref().is_some_and(is_exact);
        let scoped = (!is_clear).then(|| self.best(profile, scoped, NEARLY_ALL));
        let singles = single.into_iter().chain(scoped.flatten());
        if let Some(cause) = singles.min_by_key(|cause| cause.errors) {
            // what one mistake does not explain, another may
            let is_all = cause.explained * 100 >= cause.of * 97;
            let pair = (!is_all).then(|| self.pair(profile, &exact)).flatten();
            let left = |cause: &Cause| cause.of - cause.explained;
            return pair
                .filter(|pair| left(pair) * 2 < left(&cause))
                .or(Some(cause));
        }
        let rough = rough
            .iter()
            .find_map(|fault| self.roughness(profile, *fault));
        rough
            .or_else(|| self.pair(profile, &exact))
            .or_else(|| alone(0.5))
    }

    /// The best of the candidates.
    fn best(
        &self,
        profile: &Profile,
        candidates: impl Iterator<Item = Vec<Fault>>,
        least: f64,
    ) -> Option<Cause> {
        let scored = candidates.filter_map(|faults| self.score(profile, faults, least));
        let mut ranked: Vec<Cause> = scored.collect();
        ranked.sort_by_key(|cause| cause.errors);
        let mut best = ranked.first()?.clone();
        let others = ranked.into_iter().skip(1);
        let alike = others.take_while(|cause| cause.errors == best.errors);
        best.alternatives = alike.map(|cause| cause.mistakes).collect();
        Some(best)
    }

    /// The mistakes as a cause, if they give at least this share of the wrong colors and contradict nearly no right one.
    fn score(&self, profile: &Profile, faults: Vec<Fault>, least: f64) -> Option<Cause> {
        let formula = Formula::new(profile, &faults);
        #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation)]
        #[allow(clippy::cast_sign_loss)] // a part of a small count
        let misses = |count: usize, share: f64| (count as f64 * share) as usize;
        let most = misses(self.wrong.len(), 1.0 - least);
        let (mut unexplained, mut unknown) = (0, 0);
        for (i, sample) in self.wrong.iter().enumerate() {
            match formula.fits(&sample.scene, sample.reply) {
                Some(true) => {}
                Some(false) => unexplained += 1,
                None => unknown += 1, // such as that of the eye in the surface, which has no direction
            }
            // what fails so often at the beginning hardly ever explains enough in the end
            let most_so_far = misses(i, 2.0 * (1.0 - least)) + 3;
            if unexplained > most.min(most_so_far) || unknown * 4 > self.wrong.len() * 3 {
                return None;
            }
        }
        let is_contradicted =
            |sample: &&Sample| formula.fits(&sample.scene, sample.reply) == Some(false);
        let most = misses(self.right.len(), 0.02);
        let contradicted = self.right.iter().filter(is_contradicted).take(most + 1);
        let contradicted = contradicted.count();
        let of = self.wrong.len() - unknown;
        #[allow(clippy::cast_precision_loss)]
        let is_enough = (of - unexplained) as f64 >= least * of as f64;
        (contradicted <= most && is_enough).then(|| Cause {
            explained: of - unexplained,
            of,
            alternatives: Vec::new(),
            errors: unexplained + unknown + contradicted,
            mistakes: faults,
        })
    }

    /// The cause if the colors are as if they were rounded so: nearly all of them, and, where not each of them shows it,
    /// some too bright and some too dark.
    fn roughness(&self, profile: &Profile, fault: Fault) -> Option<Cause> {
        let (mistakes, right) = (vec![fault], Formula::new(profile, &[]));
        let rough = Formula::new(profile, &mistakes);
        let (mut explained, mut of, mut brighter) = (0, 0, 0);
        for Sample { scene, reply, .. } in &self.wrong {
            // with so few bits, hardly anything is known of some colors
            let is_vague = |c: &Bounded| c.error * 2.0 > c.value;
            match rough.fits(scene, *reply) {
                Some(true) if !rough.linear(scene).iter().all(is_vague) => explained += 1,
                Some(false) => {}
                _ => continue,
            }
            of += 1;
            let mut channels = right.linear(scene).into_iter().zip(reply);
            let is_above = |[_, high]: [f64; 2], c: f64| c > high;
            let is_brighter =
                channels.any(|(c, reply)| right.ends(c).is_some_and(|it| is_above(it, *reply)));
            brighter += usize::from(is_brighter);
        }
        let is_balanced = brighter.min(of - brighter) * 8 >= of;
        let is_so = explained * 50 >= of * 49 && of * 2 >= self.wrong.len();
        (is_so && (fault.mistake.id == "InBits" || is_balanced)).then(|| Cause {
            mistakes,
            explained,
            of,
            alternatives: Vec::new(),
            errors: 0,
        })
    }

    /// Two mistakes together, each of which gives some of the wrong colors alone.
    fn pair(&self, profile: &Profile, faults: &[Fault]) -> Option<Cause> {
        let first = &self.wrong[..self.wrong.len().min(160)];
        let gives_some = |fault: &&Fault| {
            let formula = Formula::new(profile, std::slice::from_ref(*fault));
            let gives = |sample: &&Sample| formula.fits(&sample.scene, sample.reply) == Some(true);
            let (few, others) = first.split_at(first.len() / 2);
            // what gives none of the first few hardly ever gives enough
            let of_few = few.iter().filter(gives).count();
            let is_some = || (of_few + others.iter().filter(gives).count()) * 40 >= first.len();
            !fault.mistake.is_loose() && (of_few > 0 || few.len() < 40) && is_some()
        };
        let some: Vec<Fault> = faults.iter().filter(gives_some).copied().collect();
        let pairs = some.iter().enumerate().flat_map(|(i, a)| {
            let others = some[..i].iter().filter(|b| b.mistake.id != a.mistake.id);
            others.map(move |b| vec![*b, *a])
        });
        self.best(profile, pairs, 0.97)
    }

    /// Keeps the wrong colors that these mistakes do not give, and returns the law of each.
    pub fn leave(&mut self, profile: &Profile, faults: &[Fault]) -> Vec<usize> {
        let formula = Formula::new(profile, faults);
        let is_left = |it: &Sample| formula.fits(&it.scene, it.reply) == Some(false);
        self.wrong.retain(is_left);
        self.wrong.iter().map(|sample| sample.law).collect()
    }

    /// Whether mistakes give nearly all wrong colors of a law.
    pub fn explains(&self, profile: &Profile, faults: &[Fault], law: usize) -> bool {
        let formula = Formula::new(profile, faults);
        let of_law = self.wrong.iter().filter(|sample| sample.law == law);
        let fits = |it: &&Sample| formula.fits(&it.scene, it.reply) == Some(true);
        let explained = of_law.clone().filter(fits).count();
        explained * 10 >= of_law.count() * 8
    }
}
