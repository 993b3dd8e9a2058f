//! What a run found, as text and as JSON.

use std::fmt;

use serde::Serialize;

use crate::cause::Cause;
use crate::law::Broken;
use crate::mistakes::departures;
use crate::place::Place;
use crate::profile::Profile;
use crate::scene::{Scene, Triple};

/// What a run found. Its text begins with the findings.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// The version of the report.
    pub(crate) version: u32,
    /// The seed of the scenes.
    pub seed: u64,
    /// What ended the run, or the search for smaller scenes and for places, early.
    pub error: Option<String>,
    /// The broken laws, those together that one cause breaks.
    pub findings: Vec<Finding>,
    /// Every law.
    pub laws: Vec<LawReport>,
    /// What the renderer said of itself.
    pub profile: Profile,
    /// The command that starts the renderer, if it is a program.
    pub command: Option<String>,
}

/// Broken laws that have one cause, or of which none is known.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Finding {
    /// What explains the colors.
    pub cause: Option<Cause>,
    /// What the wrong colors follow; several places where several things are wrong.
    pub places: Vec<Place>,
    /// The names of the laws.
    pub laws: Vec<&'static str>,
    /// The smallest scenes that show it, as the renderer got them.
    pub scenes: Vec<Scene>,
    /// What is shown is right if nothing is asked before.
    #[serde(skip)]
    pub(crate) is_right_alone: bool,
    /// What shows it better than the smallest case of its laws: the scenes after which a color is wrong that is
    /// right without them, or a scene in which nothing else is wrong, where another finding is of the same law.
    #[serde(skip)]
    pub(crate) own: Option<Counterexample>,
}

/// What was found of one law.
#[derive(Clone, Debug, Serialize)]
pub struct LawReport {
    /// Its name.
    pub law: &'static str,
    /// What it says.
    pub says: &'static str,
    /// Whether it holds.
    pub verdict: Verdict,
    /// The number of cases that were tried.
    pub cases: usize,
    /// The number of cases that there are.
    pub of: usize,
    /// The number of cases in which it does not hold.
    pub failures: usize,
    /// The smallest case that was found in which it does not.
    pub smallest: Option<Counterexample>,
}

/// Whether a law holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// It holds in every case.
    Holds,
    /// It does not.
    Broken,
    /// It holds in every case that was tried, but the run ended before all were.
    CutShort,
}

/// A case in which a law does not hold.
#[derive(Clone, Debug, Serialize)]
pub struct Counterexample {
    /// The scenes, as the renderer got them.
    pub scenes: Vec<Scene>,
    /// The color of each.
    pub colors: Vec<Triple>,
    /// The color that the formulas give each.
    pub right: Vec<Triple>,
    /// How the law does not hold.
    #[serde(flatten)]
    pub broken: Broken,
}

impl Finding {
    /// What shows it: the first of its laws that rounding does not explain, because one scene tells nothing of
    /// what is remembered.
    pub(crate) fn shown<'a>(
        &'a self,
        laws: &'a [LawReport],
    ) -> Option<(&'a LawReport, &'a Counterexample)> {
        let of = |name: &&str| laws.iter().find(|law| law.law == *name);
        let of_laws = self.laws.iter().filter_map(of);
        let smallest = of_laws.filter_map(|law| Some((law, law.smallest.as_ref()?)));
        let (law, smallest) = smallest.min_by_key(|(_, it)| !it.broken.is_clear())?;
        Some((law, self.own.as_ref().unwrap_or(smallest)))
    }
}

impl Report {
    fn count(&self, verdict: Verdict) -> usize {
        let laws = self.laws.iter();
        laws.filter(|law| law.verdict == verdict).count()
    }

    /// Whether a law is broken.
    #[must_use]
    pub fn is_broken(&self) -> bool {
        self.count(Verdict::Broken) > 0
    }

    /// Whether the run ended before all cases of a law were tried.
    #[must_use]
    pub fn is_cut_short(&self) -> bool {
        self.count(Verdict::CutShort) > 0
    }

    /// Whether all is well: every law holds, and all cases were tried.
    #[must_use]
    pub fn passes(&self) -> bool {
        self.error.is_none() && !self.is_broken() && !self.is_cut_short()
    }

    /// The report as one JSON object.
    ///
    /// # Panics
    ///
    /// Never: plain data is JSON.
    #[must_use]
    pub fn to_json(&self) -> String {
        let json = serde_json::to_string(self).expect("plain data is JSON");
        format!("{{\"passes\":{},{}", self.passes(), &json[1..])
    }

