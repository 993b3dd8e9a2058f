//! What a report says, and what prevents one.

#![allow(missing_docs)]
#![allow(clippy::float_cmp)] // short numbers, compared exactly

use shading_laws::{Laws, Profile, Renderer, Report, Scene, Triple, from_fn};

fn run(laws: &Laws, color: impl FnMut(&Scene) -> Triple) -> Report {
    let report = laws.run(&mut from_fn(Profile::default(), color));
    report.expect("a report")
}

fn only(law: &str) -> Laws {
    Laws {
        only: vec![law.into()],
        cases: 320,
        shrinks: 40,
        ..Laws::default()
    }
}

/// Light from the eye's side alone, so that much is wrong.
#[test]
fn the_same_seed_gives_the_same_report() {
    let headlight = |scene: &Scene| scene.k_d.map(|k| k * scene.v[2].max(0.0));
    let of = |seed| {
        let laws = Laws {
            seed,
            ..only("formula")
        };
        run(&laws, headlight).to_json()
    };
    assert_eq!(of(1), of(1));
    assert_ne!(
        of(1).replace("\"seed\":1", ""),
        of(2).replace("\"seed\":2", "")
    );
}

/// A light that is too bright: one light, one reflectance and one color are enough to show it.
#[test]
fn a_counterexample_is_small() {
    let color = |scene: &Scene| {
        let mut bright = scene.i_a;
        for light in &scene.lights {
            bright = [0, 1, 2].map(|i| bright[i] + light.intensity()[i]);
        }
        bright
    };
    let report = run(&only("formula"), color);
    let smallest = report.laws[0].smallest().expect("a broken law");
    let [scene] = &smallest.scenes[..] else {
        panic!("{report}");
    };
    let is_small = scene.lights.len() <= 1 && scene.p == [0.0; 3] && scene.m == 1.0;
    let line = format!("Scene::from_json(r#\"{}\"#)", scene.to_json());
    assert!(is_small && report.to_string().contains(&line), "{report}");
    assert_eq!(Scene::from_json(&scene.to_json()).as_ref(), Ok(scene));
}

#[test]
fn colors_that_are_no_numbers_are_found_and_placed() {
    for (nonsense, word) in [(f64::NAN, "NaN"), (f64::INFINITY, "inf")] {
        let color = |scene: &Scene| {
            let blue = if scene.lights.len() > 1 {
                nonsense
            } else {
                0.0
            };
            [0.0, 0.0, blue]
        };
        let text = run(&only("finite"), color).to_string();
        assert!(text.contains(&format!("blue is {word}")), "{text}");
        assert!(text.contains("only with: several lights"), "{text}");
    }
}

/// The light of the scene before: a scene alone shows nothing of it, three do.
#[test]
fn what_is_remembered_is_shown_by_three_scenes() {
    let mut last = [0.0; 3];
    let laws = Laws {
        cases: 64,
        ..Laws::default()
    };
    let text = run(&laws, |scene| std::mem::replace(&mut last, scene.k_a)).to_string();
    let (_, first) = text.split_once("Finding 1 of 1: ").expect("one finding");
    assert!(first.starts_with("a scene changes the color of the scenes after it"));
    assert!(first.contains("  color 3: "), "{text}");
}

struct Answers(Result<Vec<Triple>, String>);

impl Renderer for Answers {
    fn shade(&mut self, _: &[Scene]) -> Result<Vec<Triple>, String> {
        self.0.clone()
    }
}

#[test]
fn what_prevents_a_report_is_said_in_one_line() {
    let ended = |answer| {
        let report = only("finite").run(&mut Answers(answer));
        report.expect("a report").error.expect("an error")
    };
    assert_eq!(ended(Ok(vec![])), "0 colors for 1 scenes");
    assert_eq!(ended(Err("it is gone".into())), "it is gone");
    let refused = |laws: Laws, change: fn(&mut Profile)| {
        let mut profile = Profile::default();
        change(&mut profile);
        let black = from_fn(profile, |_| [0.0; 3]);
        laws.run(&mut { black }).expect_err("no report")
    };
    let vague = refused(only("finite"), |it| it.roundoff = 0.5);
    let why = "the profile of the renderer: roundoff is 0.5, not from 1e-40 to 0.01";
    assert_eq!(vague, why);
    let many = refused(only("finite"), |it| it.most_lights = 4000);
    assert!(many.ends_with("most_lights is 4000, not from 1.0 to 1024.0"));
    let none = Laws {
        cases: 0,
        ..Laws::default()
    };
    assert_eq!(refused(none, |_| {}), "the number of cases is 0");
    assert_eq!(refused(only("gravity"), |_| {}), "there is no law gravity");
}

/// A device may not take a batch without scenes. What asks for none is all that holds.
struct NeverEmpty;

impl Renderer for NeverEmpty {
    fn shade(&mut self, scenes: &[Scene]) -> Result<Vec<Triple>, String> {
        assert!(!scenes.is_empty());
        Ok(vec![[0.0; 3]; scenes.len()])
    }
}

#[test]
fn no_batch_is_empty() {
    for law in ["finite", "formula"] {
        assert!(only(law).run(&mut NeverEmpty).is_ok());
    }
}
