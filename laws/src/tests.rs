//! Every known mistake, planted: it is found, named and placed.

use std::collections::BTreeSet;

use crate::bounded::Bounded3;
use crate::corpus;
use crate::formula::{Formula, Part};
use crate::generator;
use crate::law::LAWS;
use crate::mistakes::{Fault, MISTAKES, SCOPES};
use crate::plan::Plan;
use crate::random::Random;
use crate::{Laws, Light, Model, Profile, Report, Scene, from_fn};

fn single() -> Profile {
    Profile {
        most_shiny: 1024.0,
        ..Profile::default()
    }
}

fn double() -> Profile {
    Profile {
        roundoff: f64::EPSILON / 2.0,
        ..single()
    }
}

fn bytes() -> Profile {
    Profile {
        srgb: true,
        bits: Some(8),
        ..single()
    }
}

fn scenes(profile: &Profile, count: u64) -> impl Iterator<Item = Scene> {
    (0..count).map(|seed| generator::case(profile, &mut Random::new(seed, "tests")).scene)
}

/// A renderer that makes these mistakes, in the arithmetic of the profile.
fn planted(plan: &Plan, faults: &[Fault]) -> Report {
    let profile = &plan.profile;
    let formula = Formula::new(profile, faults).rounding();
    let report = plan.run(&mut from_fn(profile.clone(), |scene| formula.reply(scene)));
    let holds = |told: &&str| {
        report
            .laws
            .iter()
            .any(|law| law.law == *told && !law.is_broken())
    };
    let mut told = report.findings.iter().flat_map(|finding| &finding.laws);
    assert!(!told.any(holds), "{report}");
    report
}

fn plan(profile: &Profile, cases: usize) -> Plan {
    let laws = Laws {
        cases,
        shrinks: 0,
        ..Laws::default()
    };
    laws.plan(profile).expect("a profile")
}

/// What a person expects to read of a mistake in this ingredient: one of these, or of nothing in particular.
fn expected(part: Part) -> &'static [&'static str] {
    use Part::*;
    match part {
        Ambient | Once | Ia | AmbientToo => &["ambient"],
        Ka => &["ambient", "color of the surface"],
        Kd => &["diffuse", "color of the surface"],
        Diffuse | Lambert | MatteLight | MatteFalloff | MatteCone => &["diffuse"],
        Abc | Denominator | Falloff | Q => &["attenuation", "distance", "lamps"],
        Angle | Edge | Against | Within | Cone => &["cone"],
        N | Side | OfThisLight => &["length of N", "lights", "eye behind", "light behind"],
        Way | P | Position | L => &["position p", "lamps", "lights"],
        Intensity | OfLight => &["lights", "several lights"],
        Sum | Clamp | Encode | Level => &[
            "",
            "colors above 1",
            "color of lights",
            "color of the surface",
            "lights",
            "highlight",
        ],
        // k_s, H, the power, …
        _ => &["highlight"],
    }
}

/// Whether a mistake can be seen in one of fifty scenes of such a renderer: the runs below have few random ones.
fn shows(formula: &Formula, right: &Formula, scenes: &[Scene]) -> bool {
    let is_clear = |scene: &&Scene| right.fits(scene, formula.reply(scene)) == Some(false);
    scenes.iter().filter(is_clear).count() * 50 > scenes.len()
}

fn measure(profile: &Profile, only: impl Fn(usize) -> bool, broken: &mut BTreeSet<&'static str>) {
    let plan = plan(profile, 16);
    let scenes: Vec<Scene> = scenes(profile, 300).collect();
    let right = Formula::new(profile, &[]);
    let (mut count, mut missed, mut unnamed, mut astray) = (0, vec![], vec![], vec![]);
    for (i, mistake) in MISTAKES.iter().enumerate().filter(|(i, _)| only(*i)) {
        let value = mistake.values.get(i % mistake.values.len().max(1));
        let fault = Fault::new(mistake, value.copied().unwrap_or(0.0));
        if !shows(&Formula::new(profile, &[fault]).rounding(), &right, &scenes) {
            continue;
        }
        count += 1;
        let report = planted(&plan, &[fault]);
        let laws = report.laws.iter().filter(|law| law.is_broken());
        broken.extend(laws.map(|law| law.law));
        let Some(finding) = report.findings.first() else {
            missed.push(fault);
            continue;
        };
        let cause = finding.cause.iter();
        let mut named = cause.flat_map(|it| it.alternatives.iter().chain([&it.mistakes]));
        if !named.any(|faults| *faults == [fault]) {
            unnamed.push((
                fault,
                finding.cause.as_ref().map(|it| &it.mistakes).cloned(),
            ));
        }
        let told = finding.places.iter().flat_map(|place| &place.only_with);
        let told: Vec<&str> = told.copied().collect();
        let parts = fault.mistake.changes.iter();
        let mut expected = parts.flat_map(|(part, _)| expected(*part));
        if !expected.any(|place| told.contains(place) || place.is_empty() && told.is_empty()) {
            astray.push((fault, told));
        }
    }
    println!("{count} planted; unnamed {unnamed:?}; not placed {astray:?}");
    assert!(missed.is_empty(), "missed: {missed:?}");
    assert!(unnamed.len() * 10 <= count, "{count}: {unnamed:?}");
    assert!(astray.len() * 10 <= count, "{count}: {astray:?}");
}

