//! Right renderers in other algebraic forms, frames, precisions and encodings: no law is broken.

#![allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap)] // small numbers
#![allow(missing_docs)]

mod renderer;

use half::{bf16, f16};
use shading_laws::{Kind, Laws, Profile, Report, Scene, Triple, from_fn};

use renderer::{Form, renderer};

/// The colors as a profile says: clamped, encoded, in levels, and times what is white.
fn told(color: Triple, profile: &Profile) -> Triple {
    let range = profile.clamps.or(profile.bits.map(|_| [0.0, 1.0]));
    let most = profile.bits.map(|bits| f64::from(bits).exp2() - 1.0);
    color.map(|c| {
        let c = range.map_or(c, |[low, high]| c.clamp(low, high));
        let c = match c {
            c if !profile.srgb => c,
            c if c <= 0.003_130_8 => 12.92 * c,
            c => 1.055 * c.powf(1.0 / 2.4) - 0.055,
        };
        most.map_or(c, |most| (c * most).round() / most) * profile.white
    })
}

fn profile(json: &str) -> Profile {
    Profile::from_json(json).expect("a profile")
}

fn run(profile: &Profile, seed: u64, cases: usize, color: impl FnMut(&Scene) -> Triple) -> Report {
    let laws = Laws {
        seed,
        cases,
        shrinks: false,
        ..Laws::default()
    };
    laws.run(&mut from_fn(profile.clone(), color))
        .expect("a profile")
}

/// A right renderer, how it computes, and a form of it that no law may be broken by.
fn holds(number: usize, seed: u64, cases: usize) -> Option<Report> {
    let form = Form(number);
    let mut failed = None;
    let mut check = |profile: &Profile, color: &mut dyn FnMut(&Scene) -> Triple| {
        let report = run(profile, seed, cases, color);
        if !report.passes() {
            failed.get_or_insert(report);
        }
    };
    let single = profile(r#"{"name":"f32","most_shiny":1024}"#);
    check(&single, &mut renderer::<f32>(form, &single));
    let double = profile(r#"{"name":"f64","roundoff":1.1102230246251565e-16,"most_shiny":1024}"#);
    check(&double, &mut renderer::<f64>(form, &double));
    let other = match number % 12 {
        0 => r#"{"bits":8,"srgb":true}"#,
        1 => r#"{"bits":8,"white":255}"#,
        2 => r#"{"bits":5}"#,
        3 => r#"{"bits":16}"#,
        4 => r#"{"clamps":[0,1],"srgb":true}"#,
        // computed in f32, written as half precision or bfloat
        5 | 6 => r#"{"name":"half precision","roundoff":0.00048828125}"#,
        7 | 8 => r#"{"name":"bfloat","roundoff":0.00390625}"#,
        // computed in more digits than it writes, as by the x87
        9 => r#"{"name":"x87"}"#,
        10 => r#"{"bits":8,"srgb":true,"white":255}"#,
        _ => r#"{"clamps":[0,4]}"#,
    };
    let other = profile(other);
    let in_single = renderer::<f32>(form, &other);
    match number % 12 {
        5 => check(&other, &mut |scene| {
            in_single(scene).map(|c| f16::from_f64(c).to_f64())
        }),
        6 => check(&other, &mut renderer::<f16>(form, &other)),
        7 => check(&other, &mut |scene| {
            in_single(scene).map(|c| bf16::from_f64(c).to_f64())
        }),
        8 => check(&other, &mut renderer::<bf16>(form, &other)),
        9 => {
            let exact = renderer::<f64>(form, &other);
            check(&other, &mut |scene| {
                exact(scene).map(|c| f64::from(c as f32))
            });
        }
        _ => check(&other, &mut |scene| told(in_single(scene), &other)),
    }
    failed
}

/// The number of forms, each in `f32`, in `f64` and in another precision or encoding.
const FORMS: usize = 120;

#[test]
fn right_renderers_break_no_law() {
    for number in 0..FORMS {
        if let Some(report) = holds(number, number as u64 % 5, 64) {
            panic!("form {number}: {report}");
        }
    }
}

/// The same with all cases, at five seeds. It takes minutes.
#[test]
#[ignore = "it takes minutes"]
fn right_renderers_break_no_law_at_five_seeds() {
    let mut failed = 0;
    for (seed, number) in (0..5).flat_map(|seed| (0..FORMS).map(move |number| (seed, number))) {
        if let Some(report) = holds(number, seed, 1024) {
            println!("form {number}, seed {seed}: {report}");
            failed += 1;
        }
    }
    assert_eq!(failed, 0);
}

/// Renderers that lack something, or depart from the formulas on purpose, as the format says it.
#[test]
fn what_differs_on_purpose_is_no_mistake() {
    for (i, json) in [
        r#"{"models":["phong"],"lights":["point","spot"],"most_lights":1,"unit_vectors":true}"#,
        r#"{"models":["lambert","blinn_phong"],"lights":["directional"],"ambient":false}"#,
        r#"{"departs":["HighlightNotGated","ConeExponent=2"]}"#,
        r#"{"departs":["NormalTowardEye","AmbientTimesDiffuse"],"unattenuated":true,"gray_highlight":true}"#,
        r#"{"departs":["UnlitWithoutLights"],"lights":["point","spot"],"most_lights":1024}"#,
    ]
    .into_iter()
    .enumerate()
    {
        let profile = profile(json);
        for seed in 0..2 {
            let report = run(&profile, seed, 256, renderer::<f32>(Form(i), &profile));
            assert!(report.passes(), "{json}: {report}");
        }
    }
}

/// Tolerances follow the precision: what holds for `f32` is broken for `f64`.
#[test]
fn single_precision_is_not_double() {
    let profile = Profile {
        roundoff: f64::EPSILON / 2.0,
        lights: vec![Kind::Directional],
        ..Profile::default()
    };
    let report = run(&profile, 0, 1024, renderer::<f32>(Form(0), &profile));
    let text = report.to_string();
    for line in ["\nformula is BROKEN", "a roundoff of 2^-2"] {
        assert!(text.contains(line), "{text}");
    }
}
