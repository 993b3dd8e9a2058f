//! Tries a renderer by the laws.

use std::collections::BTreeMap;
use std::time::Duration;

use crate::cause::{Cause, Evidence, FEW};
use crate::edit::EDITS;
use crate::formula::Formula;
use crate::law::{Broken, Law};
use crate::mistakes::formula;
use crate::options::Laws;
use crate::place::{self, Place};
use crate::plan::{Case, Plan, handed};
use crate::profile::Profile;
use crate::renderer::{Progress, Renderer};
use crate::report::{Counterexample, Finding, LawReport, Report, Verdict};
use crate::scene::{Scene, Triple};
use crate::shrink;

/// The simpler cases that are asked for at once.
const SIMPLER: usize = 32;

/// The most broken cases that are placed.
const MOST_BROKEN: usize = 600;

/// The most batches in which a smaller case is looked for.
const MOST_BATCHES: usize = 200;

/// The longest search for smaller cases, and that for places.
const SEARCH: Duration = Duration::from_secs(2);

impl Laws {
    /// Tries a renderer by the laws. What prevents an answer is in the report, beside what was found before.
    ///
    /// # Errors
    ///
    /// In one line: a contradictory profile; no cases at all.
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

impl Failure {
    /// The order in which failures are worth showing.
    fn rank(&self) -> (bool, u32) {
        (!self.broken.is_clear(), shrink::cost(&self.case.scene))
    }
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
        let failure = |law: Law| {
            Some(Failure {
                law,
                case: case.clone(),
                broken: law.broken(&self.right, case.linear, replies)?,
                replies: replies.to_vec(),
            })
        };
        let laws = Law::ALL.into_iter().filter(|law| case.is_of(*law));
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
        let laws = Law::ALL.map(|law| {
            let (name, says) = law.told();
            LawReport {
                law: name,
                says,
                verdict: self.verdict(law, until),
            }
        });
        self.show_apart(&mut findings, until);
        for finding in &mut findings {
            let shown = finding.shown(&laws);
            finding.scenes = shown.map_or_else(Vec::new, |(_, it)| it.scenes.clone());
        }
        Report {
            version: 8,
            seed: self.plan.laws.seed,
            error: self.error,
            findings,
            laws: laws.into(),
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
        match failures.iter().min_by_key(|it| it.rank()).cloned() {
            Some(least) => Verdict::Broken {
                cases,
                failures: failures.len(),
                smallest: {
                    let smallest = self.smaller(least, until, &|_| true);
                    Box::new(self.counterexample(smallest))
                },
            },
            None if cases < of => Verdict::CutShort { cases, of },
            None => Verdict::Holds { cases },
        }
    }

    /// Gives each of two findings of one law a scene in which the other makes no difference.
    fn show_apart(&mut self, findings: &mut [Finding], until: Duration) {
        let plan = self.plan;
        let [.., first, second] = findings else {
            return;
        };
        let then = first.cause.as_ref().and_then(|cause| cause.then.clone());
        let Some(then) = then.filter(|_| first.laws == second.laws) else {
            return;
        };
        let (right, with_first) = (formula(&plan.profile, None), formula(&then, None));
        let ratio = plan.profile.white / then.white;
        let is_of_first = |scene: &Scene, color: Triple| {
            with_first.fits(scene, color.map(|c| c * ratio)) == Some(true)
        };
        let is_first = |it: &Failure| is_of_first(&it.case.scene, it.replies[0]);
        let is_second = |it: &Failure| is_of_first(&it.case.scene, right.reply(&it.case.scene));
        let is_so: [&dyn Fn(&Failure) -> bool; 2] = [&is_first, &is_second];
        for (finding, is_so) in [first, second].into_iter().zip(is_so) {
            let failures = self.failures.get(&Law::Formula).into_iter().flatten();
            let least = failures.filter(|it| is_so(it)).min_by_key(|it| it.rank());
            if let Some(least) = least.cloned() {
                let smallest = self.smaller(least, until, is_so);
                finding.own = Some(Box::new(self.counterexample(smallest)));
            }
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

    /// The smallest case like this that is still broken; if rounding does not explain the first one, it does
    /// not explain that one either.
    fn smaller(
        &mut self,
        mut failure: Failure,
        until: Duration,
        is_so: &dyn Fn(&Failure) -> bool,
    ) -> Failure {
        // without a clock, so many batches end the search
        let mut left = if self.plan.laws.shrinks {
            MOST_BATCHES
        } else {
            0
        };
        let (law, is_clear) = (failure.law, failure.broken.is_clear());
        'smaller: loop {
            let simpler = shrink::simpler(&failure.case.scene, &self.plan.profile);
            for scenes in simpler.chunks(SIMPLER) {
                if left == 0 || self.now() >= until || self.is_over {
                    return failure;
                }
                left -= 1;
                let scenes = scenes.iter().cloned();
                let case = |scene| Case::new(scene, &self.right, law == Law::NoMemory);
                let cases: Vec<Case> = scenes.map(case).collect();
                let replies = self.replies(&cases).unwrap_or_default();
                let judged = cases
                    .iter()
                    .zip(&replies)
                    .flat_map(|(case, it)| self.judge(case, it));
                let is_like = |it: &Failure| {
                    it.law == law && (it.broken.is_clear() || !is_clear) && is_so(it)
                };
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
        let explains = self.plan.laws.explains;
        let cause = explains
            .then(|| self.evidence.cause(&self.plan.profile))
            .flatten();
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
                own: None,
            });
        }
        if !others.is_empty() && (cause.is_some() || !is_fickle) {
            let laws = names(&others);
            let finding = |(cause, places)| Finding {
                cause,
                places,
                laws: laws.clone(),
                scenes: Vec::new(),
                history: None,
                own: None,
            };
            findings.extend(self.placed(cause).into_iter().map(finding));
        }
        findings
    }

