//! Every value, field and number of a scene file, spoiled one at a time: each file is refused with one line of text that
//! gives the place.

use features::Scene;
use serde_json::{Map, Value};

const JSON: &str = include_str!("../scenes/room.json");
const RON: &str = include_str!("../scenes/room.ron");

/// The JSON pointers of a value and of all that it holds.
fn pointers(value: &Value, pointer: &str) -> Vec<String> {
    let at = |(key, held): (String, &Value)| pointers(held, &format!("{pointer}/{key}"));
    let held: Vec<String> = match value {
        Value::Array(list) => (0..)
            .map(|i: usize| i.to_string())
            .zip(list)
            .flat_map(at)
            .collect(),
        Value::Object(map) => map
            .iter()
            .map(|(key, held)| (key.clone(), held))
            .flat_map(at)
            .collect(),
        _ => vec![],
    };
    [vec![pointer.to_owned()], held].concat()
}

/// The file is refused with one line of text, and at this line of it.
fn refused_at(file: &str, line: usize) -> String {
    let error = serde_json::from_str::<Scene>(file).expect_err(file);
    assert_eq!(error.line(), line, "{error}:\n{file}");
    let text = error.to_string();
    assert!(!text.is_empty() && !text.contains('\n'), "{text:?}");
    text
}

/// The file with one value replaced, a value a line, and the line of the new value.
fn with(scene: &Value, pointer: &str, new: &str) -> (String, usize) {
    let mut scene = scene.clone();
    *scene.pointer_mut(pointer).unwrap() = "here".into();
    let file = serde_json::to_string_pretty(&scene).unwrap();
    let line = 1 + file[..file.find("\"here\"").unwrap()].matches('\n').count();
    (file.replace("\"here\"", new), line)
}

#[test]
fn every_value_of_a_wrong_type_is_refused_at_its_place() {
    let scene: Value = serde_json::from_str(JSON).unwrap();
    let mut count = 0;
    for pointer in pointers(&scene, "") {
        let value = scene.pointer(&pointer).unwrap();
        let all = [
            "null",
            "true",
            "\"x\"",
            "7",
            "[]",
            "{}",
            "[[]]",
            "{\"x\": 7}",
        ];
        for new in all {
            let is_right = match value {
                // no lights and no materials are a scene too
                Value::Array(_) => new == "[]" && ["/lights", "/materials"].contains(&&*pointer),
                Value::Number(_) => new == "7",
                _ => serde_json::from_str::<Value>(new).is_ok_and(|new| new == *value),
            };
            if !is_right {
                let (file, line) = with(&scene, &pointer, new);
                refused_at(&file, line);
                count += 1;
            }
        }
    }
    assert!(count > 400, "{count}");
}

/// The fields of a map without its braces.
fn fields(map: &Map<String, Value>) -> String {
    let text = Value::from(map.clone()).to_string();
    text[1..text.len() - 1].to_owned()
}

#[test]
fn every_unknown_missing_or_repeated_field_is_refused() {
    let scene: Value = serde_json::from_str(JSON).unwrap();
    for pointer in pointers(&scene, "") {
        let Some(map) = scene.pointer(&pointer).unwrap().as_object() else {
            continue;
        };
        let refused = |fields: &str| {
            let (file, line) = with(&scene, &pointer, &format!("{{{fields}}}"));
            refused_at(&file, line)
        };
        let all = fields(map);
        let text = refused(&format!("\"colour\": 1, {all}"));
        assert!(
            text.contains("unknown") && text.contains("`colour`"),
            "{text}"
        );
        for (name, value) in map {
            refused(&format!("{all}, \"{name}\": {value}"));
            let mut others = map.clone();
            others.remove(name);
            if name != "clamped" {
                let text = refused(&fields(&others));
                // without its only field a light or a cone is nothing
                assert!(
                    text.contains(&**name) || others.is_empty(),
                    "{name}: {text}"
                );
            }
        }
    }
}

/// In RON, which has words for them.
#[test]
fn every_number_that_is_not_finite_is_refused_at_its_place() {
    let is_of_number = |c: char| c.is_ascii_digit() || c == '.' || c == '-';
    let mut numbers = 0;
    let mut end = 0;
    while let Some(start) = RON[end..].find(|c: char| c.is_ascii_digit() || c == '-') {
        let start = end + start;
        end = start + RON[start..].find(|c| !is_of_number(c)).unwrap();
        let line = 1 + RON[..start].matches('\n').count();
        for new in ["NaN", "-NaN", "inf", "-inf", "1e39", "-1e39"] {
            let file = [&RON[..start], new, &RON[end..]].concat();
            let error = ron::from_str::<Scene>(&file).expect_err(&file);
            let text = error.code.to_string();
            assert!(
                text.contains("finite") || text.contains("half_angle"),
                "{text}"
            );
            assert!(
                (error.span.start.line..=error.span.end.line).contains(&line),
                "{error}"
            );
        }
        numbers += 1;
    }
    assert!(numbers > 40, "{numbers}");
}

/// A binary file may announce more than it holds.
#[test]
fn lights_that_are_announced_and_not_there_are_refused() {
    let ambient = [0; 12];
    for count in [1_u64, 1_000_000, u64::MAX] {
        let announced = postcard::to_allocvec(&count).unwrap();
        let file = [&ambient[..], &announced].concat();
        let error = postcard::from_bytes::<Scene>(&file).unwrap_err();
        assert_eq!(error, postcard::Error::DeserializeUnexpectedEnd);
    }
}