/// In `f32` every one, in `f64` and in bytes a twelfth, and those of the reply.
#[test]
fn mistakes_are_found_named_and_placed() {
    let mut broken = BTreeSet::new();
    measure(&single(), |_| true, &mut broken);
    measure(&double(), |i| i % 12 == 0, &mut broken);
    let is_of_reply = |(part, _): &(Part, _)| matches!(part, Part::Clamp | Part::Level);
    let of_reply = |i: usize| MISTAKES[i].changes.iter().any(is_of_reply);
    measure(&bytes(), |i| i % 12 == 1 || of_reply(i), &mut broken);
    // no law is there for show; state has no row
    let never = LAWS.iter().filter(|law| !broken.contains(law.name));
    let never: Vec<&str> = never.map(|law| law.name).collect();
    assert_eq!(never, ["no_memory"]);
}

#[test]
fn what_has_no_row_breaks_the_other_laws() {
    let profile = single();
    let (plan, right) = (plan(&profile, 64), Formula::new(&profile, &[]).rounding());
    let breaks = |law: &str, color: &mut dyn FnMut(&Scene, [f64; 3]) -> [f64; 3]| {
        let report = plan.run(&mut from_fn(profile.clone(), |scene| {
            color(scene, right.reply(scene))
        }));
        let broken = report
            .laws
            .iter()
            .any(|one| one.law == law && one.is_broken());
        assert!(broken, "{law} holds:\n{report}");
        report
    };
    let mut previous = 0.0;
    let leak = breaks("no_memory", &mut |_, color| {
        let first = std::mem::replace(&mut previous, color[0]);
        [color[0] + 0.01 * first, color[1], color[2]]
    });
    let cause = leak.findings[0].cause.as_ref().expect("a cause");
    assert_eq!(cause.mistakes, [Fault::named("Leak")]);
    let mut is_ready = false;
    let unready = breaks("formula", &mut |_, color| {
        let is_first = !std::mem::replace(&mut is_ready, true);
        color.map(|c| if is_first { 0.0 } else { c })
    });
    assert_eq!(unready.findings[0].cause, leak.findings[0].cause);
    breaks("eye", &mut |scene, color| {
        color.map(|c| c * (1.0 + 0.01 * scene.v[2]))
    });
    breaks("rotation", &mut |scene, color| {
        color.map(|c| c * (1.0 + 0.01 * scene.n[1].abs()))
    });
}

#[test]
fn two_mistakes_are_named_and_placed_together() {
    let both = ["SquaredDistance", "HighlightNotGated"].map(Fault::named);
    let report = planted(&plan(&single(), 100), &both);
    let finding = &report.findings[0];
    assert_eq!(
        finding.cause.as_ref().expect("a cause").mistakes,
        both,
        "{report}"
    );
    let ambient = ["AmbientForgotten", "HighlightTimesCosine"].map(Fault::named);
    let report = planted(&plan(&single(), 100), &ambient);
    let places = report.findings[0]
        .places
        .iter()
        .map(|place| &place.only_with);
    let told: Vec<&str> = places.flatten().copied().collect();
    assert!(
        told.contains(&"ambient") && told.contains(&"highlight"),
        "{report}"
    );
}

/// A mistake of spots alone is told from one of all lights.
#[test]
fn scopes_are_named() {
    let of = &SCOPES[3];
    let fault = Fault {
        of,
        ..Fault::named("HighlightNotGated")
    };
    let report = planted(&plan(&single(), 100), &[fault]);
    assert!(
        report
            .to_string()
            .contains("so faces turned away from a light have one, of spots only"),
        "{report}"
    );
}

