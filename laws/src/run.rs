//! Tries a renderer by the laws.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use crate::cause::{Cause, Evidence};
use crate::claim::{Broken, Seen};
use crate::corpus;
use crate::coverage::Coverage;
use crate::formula::Formula;
use crate::generator::Case;
use crate::law::{LAWS, Law};
use crate::mistakes::Fault;
use crate::place::{Edits, Place};
use crate::plan::{Plan, Tried, handed};
use crate::profile::Profile;
use crate::renderer::Renderer;
use crate::report::{Counterexample, Finding, LawReport, Report, Saved, Verdict};
use crate::scene::{Scene, Triple};
use crate::shrink;

/// The simpler cases that are asked for at once.
const SIMPLER: usize = 32;

/// The scenes of a batch after which those before the batch no longer leak into a color.
const SETTLED: usize = 32;

/// The most broken cases from which things are taken out.
const PLACED: f64 = 40.0;

/// A run of the laws. It is deterministic: the same seed gives the same scenes.
///
/// ```
/// use shading_laws::{Laws, Profile, from_fn};
///
/// let mut black = from_fn(Profile::default(), |_scene| [0.0; 3]);
/// let laws = Laws { seed: 7, cases: 50, ..Laws::default() };
/// let report = laws.run(&mut black).unwrap();
/// assert!(report.is_broken()); // there is no k_a I_a
/// ```
#[derive(Clone, Debug)]
pub struct Laws {
    /// The seed of the scenes.
    pub seed: u64,
    /// The number of random cases of each law, beside the fixed ones.
    pub cases: usize,
    /// The laws to try, or none for all. [`Laws::names`] lists the names.
    pub only: Vec<String>,
    /// The laws that are expected to be broken: the report passes if they are, and does not if one holds.
    pub known: Vec<String>,
    /// Cases that are tried before the others: the text that [`Report::cases`] gives, a case a line.
    pub replay: String,
    /// The most batches of each broken law in which its smallest scene is looked for, and the longest time of all. With 0,
    /// the report shows the smallest scene of those that were generated.
    pub shrinks: usize,
    /// See `shrinks`.
    pub shrinking: Duration,
    /// The longest time of the run. A law that is not tried by then is no pass.
    pub time: Option<Duration>,
    /// Only the scenes of the plan are asked for, which do not depend on the answers: nothing is made smaller, and no
    /// place is looked for.
    pub asks_once: bool,
}

impl Default for Laws {
    fn default() -> Self {
        Self {
            seed: 0,
            cases: 256,
            only: Vec::new(),
            known: Vec::new(),
            replay: String::new(),
            shrinks: 200,
            shrinking: Duration::from_secs(3),
            time: None,
            asks_once: false,
        }
    }
}

impl Laws {
    /// The name of each law, and what it says.
    pub fn names() -> impl Iterator<Item = (&'static str, &'static str)> {
        LAWS.iter().map(|law| (law.name, law.says))
    }

    pub(crate) fn tries(&self, name: &str) -> bool {
        self.only.is_empty() || self.only.iter().any(|only| only == name)
    }

    /// The scenes of a run, for a renderer that says this of itself.
    ///
    /// # Errors
    ///
    /// In one line: a contradictory profile; the name of a law that does not exist; no cases at all; a line that is no case.
    pub fn plan(&self, profile: &Profile) -> Result<Plan, String> {
        if let Some(complaint) = profile.complaint() {
            return Err(format!("the profile of {}: {complaint}", profile.name));
        }
        if self.cases == 0 {
            return Err("the number of cases is 0".into());
        }
        let mut names = self.only.iter().chain(&self.known);
        if let Some(name) = names.find(|name| Law::named(name).is_none()) {
            return Err(format!("there is no law {name}"));
        }
        let mut replayed = Vec::new();
        for (i, line) in self.replay.lines().enumerate() {
            let saved: Result<Saved, _> = serde_json::from_str(line);
            let saved = saved.map_err(|why| why.to_string()).and_then(|saved| {
                let law = Law::named(&saved.law).ok_or(format!("there is no law {}", saved.law))?;
                Ok((law.name, saved.case))
            });
            replayed.push(saved.map_err(|why| format!("replayed case {}: {why}", i + 1))?);
        }
        Ok(Plan::new(self, profile, &replayed))
    }

