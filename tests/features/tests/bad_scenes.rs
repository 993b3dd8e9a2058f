//! A malformed scene file gives one error that says where and why. Nothing panics, and there are no
//! partial scenes: reading returns either a scene or an error.

use std::iter::repeat_n;

use features::Scene;

const JSON: &str = include_str!("../scenes/room.json");
const RON: &str = include_str!("../scenes/room.ron");

#[test]
fn both_files_hold_the_same_scene() {
    let scene: Scene = serde_json::from_str(JSON).unwrap();
    assert_eq!(scene, ron::from_str(RON).unwrap());
    assert_eq!(scene.lights.len(), 3);
}

/// The file with `bad` in place of `good`, which occurs once, and the line of that place.
fn spoiled(file: &str, good: &str, bad: &str) -> (String, usize) {
    assert_eq!(file.matches(good).count(), 1, "{good}");
    let line = file[..file.find(good).unwrap()].lines().count();
    (file.replace(good, bad), line)
}

/// The JSON file with `bad` in place of `good` is refused at that line, because of `why`.
fn json_refuses(good: &str, bad: &str, why: &str) {
    let (file, line) = spoiled(JSON, good, bad);
    let error = serde_json::from_str::<Scene>(&file).unwrap_err();
    assert!(
        error.to_string().starts_with(why),
        "{error} does not start with: {why}"
    );
    assert_eq!(error.line(), line, "{error}");
}

/// The same for the RON file.
fn ron_refuses(good: &str, bad: &str, why: &str) {
    let (file, line) = spoiled(RON, good, bad);
    let error = ron::from_str::<Scene>(&file).unwrap_err();
    assert_eq!(error.code.to_string(), why);
    assert_eq!(error.span.start.line, line, "{error}");
}

const TOO_LONG: &str =
    "l: [1.0, 1.0, 1.0] has length 1.7320508, not 1; write [0.57735026, 0.57735026, 0.57735026]";
const IN_DEGREES: &str =
    "half_angle: 30.0 is not between 0 and π; write half of the opening angle, in radians";

#[test]
fn numbers_that_no_scene_can_have_are_refused() {
    json_refuses("[2, 0, 2]", "[2, NaN, 2]", "expected value");
    json_refuses(
        "[2, 0, 2]",
        "[2, null, 2]",
        "invalid type: null, expected f32",
    );
    json_refuses("[2, 0, 2]", "[2, 1e400, 2]", "number out of range");
    ron_refuses(
        "(2, 0, 2)",
        "(2, NaN, 2)",
        "position: y = NaN is not finite",
    );
    ron_refuses(
        "(2, 0, 2)",
        "(2, 0, -inf)",
        "position: z = -inf is not finite",
    );
    ron_refuses(
        "(2, 0, 2)",
        "(1e39, 0, 2)",
        "position: x = inf is not finite",
    );
    ron_refuses(
        "(4, 4, 4)",
        "(4, 4, NaN)",
        "intensity: b = NaN is not finite",
    );
    ron_refuses("m: 32", "m: inf", "m: inf is not finite");
}

#[test]
fn directions_of_another_length_are_refused() {
    json_refuses("[0.0, 0.6, 0.8]", "[1, 1, 1]", TOO_LONG);
    ron_refuses("(0.0, 0.6, 0.8)", "(1, 1, 1)", TOO_LONG);
    json_refuses(
        "[0, -1, 0]",
        "[0, 0, 0]",
        "axis: [0.0, 0.0, 0.0] has length 0.0, not 1",
    );
    ron_refuses("(0, -1, 0)", "(0, NaN, 0)", "axis: y = NaN is not finite");
    // three decimals are not enough
    json_refuses(
        "[0.0, 0.6, 0.8]",
        "[0.577, 0.577, 0.577]",
        "l: [0.577, 0.577, 0.577] has length 0.99",
    );
}

#[test]
fn impossible_attenuations_are_refused() {
    json_refuses(
        "[1, 0, 0.25]",
        "[1, -0.5, 0]",
        "attenuation: b = -0.5 is negative",
    );
    ron_refuses(
        "(1, 0, 0.25)",
        "(1, 0, -1)",
        "attenuation: c = -1.0 is negative",
    );
    ron_refuses(
        "(1, 0, 0.25)",
        "(NaN, 0, 0)",
        "attenuation: a = NaN is not finite",
    );
    let zero = "attenuation: all are 0; write [1, 0, 0] for no attenuation";
    json_refuses("[1, 0, 0.25]", "[0, 0, 0]", zero);
    json_refuses(
        "[0, 0, 1]",
        "[0, -2, 1]",
        "coefficients: b = -2.0 is negative",
    );
    json_refuses(
        "[1, 0, 0.25]",
        "{\"clamped\": true}",
        "missing field `coefficients`",
    );
}

