//! Tries a renderer by the laws.

use std::collections::BTreeMap;
use std::time::Duration;

use crate::cause::{Cause, Evidence};
use crate::edit::EDITS;
use crate::formula::Formula;
use crate::law::{Broken, Law};
use crate::mistakes::formula;
use crate::options::Laws;
use crate::place::{self, Place};
use crate::plan::{Case, Plan, handed};
use crate::renderer::{Progress, Renderer};
use crate::report::{Counterexample, Finding, LawReport, Report, Verdict};
use crate::scene::{Scene, Triple};
use crate::shrink;

/// The simpler cases that are asked for at once.
const SIMPLER: usize = 32;

/// The longest search for smaller cases, and that for places.
const SEARCH: Duration = Duration::from_secs(2);

impl Laws {
    /// Tries a renderer by the laws. What prevents an answer is in the report, beside what was found before.
    ///
    /// # Errors
    ///
    /// In one line: a contradictory profile; the name of a law that does not exist; no cases at all.
    pub fn run(&self, renderer: &mut impl Renderer) -> Result<Report, String> {
        let plan = Plan::new(self, &renderer.profile())?;
        let start = (self.clock)();
        let mut run = Run {
            renderer,
            plan: &plan,
            right: formula(&plan.profile, None),
            start,
            deadline: self.time.map(|time| start + time),
            asked: 0,
            waited: Duration::ZERO,
            of: handed(&plan.cases).len(),
            tried: 0,
            failures: BTreeMap::new(),
            evidence: Evidence::default(),
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

/// A case in which a law does not hold.
#[derive(Clone)]
struct Failure {
    law: Law,
    case: Case,
    broken: Broken,
    replies: Vec<Triple>,
}

struct Run<'a> {
    renderer: &'a mut dyn Renderer,
    plan: &'a Plan,
    right: Formula<'a>,
    start: Duration,
    deadline: Option<Duration>,
    /// The number of scenes, and that of the whole plan.
    asked: usize,
    of: usize,
    /// The time that the renderer took for them.
    waited: Duration,
    /// The number of cases, and for each law those that failed.
    tried: usize,
    failures: BTreeMap<Law, Vec<Failure>>,
    evidence: Evidence,
    /// Why the renderer did not answer the first time that it did not, and whether it was the last
    /// time that it was asked.
    error: Option<String>,
    is_over: bool,
    /// The renderer does not go on.
    is_stopped: bool,
}

impl Run<'_> {
    /// Every case of the plan, until the time is up or the renderer no longer answers.
    fn all(&mut self) -> Option<()> {
        for range in self.plan.batches() {
            if range.start > 0 && self.is_late() {
                break;
            }
            let cases = &self.plan.cases[range];
            for (case, replies) in cases.iter().zip(self.replies(cases)?) {
                let is_right = self.right.fits_linear(case.linear, replies[0]) != Some(false);
                self.evidence.note(is_right, &case.scene, replies[0]);
                for failure in self.judge(case, &replies) {
                    self.failures.entry(failure.law).or_default().push(failure);
                }
            }
            self.tried += cases.len();
        }
        Some(())
    }

    fn now(&self) -> Duration {
        (self.plan.laws.clock)()
    }

    fn is_late(&self) -> bool {
        self.deadline.is_some_and(|end| {
            // what is wrong needs time to be placed
            let left = end.saturating_sub(self.now());
            left.is_zero() || !self.failures.is_empty() && left * 4 < end.saturating_sub(self.start)
        })
    }

    /// How a case breaks laws.
    fn judge(&self, case: &Case, replies: &[Triple]) -> Vec<Failure> {
        let tried = |law: &Law| self.plan.laws.tries(*law) && case.is_of(*law);
        let failure = |law: Law| {
            Some(Failure {
                law,
                case: case.clone(),
                broken: law.broken(&self.right, case.linear, replies)?,
                replies: replies.to_vec(),
            })
        };
        let laws = Law::ALL.into_iter().filter(tried);
        laws.filter_map(failure).collect()
    }

    /// For each case the colors of its scenes.
    fn replies(&mut self, cases: &[Case]) -> Option<Vec<Vec<Triple>>> {
        let mut replies = self.ask(&handed(cases))?.into_iter();
        let of_case = |case: &Case| replies.by_ref().take(case.scenes().len()).collect();
        Some(cases.iter().map(of_case).collect())
    }

    /// The colors of scenes, with 1 for white, if the renderer answers.
    fn ask(&mut self, scenes: &[Scene]) -> Option<Vec<Triple>> {
        if scenes.is_empty() {
            return Some(Vec::new()); // a batch has scenes
        }
        let progress = Progress {
            asked: self.asked,
            of: self.of,
            broken: self.failures.len(),
        };
        self.is_stopped |= !self.renderer.goes_on(&progress);
        if self.is_stopped {
            self.is_over = true;
            return None;
        }
        self.asked += scenes.len();
        let asked = self.now();
        let answer = self.renderer.shade(scenes);
        self.waited += self.now().saturating_sub(asked);
        match answer {
            Ok(mut colors) if colors.len() == scenes.len() => {
                let white = self.plan.profile.white;
                colors.iter_mut().flatten().for_each(|c| *c /= white);
                Some(colors)
            }
            answer => {
                let few =
                    |colors: Vec<_>| format!("{} colors for {} scenes", colors.len(), scenes.len());
                let why = answer.map_or_else(|why| why, few);
                // that it was interrupted is no error
                self.is_stopped |= !self.renderer.goes_on(&progress);
                if !self.is_stopped {
                    self.error.get_or_insert(why);
                }
                self.is_over = true;
                None
            }
        }
    }

    /// What was found, with smaller cases and places where the renderer still answers.
    fn report(mut self) -> Report {
        self.evidence.sample();
        let mut findings = self.findings();
        let until = self.now() + SEARCH;
        let until = self.deadline.map_or(until, |end| end.min(until));
        let mut laws = Vec::new();
        for law in Law::ALL {
            if self.plan.laws.tries(law) {
                let (name, says) = law.told();
                laws.push(LawReport {
                    law: name,
                    says,
                    verdict: self.verdict(law, until),
                });
            }
        }
        for finding in &mut findings {
            let shown = finding.shown(&laws);
            finding.scenes = shown.map_or_else(Vec::new, |(_, it)| it.scenes.clone());
        }
        Report {
            version: 8,
            seed: self.plan.laws.seed,
            error: self.error,
            findings,
            laws,
            profile: self.plan.profile.clone(),
            command: None,
        }
    }

    fn verdict(&mut self, law: Law, until: Duration) -> Verdict {
        let is_of_law = |case: &&Case| case.is_of(law);
        let count = |cases: &[Case]| cases.iter().filter(is_of_law).count();
        let (cases, of) = (
            count(&self.plan.cases[..self.tried]),
            count(&self.plan.cases),
        );
        let failures = self.failures.get(&law).map_or(&[][..], Vec::as_slice);
        let rank = |it: &&Failure| (!it.broken.is_clear(), shrink::cost(&it.case.scene));
        match failures.iter().min_by_key(rank).cloned() {
            Some(least) => Verdict::Broken {
                cases,
                failures: failures.len(),
                smallest: {
                    let smallest = self.smaller(least, until);
                    Box::new(self.counterexample(smallest))
                },
            },
            None if cases < of => Verdict::CutShort { cases, of },
            None => Verdict::Holds { cases },
        }
    }

    fn counterexample(&self, failure: Failure) -> Counterexample {
        let mut scenes = failure.case.scenes();
        if failure.law != Law::NoMemory {
            scenes.truncate(1);
        }
        self.told(scenes, failure.replies, failure.broken)
    }

    /// Scenes and their colors, in the numbers that the renderer gives.
    fn told(&self, scenes: Vec<Scene>, colors: Vec<Triple>, mut broken: Broken) -> Counterexample {
        let white = self.plan.profile.white;
        let as_given = |color: Triple| color.map(|c| c * white);
        let right = scenes.iter().map(|it| self.right.reply(it));
        broken.off *= white;
        broken.allowed *= white;
        Counterexample {
            right: right.map(as_given).collect(),
            colors: colors
                .into_iter()
                .take(scenes.len())
                .map(as_given)
                .collect(),
            broken,
            scenes,
        }
    }

    /// The smallest case that is still broken; if rounding does not explain the first one, it does
    /// not explain that one either.
    fn smaller(&mut self, mut failure: Failure, until: Duration) -> Failure {
        let mut batches = 0;
        let (law, is_clear) = (failure.law, failure.broken.is_clear());
        'smaller: loop {
            let simpler = shrink::simpler(&failure.case.scene, &self.plan.profile);
            for scenes in simpler.chunks(SIMPLER) {
                batches += 1;
                if batches > self.plan.laws.shrinks || self.now() >= until || self.is_over {
                    return failure;
                }
                let scenes = scenes.iter().cloned();
                let case = |scene| Case::new(scene, &self.right, law == Law::NoMemory);
                let cases: Vec<Case> = scenes.map(case).collect();
                let replies = self.replies(&cases).unwrap_or_default();
                let judged = cases
                    .iter()
                    .zip(&replies)
                    .flat_map(|(case, it)| self.judge(case, it));
                let is_like = |it: &Failure| it.law == law && (it.broken.is_clear() || !is_clear);
                if let Some(found) = judged.into_iter().find(is_like) {
                    failure = found;
                    continue 'smaller;
                }
            }
            return failure;
        }
    }

