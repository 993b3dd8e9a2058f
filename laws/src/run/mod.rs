//! Tries a renderer by the laws.

mod findings;

use std::collections::BTreeMap;
use std::time::Duration;

use crate::evidence::Evidence;
use crate::formula::Formula;
use crate::law::{Broken, Law};
use crate::mistakes::formula;
use crate::options::Laws;
use crate::plan::{Case, Plan};
use crate::renderer::{Progress, Renderer};
use crate::report::{Counterexample, LawReport, Report, Verdict};
use crate::scene::{Scene, Triple};
use crate::shrink;

/// The sizes of the batches: small ones first, so that a slow renderer soon shows something.
const SIZES: [usize; 4] = [1, 8, 32, 256];

/// The simpler cases that are asked for at once.
const SIMPLER: usize = 32;

/// The most batches in which a smaller case is looked for.
const MOST_BATCHES: usize = 200;

/// The longest search for smaller cases, that for places, and that for what was asked before.
const SEARCH: Duration = Duration::from_secs(2);

impl Laws {
    /// Tries a renderer by the laws. What prevents an answer is in the report, beside what was found before.
    ///
    /// # Errors
    ///
    /// In one line: a contradictory profile; no cases at all.
    pub fn run(&self, renderer: &mut impl Renderer) -> Result<Report, String> {
        let plan = Plan::new(self, &renderer.profile())?;
        let mut run = Run {
            renderer,
            plan: &plan,
            right: formula(&plan.profile, None),
            start: (self.clock)(),
            progress: Progress {
                asked: 0,
                of: plan.cases.iter().flat_map(Case::scenes).count(),
                broken: 0,
            },
            waited: Duration::ZERO,
            tried: 0,
            failures: BTreeMap::new(),
            evidence: Evidence::new(plan.profile.clone()),
            error: None,
            is_over: false,
            is_stopped: false,
        };
        run.all();
        run.is_over = run.is_stopped; // a renderer that ended may answer again
        Ok(run.report())
    }
}

/// Tries a renderer by the laws, and panics with the report if one is broken.
///
/// # Panics
///
/// If a law is broken, or the renderer cannot answer.
#[track_caller]
pub fn check(mut renderer: impl Renderer) {
    let report = Laws::default().run(&mut renderer);
    let report = report.unwrap_or_else(|error| panic!("{error}"));
    assert!(report.passes(), "{report}");
}

/// A case in which a law does not hold.
#[derive(Clone)]
struct Failure {
    law: Law,
    case: Case,
    broken: Broken,
    replies: Vec<Triple>,
}

/// Whether a case is one that is looked for.
type IsSo<'a> = dyn Fn(&Failure) -> bool + 'a;

struct Run<'a> {
    renderer: &'a mut dyn Renderer,
    plan: &'a Plan,
    right: Formula<'a>,
    start: Duration,
    progress: Progress,
    /// The time that the renderer took for what it was asked.
    waited: Duration,
    /// The number of cases, and for each law those that failed.
    tried: usize,
    failures: BTreeMap<Law, Vec<Failure>>,
    evidence: Evidence,
    /// Why the renderer did not answer for the first time, and whether it is asked no more.
    error: Option<String>,
    is_over: bool,
    /// The renderer does not go on.
    is_stopped: bool,
}

