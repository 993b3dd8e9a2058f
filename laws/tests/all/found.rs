//! What is wrong is found, and named.

use std::collections::BTreeSet;
use std::time::Duration;

use shading_laws::{
    Fault, Laws, Light, Mistake, Profile, Renderer, Report, Scene, Triple, from_fn,
};

use crate::by_hand::{self, Plan, renderer};
use crate::profiles;

fn report(renderer: &mut impl Renderer) -> Report {
    Laws::new().cases(100).run(renderer).expect("an answer")
}

/// The kind of renderer in which the mistake shows.
fn profile_that_shows(mistake: Mistake) -> Profile {
    match mistake {
        Mistake::SrgbTwice
        | Mistake::SrgbForgotten
        | Mistake::Gamma22ForSrgb
        | Mistake::LevelsTruncated
        | Mistake::LevelsOverflow => profiles::bytes(),
        Mistake::EachLightClamped => profiles::clamped(),
        _ => profiles::linear(),
    }
}

/// The laws that a renderer breaks.
fn broken(report: &Report) -> BTreeSet<&'static str> {
    let broken = report.laws.iter().filter(|law| law.is_broken());
    broken.map(|law| law.name).collect()
}

#[test]
fn two_mistakes_are_named_together() {
    let both = [Mistake::HighlightNotGated, Mistake::SquaredDistance];
    let report = report(&mut renderer(&profiles::linear(), both));
    let cause = report.findings[0].cause.as_ref().expect("a cause");
    assert_eq!(cause.mistakes, both.map(Fault::from), "{report}");
}

/// An error of a hundred-thousandth is too much for `f32`.
#[test]
fn a_small_deviation_is_found() {
    let of = profiles::linear();
    let mut brighter = from_fn(of.clone(), move |scene| {
        by_hand::shade::<f32>(scene, &of, &Plan::default()).map(|c| c * 1.000_01)
    });
    let report = report(&mut brighter);
    assert!(broken(&report).contains("formula"), "{report}");
    assert!(report.findings[0].cause.is_none(), "{report}");
}

/// A way to be wrong that is not a known mistake, and the law that it breaks.
fn breaks(law: &str, mut color: impl FnMut(&Scene, Triple) -> Triple) {
    let of = profiles::linear();
    let mut renderer = from_fn(of.clone(), move |scene| {
        let right = by_hand::shade::<f32>(scene, &of, &Plan::default());
        color(scene, right)
    });
    let report = report(&mut renderer);
    assert!(broken(&report).contains(law), "{law} holds:\n{report}");
}

/// No law is there for show: each is broken by a known mistake, or by one of these deviations.
#[test]
fn every_law_can_be_broken() {
    let mut previous = 0.0;
    breaks("no_memory", |_, color| {
        let first = std::mem::replace(&mut previous, color[0]);
        [color[0] + 0.01 * first, color[1], color[2]]
    });
    let mut count = 0.0;
    breaks("repeatable", |_, color| {
        count += 0.001;
        color.map(|c| c * (1.0 + count % 0.1))
    });
    breaks("order", |scene, color| {
        let first = scene.lights.first();
        color.map(|c| c + 0.01 * first.map_or(0.0, |light| light.intensity()[0]))
    });
    breaks("eye", |scene, color| {
        color.map(|c| c * (1.0 + 0.01 * scene.v[2]))
    });
    breaks("rotation", |scene, color| {
        color.map(|c| c * (1.0 + 0.01 * scene.n[1].abs()))
    });
    breaks("both_reversed", |scene, color| {
        color.map(|c| c * (1.0 + 0.01 * scene.n[1]))
    });
    breaks("translation", |scene, color| {
        color.map(|c| c * (1.0 + 0.01 * scene.p[0]))
    });
    breaks("shininess", |scene, color| {
        color.map(|c| c * scene.material.m)
    });
    breaks("wider_cone", |scene, color| match scene.lights.first() {
        Some(Light::Spot { half_angle, .. }) => color.map(|c| c * (2.0 - half_angle)),
        _ => color,
    });
    let mut found = BTreeSet::from([
        "no_memory",
        "repeatable",
        "order",
        "eye",
        "rotation",
        "both_reversed",
        "translation",
        "shininess",
        "wider_cone",
    ]);
    let laws = Laws::new().cases(32).shrinking(0, Duration::ZERO);
    'all: for profile in [profiles::clamped(), profiles::bytes(), profiles::linear()] {
        let prepared = laws.prepared(&profile);
        let shown = Mistake::ALL.iter().copied();
        for mistake in shown.filter(|mistake| profile_that_shows(*mistake) == profile) {
            if found.len() == Laws::names().count() {
                break 'all;
            }
            let report = prepared.run(&mut renderer(&profile, [mistake]));
            found.extend(broken(&report.expect("colors")));
        }
    }
    let names = Laws::names().map(|(name, _)| name);
    let never: Vec<&str> = names.filter(|name| !found.contains(name)).collect();
    assert!(never.is_empty(), "never broken: {never:?}");
}

/// A declaration that no scene can show is no pass.
#[test]
fn what_is_declared_is_exercised() {
    let profile = Profile {
        most_lights: 4000,
        ..profiles::linear()
    };
    let report = report(&mut renderer(&profile, []));
    assert!(!report.is_broken() && !report.passes(), "{report}");
    let text = report.to_string();
    assert!(
        text.contains("NOT exercised, so this is no pass: 1024 of 4000 lights in a scene"),
        "{text}"
    );
}
