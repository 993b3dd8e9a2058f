//! A spoiled scene file gives one error that says where and why: never a panic, and never a part of a scene.

use features::Scene;
use serde::Deserialize;
use serde_json::{Value, json};

const JSON: &str = include_str!("../scenes/room.json");
const RON: &str = include_str!("../scenes/room.ron");

#[test]
fn both_files_hold_the_same_scene() {
    let scene: Scene = serde_json::from_str(JSON).unwrap();
    assert_eq!(scene, ron::from_str(RON).unwrap());
    assert_eq!(scene.lights.len(), 3);
}

const VECTOR: &str = "vector: a coordinate is not finite";
const COLOR: &str = "color: a channel is negative or not finite";
const ZERO: &str = "direction: the zero vector has none; a vector of any other length will do";
const DIRECTION: &str = "direction: a coordinate is not finite";
const COEFFICIENTS: &str = "attenuation: a, b and c must be finite, 0 or more, and not all 0";
const RANGE: &str = "range: it must be above 0";
const COSINE: &str = "cosine: it must be between -1 and 1";
const HALF_ANGLE: &str = "half_angle: it must be between 0 and π; write half of the opening angle";
const COSINES: &str = "cosines: they must be between -1 and 1, and the inner one not below";
const HALF_ANGLES: &str =
    "half_angles: they must be between 0 and π radians, and the inner one not";
const CONE: &str = r#"{"half_angles": {"inner": 0.25, "outer": 0.5, "smoothstep": true}}"#;

