//! What a report says, and what prevents one.

#![allow(missing_docs)]
#![allow(clippy::float_cmp)] // short numbers, compared exactly

use std::time::Duration;

use shading_laws::{
    Fault, Kind, Laws, Light, Model, Profile, Renderer, Report, Scene, Triple, from_fn,
};

fn run(laws: &Laws, color: impl FnMut(&Scene) -> Triple) -> Report {
    let report = laws.run(&mut from_fn(Profile::default(), color));
    report.expect("a report")
}

/// A run that no clock ends, so that a busy machine gives the same report.
fn few() -> Laws {
    Laws {
        cases: 320,
        clock: || Duration::ZERO,
        ..Laws::default()
    }
}

/// Light from the eye's side alone, so that much is wrong.
#[test]
fn the_same_seed_gives_the_same_report() {
    let headlight = |scene: &Scene| scene.k_d.map(|k| k * scene.v[2].max(0.0));
    let of = |seed| {
        let laws = Laws { seed, ..few() };
        run(&laws, headlight).to_json()
    };
    assert_eq!(of(1), of(1));
    assert_ne!(
        of(1).replace("\"seed\":1", ""),
        of(2).replace("\"seed\":2", "")
    );
}

/// Without the search for a cause, the laws say the same.
#[test]
fn a_cause_is_left_out_on_demand() {
    let ungated = Fault::known().find(|it| it.id() == "HighlightNotGated");
    let ungated = ungated.expect("a mistake of the table");
    let [with, without] = [true, false].map(|explains| {
        let laws = Laws { explains, ..few() };
        run(&laws, |scene| ungated.color(scene))
    });
    assert!(with.findings[0].cause.is_some(), "{with}");
    assert!(
        without.findings.iter().all(|it| it.cause.is_none()),
        "{without}"
    );
    let broken = |report: &Report| {
        report
            .laws
            .iter()
            .map(|law| law.smallest.as_ref().map(|it| it.scenes.clone()))
            .collect::<Vec<_>>()
    };
    assert_eq!(broken(&with), broken(&without));
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
    let report = run(&few(), color);
    let smallest = report.laws[1].smallest.as_ref().expect("a broken law");
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
        // all is as it says, but for the nonsense
        let dark = ["AmbientTimes=0", "LightTimes=0"].map(String::from);
        let profile = Profile {
            departs: dark.into(),
            ..Profile::default()
        };
        let report = few().run(&mut from_fn(profile, color));
        let text = report.expect("a report").to_string();
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

/// A pass says of what it is none.
#[test]
fn a_pass_says_what_was_declared() {
    let profile = Profile {
        departs: vec!["LightTimes=0".into()],
        ..Profile::default()
    };
    let ambient = |scene: &Scene| [0, 1, 2].map(|i| scene.k_a[i] * scene.i_a[i]);
    let report = Laws::default().run(&mut from_fn(profile, ambient));
    let report = report.expect("a report");
    assert!(report.passes(), "{report}");
    let said = "declared as on purpose:\n  LightTimes=0: the color of a light is multiplied by 0\n";
    assert!(report.to_string().ends_with(said), "{report}");
}

/// V of length 0.98 looks like little precision. Who declared it would lose a mistake.
#[test]
fn what_hides_mistakes_is_not_to_be_pasted() {
    let power = |cosine: f64, m: f64| cosine.max(0.0).powf(m);
    let short = |scene: &Scene| {
        let unit = |v: Triple| v.map(|c| c / (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt());
        let dot = |a: Triple, b: Triple| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let (n, v) = (unit(scene.n), unit(scene.v).map(|c| 0.98 * c));
        let mut color = [0, 1, 2].map(|i| scene.k_a[i] * scene.i_a[i]);
        for light in &scene.lights {
            let Light::Directional { l, intensity } = light else {
                continue;
            };
            let n_dot_l = dot(n, *l);
            if n_dot_l > 0.0 {
                let h = unit([0, 1, 2].map(|i| l[i] + v[i]));
                let shine = power(dot(n, h), scene.m);
                color = [0, 1, 2].map(|i| {
                    color[i] + intensity[i] * (scene.k_d[i] * n_dot_l + scene.k_s[i] * shine)
                });
            }
        }
        color
    };
    let profile = Profile {
        models: vec![Model::BlinnPhong],
        lights: vec![Kind::Directional],
        ..Profile::default()
    };
    let report = Laws::default().run(&mut from_fn(profile, short));
    let text = report.expect("a report").to_string();
    assert!(text.contains("% of a highlight"), "{text}");
    assert!(!text.contains("add to the profile"), "{text}");
}

/// A white surface would be brighter than the range, so it is tried in dimmer light. There, no light is above 4,
/// and the color is right without a black or a colored surface being the reason. Without the diffuse term or
/// lights, all of which are directional, nothing is left of the mistake, and no light of 1 is cut.
#[test]
fn what_is_right_in_dimmer_light_is_not_placed_by_that() {
    let cut = |scene: &Scene| {
        let square = scene.n.map(|c| c * c).iter().sum::<f64>();
        let mut color = [0, 1, 2].map(|i| scene.k_a[i] * scene.i_a[i]);
        for light in &scene.lights {
            if let Light::Directional { l, intensity } = light {
                let n_dot_l = (0..3).map(|i| scene.n[i] * l[i]).sum::<f64>() / square.sqrt();
                let lit = |i: usize| scene.k_d[i] * intensity[i].min(4.0) * n_dot_l.max(0.0);
                color = [0, 1, 2].map(|i| color[i] + lit(i));
            }
        }
        color.map(|c| c.min(1.0))
    };
    let profile = Profile {
        models: vec![Model::Lambert],
        lights: vec![Kind::Directional],
        clamps: Some([0.0, 1.0]),
        ..Profile::default()
    };
    for seed in 0..3 {
        let laws = Laws { seed, ..few() };
        let report = laws.run(&mut from_fn(profile.clone(), cut));
        let report = report.expect("a report");
        let [place] = &report.findings[0].places[..] else {
            panic!("{report}");
        };
        let expected = ["directional", "color of lights", "diffuse", "lights"];
        assert_eq!(place.only_with, expected, "{report}");
    }
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
        let report = few().run(&mut Answers(answer));
        report.expect("a report").error.expect("an error")
    };
    // the first scene, another one, and the first one again
    assert_eq!(ended(Ok(vec![])), "0 colors for 3 scenes");
    assert_eq!(ended(Err("it is gone".into())), "it is gone");
    let refused = |laws: Laws, change: fn(&mut Profile)| {
        let mut profile = Profile::default();
        change(&mut profile);
        let black = from_fn(profile, |_| [0.0; 3]);
        laws.run(&mut { black }).expect_err("no report")
    };
    let vague = refused(few(), |it| it.roundoff = 0.5);
    let why = "the profile of the renderer: roundoff is 0.5, not from 1e-40 to 0.01";
    assert_eq!(vague, why);
    let many = refused(few(), |it| it.most_lights = 4000);
    assert!(many.ends_with("most_lights is 4000, not from 1.0 to 1024.0"));
    let none = Laws {
        cases: 0,
        ..Laws::default()
    };
    assert_eq!(refused(none, |_| {}), "the number of cases is 0");
    let departs = |name: fn() -> String| {
        let mut profile = Profile::default();
        profile.departs.push(name());
        let black = from_fn(profile, |_| [0.0; 3]);
        Laws::default().run(&mut { black }).expect_err("no report")
    };
    let numberless = departs(|| "LightTimes".into());
    assert!(
        numberless.ends_with("LightTimes needs a number, as in LightTimes=0"),
        "{numberless}"
    );
    let numbered = departs(|| "NormalReversed=2".into());
    assert!(
        numbered.contains("NormalReversed has no number"),
        "{numbered}"
    );
    let unknown = departs(|| "LightTime=2".into());
    assert!(
        unknown.contains("there is no departure LightTime; there are Normal"),
        "{unknown}"
    );
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
    assert!(few().run(&mut NeverEmpty).is_ok());
}