    /// The broken laws, together with what is known of their cause: what depends on what was asked
    /// before, and all else.
    fn findings(&mut self) -> Vec<Finding> {
        let broken = self.failures.keys().copied();
        let (mut of_state, others): (Vec<Law>, Vec<Law>) =
            broken.partition(|law| *law == Law::NoMemory);
        let cause = self.evidence.cause(&self.plan.profile);
        let is_right_alone = self.is_right_alone();
        let history = if is_right_alone { self.history() } else { None };
        let is_fickle = !of_state.is_empty() || is_right_alone || self.is_right_again();
        let names = |laws: &[Law]| laws.iter().map(|law| law.name()).collect();
        let mut findings = Vec::new();
        if is_fickle {
            if cause.is_none() || of_state.is_empty() {
                of_state.extend(&others);
            }
            findings.push(Finding {
                cause: Some(Cause::state()),
                places: Vec::new(),
                laws: names(&of_state),
                scenes: Vec::new(),
                history: history.map(Box::new),
            });
        }
        if !others.is_empty() && (cause.is_some() || !is_fickle) {
            findings.push(Finding {
                cause,
                places: self.places().unwrap_or_default(),
                laws: names(&others),
                scenes: Vec::new(),
                history: None,
            });
        }
        findings
    }

    /// The reply to the last scene, of a renderer that has forgotten all before, if it can forget.
    fn afresh(&mut self, scenes: &[Scene]) -> Option<Vec<Triple>> {
        if self.is_over || !self.renderer.begin_again().unwrap_or(false) {
            return None;
        }
        self.ask(scenes)
    }