    /// What gives the colors of these scenes again.
    fn reproduction(&self, scenes: &[Scene]) -> String {
        let lines: Vec<String> = scenes.iter().map(Scene::to_json).collect();
        if let Some(command) = &self.command {
            // a line has neither a quote of this kind nor a backslash
            let lines = lines.join("' '");
            format!("printf '%s\\n' '{{\"shading-laws\":1}}' '{lines}' '' | {command}\n")
        } else {
            let lines = lines.join("\"#)\nScene::from_json(r#\"");
            format!("Scene::from_json(r#\"{lines}\"#)\n")
        }
    }

    fn show(&self, f: &mut fmt::Formatter, finding: &Finding) -> fmt::Result {
        let is_whole = |cause: &&Cause| cause.of == 0 || cause.is_nearly_all();
        let whole = finding.cause.as_ref().filter(is_whole);
        match &finding.cause {
            Some(cause) => {
                let Cause { explained, of, .. } = cause;
                let part = whole.map_or("part of it: ", |_| "");
                writeln!(f, "{part}{}", cause.says)?;
                for other in cause.alternatives.iter().take(3) {
                    writeln!(f, "  or, with the same colors: {other}")?;
                }
                if *of > 0 {
                    writeln!(f, "  This explains {explained} of {of} wrong colors.")?;
                }
                if let Some(declare) = cause.declare.as_ref().filter(|_| whole.is_some()) {
                    writeln!(f, "  If it is on purpose, add to the profile: {declare}")?;
                }
            }
            None => writeln!(f, "no known mistake gives these colors")?,
        }
        for (i, place) in finding.places.iter().enumerate() {
            let other = if i > 0 { "Others are wrong" } else { "Wrong" };
            match place.only_with.join(", ") {
                all if all.is_empty() => writeln!(f, "  {other} in all kinds of scenes alike.")?,
                with => writeln!(f, "  {other} only with: {with}.")?,
            }
            let (few, more) = place.also_without.split_at(place.also_without.len().min(6));
            let dots = if more.is_empty() { "." } else { ", …" };
            if !few.is_empty() {
                writeln!(f, "  Also without: {}{dots}", few.join(", "))?;
            }
        }
        if let Some((law, smallest)) = finding.shown(&self.laws) {
            write!(f, "\n  {}: {}\n{smallest}", law.law, law.says)?;
            let again = self.reproduction(&smallest.scenes);
            let how = match smallest.scenes.len() {
                1 if finding.is_right_alone => {
                    "To reproduce it, run the laws again with this seed.\n  This scene alone has the right color:"
                }
                _ if finding.is_right_alone => {
                    "The last scene alone has the right color.\n  To reproduce it:"
                }
                _ => "To reproduce it:",
            };
            writeln!(f, "  {how}\n{again}")?;
        }
        Ok(())
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let broken = self.count(Verdict::Broken);
        // a terminal obeys control characters
        let name = self.profile.name.escape_debug();
        let (seed, of) = (self.seed, self.laws.len());
        writeln!(f, "{name}, seed {seed}: {broken} of {of} laws broken")?;
        // what stands at the end of a long report is not read
        if let Some(why) = &self.error {
            writeln!(f, "the run ended early: {why}")?;
        }
        writeln!(f)?;
        for (i, finding) in self.findings.iter().enumerate() {
            write!(f, "Finding {} of {}: ", i + 1, self.findings.len())?;
            // the colors of this one were compared as if that one were on purpose
            if i > 0 && self.findings[i - 1].laws == finding.laws {
                write!(f, "with that mended, ")?;
            }
            self.show(f, finding)?;
        }
        for it in &self.laws {
            let (law, cases, failures, left) = (it.law, it.cases, it.failures, it.of - it.cases);
            write!(f, "{law} ")?;
            match it.verdict {
                Verdict::Broken => writeln!(f, "is BROKEN in {failures} of {cases} cases")?,
                Verdict::Holds => writeln!(f, "holds in {cases} cases")?,
                Verdict::CutShort => writeln!(
                    f,
                    "holds in {cases} cases, but the run ended before the other {left}"
                )?,
            }
        }
        if !self.profile.departs.is_empty() {
            writeln!(f, "declared as on purpose:")?;
        }
        for fault in departures(&self.profile).unwrap_or_default() {
            writeln!(f, "  {}: {fault}", fault.name())?;
        }
        Ok(())
    }
}

impl fmt::Display for Counterexample {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Broken { off, allowed, .. } = self.broken;
        let channel = ["red", "green", "blue"][self.broken.channel];
        for (i, (color, right)) in self.colors.iter().zip(&self.right).enumerate() {
            let i = i + 1;
            writeln!(f, "  color {i}: {color:?}; the formula gives {right:?}")?;
        }
        if !off.is_finite() {
            return writeln!(f, "  {channel} is {off}");
        }
        let explained = format!("rounding explains {allowed:.1e}");
        writeln!(f, "  {channel} is off by {off:.3e}; {explained}")
    }
}