    /// Causes with their places: one, or two where one mistake is known and something else is wrong without it.
    fn placed(&mut self, cause: Option<Cause>) -> Vec<(Option<Cause>, Vec<Place>)> {
        let (plan, scenes) = (self.plan, self.broken());
        let places = self.places(&plan.profile, &scenes).unwrap_or_default();
        let is_whole = |it: &Cause| it.of > 0 && it.is_nearly_all();
        if !plan.laws.explains || cause.as_ref().is_some_and(is_whole) {
            return vec![(cause, places)];
        }
        let is_vague = matches!(&places[..], [place] if place.is_general());
        let parts = self.evidence.parts(&plan.profile).into_iter().take(3);
        let candidates: Vec<Cause> = cause.iter().cloned().chain(parts).collect();
        for part in candidates {
            let Some(then) = part.then.as_deref() else {
                continue;
            };
            let rest = self.evidence.rest(&plan.profile, then);
            let left = rest.wrong_scenes();
            if left.len() < FEW {
                continue;
            }
            let other = rest.cause(then);
            let other = other.filter(is_whole);
            if other.is_none() && !is_vague {
                continue;
            }
            let others = self.places(then, &left).unwrap_or_default();
            let is_sure = part.explained * 2 >= part.of || other.is_some();
            if is_sure || others.iter().all(|place| !place.is_general()) {
                let of_part = places_of_mistake(&scenes, &plan.profile, then);
                // the parts of one thing are one mistake
                let mut all = [&of_part[..], &others].concat();
                place::merge(&mut all);
                if all.len() > 1 {
                    return vec![(Some(part), of_part), (other, others)];
                }
            }
        }
        vec![(cause, places)]
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

    /// Some of the scenes whose colors are wrong, of each law as many.
    fn broken(&self) -> Vec<Scene> {
        // what is remembered has no place, and is the last law
        let of_law = self.failures.range(..Law::NoMemory);
        let of_law: Vec<&Vec<Failure>> = of_law.map(|(_, failures)| failures).collect();
        let most = MOST_BROKEN / of_law.len().max(1);
        let some = of_law.into_iter().flat_map(|failures| {
            let count = failures.len().min(most);
            (0..count).map(move |i| failures[i * failures.len() / count].case.scene.clone())
        });
        some.collect()
    }

    /// Where the colors of these scenes are wrong for a renderer that says this of itself.
    fn places(&mut self, profile: &Profile, scenes: &[Scene]) -> Option<Vec<Place>> {
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
        let (deadline, right) = (self.deadline, formula(profile, None));
        let ratio = self.plan.profile.white / profile.white;
        let mut ask = |scenes: &[Scene]| {
            // with time left for the first experiment, what others would find is left out
            if deadline.is_some_and(|end| self.now() >= end) {
                return None;
            }
            let mut are_wrong = Vec::new();
            for some in scenes.chunks(256) {
                let replies = self.ask(some)?;
                let is_wrong = |(scene, reply): (&Scene, Triple)| {
                    is_broken(&right, scene, reply.map(|c| c * ratio))
                };
                are_wrong.extend(some.iter().zip(replies).map(is_wrong));
            }
            Some(are_wrong)
        };
        place::places(scenes, most.min(place::MOST), profile, &mut ask)
    }
}

/// Whether a color breaks a law by itself.
fn is_broken(right: &Formula, scene: &Scene, reply: Triple) -> bool {
    let linear = right.linear(scene);
    let mut alone = Law::ALL.into_iter().filter(|law| *law != Law::NoMemory);
    alone.any(|law| law.broken(right, linear, &[reply]).is_some())
}

/// Where the colors would be wrong if nothing else were wrong than what a profile says in addition.
fn places_of_mistake(scenes: &[Scene], profile: &Profile, then: &Profile) -> Vec<Place> {
    let (right, wrong) = (formula(profile, None), formula(then, None));
    let ratio = then.white / profile.white;
    let is_wrong = |scene: &Scene| {
        let reply = wrong.reply(scene).map(|c| c * ratio);
        is_broken(&right, scene, reply)
    };
    let scenes: Vec<Scene> = scenes.iter().filter(|it| is_wrong(it)).cloned().collect();
    let mut ask = |scenes: &[Scene]| Some(scenes.iter().map(is_wrong).collect());
    place::places(&scenes, place::MOST, profile, &mut ask).unwrap_or_default()
}
