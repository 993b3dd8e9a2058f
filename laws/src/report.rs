//! What a run found, as text and as JSON.

use std::fmt;

use serde_json::{Value, json};

use crate::cause::Cause;
use crate::corpus;
use crate::coverage::Exercised;
use crate::generator::Base;
use crate::mistake::Fault;
use crate::profile::Profile;
use crate::reproduction::Reproduction;
use crate::scene::{Light, Scene, Triple};
use crate::smaller::cost;
use crate::textbook::Textbook;

/// What a run found. Its text is a table of the laws, then each finding with its smallest scenes.
#[derive(Clone, Debug)]
pub struct Report {
    /// What the renderer said of itself.
    pub profile: Profile,
    /// The seed of the scenes.
    pub seed: u64,
    /// Every law.
    pub laws: Vec<LawReport>,
    /// The broken laws, those together that one cause breaks.
    pub findings: Vec<Finding>,
    /// What was exercised of what the renderer says it has. It is empty where laws were chosen.
    pub exercised: Vec<Exercised>,
    /// The laws that are expected to be broken.
    pub known: Vec<String>,
    /// How the text shows a broken case as code to run.
    pub reproduction: Reproduction,
}

/// Broken laws that have one cause, or of which none is known.
#[derive(Clone, Debug)]
pub struct Finding {
    /// What explains the colors.
    pub cause: Option<Cause>,
    /// The names of the laws.
    pub laws: Vec<&'static str>,
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
    /// The known mistakes that give these colors, where nothing explains those of the run.
    pub suspects: Vec<Fault>,
    pub(crate) case: Base,
}

impl Counterexample {
    /// Whether a mistake gives these colors, and the formulas do not.
    pub(crate) fn fits(&self, profile: &Profile, fault: Fault) -> bool {
        let fits = |faults: &[Fault]| {
            let textbook = Textbook::new(profile, faults);
            let colors = self.scenes.iter().zip(&self.colors);
            colors
                .map(|(scene, color)| textbook.fits(scene, *color))
                .collect::<Vec<_>>()
        };
        fits(&[fault]).iter().all(|fits| *fits == Some(true)) && fits(&[]).contains(&Some(false))
    }
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

    /// Whether all is well: no law is broken but those that are known to be, those are, and all that the renderer says
    /// it has was exercised.
    #[must_use]
    pub fn passes(&self) -> bool {
        let is_expected = |law: &LawReport| law.is_broken() == self.is_known(law);
        let in_time = |law: &LawReport| !matches!(law.verdict, Verdict::NotTried { because } if because == "the time is up");
        self.laws.iter().all(|law| is_expected(law) && in_time(law))
            && self.exercised.iter().all(Exercised::is_all)
    }

    pub(crate) fn is_known(&self, law: &LawReport) -> bool {
        self.known.iter().any(|name| name == law.name)
    }

    /// The smallest case of each broken law, one a line, to be stored and given to
    /// [`Laws::replay`](crate::Laws::replay).
    #[must_use]
    pub fn cases(&self) -> String {
        let line = |law: &LawReport| match &law.verdict {
            Verdict::Broken { smallest, .. } => {
                Some(crate::case::write(law.name, &smallest.case) + "\n")
            }
            _ => None,
        };
        self.laws.iter().filter_map(line).collect()
    }

    /// The report in the Test Anything Protocol, version 13: a test for each law, and one for what was exercised.
    #[must_use]
    pub fn to_tap(&self) -> String {
        let mut lines = vec![
            "TAP version 13".to_owned(),
            format!("1..{}", self.laws.len() + 1),
        ];
        for (i, law) in self.laws.iter().enumerate() {
            let (i, name) = (i + 1, law.name);
            let todo = if self.is_known(law) {
                " # TODO known"
            } else {
                ""
            };
            match &law.verdict {
                Verdict::Holds { .. } => lines.push(format!("ok {i} - {name}{todo}")),
                Verdict::NotTried { because } if *because == "the time is up" => {
                    lines.push(format!("not ok {i} - {name}: {because}"));
                }
                Verdict::NotTried { because } => {
                    lines.push(format!("ok {i} - {name} # SKIP {because}"));
                }
                Verdict::Broken { smallest, .. } => {
                    lines.push(format!("not ok {i} - {name}{todo}"));
                    let text = format!("{}\n{smallest}", law.says);
                    lines.extend(text.lines().map(|line| format!("# {line}")));
                }
            }
        }
        let (i, missing) = (self.laws.len() + 1, self.unexercised());
        if missing.is_empty() {
            lines.push(format!("ok {i} - what is declared is exercised"));
        } else {
            lines.push(format!("not ok {i} - what is declared is exercised"));
            lines.extend(missing.iter().map(|what| format!("# {what}")));
        }
        lines.join("\n") + "\n"
    }