impl Run<'_> {
    /// Every case of the plan, until the time is up or the renderer no longer answers.
    fn all(&mut self) -> Option<()> {
        let plan = self.plan;
        let mut sizes = SIZES.into_iter();
        while self.tried < plan.cases.len() && (self.tried == 0 || !self.is_late()) {
            let left = &plan.cases[self.tried..];
            let size = sizes.next().unwrap_or(SIZES[3]);
            let cases = &left[..size.min(left.len())];
            for (case, replies) in cases.iter().zip(self.replies(cases)?) {
                let is_right = self.right.fits_linear(case.linear, replies[0]) != Some(false);
                self.evidence.note(is_right, &case.scene, replies[0]);
                for law in Law::ALL {
                    if let Some(failure) = self.failure(law, case, &replies) {
                        self.failures.entry(law).or_default().push(failure);
                    }
                }
            }
            self.tried += cases.len();
        }
        Some(())
    }

    fn now(&self) -> Duration {
        (self.plan.laws.clock)()
    }

    /// The time that is left, if it is limited.
    fn left(&self) -> Option<Duration> {
        let end = self.start + self.plan.laws.time?;
        Some(end.saturating_sub(self.now()))
    }

    fn is_late(&self) -> bool {
        let left = self.left().zip(self.plan.laws.time);
        // what is wrong needs time to be placed
        left.is_some_and(|(left, time)| {
            left.is_zero() || !self.failures.is_empty() && left * 4 < time
        })
    }

    /// How a case breaks a law, if it does.
    fn failure(&self, law: Law, case: &Case, replies: &[Triple]) -> Option<Failure> {
        Some(Failure {
            law,
            case: case.clone(),
            broken: law.broken(&self.right, case.linear, replies)?,
            replies: replies.to_vec(),
        })
    }

    /// The time for a search that begins now.
    fn time_of_search(&self) -> Duration {
        self.left().map_or(SEARCH, |left| left.min(SEARCH))
    }

    /// For each case the colors of its scenes.
    fn replies(&mut self, cases: &[Case]) -> Option<Vec<Vec<Triple>>> {
        let scenes: Vec<Scene> = cases.iter().flat_map(Case::scenes).collect();
        let mut replies = self.ask(&scenes)?.into_iter();
        let of_case = |case: &Case| replies.by_ref().take(case.scenes().len()).collect();
        Some(cases.iter().map(of_case).collect())
    }

    /// The colors of scenes, if the renderer answers.
    fn ask(&mut self, scenes: &[Scene]) -> Option<Vec<Triple>> {
        if scenes.is_empty() {
            return Some(Vec::new()); // a batch has scenes
        }
        self.progress.broken = self.failures.len();
        self.is_stopped |= !self.renderer.goes_on(&self.progress);
        if self.is_stopped {
            self.is_over = true;
            return None;
        }
        self.progress.asked += scenes.len();
        let asked = self.now();
        let answer = self.renderer.shade(scenes);
        self.waited += self.now().saturating_sub(asked);
        let why = match answer {
            Ok(colors) if colors.len() == scenes.len() => return Some(colors),
            Ok(colors) => format!("{} colors for {} scenes", colors.len(), scenes.len()),
            Err(why) => why,
        };
        // that it was interrupted is no error
        self.is_stopped |= !self.renderer.goes_on(&self.progress);
        if !self.is_stopped {
            self.error.get_or_insert(why);
        }
        self.is_over = true;
        None
    }

    /// What was found, with smaller cases and places where the renderer still answers.
    fn report(mut self) -> Report {
        self.evidence.sample();
        let mut findings = self.findings();
        let until = self.now() + self.time_of_search();
        let laws = Law::ALL.map(|law| self.law(law, until));
        self.show_apart(&mut findings, until);
        for finding in &mut findings {
            let shown = finding.shown(&laws);
            finding.scenes = shown.map_or_else(Vec::new, |(_, it)| it.scenes.clone());
        }
        Report {
            version: 9,
            seed: self.plan.laws.seed,
            error: self.error,
            findings,
            laws: laws.into(),
            profile: self.plan.profile.clone(),
            command: None,
        }
    }

    /// What was found of a law.
    fn law(&mut self, law: Law, until: Duration) -> LawReport {
        let is_of_law = |case: &&Case| case.is_again || law != Law::NoMemory;
        let count = |cases: &[Case]| cases.iter().filter(is_of_law).count();
        let plan = self.plan;
        let (cases, of) = (count(&plan.cases[..self.tried]), count(&plan.cases));
        let smallest = self.smallest(law, until, &|_| true);
        let (name, says) = law.told();
        LawReport {
            law: name,
            says,
            verdict: match &smallest {
                Some(_) => Verdict::Broken,
                None if cases < of => Verdict::CutShort,
                None => Verdict::Holds,
            },
            cases,
            of,
            failures: self.failures.get(&law).map_or(0, Vec::len),
            smallest,
        }
    }

    fn told(&self, scenes: Vec<Scene>, mut colors: Vec<Triple>, broken: Broken) -> Counterexample {
        colors.truncate(scenes.len());
        Counterexample {
            right: scenes.iter().map(|it| self.right.reply(it)).collect(),
            colors,
            broken,
            scenes,
        }
    }

    /// The smallest case like this that breaks a law, if one does; if rounding does not explain the first one, it
    /// does not explain that one either.
    fn smallest(&mut self, law: Law, until: Duration, is_so: &IsSo) -> Option<Counterexample> {
        let failures = self.failures.get(&law)?.iter().filter(|it| is_so(it));
        // the order in which failures are worth showing
        let rank = |it: &&Failure| (!it.broken.is_clear(), shrink::cost(&it.case.scene));
        let mut failure = failures.min_by_key(rank)?.clone();
        let is_clear = failure.broken.is_clear();
        let plan = self.plan;
        let mut simpler = shrink::simpler(&failure.case.scene, &plan.profile).into_iter();
        // without a clock, so many batches end the search
        for _ in 0..usize::from(plan.laws.shrinks) * MOST_BATCHES {
            if simpler.len() == 0 || self.now() >= until || self.is_over {
                break;
            }
            let scenes = simpler.by_ref().take(SIMPLER);
            let case = |scene| Case::new(scene, &self.right, law == Law::NoMemory);
            let cases: Vec<Case> = scenes.map(case).collect();
            let replies = self.replies(&cases).unwrap_or_default();
            let answers = cases.iter().zip(&replies);
            let mut failures = answers.filter_map(|(case, it)| self.failure(law, case, it));
            let is_like = |it: &Failure| (it.broken.is_clear() || !is_clear) && is_so(it);
            if let Some(found) = failures.find(is_like) {
                simpler = shrink::simpler(&found.case.scene, &plan.profile).into_iter();
                failure = found;
            }
        }
        let mut scenes = failure.case.scenes();
        if law != Law::NoMemory {
            scenes.truncate(1);
        }
        Some(self.told(scenes, failure.replies, failure.broken))
    }
}
