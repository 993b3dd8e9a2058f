//! Tries a renderer by the laws.

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use crate::cause::{Cause, Evidence};
use crate::claim::Broken;
use crate::law::{LAWS, Law};
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

/// The longest search for smaller cases, and that for places.
const SEARCH: Duration = Duration::from_secs(2);

impl Laws {
    /// Tries a renderer by the laws. What prevents an answer is in the report, beside what was found before.
    ///
    /// # Errors
    ///
    /// As [`scenes`](Laws::scenes).
    pub fn run(&self, renderer: &mut impl Renderer) -> Result<Report, String> {
        let plan = Plan::new(self, &renderer.profile())?;
        let start = Instant::now();
        let mut run = Run {
            renderer,
            plan: &plan,
            profile: &plan.profile,
            start,
            deadline: self.time.map(|time| start + time),
            asked: 0,
            waited: Duration::ZERO,
            of: plan.scenes(),
            tried: vec![0; plan.tries.len()],
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
    law: &'static Law,
    case: Case,
    broken: Broken,
    replies: Vec<Triple>,
}

impl Failure {
    fn scene(&self) -> &Scene {
        &self.case.scenes[0]
    }
}

struct Run<'a> {
    renderer: &'a mut dyn Renderer,
    plan: &'a Plan,
    profile: &'a Profile,
    start: Instant,
    deadline: Option<Instant>,
    /// The number of scenes, and that of the whole plan.
    asked: usize,
    of: usize,
    /// The time that the renderer took for them.
    waited: Duration,
    /// The number of cases of each group of laws, and for each law those that failed.
    tried: Vec<usize>,
    failures: BTreeMap<&'static str, Vec<Failure>>,
    evidence: Evidence,
    /// Why the renderer did not answer the first time that it did not, and whether it was the last time that it was asked.
    error: Option<String>,
    is_over: bool,
    /// The renderer does not go on.
    is_stopped: bool,
}

impl Run<'_> {
    /// Every case of the plan, until the time is up or the renderer no longer answers.
    fn all(&mut self) -> Option<()> {
        for (i, range) in self.plan.batches() {
            if range.start > 0 && self.is_late() {
                break;
            }
            let tries = &self.plan.tries[i];
            let cases = &tries.cases[range];
            let failures = self.judge(&tries.laws, cases, true)?;
            self.tried[i] += cases.len();
            for failure in failures.into_iter().flatten() {
                self.failures
                    .entry(failure.law.name)
                    .or_default()
                    .push(failure);
            }
        }
        Some(())
    }

    fn is_late(&self) -> bool {
        self.deadline.is_some_and(|end| {
            // what is wrong needs time to be placed
            let left = end.saturating_duration_since(Instant::now());
            left.is_zero() || !self.failures.is_empty() && left * 4 < end - self.start
        })
    }