    /// What was declared and not exercised, in words.
    pub(crate) fn unexercised(&self) -> Vec<String> {
        let missing = self.exercised.iter().filter(|one| !one.is_all());
        missing.map(ToString::to_string).collect()
    }

    /// The report as one JSON object.
    ///
    /// ```
    /// use shading_laws::{Laws, Profile, from_fn};
    ///
    /// let mut black = from_fn(Profile::default(), |_scene| [0.0; 3]);
    /// let json = Laws::new().cases(20).run(&mut black).unwrap().to_json();
    /// assert!(json.starts_with(r#"{"version":2,"corpus":3,"renderer":"the renderer","passes":false,"#));
    /// ```
    #[must_use]
    pub fn to_json(&self) -> String {
        let words = |faults: &[Fault]| -> Value { faults.iter().map(fault_json).collect() };
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
                "known": self.is_known(law),
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
        let findings = self.findings.iter().map(|finding| {
            let cause = finding.cause.as_ref().map(|cause| {
                let others = cause.alternatives.iter().map(|faults| words(faults));
                json!({
                    "mistakes": words(&cause.mistakes),
                    "explained": cause.explained,
                    "of": cause.of,
                    "alternatives": others.collect::<Value>(),
                })
            });
            json!({"laws": finding.laws, "cause": cause})
        });
        let exercised = self.exercised.iter().map(
            |one| json!({"what": one.what, "exercised": one.exercised, "declared": one.declared}),
        );
        json!({
            "version": 2,
            "corpus": corpus::VERSION,
            "renderer": self.profile.name,
            "passes": self.passes(),
            "broken": self.is_broken(),
            "seed": self.seed,
            "profile": self.profile.json(),
            "exercised": exercised.collect::<Value>(),
            "findings": findings.collect::<Value>(),
            "laws": laws.collect::<Value>(),
        })
        .to_string()
    }
}

fn fault_json(fault: &Fault) -> Value {
    let id = fault.mistake.id();
    if fault.mistake.values().is_empty() {
        json!({"id": id, "says": fault.to_string()})
    } else {
        json!({"id": id, "value": fault.value, "says": fault.to_string()})
    }
}

impl Profile {
    /// What the renderer says of itself, as one line of JSON, with every member of the format.
    #[must_use]
    pub fn to_json(&self) -> String {
        self.json().to_string()
    }

    fn json(&self) -> Value {
        let kinds = [
            ("directional", self.directional_lights),
            ("point", self.point_lights),
            ("spot", self.spot_lights),
        ];
        let kinds = kinds
            .into_iter()
            .filter_map(|(kind, has)| has.then_some(kind));
        json!({
            "name": self.name,
            "roundoff": self.roundoff,
            "models": self.models.iter().map(|model| model.name()).collect::<Value>(),
            "ambient": self.ambient,
            "lights": kinds.collect::<Value>(),
            "most_lights": self.most_lights,
            "most_shiny": self.most_shiny,
            "integer_shininess": self.integer_shininess,
            "unit_vectors": self.unit_vectors,
            "clamps": self.clamps,
            "srgb": self.srgb,
            "bits": self.bits,
            "whole_angle": self.whole_angle,
            "attenuated_ambient": self.attenuated_ambient,
            "unattenuated_highlight": self.unattenuated_highlight,
            "highlight_on_the_dark_side": self.highlight_on_the_dark_side,
            "normal_faces_eye": self.normal_faces_eye,
            "black_without_lights": self.black_without_lights,
            "unlit_without_lights": self.unlit_without_lights,
            "unattenuated": self.unattenuated,
            "gray_highlight": self.gray_highlight,
            "spot_exponent": self.spot_exponent,
            "ambient_times_diffuse": self.ambient_times_diffuse,
        })
    }
}

