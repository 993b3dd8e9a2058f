//! What is wrong is found, and named.

use std::collections::BTreeSet;

use shading_laws::{Laws, Light, Mistake, Profile, Renderer, Report, Scene, Triple, from_fn};

use crate::by_hand::{self, renderer};
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
        | Mistake::LevelsTruncated => profiles::bytes(),
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
    let report = report(&mut renderer(&profiles::linear(), &both));
    assert_eq!(report.causes, [both]);
}

/// An error of a hundred-thousandth is too much for `f32`.
#[test]
fn a_small_deviation_is_found() {
    let of = profiles::linear();
    let mut brighter = from_fn(of.clone(), move |scene| {
        by_hand::shade(scene, &of, &[]).map(|c| c * 1.000_01)
    });
    let report = report(&mut brighter);
    assert!(broken(&report).contains("formula"), "{report}");
    assert!(report.causes.is_empty(), "{report}");
}

/// A way to be wrong that is not a known mistake, and the law that it breaks.
fn breaks(law: &str, mut color: impl FnMut(&Scene, Triple) -> Triple) {
    let of = profiles::linear();
    let mut renderer = from_fn(of.clone(), move |scene| {
        let right = by_hand::shade(scene, &of, &[]);
        color(scene, right)
    });
    let report = report(&mut renderer);
    assert!(broken(&report).contains(law), "{law} holds:\n{report}");
}

/// Each known mistake is found and named. No law is there for show: each is broken by one of the
/// mistakes, or by one of the deviations here.
#[test]
fn each_mistake_is_named_and_every_law_can_be_broken() {
    let mut previous = 0.0;
    breaks("no_memory", |_, color| {
        let first = std::mem::replace(&mut previous, color[0]);
        [color[0] + 0.01 * first, color[1], color[2]]
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
    let by_others = [
        "no_memory",
        "order",
        "eye",
        "rotation",
        "both_reversed",
        "translation",
        "shininess",
        "wider_cone",
    ];
    let mut found = BTreeSet::from(by_others);

    let mut unnamed = Vec::new();
    for &mistake in Mistake::ALL {
        let report = report(&mut renderer(&profile_that_shows(mistake), &[mistake]));
        if !report.is_broken() || report.causes != [[mistake]] {
            unnamed.push(format!("{mistake:?}: {:?}\n{report}", report.causes));
        }
        found.extend(broken(&report));
    }
    assert!(unnamed.is_empty(), "{}", unnamed.join("\n"));
    let names = Laws::names().map(|(name, _)| name);
    let never: Vec<&str> = names.filter(|name| !found.contains(name)).collect();
    assert!(never.is_empty(), "never broken: {never:?}");
}