    /// For each case how it breaks laws, if it does. The colors of the plan's own cases are noted.
    fn judge(
        &mut self,
        laws: &[&'static Law],
        cases: &[Case],
        is_noted: bool,
    ) -> Option<Vec<Vec<Failure>>> {
        let mut replies = self.ask(&handed(cases))?.into_iter();
        let right = formula(self.profile, &[]);
        let mut failures = Vec::with_capacity(cases.len());
        for case in cases {
            let replies: Vec<Triple> = replies.by_ref().take(case.scenes.len()).collect();
            if is_noted {
                for ((reply, (linear, _)), scene) in
                    replies.iter().zip(&case.known).zip(&case.scenes)
                {
                    let is_right = right.fits_linear(*linear, *reply) != Some(false);
                    self.evidence.note(is_right, scene, *reply);
                }
            }
            let mut of_case = Vec::new();
            for law in laws {
                let broken = case.broken(law, self.profile, &replies);
                let broken = broken.filter(|_| !case.is_exempt(law, self.profile));
                of_case.extend(broken.map(|broken| Failure {
                    law,
                    case: case.clone(),
                    broken,
                    replies: replies.clone(),
                }));
            }
            failures.push(of_case);
        }
        Some(failures)
    }

    /// The colors of scenes, with 1 for white, if the renderer answers.
    fn ask(&mut self, scenes: &[Scene]) -> Option<Vec<Triple>> {
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
        let asked = Instant::now();
        let mut shade = |scenes: &[Scene]| {
            let shade = AssertUnwindSafe(|| self.renderer.shade(scenes));
            catch_unwind(shade).ok()
        };
        let answer = shade(scenes).unwrap_or_else(|| {
            let mut alone = scenes.iter();
            let alone = alone.find(|scene| shade(std::slice::from_ref(scene)).is_none());
            let scene = alone.map_or("none alone".into(), Scene::to_json);
            Err(format!("the renderer panicked; the scene: {scene}"))
        });
        self.waited += asked.elapsed();
        let answer = answer.and_then(|colors| match (colors.len(), scenes.len()) {
            (few, many) if few != many => Err(format!("{few} colors for {many} scenes")),
            _ => Ok(colors),
        });
        match answer {
            Ok(mut colors) => {
                let white = self.profile.white;
                colors.iter_mut().flatten().for_each(|c| *c /= white);
                Some(colors)
            }
            Err(why) => {
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
        let findings = self.findings();
        let until = Instant::now() + SEARCH;
        let until = self.deadline.map_or(until, |end| end.min(until));
        // what is shown is made smaller first
        let mut smallest = BTreeMap::new();
        for law in shown_first(&findings) {
            let least = self.failures[law]
                .iter()
                .min_by_key(|failure| (!failure.broken.is_clear(), shrink::cost(failure.scene())));
            if let Some(failure) = least.cloned() {
                let failure = self.smaller(failure, until);
                smallest.insert(law, self.counterexample(failure));
            }
        }
        let mut laws = Vec::new();
        for law in LAWS.iter().filter(|law| self.plan.laws.tries(law.name)) {
            let verdict = self.verdict(law, smallest.remove(law.name));
            laws.push(LawReport {
                law: law.name,
                says: law.says,
                is_known: self.plan.laws.known.iter().any(|known| known == law.name),
                verdict,
            });
        }
        Report {
            version: 5,
            seed: self.plan.laws.seed,
            error: self.error,
            findings,
            laws,
            profile: self.profile.clone(),
            command: None,
        }
    }

    fn verdict(&self, law: &Law, smallest: Option<Counterexample>) -> Verdict {
        let is_of_law = |laws: &[&Law]| laws.iter().any(|it| it.name == law.name);
        let tries = self.plan.tries.iter().zip(&self.tried);
        let (lacks, of, cases) = tries
            .filter(|(tries, _)| is_of_law(&tries.laws))
            .map(|(tries, tried)| (tries.lacks, tries.cases.len(), *tried))
            .next()
            .unwrap_or_default();
        let failures = self.failures.get(law.name).map_or(0, Vec::len);
        match smallest {
            Some(smallest) => Verdict::Broken {
                cases,
                failures,
                smallest: Box::new(smallest),
            },
            None if of == 0 => Verdict::NotTried { because: lacks },
            None if law.name == "as_said" && self.profile.range().is_none() => Verdict::NotTried {
                because: "its colors are neither clamped nor levels",
            },
            None if cases < of => Verdict::CutShort { cases, of },
            None => Verdict::Holds { cases },
        }
    }

    fn counterexample(&self, failure: Failure) -> Counterexample {
        let (right, white) = (formula(self.profile, &[]), self.profile.white);
        let as_given = |color: Triple| color.map(|c| c * white);
        let Broken {
            channel,
            off,
            allowed,
        } = failure.broken;
        Counterexample {
            right: failure
                .case
                .scenes
                .iter()
                .map(|scene| as_given(right.reply(scene)))
                .collect(),
            colors: failure.replies.into_iter().map(as_given).collect(),
            broken: Broken {
                channel,
                off: off * white,
                allowed: allowed * white,
            },
            scenes: failure.case.scenes,
        }
    }

    /// The smallest case that is still broken; if rounding does not explain the first one, it does not explain that one either.
    fn smaller(&mut self, mut failure: Failure, until: Instant) -> Failure {
        let mut batches = 0;
        let is_clear = failure.broken.is_clear();
        'smaller: loop {
            let (law, profile) = (failure.law, self.profile);
            let simpler = shrink::simpler(failure.scene(), profile).into_iter();
            let mut cases = simpler.filter_map(|scene| Case::new(law, &scene, profile).ok());
            loop {
                batches += 1;
                let is_late = batches > self.plan.laws.shrinks || Instant::now() >= until;
                let tried: Vec<Case> = cases.by_ref().take(SIMPLER).collect();
                if tried.is_empty() || is_late || self.is_over {
                    return failure;
                }
                let failures = self.judge(&[law], &tried, false).unwrap_or_default();
                let found = failures
                    .into_iter()
                    .flatten()
                    .find(|it| it.broken.is_clear() || !is_clear);
                if let Some(found) = found {
                    failure = found;
                    continue 'smaller;
                }
            }
        }
    }

    /// The broken laws, together with what is known of their cause: what depends on what was asked before, and all else.
    fn findings(&mut self) -> Vec<Finding> {
        let is_broken = |law: &&Law| self.failures.contains_key(law.name);
        let broken = LAWS.iter().filter(is_broken);
        let (of_state, others): (Vec<&Law>, Vec<&Law>) = broken.partition(|law| law.is_of_state());
        let names = |laws: &[&Law]| laws.iter().map(|law| law.name).collect::<Vec<_>>();
        let (mut of_state, others) = (names(&of_state), names(&others));
        let cause = self.evidence.cause(self.profile);
        let is_fickle = !of_state.is_empty() || self.is_right_again();
        let mut findings = Vec::new();
        if is_fickle {
            if cause.is_none() {
                of_state.extend(&others);
            }
            findings.push(Finding {
                cause: Some(Cause::state()),
                places: Vec::new(),
                laws: of_state,
            });
        }
        if !others.is_empty() && (cause.is_some() || !is_fickle) {
            let places = self.places().unwrap_or_default();
            findings.push(Finding {
                cause,
                places,
                laws: others,
            });
        }
        findings
    }

    /// Whether what was wrong is right when it is asked again, so that it depends on what was asked before.
    fn is_right_again(&mut self) -> bool {
        let first = self.failures.values().filter_map(|of_law| of_law.first());
        let first: Vec<Failure> = first.cloned().collect();
        let mut still_broken = 0;
        for failure in &first {
            match self.judge(&[failure.law], std::slice::from_ref(&failure.case), false) {
                Some(failures) => still_broken += failures.iter().flatten().count(),
                None => return false,
            }
        }
        still_broken * 2 < first.len()
    }

    /// Where the colors are wrong.
    fn places(&mut self) -> Option<Vec<Place>> {
        if self.is_over {
            return None;
        }
        let of_one_scene = ["finite", "formula", "as_said"].into_iter();
        let mut chosen: Vec<&str> = of_one_scene
            .filter(|name| self.failures.contains_key(name))
            .collect();
        if chosen.is_empty() {
            chosen.extend(self.failures.keys().find(|name| **name != "no_memory"));
        }
        let asked = f64::from(u32::try_from(self.asked.max(1)).unwrap_or(u32::MAX));
        let per_scene = self.waited.as_secs_f64() / asked;
        let until_end = |end: Instant| end.saturating_duration_since(Instant::now()).min(SEARCH);
        let left = self.deadline.map_or(SEARCH, until_end).as_secs_f64();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // from 2 to 60
        let most = (left / (per_scene * 22.0).max(1e-9)).clamp(2.0, 60.0) as usize;
        let most = most.min(place::MOST) / chosen.len().max(1);
        let mut failures: Vec<Failure> = Vec::new();
        for name in chosen {
            let of_law = &self.failures[name];
            let count = of_law.len().min(most.max(1));
            failures.extend((0..count).map(|i| of_law[i * of_law.len() / count].clone()));
        }
        let profile = self.profile;
        let broken = failures
            .iter()
            .map(|failure| failure.scene().clone())
            .enumerate();
        let broken: Vec<(usize, Scene)> = broken.collect();
        let mut ask = |edited: &[(usize, Scene)]| {
            let cases = edited
                .iter()
                .map(|(i, scene)| Case::new(failures[*i].law, scene, profile).ok());
            let cases: Vec<Option<Case>> = cases.collect();
            let asked: Vec<Case> = cases.iter().flatten().cloned().collect();
            let mut laws: Vec<&Law> = failures.iter().map(|failure| failure.law).collect();
            laws.sort_by_key(|law| law.name);
            laws.dedup_by_key(|law| law.name);
            let mut found = Vec::new();
            for some in asked.chunks(256) {
                found.extend(self.judge(&laws, some, false)?);
            }
            let mut found = found.into_iter();
            let answers = cases.iter().zip(edited).map(|(case, (i, _))| {
                let failed = case.as_ref().and_then(|_| found.next())?;
                Some(failed.iter().any(|it| it.law.name == failures[*i].law.name))
            });
            Some(answers.collect())
        };
        place::places(&broken, profile, &mut ask)
    }
}

/// The broken laws, those first whose smallest case is shown.
fn shown_first(findings: &[Finding]) -> Vec<&'static str> {
    let mut laws: Vec<&'static str> = findings
        .iter()
        .flat_map(|finding| &finding.laws)
        .copied()
        .collect();
    laws.sort_by_key(|law| match *law {
        "finite" => 0,
        "formula" => 1,
        _ => 2,
    });
    laws.dedup();
    laws
}