impl Scene {
    /// The scene as one line of JSON, its members always in the same order. The format is that of the
    /// program `shading-laws`.
    #[must_use]
    pub fn to_json(&self) -> String {
        self.json().to_string()
    }

    pub(crate) fn json(&self) -> Value {
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
        writeln!(f, "{}, seed {}\n", printable(&self.profile.name), self.seed)?;
        writeln!(f, "{:width$}  cases  verdict", "law")?;
        for law in &self.laws {
            let known = match (self.is_known(law), law.is_broken()) {
                (false, _) => "",
                (true, true) => ", as is known",
                (true, false) => ", but is known as broken",
            };
            write!(f, "{:width$}  ", law.name)?;
            match &law.verdict {
                Verdict::Holds { cases } => writeln!(f, "{cases:5}  holds{known}")?,
                Verdict::NotTried { because } => writeln!(f, "    –  not tried: {because}")?,
                Verdict::Broken {
                    cases, failures, ..
                } => writeln!(f, "{cases:5}  BROKEN in {failures}{known}")?,
            }
        }
        let of_size = |what: &str| ["lights in a scene", "shininess"].contains(&what);
        let sizes = self.exercised.iter().filter(|one| of_size(one.what));
        let sizes: Vec<String> = sizes.map(ToString::to_string).collect();
        if !sizes.is_empty() {
            writeln!(f, "\nExercised: {}", sizes.join(", "))?;
        }
        for what in self.unexercised() {
            writeln!(f, "NOT exercised, so this is no pass: {what}")?;
        }
        for (i, finding) in self.findings.iter().enumerate() {
            self.show(f, i, finding)?;
        }
        Ok(())
    }
}

impl Report {
    fn show(&self, f: &mut fmt::Formatter, i: usize, finding: &Finding) -> fmt::Result {
        let count = self.findings.len();
        writeln!(
            f,
            "\nFinding {} of {count}: {}",
            i + 1,
            finding.laws.join(", ")
        )?;
        let mut broken: Vec<(&LawReport, &Counterexample)> = self
            .laws
            .iter()
            .filter(|law| finding.laws.contains(&law.name))
            .filter_map(|law| match &law.verdict {
                Verdict::Broken { smallest, .. } => Some((law, &**smallest)),
                _ => None,
            })
            .collect();
        broken.sort_by_key(|(_, smallest)| (smallest.scenes.len(), cost(&smallest.case)));
        if let Some(cause) = &finding.cause {
            writeln!(f, "Likely cause: {}", words(&cause.mistakes))?;
            for other in &cause.alternatives {
                writeln!(f, "  or: {}", words(other))?;
            }
            // rounded down: 100 % means all
            if let Some(share) = (100 * cause.explained).checked_div(cause.of) {
                let Cause { explained, of, .. } = cause;
                writeln!(
                    f,
                    "  It explains {share} % of the wrong colors: {explained} of {of}."
                )?;
            }
            // one law shows it
            broken.truncate(1);
        } else {
            writeln!(f, "No known mistake explains these colors.")?;
        }
        for (i, (law, smallest)) in broken.into_iter().enumerate() {
            write!(f, "\n{}: {}\n{smallest}", law.name, law.says)?;
            if i == 0 {
                f.write_str(&self.reproduction.of(&smallest.scenes))?;
            }
        }
        Ok(())
    }
}

fn words(faults: &[Fault]) -> String {
    let words: Vec<String> = faults.iter().map(ToString::to_string).collect();
    words.join("; and ")
}

/// A text without control characters.
pub(crate) fn printable(text: &str) -> String {
    let escaped = |c: char| {
        if c.is_control() {
            c.escape_default().collect()
        } else {
            c.to_string()
        }
    };
    text.chars().map(escaped).collect()
}

impl fmt::Display for Exercised {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self {
            what,
            exercised,
            declared,
        } = self;
        match *what {
            "lights in a scene" => write!(f, "{exercised} of {declared} {what}"),
            "shininess" => write!(f, "{what} up to {exercised} of {declared}"),
            _ => write!(f, "{what}"),
        }
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
        writeln!(f, "  the scenes as lines of the format:")?;
        for scene in &self.scenes {
            writeln!(f, "{}", scene.to_json())?;
        }
        Ok(())
    }
}
