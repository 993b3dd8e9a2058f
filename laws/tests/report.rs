//! What a report says, and what prevents one.

#![allow(missing_docs)]
#![allow(clippy::float_cmp)] // short numbers, compared exactly

use std::time::Duration;

use shading_laws::{Laws, Profile, Renderer, Scene, Triple, from_fn};

/// Light from the eye's side alone, so that much is wrong.
fn headlight(scene: &Scene) -> Triple {
    let cosine = (0..3)
        .map(|i| scene.n[i] * scene.v[i])
        .sum::<f64>()
        .max(0.0);
    scene.k_d.map(|k| k * cosine)
}

fn run(laws: &Laws, color: impl FnMut(&Scene) -> Triple) -> shading_laws::Report {
    let mut renderer = from_fn(Profile::default(), color);
    laws.run(&mut renderer).expect("a report")
}

fn only(law: &str) -> Laws {
    Laws {
        only: vec![law.into()],
        ..Laws::default()
    }
}

#[test]
fn the_same_seed_gives_the_same_report() {
    let of = |seed| {
        let cases = 20;
        run(
            &Laws {
                seed,
                cases,
                ..Laws::default()
            },
            headlight,
        )
        .to_json()
    };
    assert_eq!(of(1), of(1));
    assert_ne!(of(1).replace("\"seed\":1", "\"seed\":2"), of(2));
}

#[test]
fn a_law_alone_has_the_scenes_that_it_has_among_all() {
    let laws = |only| Laws {
        only,
        cases: 20,
        shrinks: 0,
        ..Laws::default()
    };
    let all = run(&laws(vec![]), headlight);
    let one = run(&laws(vec!["distance".into()]), headlight);
    let [law] = &one.laws[..] else {
        panic!("{one}");
    };
    let same = all
        .laws
        .iter()
        .find(|other| other.law == law.law)
        .expect("the law");
    assert_eq!(format!("{:?}", same.verdict), format!("{:?}", law.verdict));
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
            let many = scene.lights.len() > 1;
            [if many { nonsense } else { 0.0 }, 0.0, 0.0]
        };
        let report = run(&only("finite"), color);
        let text = report.to_string();
        assert!(text.contains(&format!("red is {word}")), "{text}");
        assert!(
            text.contains("only with: several lights, lights."),
            "{text}"
        );
    }
}

struct Answers(Result<Vec<Triple>, String>, Profile);

impl Renderer for Answers {
    fn profile(&self) -> Profile {
        self.1.clone()
    }

    fn shade(&mut self, _: &[Scene]) -> Result<Vec<Triple>, String> {
        self.0.clone()
    }
}

#[test]
fn what_prevents_a_report_is_said_in_one_line() {
    let laws = || only("finite");
    let ended = |answer| {
        let report = laws().run(&mut Answers(answer, Profile::default()));
        report.expect("a report").error.expect("an error")
    };
    assert_eq!(ended(Ok(vec![])), "0 colors for 1 scenes");
    assert_eq!(ended(Err("it is gone".into())), "it is gone");
    let refused = |laws: Laws, profile| {
        laws.run(&mut Answers(Ok(vec![]), profile))
            .expect_err("no report")
    };
    let vague = Profile {
        roundoff: 0.5,
        ..Profile::default()
    };
    let why = "the profile of the renderer: roundoff is 0.5, not between 0 and 0.01";
    assert_eq!(refused(laws(), vague), why);
    assert_eq!(
        refused(Laws { cases: 0, ..laws() }, Profile::default()),
        "the number of cases is 0"
    );
    assert_eq!(
        refused(only("gravity"), Profile::default()),
        "there is no law gravity"
    );
}

/// A renderer that panics: the scene, the law and the seed are known, and the scene is small.
#[test]
fn a_panic_names_its_scene() {
    let laws = Laws {
        seed: 5,
        ..only("finite")
    };
    let report = run(&laws, |scene| {
        assert!(scene.lights.len() < 2, "two lights are too many");
        [0.0; 3]
    });
    let error = report.error.expect("a panic");
    let start = "the renderer panicked in law finite, seed 5: two lights are too many; ";
    assert!(error.starts_with(start), "{error}");
    assert_eq!(error.matches("\"kind\"").count(), 2, "{error}");
}

/// At 20 ms a scene, three seconds are enough to try each law, and to place what is wrong.
#[test]
fn a_slow_renderer_tries_every_law() {
    let laws = Laws {
        time: Some(Duration::from_secs(3)),
        ..Laws::default()
    };
    let report = run(&laws, |scene| {
        std::thread::sleep(Duration::from_millis(20));
        [0, 1, 2].map(|i| scene.k_a[i] * scene.i_a[i]) // no light but the ambient
    });
    let text = report.to_string();
    assert!(!text.contains("NOT REACHED"), "{text}");
    assert!(text.contains("only with:"), "{text}");
}