    /// Tries a renderer by the laws. What prevents an answer is in the report, beside what was found before.
    ///
    /// # Errors
    ///
    /// As [`plan`](Laws::plan).
    pub fn run(&self, renderer: &mut impl Renderer) -> Result<Report, String> {
        Ok(self.plan(&renderer.profile())?.run(renderer))
    }
}

impl Plan {
    /// Tries a renderer by the laws.
    pub fn run(&self, renderer: &mut impl Renderer) -> Report {
        let start = Instant::now();
        let mut run = Run {
            renderer,
            plan: self,
            profile: &self.profile,
            start,
            deadline: self.laws.time.map(|time| start + time),
            asked: 0,
            tried: vec![0; self.tries.len()],
            failures: vec![Vec::new(); self.tries.len()],
            evidence: Evidence::new(),
            is_fickle: false,
        };
        let error = run.all().err();
        run.report(error)
    }
}

/// A case in which a law does not hold.
#[derive(Clone)]
struct Failure {
    tried: Tried,
    broken: Broken,
    replies: Vec<Triple>,
}

struct Run<'a> {
    renderer: &'a mut dyn Renderer,
    plan: &'a Plan,
    profile: &'a Profile,
    start: Instant,
    deadline: Option<Instant>,
    /// The number of scenes.
    asked: u32,
    /// For each law the number of cases, and those that failed.
    tried: Vec<usize>,
    failures: Vec<Vec<Failure>>,
    evidence: Evidence,
    /// Whether a scene had another color when it was asked again, long after what was asked before the batch.
    is_fickle: bool,
}