/// What stands in the file once, what replaces it, and the error.
const IN_JSON: [(&str, &str, &str); 28] = [
    ("[2, 0, 2]", "[2, NaN, 2]", "expected value"),
    (
        "[2, 0, 2]",
        "[2, 0]",
        "invalid length 2, expected an array of length 3",
    ),
    ("[4, 4, 4]", "[4, 4, -1]", COLOR),
    ("[0.3, 0.3, 0.3]", "[0.3, -0.3, 0.3]", COLOR),
    ("[0.1, 0.1, 0.12]", "[-0.1, 0.1, 0.12]", COLOR),
    ("[0, -1, 0]", "[0, 0, 0]", ZERO),
    ("[0, -1, 0]", "[0, 1e-60, -0.0]", ZERO), // in `f32`
    ("[1, 0, 0.25]", "[1, -0.5, 0]", COEFFICIENTS),
    ("[1, 0, 0.25]", "[-0.0, 0, 0]", COEFFICIENTS),
    (
        "[1, 0, 0.25]",
        "[1, 0]",
        "invalid length 2, expected an attenuation with a, b and c",
    ),
    ("\"c\": 1", "\"c\": 0", COEFFICIENTS),
    ("\"range_gltf\": 8", "\"range\": 0", RANGE),
    ("\"range_gltf\": 8", "\"range\": -2", RANGE),
    (
        "\"range_gltf\": 8",
        "\"range_gltf\": 0",
        "range_gltf: it must be above 0",
    ),
    (
        "\"range_gltf\": 8",
        "\"range_gltf\": 8, \"range\": 9",
        "range: write it or range_gltf, not both",
    ),
    ("\"limit\": 1", "\"limit\": 0", "limit: it must be above 0"),
    ("\"limit\": 1", "\"limit\": -1", "limit: it must be above 0"),
    ("\"limit\"", "\"radius\"", "unknown field `radius`"),
    ("\"inner\": 0.25", "\"inner\": 0.51", HALF_ANGLES),
    ("\"outer\": 0.5", "\"outer\": 3.1416", HALF_ANGLES),
    (CONE, r#"{"half_angle": 30}"#, HALF_ANGLE),
    (CONE, r#"{"half_angle": -0.001}"#, HALF_ANGLE),
    (CONE, r#"{"cosine": 1.0001}"#, COSINE),
    (
        CONE,
        r#"{"cosines": {"inner": 0.4, "outer": 0.5}}"#,
        COSINES,
    ),
    (
        CONE,
        r#"{"half_angle": 0.5, "cosine": 0.5}"#,
        "expected value",
    ),
    (
        CONE,
        r#"{"angle": 0.5}"#,
        "unknown variant `angle`, expected one of",
    ),
    (
        "\"l\"",
        "\"to_light\"",
        "unknown field `to_light`, expected `l` or `intensity`",
    ),
    (
        "\"directional\"",
        "\"sun\"",
        "unknown variant `sun`, expected one of `directional`, `point`, `spot`",
    ),
];

const IN_RON: [(&str, &str, &str); 9] = [
    ("(2, 0, 2)", "(2, NaN, 2)", VECTOR),
    ("(2, 0, 2)", "(2, 0, -inf)", VECTOR),
    ("(4, 4, 4)", "(4, 4, NaN)", COLOR),
    ("(0.0, 0.6, 0.8)", "(0, 0, 0)", ZERO),
    ("(0, -1, 0)", "(0, NaN, 0)", DIRECTION),
    ("c: 0.25", "c: NaN", COEFFICIENTS),
    ("Some(8)", "Some(NaN)", "range_gltf: it must be above 0"),
    ("inner: 0.25", "inner: NaN", HALF_ANGLES),
    (
        "half_angles((inner: 0.25, outer: 0.5, smoothstep: true))",
        "half_angle(30)",
        HALF_ANGLE,
    ),
];

/// The file with `bad` in place of `good`, which occurs once, and the line of that place.
fn spoiled(file: &str, good: &str, bad: &str) -> (String, usize) {
    assert_eq!(file.matches(good).count(), 1, "{good}");
    let line = file[..file.find(good).unwrap()].lines().count();
    (file.replace(good, bad), line)
}

#[test]
fn errors_say_where_and_why() {
    for (good, bad, why) in IN_JSON {
        let (file, line) = spoiled(JSON, good, bad);
        let error = serde_json::from_str::<Scene>(&file).expect_err(bad);
        assert!(error.to_string().starts_with(why), "{bad}: {error}");
        // or at the next token, which may stand on the next line
        assert!((line..=line + 1).contains(&error.line()), "{bad}: {error}");
    }
    for (good, bad, why) in IN_RON {
        let (file, line) = spoiled(RON, good, bad);
        let error = ron::from_str::<Scene>(&file).expect_err(bad);
        assert!(error.code.to_string().starts_with(why), "{bad}: {error}");
        assert_eq!(error.span.start.line, line, "{bad}: {error}");
    }
}

/// With `serde_path_to_error`, an error names the fields that lead to the place, in each format.
#[test]
fn an_error_names_the_fields_that_lead_there() {
    let path = |good, bad| {
        let (json, _) = spoiled(JSON, good, bad);
        let mut format = serde_json::Deserializer::from_str(&json);
        let error = serde_path_to_error::deserialize::<_, Scene>(&mut format).expect_err(bad);
        error.path().to_string()
    };
    assert_eq!(path("[0.6, 0.6, 0.6]", "[0.6, -1, 0]"), "materials[0].k_d");
    assert_eq!(
        path("[2, 0, 2]", "[2, 0, 1e39]"),
        "lights[1].point.position[2]"
    );
    assert_eq!(path("[0, -1, 0]", "[0, 0, 0]"), "lights[2].spot.axis");
    let (ron, _) = spoiled(RON, "(0.6, 0.6, 0.6)", "(0.6, NaN, 0)");
    let mut format = ron::Deserializer::from_str(&ron).expect("tokens");
    let error = serde_path_to_error::deserialize::<_, Scene>(&mut format).expect_err("NaN");
    assert_eq!(error.path().to_string(), "materials[0].k_d");
}

/// The JSON pointers of a value and of all that it holds.
fn pointers(value: &Value, pointer: &str) -> Vec<String> {
    let held: Vec<(String, &Value)> = match value {
        Value::Array(list) => (0..list.len()).map(|i| (i.to_string(), &list[i])).collect(),
        Value::Object(map) => map.iter().map(|(key, held)| (key.clone(), held)).collect(),
        _ => vec![],
    };
    let held = held.into_iter();
    let within = held.flat_map(|(key, held)| pointers(held, &format!("{pointer}/{key}")));
    within.chain([pointer.to_owned()]).collect()
}

/// Every way to spoil the value at a pointer, but those that give another scene.
fn spoilers(pointer: &str, value: &Value) -> Vec<Value> {
    let is = |name| pointer.ends_with(name);
    let is_of_a_vector = ["/position/", "/l/", "/axis/"]
        .iter()
        .any(|name| pointer.contains(name));
    let is_right = |new: &Value| match new {
        Value::Null => is("/range_gltf") || is("/limit"),
        Value::Bool(_) => value.is_boolean(),
        Value::Number(x) if x.is_f64() => is("/m") || is("/range_gltf") || is("/limit"),
        Value::Number(_) => is("/m") || value.is_number() && is_of_a_vector,
        _ => (is("/lights") || is("/materials")) && *new == json!([]),
    };
    let all = json!([null, true, "x", -7, 1e39, [], {}, [[]]]);
    let mut bad = all.as_array().unwrap().clone();
    bad.retain(|new| !is_right(new));
    if let Value::Object(fields) = value {
        let mut more = fields.clone();
        more.insert("colour".into(), json!(1));
        bad.push(more.into());
        let optional = ["limit", "range", "range_gltf", "smoothstep"];
        for name in fields.keys().filter(|name| !optional.contains(&&***name)) {
            let mut fewer = fields.clone();
            fewer.remove(name);
            bad.push(fewer.into());
        }
    }
    bad
}

#[test]
fn every_spoiled_value_is_refused() {
    let scene: Value = serde_json::from_str(JSON).unwrap();
    let mut count = 0;
    for pointer in pointers(&scene, "") {
        for bad in spoilers(&pointer, scene.pointer(&pointer).unwrap()) {
            let mut spoiled = scene.clone();
            *spoiled.pointer_mut(&pointer).unwrap() = bad;
            count += 1;
            assert!(Scene::deserialize(&spoiled).is_err(), "{spoiled}");
        }
    }
    assert!(count > 400, "{count}");
}
