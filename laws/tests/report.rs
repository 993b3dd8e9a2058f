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

/// Light from the eye's side alone, so that much is wrong: the same seed gives the same report, and
/// a law alone has the scenes that it has among all.
#[test]
fn the_same_seed_gives_the_same_report() {
    let headlight = |scene: &Scene| scene.k_d.map(|k| k * scene.v[2].max(0.0));
    let of = |seed, only: &str| {
        let only = only.split_whitespace().map(Into::into).collect();
        let laws = Laws {
            seed,
            only,
            cases: 320,
            shrinks: 0,
            ..Laws::default()
        };
        run(&laws, headlight)
    };
    let (all, again, other) = (of(1, ""), of(1, ""), of(2, ""));
    assert_eq!(all.to_json(), again.to_json());
    assert_ne!(format!("{:?}", all.laws), format!("{:?}", other.laws));
    let one = &of(1, "formula").laws[0];
    let same = all
        .laws
        .iter()
        .find(|law| law.law == "formula")
        .expect("it");
    assert_eq!(format!("{:?}", same.verdict), format!("{:?}", one.verdict));
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
    assert!(
        scene.lights.len() <= 1 && scene.p == [0.0; 3] && scene.m == 1.0,
        "{report}"
    );
    let text = report.to_string();
    assert!(
        text.contains(&format!("Scene::from_json(r#\"{}\"#)", scene.to_json())),
        "{text}"
    );
    assert_eq!(Scene::from_json(&scene.to_json()).as_ref(), Ok(scene));
}

#[test]
fn colors_that_are_no_numbers_are_found_and_placed() {
    for (nonsense, word) in [(f64::NAN, "NaN"), (f64::INFINITY, "inf")] {
        let color = |scene: &Scene| {
            [
                0.0,
                0.0,
                if scene.lights.len() > 1 {
                    nonsense
                } else {
                    0.0
                },
            ]
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

/// A renderer that panics: the scene is known.
#[test]
fn a_panic_names_its_scene() {
    let report = run(&only("finite"), |scene| {
        assert!(scene.lights.len() < 2, "two lights are too many");
        [0.0; 3]
    });
    let error = report.error.expect("a panic");
    assert!(error.starts_with("the renderer panicked; the scene: {"));
    assert!(error.matches("\"kind\"").count() > 1, "{error}");
}
