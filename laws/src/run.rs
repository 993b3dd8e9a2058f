//! Tries a renderer by the laws.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use crate::cause::{Cause, Evidence};
use crate::claim::{Broken, Seen};
use crate::formula::Formula;
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
    /// The most batches of each broken law in which its smallest scene is looked for; it is looked for three seconds in all.
    pub shrinks: usize,
    /// The longest time of the run. A law that is not tried by then is no pass.
    pub time: Option<Duration>,
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
            time: None,
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

    pub(crate) fn plan(&self, profile: &Profile) -> Result<Plan, String> {
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

    /// Every scene in the order in which a renderer gets it that says this of itself. They do not depend on its answers; what
    /// else it is asked for, in search of smaller scenes and of places, does.
    ///
    /// # Errors
    ///
    /// In one line: a contradictory profile; the name of a law that does not exist; no cases at all; a line that is no case.
    pub fn scenes(&self, profile: &Profile) -> Result<Vec<Scene>, String> {
        let plan = self.plan(profile)?;
        let batches = plan.batches().into_iter();
        let handed = batches.flat_map(|(law, of)| handed(&plan.tries[law].cases[of], profile));
        Ok(handed.collect())
    }

    /// Tries a renderer by the laws. What prevents an answer is in the report, beside what was found before.
    ///
    /// # Errors
    ///
    /// As [`scenes`](Laws::scenes).
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
            evidence: Evidence::default(),
            error: None,
            is_over: false,
        };
        run.all();
        run.is_over = false; // a renderer that ended may answer again
        run.report()
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
    /// Why the renderer did not answer the first time that it did not, and whether it was the last time that it was asked.
    error: Option<String>,
    is_over: bool,
}

