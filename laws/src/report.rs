//! What a run found, as text and as JSON.

use std::fmt;

use serde_json::{Value, json};

use crate::mistake::Mistake;
use crate::profile::Profile;
use crate::scene::{Light, Scene, Triple};

/// What a run found. Its text is a table of the laws, then each broken law with its smallest
/// scenes.
#[derive(Clone, Debug)]
pub struct Report {
    /// What the renderer said of itself.
    pub profile: Profile,
    /// The seed of the scenes.
    pub seed: u64,
    /// Every law.
    pub laws: Vec<LawReport>,
    /// The known mistakes, each alone or two together, with which the formulas give every color of
    /// the run. Several entries are alternatives.
    pub causes: Vec<Vec<Mistake>>,
}

/// What was found of one law.
#[derive(Clone, Debug)]
pub struct LawReport {
    /// Its name.
    pub name: &'static str,
    /// What it says.
    pub says: &'static str,
    /// Whether it holds.
    pub verdict: Verdict,
}

/// Whether a law holds.
#[derive(Clone, Debug)]
pub enum Verdict {
    /// It holds in every case.
    Holds {
        /// The number of cases.
        cases: usize,
    },
    /// It does not.
    Broken {
        /// The number of cases.
        cases: usize,
        /// The number of cases in which it does not hold.
        failures: usize,
        /// The smallest case that was found.
        smallest: Box<Counterexample>,
    },
    /// The renderer lacks what the law needs.
    NotTried {
        /// What it lacks.
        because: &'static str,
    },
}

/// A case in which a law does not hold.
#[derive(Clone, Debug)]
pub struct Counterexample {
    /// The scenes, as the renderer got them.
    pub scenes: Vec<Scene>,
    /// The color of each.
    pub colors: Vec<Triple>,
    /// What should hold between the colors.
    pub claim: &'static str,
    /// The channel in which it does not: 0 for red, 1 for green, 2 for blue.
    pub channel: usize,
    /// How far the channel is off.
    pub off: f64,
    /// How far rounding may put it off.
    pub allowed: f64,
    /// The known mistakes that give these colors.
    pub suspects: Vec<Mistake>,
}

impl LawReport {
    /// Whether the law is broken.
    #[must_use]
    pub fn is_broken(&self) -> bool {
        matches!(self.verdict, Verdict::Broken { .. })
    }
}

impl Report {
    /// Whether a law is broken.
    #[must_use]
    pub fn is_broken(&self) -> bool {
        self.laws.iter().any(LawReport::is_broken)
    }

    /// The report as one JSON object.
    ///
    /// ```
    /// use shading_laws::{Laws, Profile, from_fn};
    ///
    /// let mut black = from_fn(Profile::default(), |_scene| [0.0; 3]);
    /// let json = Laws::new().cases(20).run(&mut black).unwrap().to_json();
    /// assert!(json.starts_with(r#"{"renderer":"the renderer","broken":true,"#));
    /// ```
    #[must_use]
    pub fn to_json(&self) -> String {
        let words = |mistakes: &[Mistake]| -> Value {
            mistakes.iter().map(|mistake| mistake.name()).collect()
        };
        let laws = self.laws.iter().map(|law| match &law.verdict {
            Verdict::Holds { cases } => {
                json!({"law": law.name, "verdict": "holds", "cases": cases})
            }
            Verdict::NotTried { because } => {
                json!({"law": law.name, "verdict": "not tried", "because": because})
            }
            Verdict::Broken {
                cases,
                failures,
                smallest,
            } => json!({
                "law": law.name,
                "verdict": "broken",
                "cases": cases,
                "failures": failures,
                "smallest": {
                    "claim": smallest.claim,
                    "scenes": smallest.scenes.iter().map(Scene::json).collect::<Value>(),
                    "colors": smallest.colors,
                    "channel": smallest.channel,
                    "off": smallest.off,
                    "allowed": smallest.allowed,
                    "suspects": words(&smallest.suspects),
                },
            }),
        });
        json!({
            "renderer": self.profile.name,
            "broken": self.is_broken(),
            "seed": self.seed,
            "laws": laws.collect::<Value>(),
            "causes": self.causes.iter().map(|cause| words(cause)).collect::<Value>(),
        })
        .to_string()
    }
}

