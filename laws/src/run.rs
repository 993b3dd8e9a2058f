//! Puts a renderer to the laws.

use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

use crate::law::{LAWS, Law};
use crate::renderer::Renderer;
use crate::report::{LawReport, Report};
use crate::trial::Trial;

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
    /// The law is broken, and its smallest scene is being looked for.
    pub shrinking: bool,
}

impl Laws {
    /// All laws, with 256 cases of each, from seed 0.
    #[must_use]
    pub fn new() -> Self {
        Self {
            seed: 0,
            cases: 256,
            only: Vec::new(),
        }
    }

    /// The seed of the scenes.
    #[must_use]
    pub fn seed(self, seed: u64) -> Self {
        Self { seed, ..self }
    }

    /// The number of cases of each law.
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

        let mut trial = Trial::new(renderer, profile);
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
            report(false);
            let runner = self.runner(law);
            let verdict = trial.of(law, self.cases, runner, &mut || report(true))?;
            reports.push(LawReport {
                name: law.name,
                says: law.says,
                verdict,
            });
        }
        let causes = if reports.iter().any(LawReport::is_broken) {
            trial.causes()
        } else {
            Vec::new()
        };
        Ok(Report {
            profile: trial.profile,
            seed: self.seed,
            laws: reports,
            causes,
        })
    }

    fn runner(&self, law: &Law) -> TestRunner {
        // every law has scenes of its own, whichever others are tried
        let mut seed = [0; 32];
        seed[..8].copy_from_slice(&self.seed.to_le_bytes());
        for (byte, letter) in seed[8..].iter_mut().zip(law.name.bytes()) {
            *byte = letter;
        }
        TestRunner::new_with_rng(
            Config::default(),
            TestRng::from_seed(RngAlgorithm::ChaCha, &seed),
        )
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
        Ok(report) if report.is_broken() => panic!("{report}"),
        Ok(_) => {}
        Err(error) => panic!("{error}"),
    }
}