    /// The first case that is wrong by itself, or so it seems.
    fn first(&self) -> Option<Failure> {
        let mut failures = self.failures.range(..Law::NoMemory);
        failures.find_map(|(_, it)| it.first()).cloned()
    }

    /// How the reply to the last of some scenes breaks the law that a case broke.
    fn again(&self, failure: &Failure, replies: &[Triple]) -> Option<Broken> {
        let judged = self.judge(&failure.case, &[*replies.last()?]);
        let like = judged.into_iter().find(|it| it.law == failure.law)?;
        Some(like.broken)
    }

    /// Whether a color that was wrong is right if nothing is asked before. A renderer that cannot forget does
    /// not show it.
    fn is_right_alone(&mut self) -> bool {
        let Some(failure) = self.first() else {
            return false;
        };
        let scene = std::slice::from_ref(&failure.case.scene);
        let replies = self.afresh(scene);
        replies.is_some_and(|replies| self.again(&failure, &replies).is_none())
    }

    /// The few scenes after which a color is wrong that is right without them, if few are found.
    fn history(&mut self) -> Option<Counterexample> {
        let failure = self.first()?;
        let scene = std::slice::from_ref(&failure.case.scene);
        let until = self.now() + SEARCH;
        let until = self.deadline.map_or(until, |end| end.min(until));
        let before = self
            .plan
            .cases
            .iter()
            .take_while(|case| case.scene != failure.case.scene);
        let mut before: Vec<Scene> = before.flat_map(Case::scenes).collect();
        let mut found = None;
        // one half is enough, as long as one scene is the reason
        'halved: while self.now() < until {
            let latter = before.split_off(before.len() / 2);
            for half in [latter, std::mem::take(&mut before)] {
                let scenes = [&half, scene].concat();
                let replies = self.afresh(&scenes).unwrap_or_default();
                if replies.is_empty() {
                    break 'halved;
                }
                if let Some(broken) = self.again(&failure, &replies) {
                    found = Some((scenes, replies, broken));
                    if half.len() < 2 {
                        break 'halved;
                    }
                    before = half;
                    continue 'halved;
                }
            }
            break;
        }
        let (scenes, colors, broken) = found.filter(|(scenes, ..)| scenes.len() <= 8)?;
        Some(self.told(scenes, colors, broken))
    }

    /// Whether what was wrong is right when it is asked again, so that it depends on what was asked before.
    fn is_right_again(&mut self) -> bool {
        let first = self.failures.values().filter_map(|of_law| of_law.first());
        let first: Vec<Failure> = first.cloned().collect();
        let cases: Vec<Case> = first.iter().map(|failure| failure.case.clone()).collect();
        let Some(replies) = self.replies(&cases) else {
            return false;
        };
        let is_broken = |(failure, replies): &(&Failure, Vec<Triple>)| {
            let judged = self.judge(&failure.case, replies);
            judged.iter().any(|it| it.law == failure.law)
        };
        first.iter().zip(replies).filter(is_broken).count() * 2 < first.len()
    }

    /// Where the colors are wrong.
    fn places(&mut self) -> Option<Vec<Place>> {
        if self.is_over {
            return None;
        }
        let waited = self.waited.as_secs_f64();
        let until_end = |end: Duration| end.saturating_sub(self.now()).min(SEARCH);
        let left = self.deadline.map_or(SEARCH, until_end).as_secs_f64();
        // so many cases without each of so many things
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // from 2 to 60
        #[allow(clippy::cast_precision_loss)] // the count of scenes
        let most =
            (left / waited * self.asked as f64 / EDITS.len() as f64).clamp(2.0, 60.0) as usize;
        // what is remembered has no place, and is the last law
        let of_law = self.failures.range(..Law::NoMemory);
        let of_law: Vec<&Vec<Failure>> = of_law.map(|(_, failures)| failures).collect();
        let most = (most.min(place::MOST) / of_law.len().max(1)).max(1);
        let mut scenes = Vec::new();
        for failures in of_law {
            let count = failures.len().min(most);
            let some = (0..count).map(|i| &failures[i * failures.len() / count]);
            scenes.extend(some.map(|failure| failure.case.scene.clone()));
        }
        let (profile, deadline) = (&self.plan.profile, self.deadline);
        let mut ask = |scenes: &[Scene]| {
            // with time left for the first experiment, what others would find is left out
            if deadline.is_some_and(|end| self.now() >= end) {
                return None;
            }
            let mut are_wrong = Vec::new();
            for some in scenes.chunks(256) {
                let case = |scene: &Scene| Case::new(scene.clone(), &self.right, false);
                let cases: Vec<Case> = some.iter().map(case).collect();
                let replies = self.replies(&cases)?;
                let is_wrong = |(case, it): (_, &Vec<_>)| !self.judge(case, it).is_empty();
                are_wrong.extend(cases.iter().zip(&replies).map(is_wrong));
            }
            Some(are_wrong)
        };
        place::places(&scenes, profile, &mut ask)
    }
}