impl Scene {
    /// The scene as one line of JSON, its members always in the same order. The format is that of the
    /// program `shading-laws`.
    #[must_use]
    pub fn to_json(&self) -> String {
        self.json().to_string()
    }

    fn json(&self) -> Value {
        let light = |light: &Light| match light {
            Light::Directional { l, intensity } => {
                json!({"kind": light.kind(), "intensity": intensity, "l": l})
            }
            Light::Point {
                position,
                intensity,
                attenuation,
            } => json!({
                "kind": light.kind(),
                "intensity": intensity,
                "position": position,
                "attenuation": attenuation,
            }),
            Light::Spot {
                position,
                intensity,
                attenuation,
                axis,
                half_angle,
            } => json!({
                "kind": light.kind(),
                "intensity": intensity,
                "position": position,
                "attenuation": attenuation,
                "axis": axis,
                "angle": half_angle,
            }),
        };
        let material = &self.material;
        json!({
            "model": self.model.name(),
            "p": self.p,
            "n": self.n,
            "v": self.v,
            "k_a": material.k_a,
            "k_d": material.k_d,
            "k_s": material.k_s,
            "m": material.m,
            "i_a": self.i_a,
            "lights": self.lights.iter().map(light).collect::<Value>(),
        })
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let width = self.laws.iter().map(|law| law.name.len()).max();
        let width = width.unwrap_or(0);
        writeln!(f, "{}, seed {}\n", self.profile.name, self.seed)?;
        writeln!(f, "{:width$}  cases  verdict", "law")?;
        for law in &self.laws {
            write!(f, "{:width$}  ", law.name)?;
            match &law.verdict {
                Verdict::Holds { cases } => writeln!(f, "{cases:5}  holds")?,
                Verdict::NotTried { because } => writeln!(f, "    –  not tried: {because}")?,
                Verdict::Broken {
                    cases, failures, ..
                } => writeln!(f, "{cases:5}  BROKEN in {failures}")?,
            }
        }
        match &self.causes[..] {
            [] => {}
            causes => {
                let all = "every color of this run is that of the formulas with this mistake:";
                writeln!(f, "\nLikely cause: {all}")?;
                for (i, cause) in causes.iter().enumerate() {
                    let words: Vec<&str> = cause.iter().map(|mistake| mistake.name()).collect();
                    let or = if i == 0 { "" } else { "or: " };
                    writeln!(f, "  {or}{}", words.join("; and "))?;
                }
            }
        }
        let broken = self.laws.iter().filter_map(|law| match &law.verdict {
            Verdict::Broken { smallest, .. } => Some((law, smallest)),
            _ => None,
        });
        for (law, smallest) in broken {
            write!(f, "\n{}: {}\n{smallest}", law.name, law.says)?;
        }
        Ok(())
    }
}

impl fmt::Display for Counterexample {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let channel = ["red", "green", "blue"][self.channel];
        let Self {
            claim,
            off,
            allowed,
            ..
        } = self;
        writeln!(f, "  expected: {claim}")?;
        for (i, color) in self.colors.iter().enumerate() {
            writeln!(f, "  color {}: {color:?}", i + 1)?;
        }
        if off.is_finite() {
            writeln!(
                f,
                "  {channel} is off by {off:.3e}; rounding explains {allowed:.1e}"
            )?;
        } else {
            writeln!(f, "  {channel} is {off}")?;
        }
        for suspect in self.suspects.iter().take(3) {
            writeln!(f, "  it fits that {suspect}")?;
        }
        writeln!(f, "  to reproduce it:")?;
        writeln!(f, "    let scenes = [")?;
        for scene in &self.scenes {
            let scene = scene.to_string().replace('\n', "\n        ");
            writeln!(f, "        {scene},")?;
        }
        writeln!(f, "    ];")?;
        writeln!(f, "    let colors = renderer.shade(&scenes)?;")
    }
}
