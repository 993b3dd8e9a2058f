//! What a report says, and what prevents one.

use shading_laws::{Laws, Mistake, Profile, Renderer, Scene, Triple, Verdict, from_fn};

use crate::by_hand::renderer;
use crate::profiles;

#[test]
fn the_same_seed_gives_the_same_report() {
    let run = |seed| {
        let mut wrong = renderer(&profiles::linear(), [Mistake::SquaredDistance]);
        let report = Laws::new().cases(50).seed(seed).run(&mut wrong);
        report.expect("an answer").to_json()
    };
    assert_eq!(run(1), run(1));
    assert_ne!(run(1).replace("\"seed\":1", "\"seed\":2"), run(2));
}

#[test]
fn a_law_alone_has_the_scenes_that_it_has_among_all() {
    let mut wrong = renderer(&profiles::linear(), [Mistake::SquaredDistance]);
    let all = Laws::new().cases(50).run(&mut wrong).expect("an answer");
    let one = Laws::new()
        .cases(50)
        .only("distance")
        .only("formula")
        .run(&mut wrong);
    let one = one.expect("an answer");
    assert_eq!(one.laws.len(), 2);
    for law in &one.laws {
        let same = all
            .laws
            .iter()
            .find(|other| other.name == law.name)
            .expect("the law");
        assert_eq!(format!("{:?}", same.verdict), format!("{:?}", law.verdict));
    }
}

/// A light from behind gives a highlight: one light, one reflectance and one color are enough to
/// show it.
#[test]
fn a_counterexample_is_small() {
    let mut wrong = renderer(&profiles::linear(), [Mistake::HighlightNotGated]);
    let report = Laws::new()
        .only("dark_side")
        .run(&mut wrong)
        .expect("an answer");
    let Verdict::Broken { smallest, .. } = &report.laws[0].verdict else {
        panic!("{report}");
    };
    let [scene] = &smallest.scenes[..] else {
        panic!("{report}");
    };
    assert_eq!(scene.lights.len(), 1);
    assert_eq!((scene.p, scene.i_a), ([0.0; 3], [0.0; 3]));
    assert_eq!(scene.material.m, 1.0);
    let text = report.to_string();
    assert!(
        text.contains("dark_side: a highlight needs N·L > 0"),
        "{text}"
    );
    assert!(text.contains("Likely cause"), "{text}");
    assert!(text.contains(Mistake::HighlightNotGated.name()), "{text}");
}

#[test]
fn colors_that_are_no_numbers_are_found_by_one_law() {
    for (nonsense, word) in [(f64::NAN, "NaN"), (f64::INFINITY, "inf")] {
        let mut wrong = from_fn(profiles::linear(), |scene: &Scene| {
            if scene.lights.len() > 1 {
                [nonsense, 0.0, 0.0]
            } else {
                [0.0; 3]
            }
        });
        let report = Laws::new()
            .only("finite")
            .run(&mut wrong)
            .expect("an answer");
        let text = report.to_string();
        assert!(
            report.is_broken() && text.contains(&format!("red is {word}")),
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
    let error = |answer, profile| {
        let run = Laws::new().cases(10).only("finite");
        run.run(&mut Answers(answer, profile))
            .expect_err("no report")
    };
    assert_eq!(
        error(Ok(vec![]), profiles::linear()),
        "0 colors for 256 scenes"
    );
    assert_eq!(
        error(Err("it is gone".into()), profiles::linear()),
        "it is gone"
    );
    let complaint = |profile| error(Ok(vec![]), profile);
    let no_model = Profile {
        models: vec![],
        ..profiles::linear()
    };
    assert_eq!(
        complaint(no_model),
        "the profile of the renderer: models is empty"
    );
    let vague = Profile {
        roundoff: 0.5,
        ..profiles::linear()
    };
    assert_eq!(
        complaint(vague),
        "the profile of the renderer: roundoff is 0.5, not between 0 and 0.01"
    );

    let mut black = from_fn(profiles::linear(), |_| [0.0; 3]);
    let error = Laws::new().cases(0).run(&mut black);
    assert_eq!(
        error.expect_err("nothing to try"),
        "the number of cases is 0"
    );
    let error = Laws::new()
        .only("gravity")
        .run(&mut black)
        .expect_err("no such law");
    assert_eq!(error, "there is no law gravity");
}

#[test]
#[should_panic(expected = "ambient_alone: without lights there is k_a I_a")]
fn check_panics_with_the_report() {
    shading_laws::check(from_fn(profiles::linear(), |_| [0.0; 3]));
}

/// A renderer that panics: the scene, the law and the seed are known, and the scene is small.
#[test]
fn a_panic_names_its_scene() {
    let mut fragile = from_fn(profiles::linear(), |scene: &Scene| {
        assert!(scene.lights.len() < 2, "two lights are too many");
        [0.0; 3]
    });
    let error = Laws::new().seed(5).only("finite").run(&mut fragile);
    let error = error.expect_err("a panic");
    let start = "the renderer panicked in law finite, seed 5: two lights are too many\n";
    assert!(error.starts_with(start), "{error}");
    assert_eq!(error.matches("Light::").count(), 2, "{error}");
}

/// Long numbers become short where they are not what is wrong.
#[test]
fn shrinking_brings_short_numbers_back() {
    let mut wrong = renderer(&profiles::linear(), [Mistake::DistanceAtLeast]);
    let report = Laws::new()
        .only("formula")
        .run(&mut wrong)
        .expect("an answer");
    let Verdict::Broken { smallest, .. } = &report.laws[0].verdict else {
        panic!("{report}");
    };
    let line = smallest.scenes[0].to_json();
    assert!(line.len() < 420, "{line}");
}