impl Run<'_> {
    /// Every case of the plan, until the time is up or the renderer no longer answers.
    fn all(&mut self) -> Option<()> {
        for (law, range) in self.plan.batches() {
            if self.is_late() {
                break;
            }
            let cases = &self.plan.tries[law].cases[range];
            let failures = self.judge(cases, Some(law))?;
            self.tried[law] += cases.len();
            self.failures[law].extend(failures.into_iter().flatten());
        }
        Some(())
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
    fn judge(&mut self, cases: &[Tried], note: Option<usize>) -> Option<Vec<Option<Failure>>> {
        let mut replies = self.ask(&handed(cases, self.profile))?.into_iter();
        let formula = Formula::new(self.profile, &[]);
        let mut failures = Vec::with_capacity(cases.len());
        for tried in cases {
            let scenes = &tried.group.scenes;
            let replies: Vec<Triple> = replies.by_ref().take(scenes.len()).collect();
            let known = replies.iter().zip(&tried.known);
            if let Some(law) = note {
                for ((reply, (linear, _)), scene) in known.clone().zip(scenes) {
                    let is_right = formula.fits_linear(*linear, *reply) != Some(false);
                    self.evidence.note(law, is_right, scene, *reply);
                }
            }
            let seen = known.map(|(reply, (linear, conditioning))| {
                Seen::new(self.profile, *reply, *linear, *conditioning)
            });
            let seen: Vec<Seen> = seen.collect();
            let broken = tried.group.claim.broken(self.profile, &seen);
            failures.push(broken.map(|broken| Failure {
                tried: tried.clone(),
                broken,
                replies,
            }));
        }
        Some(failures)
    }

    /// The colors of scenes, if the renderer answers.
    fn ask(&mut self, scenes: &[Scene]) -> Option<Vec<Triple>> {
        self.asked += u32::try_from(scenes.len()).unwrap_or(u32::MAX);
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
        let answer = answer.and_then(|colors| match (colors.len(), scenes.len()) {
            (few, many) if few != many => Err(format!("{few} colors for {many} scenes")),
            _ => Ok(colors),
        });
        answer
            .map_err(|why| {
                self.error.get_or_insert(why);
                self.is_over = true;
            })
            .ok()
    }

    /// What was found, with smaller cases and places where the renderer still answers.
    fn report(mut self) -> Report {
        self.evidence.sample(self.plan.tries.len());
        let findings = self.findings();
        let mut order: Vec<usize> = (0..self.plan.tries.len()).collect();
        // what is shown is made smaller first
        order.sort_by_key(|law| {
            let scenes = self.failures[*law]
                .iter()
                .map(|f| f.tried.group.scenes.len());
            let name = self.plan.tries[*law].law.name;
            (scenes.min(), ["formula", "finite"].contains(&name))
        });
        let until = Instant::now() + Duration::from_secs(3);
        let mut verdicts: Vec<(usize, Verdict)> = Vec::new();
        for law in order {
            verdicts.push((law, self.verdict(law, until)));
        }
        verdicts.sort_by_key(|(law, _)| *law);
        let laws = verdicts.into_iter().map(|(law, verdict)| {
            let Law { name, says, .. } = *self.plan.tries[law].law;
            LawReport {
                law: name,
                says,
                is_known: self.plan.laws.known.iter().any(|known| known == name),
                verdict,
            }
        });
        let laws = laws.collect();
        Report {
            version: 4,
            seed: self.plan.laws.seed,
            error: self.error,
            findings,
            laws,
            profile: self.profile.clone(),
            command: None,
        }
    }

    fn verdict(&mut self, law: usize, until: Instant) -> Verdict {
        let tries = &self.plan.tries[law];
        let cases = self.tried[law];
        let least = self.failures[law].iter();
        let least = least.min_by_key(|failure| shrink::cost(&failure.tried.case));
        let Some(failure) = least.cloned() else {
            return match tries.lacks {
                Some(because) => Verdict::NotTried { because },
                None if tries.cases.is_empty() => Verdict::NotTried {
                    because: "it says nothing about such a renderer",
                },
                None if cases == 0 => Verdict::NotReached,
                None => Verdict::Holds { cases },
            };
        };
        let failure = self.smaller(failure, until);
        let Tried { case, group, .. } = failure.tried.clone();
        let formula = Formula::new(self.profile, &[]);
        let smallest = Counterexample {
            claim: group.claim.says,
            right: group.scenes.iter().map(|s| formula.reply(s)).collect(),
            scenes: handed(&[failure.tried], self.profile),
            colors: failure.replies,
            broken: failure.broken,
            case,
        };
        Verdict::Broken {
            cases,
            failures: self.failures[law].len(),
            smallest: Box::new(smallest),
        }
    }

    /// The smallest case that is still broken.
    fn smaller(&mut self, mut failure: Failure, until: Instant) -> Failure {
        let until = self.deadline.map_or(until, |end| end.min(until));
        let mut batches = 0;
        'smaller: loop {
            let (law, profile) = (failure.tried.law, self.profile);
            let simpler = shrink::simpler(&failure.tried.case, profile).into_iter();
            let mut cases = simpler.filter_map(|case| Tried::new(law, case, profile));
            loop {
                batches += 1;
                let is_late = batches > self.plan.laws.shrinks || Instant::now() >= until;
                let tried: Vec<Tried> = cases.by_ref().take(SIMPLER).collect();
                if tried.is_empty() || is_late || self.is_over {
                    return failure;
                }
                let failures = self.judge(&tried, None).unwrap_or_default();
                if let Some(found) = failures.into_iter().flatten().next() {
                    failure = found;
                    continue 'smaller;
                }
            }
        }
    }

    /// The broken laws, together with those that the same cause breaks.
    fn findings(&mut self) -> Vec<Finding> {
        let plan = self.plan;
        let laws = 0..plan.tries.len();
        let broken = laws.filter(|law| !self.failures[*law].is_empty());
        let cause = self.evidence.cause(self.profile);
        let (state, broken): (Vec<usize>, Vec<usize>) =
            broken.partition(|law| plan.tries[*law].law.is_of_state());
        let name = |law: &usize| plan.tries[*law].law.name;
        let mut findings = Vec::new();
        let mut is_told = |cause: Option<Cause>, laws: &[usize], places| {
            let laws = laws.iter().map(name).collect();
            findings.push(Finding {
                cause,
                places,
                laws,
            });
        };
        // what was wrong and is right when it is asked again depends on what was asked before
        let first = broken.iter().filter_map(|law| self.failures[*law].first());
        let first: Vec<Tried> = first.map(|failure| failure.tried.clone()).collect();
        let is_asked = !first.is_empty() && !self.is_over;
        let again = is_asked.then(|| self.judge(&first, None)).flatten();
        let is_right_again = again.is_some_and(|it| it.iter().flatten().count() * 2 < it.len());
        let is_fickle = !state.is_empty() || is_right_again;
        if is_fickle {
            let alone = if cause.is_none() { &broken[..] } else { &[] };
            let of_state = Cause {
                mistakes: vec![Fault::named("Leak")],
                explained: 0,
                of: 0,
                alternatives: vec![vec![Fault::named("NotRepeatable")]],
                errors: 0,
            };
            is_told(Some(of_state), &[&state[..], alone].concat(), Vec::new());
        }
        if broken.is_empty() || is_fickle && cause.is_none() {
            return findings;
        }
        let mistakes = cause.as_ref().map_or(Vec::new(), |it| it.mistakes.clone());
        let is_nearly_all = cause.as_ref().is_some_and(Cause::is_nearly_all);
        let (mut explained, mut others): (Vec<usize>, Vec<usize>) =
            broken.into_iter().partition(|law| {
                is_nearly_all && self.evidence.explains(self.profile, &mistakes, *law)
            });
        // what a cause explains in part stays one finding
        if explained.is_empty() {
            std::mem::swap(&mut explained, &mut others);
        }
        // other mistakes, in what the first leaves; what is left of a part may be several things
        let (mut made, mut rest) = (mistakes.clone(), Vec::new());
        let mut last = mistakes;
        while !last.is_empty() && rest.len() < 2 {
            let mut left = self.evidence.leave(self.profile, &last);
            let found = self.evidence.cause(self.profile);
            let is_enough = |it: &Cause| it.explained == it.of || !is_nearly_all;
            let Some(found) = found.filter(|it| left.len() >= 4 && is_enough(it)) else {
                break;
            };
            left.sort_unstable();
            left.dedup();
            // a law may hold of colors that are not those of the formula
            left.retain(|law| !self.failures[*law].is_empty());
            last.clone_from(&found.mistakes);
            if !left.is_empty() {
                rest.push((Some(found), left));
            }
        }
        if rest.is_empty() && !others.is_empty() {
            rest.push((None, others));
        }
        let places = self.places(&explained, None);
        is_told(cause, &explained, places);
        for (cause, laws) in rest {
            let places = self.places(&laws, Some(&made));
            made.extend(cause.iter().flat_map(|cause| &cause.mistakes));
            is_told(cause, &laws, places);
        }
        findings
    }

    /// Where the colors of laws are wrong, but for those that some mistakes explain.
    fn places(&mut self, laws: &[usize], but: Option<&[Fault]>) -> Vec<Place> {
        let of = |name: &str| {
            let mut laws = laws.iter().copied();
            laws.find(|law| self.plan.tries[*law].law.name == name)
        };
        let of_one_scene = ["finite", "formula", "as_said"].map(of);
        let mut chosen: Vec<usize> = of_one_scene.into_iter().flatten().collect();
        if chosen.is_empty() {
            chosen.extend(laws.first());
        }
        let explained = but.map(|faults| Formula::new(self.profile, faults));
        let is_left = |failure: &&Failure| {
            explained.as_ref().is_none_or(|formula| {
                let mut replies = failure.tried.group.scenes.iter().zip(&failure.replies);
                replies.any(|(scene, reply)| formula.fits(scene, *reply) != Some(true))
            })
        };
        let per_scene = self.start.elapsed() / self.asked.max(1);
        let two = Duration::from_secs(2);
        let until_end = |end: Instant| end.saturating_duration_since(Instant::now()).min(two);
        let left = self.deadline.map_or(two, until_end);
        let affordable = left.as_secs_f64() / (per_scene.as_secs_f64() * 22.0).max(1e-9);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // from 2 to 40
        let most = affordable.clamp(2.0, PLACED) as usize / chosen.len().max(1);
        let mut broken = Vec::new();
        for law in chosen {
            let left: Vec<&Failure> = self.failures[law].iter().filter(is_left).collect();
            let count = left.len().min(most.max(1));
            broken.extend((0..count).map(|i| left[i * left.len() / count].tried.clone()));
        }
        self.places_of(&broken).unwrap_or_default()
    }

    /// Where these cases are broken: one place, or two where two things are wrong.
    fn places_of(&mut self, broken: &[Tried]) -> Option<Vec<Place>> {
        let profile = self.profile;
        if self.is_over {
            return None;
        }
        let mut ask = |cases: &[Tried]| {
            let mut are_broken = Vec::new();
            for cases in cases.chunks(256) {
                let failures = self.judge(cases, None)?;
                are_broken.extend(failures.iter().map(Option::is_some));
            }
            (!cases.is_empty()).then_some(are_broken)
        };
        let edits = Edits::new(broken, profile, &mut ask)?;
        let whole = edits.place(|_| true);
        if let Some((repaired, left)) = edits.split().filter(|_| whole.only_with.is_empty()) {
            let first = edits.place(|case| repaired.contains(&case));
            if let Some(edits) = Edits::new(&left, profile, &mut ask) {
                let second = edits.place(|_| true);
                // ambient light and that of lights alike is everything
                let is_term = |place: &Place| {
                    place.only_with.len() == 1
                        && ["lights", "ambient"].contains(&place.only_with[0])
                };
                let is_told =
                    !second.only_with.is_empty() && !(is_term(&first) && is_term(&second));
                if is_told && !first.only_with.is_empty() {
                    return Some(vec![first, second]);
                }
            }
        }
        Some(vec![whole])
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