impl Run<'_> {
    /// Every case of the plan, until the time is up.
    fn all(&mut self) -> Result<(), String> {
        for (law, range) in self.plan.batches() {
            if self.is_late() {
                break;
            }
            let tries = &self.plan.tries[law];
            let cases = &tries.cases[range];
            let failures = self.judge(tries.law, cases, Some(law))?;
            self.tried[law] += cases.len();
            for (i, failure) in failures.into_iter().enumerate() {
                if let Some(failure) = failure {
                    self.is_fickle |= tries.law.asks_twice() && i >= SETTLED;
                    self.failures[law].push(failure);
                }
            }
        }
        Ok(())
    }

    fn is_late(&self) -> bool {
        self.deadline.is_some_and(|end| {
            // what is wrong needs time to be placed
            let is_wrong = self.failures.iter().any(|of_law| !of_law.is_empty());
            let left = end.saturating_duration_since(Instant::now());
            left.is_zero() || is_wrong && left * 4 < end - self.start
        })
    }

    /// For each case how it fails, if it does. The colors of the plan's own cases are noted.
    fn judge(
        &mut self,
        law: &Law,
        cases: &[Tried],
        note: Option<usize>,
    ) -> Result<Vec<Option<Failure>>, String> {
        let asked = Plan::asked(law, cases);
        let mut replies = self.ask(law, &asked)?;
        if law.asks_twice() {
            let again = self.ask(law, &asked)?;
            let pairs = replies.into_iter().zip(again);
            replies = pairs.flat_map(|(first, second)| [first, second]).collect();
        }
        let formula = Formula::new(self.profile, &[]);
        let mut left = replies.as_slice();
        let mut failures = Vec::with_capacity(cases.len());
        for tried in cases {
            let (replies, others) = left.split_at(tried.group.scenes.len());
            left = others;
            let known = replies.iter().zip(&tried.known);
            let seen = known.clone().map(|(reply, (linear, conditioning))| {
                Seen::new(self.profile, *reply, *linear, *conditioning)
            });
            let seen: Vec<Seen> = seen.collect();
            if let Some(law) = note {
                for ((reply, (linear, _)), scene) in known.zip(&tried.group.scenes) {
                    let is_right = formula.fits_linear(*linear, *reply) != Some(false);
                    self.evidence.note(law, is_right, scene, *reply);
                }
            }
            let broken = tried.group.claim.broken(self.profile, &seen);
            failures.push(broken.map(|broken| Failure {
                tried: tried.clone(),
                broken,
                replies: replies.to_vec(),
            }));
        }
        Ok(failures)
    }

    /// The colors of scenes.
    fn ask(&mut self, law: &Law, scenes: &[Scene]) -> Result<Vec<Triple>, String> {
        self.asked += u32::try_from(scenes.len()).unwrap_or(u32::MAX);
        let to_hand = scenes.iter().map(|scene| handed(scene, self.profile));
        let to_hand: Vec<Scene> = to_hand.collect();
        let replies = match self.caught(&to_hand) {
            Ok(replies) => replies?,
            Err(message) => return Err(self.panicked(law, scenes, &message)),
        };
        if replies.len() != scenes.len() {
            let (colors, scenes) = (replies.len(), scenes.len());
            return Err(format!("{colors} colors for {scenes} scenes"));
        }
        Ok(replies)
    }

    /// The answer, or the words with which the renderer panicked.
    fn caught(&mut self, scenes: &[Scene]) -> Result<Result<Vec<Triple>, String>, String> {
        catch_unwind(AssertUnwindSafe(|| self.renderer.shade(scenes))).map_err(|panic| {
            let text = panic.downcast_ref::<&str>().map(ToString::to_string);
            let text = text.or_else(|| panic.downcast_ref::<String>().cloned());
            text.unwrap_or_else(|| "without a message".into())
        })
    }

    /// Says how a renderer panicked, with the smallest scene that makes it.
    fn panicked(&mut self, law: &Law, scenes: &[Scene], message: &str) -> String {
        let (profile, seed) = (self.profile, self.plan.laws.seed);
        let panics = |run: &mut Self, scene: &Scene| run.caught(&[handed(scene, profile)]).is_err();
        let Some(scene) = scenes.iter().find(|scene| panics(self, scene)) else {
            let name = law.name;
            return format!(
                "the renderer panicked in law {name}, seed {seed}, but with no scene alone: {message}"
            );
        };
        let mut case = Case::of(scene.clone());
        for _ in 0..SIMPLER {
            let mut simpler = shrink::simpler(&case, profile).into_iter();
            let Some(found) = simpler.find(|case| panics(self, &case.scene)) else {
                break;
            };
            case = found;
        }
        format!(
            "the renderer panicked in law {}, seed {seed}: {message}; the smallest scene that was found: {}",
            law.name,
            handed(&case.scene, profile).to_json()
        )
    }

    /// What was found, with smaller cases and places where the renderer still answers.
    fn report(mut self, error: Option<String>) -> Report {
        let mut stopped = None; // a renderer that ended may answer again
        let mut findings = self.findings(&mut stopped);
        let mut reports = Vec::new();
        let mut order: Vec<usize> = (0..self.plan.tries.len()).collect();
        // what is shown is made smaller first
        let rank = |law: &usize| {
            let name = self.plan.tries[*law].law.name;
            let least = self.failures[*law]
                .iter()
                .map(|f| f.tried.group.scenes.len())
                .min();
            (least, ["formula", "finite"].contains(&name))
        };
        order.sort_by_key(rank);
        let until = Instant::now() + self.plan.laws.shrinking;
        for law in order {
            let verdict = self.verdict(law, &mut stopped, until);
            reports.push((law, verdict));
        }
        reports.sort_by_key(|(law, _)| *law);
        let laws: Vec<LawReport> = reports
            .into_iter()
            .map(|(law, verdict)| {
                let Law { name, says, .. } = *self.plan.tries[law].law;
                let known = &self.plan.laws.known;
                LawReport {
                    law: name,
                    says,
                    is_known: known.iter().any(|known| known == name),
                    verdict,
                }
            })
            .collect();
        for finding in &mut findings {
            let of = |law: &&LawReport| finding.laws.contains(&law.law);
            let shown = laws.iter().filter(of).min_by_key(|law| match &law.verdict {
                Verdict::Broken { smallest, .. } => {
                    (smallest.scenes.len(), shrink::cost(&smallest.case))
                }
                _ => (usize::MAX, 0),
            });
            finding.shown = shown.map_or("", |law| law.law);
        }
        Report {
            version: 3,
            corpus: corpus::VERSION,
            seed: self.plan.laws.seed,
            stopped,
            error,
            findings,
            exercised: self.exercised(),
            laws,
            profile: self.profile.clone(),
            command: None,
        }
    }

    fn exercised(&self) -> Vec<crate::coverage::Exercised> {
        let plan = self.plan;
        let counts = self.tried.iter().zip(&plan.tries);
        let is_whole = counts
            .clone()
            .all(|(count, tries)| *count == tries.cases.len());
        if !plan.laws.only.is_empty() {
            return Vec::new();
        }
        if is_whole {
            return plan.coverage.of(self.profile);
        }
        let mut coverage = Coverage::default();
        let tried = counts.flat_map(|(count, tries)| &tries.cases[..*count]);
        for scene in tried.flat_map(|tried| &tried.group.scenes) {
            coverage.note(scene, self.profile);
        }
        coverage.of(self.profile)
    }

    fn verdict(&mut self, law: usize, stopped: &mut Option<String>, until: Instant) -> Verdict {
        let tries = &self.plan.tries[law];
        let (cases, of) = (self.tried[law], tries.cases.len());
        let least = self.failures[law].iter();
        let least = least.min_by_key(|failure| shrink::cost(&failure.tried.case));
        let Some(failure) = least.cloned() else {
            return match tries.lacks {
                Some(because) => Verdict::NotTried { because },
                None if of == 0 => Verdict::NotTried {
                    because: "it says nothing about such a renderer",
                },
                None if cases == 0 => Verdict::NotReached,
                None => Verdict::Holds { cases },
            };
        };
        let failure = if stopped.is_some() || self.plan.laws.asks_once {
            failure
        } else {
            self.smaller(tries.law, failure, stopped, until)
        };
        let Failure {
            tried,
            broken,
            replies,
        } = failure;
        let formula = Formula::new(self.profile, &[]);
        let scenes = tried.group.scenes.iter();
        let smallest = Counterexample {
            claim: tried.group.claim.says,
            right: scenes.clone().map(|scene| formula.reply(scene)).collect(),
            scenes: scenes.map(|scene| handed(scene, self.profile)).collect(),
            colors: replies,
            channel: broken.channel,
            off: broken.off,
            allowed: broken.allowed,
            case: tried.case,
        };
        Verdict::Broken {
            cases,
            failures: self.failures[law].len(),
            smallest: Box::new(smallest),
        }
    }

    /// The smallest case that is still broken.
    fn smaller(
        &mut self,
        law: &Law,
        mut failure: Failure,
        stopped: &mut Option<String>,
        until: Instant,
    ) -> Failure {
        let until = self.deadline.map_or(until, |end| end.min(until));
        let mut batches = 0;
        'smaller: loop {
            let simpler = shrink::simpler(&failure.tried.case, self.profile);
            let profile = self.profile;
            let mut cases = simpler
                .into_iter()
                .filter_map(|case| Tried::new(law, case, profile));
            loop {
                let tried: Vec<Tried> = cases.by_ref().take(SIMPLER).collect();
                batches += 1;
                let is_over = batches > self.plan.laws.shrinks || Instant::now() >= until;
                if tried.is_empty() || is_over {
                    return failure;
                }
                match self.judge(law, &tried, None) {
                    Err(why) => {
                        *stopped = Some(why);
                        return failure;
                    }
                    Ok(failures) => {
                        if let Some(found) = failures.into_iter().flatten().next() {
                            failure = found;
                            continue 'smaller;
                        }
                    }
                }
            }
        }
    }

    /// The broken laws, together with those that the same cause breaks.
    fn findings(&mut self, stopped: &mut Option<String>) -> Vec<Finding> {
        let plan = self.plan;
        let laws = 0..plan.tries.len();
        let mut broken: Vec<usize> = laws.filter(|law| !self.failures[*law].is_empty()).collect();
        let mut findings = Vec::new();
        let name = |law: &usize| plan.tries[*law].law.name;
        let states = broken
            .iter()
            .copied()
            .find(|law| self.plan.tries[*law].law.is_of_state());
        let cause = self.evidence.cause(self.profile);
        if let Some(law) = states {
            let mistakes = self
                .state(law, stopped)
                .map_or(vec!["Leak", "NotRepeatable"], |id| vec![id]);
            let (of_state, others): (Vec<usize>, _) = broken
                .into_iter()
                .partition(|law| cause.is_none() || self.plan.tries[*law].law.is_of_state());
            broken = others;
            let mut faults = mistakes.into_iter().map(|id| vec![Fault::named(id)]);
            findings.push(Finding {
                cause: faults.next().map(|mistakes| Cause {
                    mistakes,
                    explained: 0,
                    of: 0,
                    alternatives: faults.collect(),
                }),
                laws: of_state.iter().map(name).collect(),
                places: Vec::new(),
                shown: "",
            });
        }
        if broken.is_empty() {
            return findings;
        }
        let (explained, others): (Vec<usize>, Vec<usize>) = match &cause {
            Some(cause) => broken
                .into_iter()
                .partition(|law| self.evidence.explains(self.profile, &cause.mistakes, *law)),
            None => (Vec::new(), broken),
        };
        // what a cause explains in part stays one finding
        let is_part = cause.as_ref().is_some_and(|cause| !cause.is_nearly_all());
        let (explained, others) = if is_part || explained.is_empty() {
            ([explained, others].concat(), Vec::new())
        } else {
            (explained, others)
        };
        let mistakes = cause
            .as_ref()
            .map_or(Vec::new(), |cause| cause.mistakes.clone());
        // a second mistake, in what the first leaves
        let (mut others, mut second) = (others, None);
        if cause.as_ref().is_some_and(Cause::is_nearly_all) {
            let left = self.evidence.leave(self.profile, &mistakes);
            let found = self.evidence.cause(self.profile);
            second = found.filter(|cause| left.len() >= 4 && cause.explained == cause.of);
            if second.is_some() {
                others = left;
                others.sort_unstable();
                others.dedup();
            }
        }
        for (laws, cause, but) in [(explained, cause, None), (others, second, Some(mistakes))] {
            if !laws.is_empty() {
                let places = self.places(&laws, but.as_deref(), stopped);
                findings.push(Finding {
                    cause,
                    laws: laws.iter().map(name).collect(),
                    places,
                    shown: "",
                });
            }
        }
        findings
    }

    /// Where the colors of laws are wrong, but for those that some mistakes explain.
    fn places(
        &mut self,
        laws: &[usize],
        but: Option<&[Fault]>,
        stopped: &mut Option<String>,
    ) -> Vec<Place> {
        if stopped.is_some() || self.plan.laws.asks_once {
            return Vec::new();
        }
        let of = |name: &str| {
            laws.iter()
                .copied()
                .find(|law| self.plan.tries[*law].law.name == name)
        };
        let of_one_scene = ["finite", "formula", "as_said"].map(of);
        let mut chosen: Vec<usize> = of_one_scene.into_iter().flatten().collect();
        if chosen.is_empty() {
            chosen.extend(laws.first());
        }
        let explained = but.map(|faults| Formula::new(self.profile, faults));
        let is_left = |failure: &&Failure| {
            let replies = failure.tried.group.scenes.iter().zip(&failure.replies);
            explained.as_ref().is_none_or(|formula| {
                replies
                    .clone()
                    .any(|(scene, reply)| formula.fits(scene, *reply) != Some(true))
            })
        };
        let per_scene = self.start.elapsed() / self.asked.max(1);
        let left = self.deadline.map_or(Duration::from_secs(2), |end| {
            end.saturating_duration_since(Instant::now())
                .min(Duration::from_secs(2))
        });
        let affordable = left.as_secs_f64() / (per_scene.as_secs_f64() * 22.0).max(1e-9);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // from 2 to 40
        let most = affordable.clamp(2.0, PLACED) as usize / chosen.len();
        let (mut broken, mut of_law) = (Vec::new(), Vec::new());
        for law in chosen {
            let left: Vec<&Failure> = self.failures[law].iter().filter(is_left).collect();
            let count = left.len().min(most.max(1));
            for i in 0..count {
                broken.push(left[i * left.len() / count].tried.case.clone());
                of_law.push(law);
            }
        }
        if broken.is_empty() {
            return Vec::new();
        }
        let edits = Edits::new(broken, self.profile);
        let Some(still_broken) = self.try_edits(&edits, &of_law, stopped) else {
            return Vec::new();
        };
        let whole = edits.place(&still_broken, |_| true);
        let halves = edits
            .split(&still_broken)
            .filter(|_| whole.only_with.is_empty());
        if let Some((repaired, left)) = halves {
            let first = edits.place(&still_broken, |case| repaired.contains(&case));
            let of_law: Vec<usize> = left.iter().map(|edit| of_law[edits.of[*edit].1]).collect();
            let left = left.into_iter().map(|edit| edits.edited[edit].clone());
            let edits = Edits::new(left.collect(), self.profile);
            if let Some(still_broken) = self.try_edits(&edits, &of_law, stopped) {
                let second = edits.place(&still_broken, |_| true);
                // ambient light and that of lights alike is everything
                let is_told = second.only_with.iter().any(|knob| *knob != "lights");
                if is_told && !first.only_with.is_empty() {
                    return vec![first, second];
                }
            }
        }
        vec![whole]
    }

    /// Whether each edited case is still broken; nothing if the renderer ended.
    fn try_edits(
        &mut self,
        edits: &Edits,
        of_law: &[usize],
        stopped: &mut Option<String>,
    ) -> Option<Vec<bool>> {
        let mut still_broken = vec![true; edits.edited.len()];
        for law in 0..self.plan.tries.len() {
            let tried_law = self.plan.tries[law].law;
            let (places, tried): (Vec<usize>, Vec<Tried>) = (0..edits.edited.len())
                .filter(|edit| of_law[edits.of[*edit].1] == law)
                .filter_map(|edit| {
                    let case = edits.edited[edit].clone();
                    Some((edit, Tried::new(tried_law, case, self.profile)?))
                })
                .unzip();
            for (places, tried) in places.chunks(256).zip(tried.chunks(256)) {
                let failures = self.judge(tried_law, tried, None);
                *stopped = failures.as_ref().err().cloned();
                for (place, failure) in places.iter().zip(failures.ok()?) {
                    still_broken[*place] = failure.is_some();
                }
            }
        }
        Some(still_broken)
    }

    /// Whether colors depend on what was asked before, or on nothing that is known; nothing where it cannot be asked.
    fn state(&mut self, law: usize, stopped: &mut Option<String>) -> Option<&'static str> {
        if self.is_fickle {
            return Some("NotRepeatable");
        }
        if stopped.is_some() || self.plan.laws.asks_once {
            return None; // what repeats after as many scenes as there are in a batch looks the same
        }
        // the same scene again and again: the last ones follow themselves
        let scene = &self.failures[law][0].tried.case.scene;
        let mut other = scene.clone();
        other.lights.clear();
        let mut asked = vec![other];
        asked.extend(std::iter::repeat_n(scene.clone(), 8));
        let replies = match self.ask(&LAWS[0], &asked) {
            Ok(replies) => replies,
            Err(why) => {
                *stopped = Some(why);
                return None;
            }
        };
        let differs =
            |a: f64, b: f64| (a - b).abs() > 64.0 * self.profile.roundoff * a.abs().max(b.abs());
        let is_settled = replies[2..]
            .iter()
            .all(|color| (0..3).all(|i| !differs(color[i], replies[8][i])));
        Some(if is_settled { "Leak" } else { "NotRepeatable" })
    }
}

/// Tries a renderer by the laws, and panics with the report if one is broken.
///
/// ```should_panic
/// let black = shading_laws::from_fn(shading_laws::Profile::default(), |_scene| [0.0; 3]);
/// shading_laws::check(black);
/// ```
///
/// # Panics
///
/// If a law is broken, or the renderer cannot answer.
#[track_caller]
pub fn check(mut renderer: impl Renderer) {
    match Laws::default().run(&mut renderer) {
        Ok(report) if !report.passes() => panic!("{report}"),
        Ok(_) => {}
        Err(error) => panic!("{error}"),
    }
}