#[test]
fn impossible_cones_are_refused() {
    json_refuses("\"half_angle\": 0.5", "\"half_angle\": 30", IN_DEGREES);
    ron_refuses("half_angle: 0.5", "half_angle: 30", IN_DEGREES);
    ron_refuses(
        "half_angle: 0.5",
        "half_angle: NaN",
        "half_angle: NaN is not finite",
    );
    json_refuses(
        "\"half_angle\": 0.5",
        "\"cosine\": 1.5",
        "cosine: 1.5 is not between -1 and 1",
    );
    json_refuses("\"half_angle\": 0.5", "", "missing field `half_angle`");
    let both = "\"half_angle\": 0.5, \"cosine\": 0.5";
    json_refuses(
        "\"half_angle\": 0.5",
        both,
        "cone: half-angles and cosines cannot both be given",
    );
}

#[test]
fn impossible_ranges_and_soft_edges_are_refused() {
    let ranged = |range: &str| format!("{{\"coefficients\": [1, 0, 0.25], \"range\": {range}}}");
    json_refuses("[1, 0, 0.25]", &ranged("0"), "range: 0.0 is not above 0");
    json_refuses("[1, 0, 0.25]", &ranged("-2"), "range: -2.0 is not above 0");
    let nan = "(coefficients: (1, 0, 0.25), range: NaN)";
    ron_refuses("(1, 0, 0.25)", nan, "range: NaN is not above 0");
    let good = "\"half_angle\": 0.5";
    json_refuses(
        good,
        "\"half_angle\": 0.5, \"inner_half_angle\": 0.6",
        "inner_half_angle: 0.6 is not between 0 and the half_angle, 0.5",
    );
    json_refuses(
        good,
        "\"cosine\": 0.5, \"inner_cosine\": 0.4",
        "inner_cosine: 0.4 is not between the cosine, 0.5, and 1",
    );
    json_refuses(
        good,
        "\"inner_half_angle\": 0.3",
        "missing field `half_angle`",
    );
    json_refuses(good, "\"inner_cosine\": 0.3", "missing field `cosine`");
    let both = "\"half_angle\": 0.5, \"inner_cosine\": 0.9";
    json_refuses(
        good,
        both,
        "cone: half-angles and cosines cannot both be given",
    );
}

/// A type without a range or a soft edge does not drop them silently.
#[test]
fn what_a_type_cannot_hold_is_an_unknown_field() {
    let ranged = r#"{"coefficients": [1, 0, 0.25], "range": 8}"#;
    let error = serde_json::from_str::<shading::f32::Attenuation>(ranged).unwrap_err();
    let why = "unknown field `range`, expected `coefficients` or `clamped`";
    assert!(error.to_string().starts_with(why), "{error}");

    let soft = r#"{"half_angle": 0.5, "inner_half_angle": 0.25}"#;
    let error = serde_json::from_str::<shading::f32::Cone>(soft).unwrap_err();
    let why = "unknown field `inner_half_angle`, expected `half_angle` or `cosine`";
    assert!(error.to_string().starts_with(why), "{error}");
}

#[test]
fn unknown_missing_and_repeated_fields_are_refused() {
    json_refuses(
        "\"l\"",
        "\"to_light\"",
        "unknown field `to_light`, expected `l` or `intensity`",
    );
    json_refuses(
        "\"m\"",
        "\"n\"",
        "unknown field `n`, expected one of `k_a`, `k_d`, `k_s`, `m`",
    );
    json_refuses("\"half_angle\"", "\"inner\"", "unknown field `inner`");
    json_refuses("\"clamped\"", "\"radius\"", "unknown field `radius`");
    json_refuses("\"ambient\"", "\"fog\"", "unknown field `fog`");
    json_refuses(", \"m\": 32", "", "missing field `m`");
    json_refuses("\"m\": 32", "\"m\": 32, \"m\": 32", "duplicate field `m`");
    json_refuses(
        "\"directional\"",
        "\"sun\"",
        "unknown variant `sun`, expected one of `directional`, `point`, `spot`",
    );
}

