//! Puts a renderer to the laws.

use std::sync::Arc;
use std::time::{Duration, Instant};

use crate::batch::{Batch, Batches};
use crate::cause::Cause;
use crate::corpus;
use crate::coverage::Coverage;
use crate::generator::Base;
use crate::law::{LAWS, Law};
use crate::mistake::{Fault, Mistake};
use crate::profile::Profile;
use crate::random::Random;
use crate::renderer::Renderer;
use crate::report::{Finding, LawReport, Report, Verdict};
use crate::reproduction::Reproduction;
use crate::trial::{Budget, Trial, Tried};

/// A run of the laws. It is deterministic: the same seed gives the same scenes.
///
/// ```
/// use shading_laws::{Laws, Profile, from_fn};
///
/// let mut black = from_fn(Profile::default(), |_scene| [0.0; 3]);
/// let report = Laws::new().seed(7).cases(50).run(&mut black).unwrap();
/// assert!(report.is_broken()); // there is no k_a I_a
/// ```
#[derive(Clone, Debug)]
pub struct Laws {
    seed: u64,
    cases: usize,
    only: Vec<String>,
    known: Vec<String>,
    replayed: Vec<(String, Base)>,
    shrinks: usize,
    shrinking: Duration,
    time: Option<Duration>,
}

impl Default for Laws {
    fn default() -> Self {
        Self::new()
    }
}

/// How far a run is.
#[derive(Clone, Copy, Debug)]
pub struct Progress {
    /// The law that is being tried.
    pub law: &'static str,
    /// The number of laws that are done.
    pub done: usize,
    /// The number of laws to try.
    pub of: usize,
    /// The law is broken, and this many batches were asked for to find its smallest scene; 0 before that.
    pub shrinking: usize,
}

impl Laws {
    /// All laws, with 256 random cases of each beside the fixed ones, from seed 0.
    #[must_use]
    pub fn new() -> Self {
        Self {
            seed: 0,
            cases: 256,
            only: Vec::new(),
            known: Vec::new(),
            replayed: Vec::new(),
            shrinks: 200,
            shrinking: Duration::from_secs(60),
            time: None,
        }
    }

    /// The seed of the scenes.
    #[must_use]
    pub fn seed(self, seed: u64) -> Self {
        Self { seed, ..self }
    }

    /// The number of random cases of each law.
    #[must_use]
    pub fn cases(self, cases: usize) -> Self {
        Self { cases, ..self }
    }

    /// Tries only this law and those of further calls. [`Laws::names`] lists the names.
    #[must_use]
    pub fn only(mut self, name: impl Into<String>) -> Self {
        self.only.push(name.into());
        self
    }

    /// Expects this law to be broken: the report passes if it is, and does not if the law holds.
    #[must_use]
    pub fn known(mut self, name: impl Into<String>) -> Self {
        self.known.push(name.into());
        self
    }

    /// The most batches of each broken law in which its smallest scene is looked for, and the longest time. With 0, the
    /// report shows the smallest scene of those that were generated.
    #[must_use]
    pub fn shrinking(self, batches: usize, time: Duration) -> Self {
        Self {
            shrinks: batches,
            shrinking: time,
            ..self
        }
    }

    /// The longest time of the run. A law that is not tried by then is no pass.
    #[must_use]
    pub fn time(self, limit: Duration) -> Self {
        Self {
            time: Some(limit),
            ..self
        }
    }

    /// Tries these cases, too, before the random ones: the text that [`Report::cases`] gives, a case a line.
    ///
    /// # Errors
    ///
    /// A line that is no case, or of no law.
    pub fn replay(mut self, cases: &str) -> Result<Self, String> {
        for (i, line) in cases.lines().enumerate() {
            if line.trim().is_empty() {
                continue;
            }
            let case = crate::case::read(line).map_err(|why| format!("line {}: {why}", i + 1))?;
            self.replayed.push(case);
        }
        Ok(self)
    }

    /// The name of each law, and what it says.
    pub fn names() -> impl Iterator<Item = (&'static str, &'static str)> {
        LAWS.iter().map(|law| (law.name, law.says))
    }

    /// Puts a renderer to the laws.
    ///
    /// # Errors
    ///
    /// In one line: the renderer's own error; a wrong number of colors; a contradictory profile; the
    /// name of a law that does not exist; no cases.
    pub fn run(&self, renderer: &mut impl Renderer) -> Result<Report, String> {
        self.run_with(renderer, &mut |_| {})
    }

