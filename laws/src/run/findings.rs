//! What a run concludes: what depends on what was asked before, what the cause is, and where the colors are wrong.

use std::slice;
use std::time::Duration;

use super::{Failure, IsSo, Run};
use crate::cause::Cause;
use crate::edit::EDITS;
use crate::evidence::FEW;
use crate::experiment;
use crate::formula::Formula;
use crate::law::Law;
use crate::mistakes::formula;
use crate::place::{self, Place};
use crate::plan::Case;
use crate::profile::Profile;
use crate::report::{Counterexample, Finding};
use crate::scene::{Scene, Triple};
use crate::search::{self, Search};

/// The most broken cases that are placed.
const MOST_BROKEN: usize = 600;

impl Run<'_> {
    /// The broken laws with what is known of their cause: what depends on what was asked before, and all else.
    pub(super) fn findings(&mut self) -> Vec<Finding> {
        let broken = self.failures.keys().map(|law| law.name());
        let (mut of_state, laws): (Vec<_>, Vec<_>) =
            broken.partition(|name| *name == Law::NoMemory.name());
        let explains = self.plan.laws.explains;
        let cause = explains.then(|| self.evidence.cause()).flatten();
        let history = self.history();
        let is_fickle =
            !of_state.is_empty() || history.is_some() || self.is_right_again() == Some(true);
        // what is remembered looks like few digits, too
        let cause = cause.filter(|it| !is_fickle || it.then.is_some());
        let mut findings = Vec::new();
        if is_fickle {
            if cause.is_none() || of_state.is_empty() {
                of_state.extend(&laws);
            }
            findings.push(Finding {
                cause: Some(Cause::state()),
                laws: of_state,
                ..history.unwrap_or_default()
            });
        }
        if !laws.is_empty() && (cause.is_some() || !is_fickle) {
            let is_finite = !laws.contains(&Law::Finite.name());
            let finding = |(cause, places): (Option<Cause>, Vec<Place>)| {
                // a color that is not finite breaks a law whatever is declared, and digits that one place lacks
                // are needed elsewhere
                let is_everywhere = places.iter().all(|it| it.only_with.is_empty());
                let may = |it: &Cause| is_finite && (is_everywhere || it.then.is_some());
                let declared = cause.as_ref().filter(|it| may(it));
                let declare = declared.and_then(|it| it.declare.clone());
                Finding {
                    cause: cause.map(|it| Cause { declare, ..it }),
                    places,
                    laws: laws.clone(),
                    ..Finding::default()
                }
            };
            findings.extend(self.placed(cause).into_iter().map(finding));
        }
        findings
    }

    /// Causes with their places: one, or two where one mistake is known and something else is wrong without it.
    fn placed(&mut self, mut cause: Option<Cause>) -> Vec<(Option<Cause>, Vec<Place>)> {
        let (plan, scenes) = (self.plan, self.broken());
        let places = self.places(&plan.profile, &scenes).unwrap_or_default();
        let is_whole = |it: &Cause| it.of > 0 && it.is_nearly_all();
        if !plan.laws.explains || cause.as_ref().is_some_and(is_whole) {
            return vec![(cause, places)];
        }
        let is_vague = matches!(&places[..], [place] if place.is_general());
        let parts = self.evidence.parts();
        let candidates: Vec<Cause> = cause.iter().chain(parts).cloned().collect();
        for part in candidates {
            let Some(then) = part.then.as_deref() else {
                continue;
            };
            let rest = self.evidence.rest(then);
            let left: Vec<Scene> = rest.wrong.iter().map(|(it, _)| it.clone()).collect();
            let other = rest.whole();
            if left.len() < FEW || other.is_none() && !is_vague {
                continue;
            }
            let others = self.places(then, &left).unwrap_or_default();
            let of_part = places_of_mistake(&scenes, &plan.profile, then);
            // what gives the same where one more thing is missing is no other mistake: so m + 2 is 3m at 1
            let is_within = |it: &Place| of_part.iter().any(|part| it.is_within(part));
            let is_same = |it: &Place| it.is_general() || is_within(it);
            let is_sure = part.is_half() || other.is_some();
            // the parts of one thing are one mistake
            let mut all = [&of_part[..], &others].concat();
            place::merge(&mut all);
            if all.len() > 1 && (is_sure || !others.iter().any(is_same)) {
                return vec![(Some(part), of_part), (other, others)];
            }
            if other.is_some() {
                cause.get_or_insert(part);
            }
        }
        vec![(cause, places)]
    }

    /// What a failed case shows after these scenes, of a renderer that has forgotten all others: nothing if its
    /// color is right there. None if the renderer cannot forget.
    #[allow(clippy::option_option)] // an answer, and what it shows
    fn after(&mut self, before: &[Scene], failure: &Failure) -> Option<Option<Counterexample>> {
        if self.is_over || !self.renderer.begin_again().unwrap_or(false) {
            return None;
        }
        let scenes = [before, slice::from_ref(&failure.case.scene)].concat();
        let colors = self.ask(&scenes)?;
        let (linear, last) = (failure.case.linear, [*colors.last()?]);
        let broken = failure.law.broken(&self.right, linear, &last);
        Some(broken.map(|broken| self.told(scenes, colors, broken)))
    }

    /// The first case that is wrong by itself, or so it seems, of those with the fewest lights: what is remembered
    /// from one light to the next is wrong by itself, too.
    fn first(&self) -> Option<Failure> {
        let (_, failures) = self.failures.range(..Law::NoMemory).next()?;
        let fewest = failures.iter().min_by_key(|it| it.case.scene.lights.len());
        fewest.cloned()
    }

    /// That a color is right where nothing is asked before, with the scenes after which it is wrong, if few are
    /// found. A renderer that cannot forget does not show it.
    fn history(&mut self) -> Option<Finding> {
        let failure = self.first()?;
        if self.after(&[], &failure)?.is_some() {
            return None;
        }
        let until = self.now() + self.time_of_search();
        let cases = self.plan.cases.iter();
        let before = cases.take_while(|case| case.scene != failure.case.scene);
        let mut before: Vec<Scene> = before.flat_map(Case::scenes).collect();
        let mut found: Option<Counterexample> = None;
        // one half is enough, as long as one scene is the reason
        while found.as_ref().is_none_or(|it| it.scenes.len() > 2) && self.now() < until {
            let latter = before.split_off(before.len() / 2);
            let mut halves = [latter, std::mem::take(&mut before)].into_iter();
            let wrong = |half: Vec<Scene>| Some((self.after(&half, &failure)??, half));
            let Some((shown, half)) = halves.find_map(wrong) else {
                break;
            };
            (found, before) = (Some(shown), half);
        }
        Some(Finding {
            is_right_alone: true,
            own: found.filter(|it| it.scenes.len() <= 8),
            ..Finding::default()
        })
    }

    /// Whether what was wrong is right when it is asked again, so that it depends on what was asked before.
    fn is_right_again(&mut self) -> Option<bool> {
        let first = self.failures.values().filter_map(|of_law| of_law.first());
        let first: Vec<Failure> = first.cloned().collect();
        let cases: Vec<Case> = first.iter().map(|it| it.case.clone()).collect();
        let replies = self.replies(&cases)?;
        let again = first.iter().zip(&replies);
        let again = again.filter_map(|(it, replies)| self.failure(it.law, &it.case, replies));
        Some(again.count() * 2 < first.len())
    }

    /// Some of the scenes whose colors are wrong, of each law as many.
    fn broken(&self) -> Vec<Scene> {
        // what is remembered has no place, and is the last law
        let of_law = self.failures.range(..Law::NoMemory);
        let of_law: Vec<&Vec<Failure>> = of_law.map(|(_, failures)| failures).collect();
        let most = MOST_BROKEN / of_law.len().max(1);
        let some = of_law.into_iter().flat_map(|of| search::some(of, most));
        some.map(|failure| failure.case.scene).collect()
    }

    /// Where the colors of these scenes are wrong for a renderer that says this of itself.
    fn places(&mut self, profile: &Profile, scenes: &[Scene]) -> Option<Vec<Place>> {
        if self.is_over {
            return None;
        }
        // so many cases without each of so many things
        let asked = self.time_of_search().as_micros() * self.progress.asked as u128;
        let most = asked / self.waited.as_micros().max(1) / EDITS.len() as u128;
        let most =
            usize::try_from(most).map_or(experiment::MOST, |it| it.clamp(2, experiment::MOST));
        let right = formula(profile, None);
        let mut ask = |scenes: &[Scene]| {
            // with time left for the first experiment, what others would find is left out
            if self.left().is_some_and(|left| left.is_zero()) {
                return None;
            }
            let mut are_wrong = Vec::new();
            for some in scenes.chunks(256) {
                let replies = self.ask(some)?;
                let answers = some.iter().zip(replies);
                are_wrong.extend(answers.map(|(scene, reply)| is_broken(&right, scene, reply)));
            }
            Some(are_wrong)
        };
        let ask = &mut ask;
        Search { most, profile, ask }.places(scenes, &[])
    }

    /// Gives each of two findings of one law a scene in which the other makes no difference.
    pub(super) fn show_apart(&mut self, findings: &mut [Finding], until: Duration) {
        let plan = self.plan;
        let [.., first, second] = findings else {
            return;
        };
        let then = first.cause.as_ref().and_then(|cause| cause.then.clone());
        let Some(then) = then.filter(|_| first.laws == second.laws) else {
            return;
        };
        let (right, with_first) = (formula(&plan.profile, None), formula(&then, None));
        let is_first = |scene: &Scene, color: Triple| with_first.fits(scene, color) == Some(true);
        let mut shown = |is_so: &IsSo| self.smallest(Law::Formula, until, is_so);
        first.own = shown(&|it| is_first(&it.case.scene, it.replies[0]));
        second.own = shown(&|it| is_first(&it.case.scene, right.reply(&it.case.scene)));
    }
}

/// Whether a color breaks a law by itself.
fn is_broken(right: &Formula, scene: &Scene, reply: Triple) -> bool {
    let linear = right.linear(scene);
    let mut alone = [Law::Finite, Law::Formula].into_iter();
    alone.any(|law| law.broken(right, linear, &[reply]).is_some())
}

/// Where the colors would be wrong if nothing else were wrong than what a profile says in addition.
fn places_of_mistake(scenes: &[Scene], profile: &Profile, then: &Profile) -> Vec<Place> {
    let (right, wrong) = (formula(profile, None), formula(then, None));
    let is_wrong = |scene: &Scene| is_broken(&right, scene, wrong.reply(scene));
    let scenes: Vec<Scene> = scenes.iter().filter(|it| is_wrong(it)).cloned().collect();
    let mut ask = |scenes: &[Scene]| Some(scenes.iter().map(is_wrong).collect());
    let (most, ask) = (experiment::MOST, &mut ask);
    let places = Search { most, profile, ask }.places(&scenes, &[]);
    places.unwrap_or_default()
}