#[test]
fn wrong_types_are_refused() {
    let three = "a list of 3 numbers for";
    let why = format!("invalid length 2, expected {three} position");
    json_refuses("[2, 0, 2]", "[2, 0]", &why);
    let why = format!("invalid length 4, expected {three} intensity");
    json_refuses("[4, 4, 4]", "[4, 4, 4, 1]", &why);
    let why = format!("invalid type: string \"here\", expected {three} position");
    json_refuses("[2, 0, 2]", "\"here\"", &why);
    let why = "invalid type: string \"0\", expected f32";
    json_refuses("[2, 0, 2]", "[2, \"0\", 2]", why);
    json_refuses("32", "\"32\"", "invalid type: string \"32\", expected f32");
    json_refuses("true", "null", "invalid type: null, expected a boolean");
    // a list of the fields in their order, as formats without names have it
    let why = "missing field `inner_cosine`";
    json_refuses("{\"half_angle\": 0.5}", "[0.5]", why);
    let why = "invalid type: null, expected a map with `half_angle` or `cosine` for cone";
    json_refuses("{\"half_angle\": 0.5}", "null", why);
    let why = "invalid type: null, expected a list of 3 numbers, or a map, for attenuation";
    json_refuses("[1, 0, 0.25]", "null", why);
}

#[test]
fn integer_m_is_an_integer() {
    let material = r#"{"k_a": [0, 0, 0], "k_d": [0, 0, 0], "k_s": [0, 0, 0], "m": 32.5}"#;
    let error = serde_json::from_str::<shading::f32::Material>(material).unwrap_err();
    assert_eq!(
        error.to_string(),
        "invalid type: floating point `32.5`, expected u32 at line 1 column 64"
    );
}

#[test]
fn truncated_files_are_refused() {
    let (json, ron) = (JSON.trim_end(), RON.trim_end());
    for end in 0..json.len() {
        let error = serde_json::from_str::<Scene>(&json[..end]).unwrap_err();
        assert!(error.is_eof(), "{error}");
    }
    for end in 0..ron.len() {
        let error = ron::from_str::<Scene>(&ron[..end]).unwrap_err();
        let last = ron[..end].split('\n').count();
        assert!(error.span.end.line <= last && !error.code.to_string().is_empty());
    }
}

/// A file with `count` lamps, one per line after the first line; `last` is the last of them.
fn many_lamps(count: usize, last: &str) -> String {
    let lamp =
        r#"{"point": {"position": [2, 0, 2], "intensity": [1, 1, 1], "attenuation": [1, 0, 0]}}"#;
    let lamps = repeat_n(lamp, count - 1).chain([last]);
    let lamps: Vec<_> = lamps.collect();
    format!(
        "{{\"ambient\": [0, 0, 0], \"materials\": [], \"lights\": [\n{}]}}",
        lamps.join(",\n")
    )
}

#[test]
fn last_of_a_million_lights_is_checked() {
    let good = r#"{"directional": {"l": [0, 1, 0], "intensity": [1, 1, 1]}}"#;
    let scene: Scene = serde_json::from_str(&many_lamps(1_000_000, good)).unwrap();
    assert_eq!(scene.lights.len(), 1_000_000);

    let bad = r#"{"directional": {"l": [0, 2, 0], "intensity": [1, 1, 1]}}"#;
    let error = serde_json::from_str::<Scene>(&many_lamps(1_000_000, bad)).unwrap_err();
    assert_eq!(
        error.to_string(),
        "l: [0.0, 2.0, 0.0] has length 2.0, not 1; write [0.0, 1.0, 0.0] at line 1000001 column 31"
    );
}

#[test]
fn deep_nesting_is_refused_wherever_it_stands() {
    for good in [
        "[0.1, 0.1, 0.12]",
        "[2, 0, 2]",
        "[1, 0, 0.25]",
        "0.5",
        "true",
        "32",
        "\"spot\"",
    ] {
        for open in ["[", "{\"point\":", "{\"coefficients\":"] {
            let (file, line) = spoiled(JSON, good, &open.repeat(100_000));
            let error = serde_json::from_str::<Scene>(&file).unwrap_err();
            assert_eq!(error.line(), line, "{error}");
        }
    }
    for good in ["(2, 0, 2)", "(1, 0, 0.25)", "0.5", "true", "32", "spot"] {
        for open in ["(", "[", "{", "Some(", "(coefficients:", "point("] {
            let (file, _) = spoiled(RON, good, &open.repeat(100_000));
            assert!(
                !ron::from_str::<Scene>(&file)
                    .unwrap_err()
                    .to_string()
                    .is_empty()
            );
        }
    }
}