    /// The same, and reports its progress.
    ///
    /// # Errors
    ///
    /// As [`run`](Laws::run).
    pub fn run_with(
        &self,
        renderer: &mut impl Renderer,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<Report, String> {
        self.run_over(renderer, progress, None)
    }

    fn run_over(
        &self,
        renderer: &mut dyn Renderer,
        progress: &mut dyn FnMut(Progress),
        prepared: Option<&Prepared>,
    ) -> Result<Report, String> {
        let profile = renderer.profile();
        if let Some(complaint) = profile.complaint() {
            return Err(format!("the profile of {}: {complaint}", profile.name));
        }
        let is_known = |name: &&String| LAWS.iter().any(|law| law.name == **name);
        if self.cases == 0 {
            return Err("the number of cases is 0".into());
        }
        if let Some(name) = self.only.iter().find(|name| !is_known(name)) {
            return Err(format!("there is no law {name}"));
        }
        let is_chosen =
            |law: &&Law| self.only.is_empty() || self.only.iter().any(|name| name == law.name);
        let laws: Vec<&Law> = LAWS.iter().filter(is_chosen).collect();

        let names = self
            .known
            .iter()
            .chain(self.replayed.iter().map(|(name, _)| name));
        if let Some(name) = names.into_iter().find(|name| !is_known(name)) {
            return Err(format!("there is no law {name}"));
        }

        let edges = if prepared.is_some() {
            Vec::new()
        } else {
            corpus::edges(&profile)
        };
        let of = profile.clone();
        let coverage = prepared.is_none().then(Coverage::default);
        let mut trial = Trial::new(renderer, profile, coverage);
        let budget = Budget {
            shrinks: self.shrinks,
            shrinking: self.shrinking,
            deadline: self.time.map(|time| Instant::now() + time),
        };
        let mut reports = Vec::new();
        for (done, law) in laws.iter().enumerate() {
            let mut report = |shrinking| {
                progress(Progress {
                    law: law.name,
                    done,
                    of: laws.len(),
                    shrinking,
                });
            };
            report(0);
            let tried = self.tried(law);
            let batches: Box<dyn Iterator<Item = Arc<Batch>>> = match prepared {
                Some(prepared) => Box::new(prepared.batches[tried.index].iter().cloned()),
                None => Box::new(self.batches(law, &of, &edges).map(Arc::new)),
            };
            let verdict = trial.of(&tried, batches, budget, &mut report)?;
            reports.push(LawReport {
                name: law.name,
                says: law.says,
                verdict,
            });
        }
        let findings = self.findings(&mut trial, &mut reports)?;
        let coverage = trial.coverage.as_ref();
        let coverage = coverage.or(prepared.map(|prepared| &prepared.coverage));
        let exercised = match coverage {
            Some(coverage) if self.only.is_empty() => coverage.of(&trial.profile),
            _ => Vec::new(),
        };
        let known = self.known.iter();
        Ok(Report {
            profile: trial.profile,
            seed: self.seed,
            known: known
                .filter(|name| laws.iter().any(|law| law.name == **name))
                .cloned()
                .collect(),
            laws: reports,
            findings,
            exercised,
            reproduction: Reproduction::default(),
        })
    }

    fn tried<'l>(&self, law: &'l Law) -> Tried<'l> {
        Tried {
            law,
            index: law.index(),
            seed: self.seed,
        }
    }

    /// The fixed cases of a law, those of another run, and random ones.
    fn batches<'a>(
        &'a self,
        law: &'a Law,
        profile: &'a Profile,
        edges: &'a [Base],
    ) -> impl Iterator<Item = Batch> + 'a {
        // what is said of one scene is tried on every edge; other laws share them
        let step = if law.is_of_one_scene() { 1 } else { 8 };
        let edges = edges.iter().skip(law.index() % step).step_by(step);
        let replayed = self
            .replayed
            .iter()
            .filter(move |(name, _)| name == law.name);
        let fixed = edges.chain(replayed.map(|(_, base)| base)).cloned();
        // every law has scenes of its own, whichever others are tried
        let random = Random::new(self.seed, law.name);
        Batches::new(law, profile, fixed, random, self.cases)
    }

    /// The scenes of a run and what is known of their colors, for several renderers of one profile. They take some
    /// kilobytes for each case.
    #[doc(hidden)]
    #[must_use]
    pub fn prepared(&self, profile: &Profile) -> Prepared {
        let edges = corpus::edges(profile);
        let batches = LAWS.iter().map(|law| {
            if law.lacks(profile).is_some() {
                return Vec::new();
            }
            let batches = self.batches(law, profile, &edges);
            batches.map(Arc::new).collect()
        });
        let batches: Vec<Vec<Arc<Batch>>> = batches.collect();
        let mut coverage = Coverage::default();
        let groups = batches.iter().flatten().flat_map(|batch| &batch.groups);
        for scene in groups.flat_map(|group| &group.scenes) {
            coverage.note(scene, profile);
        }
        Prepared {
            laws: self.clone(),
            batches,
            coverage,
        }
    }

    /// The broken laws, together with those that the same cause breaks.
    fn findings(
        &self,
        trial: &mut Trial,
        reports: &mut [LawReport],
    ) -> Result<Vec<Finding>, String> {
        let mut broken: Vec<&'static str> = reports
            .iter()
            .filter(|law| law.is_broken())
            .map(|law| law.name)
            .collect();
        let mut findings = Vec::new();
        if broken.is_empty() {
            return Ok(findings);
        }
        let state = self.state(trial, reports)?;
        let cause = trial.evidence.cause(&trial.profile);
        if let Some(mistakes) = state {
            let of_state = |name: &&str| ["repeatable", "no_memory"].contains(name);
            let (laws, others) = broken
                .into_iter()
                .partition(|name| cause.is_none() || of_state(name));
            broken = others;
            findings.push(Finding {
                cause: Some(Cause {
                    mistakes: vec![mistakes[0].into()],
                    explained: 0,
                    of: 0,
                    alternatives: mistakes[1..]
                        .iter()
                        .map(|&other| vec![other.into()])
                        .collect(),
                }),
                laws,
            });
        }
        if let Some(cause) = cause {
            let (laws, others): (Vec<_>, Vec<_>) = broken.into_iter().partition(|name| {
                let index = LAWS.iter().position(|law| law.name == *name);
                let explains = |index| {
                    let evidence = &trial.evidence;
                    evidence.explains(&trial.profile, &cause.mistakes, index)
                };
                index.is_some_and(explains)
            });
            broken = others;
            if !laws.is_empty() {
                findings.push(Finding {
                    cause: Some(cause),
                    laws,
                });
            }
        }
        if !broken.is_empty() {
            for report in reports {
                if let Verdict::Broken { smallest, .. } = &mut report.verdict {
                    let fits = |fault: &Fault| {
                        smallest.fits(&trial.profile, *fault)
                            && trial.evidence.is_suspect(&trial.profile, *fault)
                    };
                    smallest.suspects = Fault::all().filter(fits).collect();
                }
            }
            findings.push(Finding {
                cause: None,
                laws: broken,
            });
        }
        Ok(findings)
    }

    /// Whether colors depend on what was asked before, or on nothing that is known: the likelier first.
    fn state(
        &self,
        trial: &mut Trial,
        reports: &[LawReport],
    ) -> Result<Option<&'static [Mistake]>, String> {
        let of_state = |law: &&LawReport| ["repeatable", "no_memory"].contains(&law.name);
        let broken = reports
            .iter()
            .filter(of_state)
            .find_map(|law| match &law.verdict {
                Verdict::Broken { smallest, .. } => Some(smallest),
                _ => None,
            });
        let (Some(case), Some(law)) = (broken, LAWS.first()) else {
            return Ok(None);
        };
        if trial.is_fickle {
            return Ok(Some(&[Mistake::NotRepeatable]));
        }
        if self.shrinks == 0 {
            // nothing more may be asked; what repeats after as many scenes as there are in a batch looks the same
            return Ok(Some(&[Mistake::Leak, Mistake::NotRepeatable]));
        }
        // the same scene again and again: the last ones follow themselves
        let scene = &case.case.scene;
        let mut other = scene.clone();
        other.lights.clear();
        let mut asked = vec![other];
        asked.extend(std::iter::repeat_n(scene.clone(), 8));
        let replies = trial.ask(&self.tried(law), &asked)?;
        let differs = |a: f64, b: f64| {
            let size = a.abs().max(b.abs());
            (a - b).abs() > 64.0 * trial.profile.roundoff * size
        };
        let last = replies[8];
        let is_settled = replies[2..].iter().all(|color| {
            let mut channels = color.iter().zip(&last);
            !channels.any(|(a, b)| differs(*a, *b))
        });
        Ok(Some(if is_settled {
            &[Mistake::Leak]
        } else {
            &[Mistake::NotRepeatable]
        }))
    }
}

/// A run of the laws over scenes that are there already.
#[doc(hidden)]
pub struct Prepared {
    laws: Laws,
    /// The cases of each law.
    batches: Vec<Vec<Arc<Batch>>>,
    coverage: Coverage,
}

impl Prepared {
    /// The report of [`Laws::run`] about a renderer of the profile.
    ///
    /// # Errors
    ///
    /// As [`Laws::run`].
    pub fn run(&self, renderer: &mut impl Renderer) -> Result<Report, String> {
        self.laws.run_over(renderer, &mut |_| {}, Some(self))
    }
}

/// Puts a renderer to the laws, and panics with the report if one is broken.
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
    match Laws::new().run(&mut renderer) {
        Ok(report) if !report.passes() => panic!("{report}"),
        Ok(_) => {}
        Err(error) => panic!("{error}"),
    }
}