/// Two rows of the same colors would be one mistake with two names.
#[test]
fn no_two_rows_give_the_same_colors() {
    let profile = single();
    let edges = corpus::edges(&profile).into_iter().map(|case| case.scene);
    let scenes: Vec<Scene> = scenes(&profile, 300).chain(edges).collect();
    let exact = MISTAKES.iter().filter(|mistake| !mistake.is_loose());
    let faults: Vec<Fault> = exact.map(|mistake| Fault::named(&mistake.id)).collect();
    let of = |fault: &Fault| -> Vec<Bounded3> {
        let formula = Formula::new(&profile, &[*fault]);
        scenes.iter().map(|scene| formula.linear(scene)).collect()
    };
    let colors: Vec<Vec<Bounded3>> = faults.iter().map(of).collect();
    let is_same = |a: &Bounded3, b: &Bounded3| {
        let mut channels = a.iter().zip(b);
        channels.all(|(a, b)| {
            let off = (a.value - b.value).abs();
            off.is_nan() || off <= a.error + b.error
        })
    };
    let right = of(&Fault::named("Leak")); // it changes no ingredient
    let changes = |colors: &Vec<Bounded3>| !colors.iter().zip(&right).all(|(a, b)| is_same(a, b));
    let mut alike = Vec::new();
    for (i, a) in colors
        .iter()
        .enumerate()
        .filter(|(_, colors)| changes(colors))
    {
        for (j, b) in colors.iter().enumerate().take(i) {
            if a.iter().zip(b).all(|(a, b)| is_same(a, b)) {
                alike.push((faults[j], faults[i]));
            }
        }
    }
    assert!(alike.is_empty(), "{alike:?}");
}

/// The color by `shading` in `f64`.
fn by_shading(scene: &Scene) -> [f64; 3] {
    use shading::f64::{
        Attenuation, Cone, DirectionalLight, IncidentLight, Material, PointLight, Rgb, SpotLight,
        UnitVec3, Vec3,
    };
    let unit = |v: [f64; 3]| -> UnitVec3 { Vec3::from(v).unit().expect("a direction") };
    let p = Vec3::from(scene.p);
    let arriving = |light: &Light| -> IncidentLight {
        let intensity = Rgb::from(light.intensity());
        if let Light::Directional { l, .. } = *light {
            let l = unit(l);
            return DirectionalLight { l, intensity }.at(p);
        }
        let (position, [a, b, c]) = light.lamp().expect("a lamp");
        let point = PointLight {
            position: Vec3::from(position),
            intensity,
            attenuation: Attenuation::new(a, b, c).expect("coefficients"),
        };
        match *light {
            Light::Spot {
                axis, half_angle, ..
            } => SpotLight {
                point,
                axis: unit(axis),
                cone: Cone::from_half_angle(half_angle).expect("an angle"),
            }
            .at(p),
            _ => point.at(p),
        }
    };
    let lights = scene.lights.iter().map(arriving);
    let material = Material {
        k_a: Rgb::from(scene.k_a),
        k_d: Rgb::from(scene.k_d),
        k_s: Rgb::from(scene.k_s),
        m: scene.m,
    };
    let (n, v, i_a) = (unit(scene.n), unit(scene.v), Rgb::from(scene.i_a));
    let shaded = match scene.model {
        Model::Lambert => shading::shade::lambert(n, &material, i_a, lights),
        Model::Phong => shading::shade::phong(n, v, &material, i_a, lights),
        Model::BlinnPhong => shading::shade::blinn_phong(n, v, &material, i_a, lights),
    };
    <[f64; 3]>::from(shaded.total())
}

/// `shading`, which was written independently, gives the same colors, and the bounds are tight: all but 6 % are below
/// 10⁻¹² of the color. The others are of faint highlights, of lights on an edge and of lamps close by.
#[test]
fn the_formulas_are_those_of_shading() {
    let profile = double();
    let formula = Formula::new(&profile, &[]);
    let mut loose = 0;
    for scene in scenes(&profile, 2000) {
        for (ours, right) in formula.linear(&scene).into_iter().zip(by_shading(&scene)) {
            let off = (ours.value - right).abs();
            assert!(
                off <= ours.error,
                "{ours:?} is not {right} in\n{}",
                scene.to_json()
            );
            loose += u32::from(ours.error > 1e-12 * right);
        }
    }
    assert!(loose < 360, "{loose} of 6000 bounds are loose");
    let report = plan(&profile, 64).run(&mut from_fn(profile.clone(), by_shading));
    assert!(report.passes(), "{report}");
}
