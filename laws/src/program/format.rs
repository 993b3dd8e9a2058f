//! Reads what a renderer says: its profile and its colors, as `docs/format.md` describes them.

use serde_json::Value;
use shading_laws::{Model, Profile, Triple};

/// What the program says first.
pub const VERSION: &str = r#"{"shading-laws":1}"#;

/// What the renderer says of itself. `command` is its name if it does not say one.
pub fn profile(line: &str, command: &str) -> Result<Profile, String> {
    let expected = |found: &str| format!("expected a JSON object or {{}}, found {found}");
    let value: Value = serde_json::from_str(line).map_err(|_| expected(&quoted(line)))?;
    let Value::Object(members) = value else {
        return Err(expected(&quoted(line)));
    };
    if let Some(twice) = members.keys().find(|name| times(line, name) > 1) {
        return Err(format!("\"{twice}\": it is there twice"));
    }
    let mut profile = Profile {
        name: command.to_owned(),
        ..Profile::default()
    };
    for (name, value) in members {
        set(&mut profile, &name, value).map_err(|why| format!("\"{name}\": {why}"))?;
    }
    profile.complaint().map_or(Ok(profile), Err)
}

/// How often an object has a member of this name.
fn times(line: &str, name: &str) -> usize {
    let (mut depth, mut count, mut rest) = (0, 0, line.char_indices());
    while let Some((start, c)) = rest.next() {
        match c {
            '{' | '[' => depth += 1,
            '}' | ']' => depth -= 1,
            '"' => {
                let mut end = start;
                while let Some((at, c)) = rest.next() {
                    end = at;
                    match c {
                        '\\' => drop(rest.next()),
                        '"' => break,
                        _ => {}
                    }
                }
                let text: Result<String, _> = serde_json::from_str(&line[start..=end]);
                let is_member = line[end + 1..].trim_start().starts_with(':');
                let is_it = text.is_ok_and(|text| text == name);
                count += usize::from(depth == 1 && is_member && is_it);
            }
            _ => {}
        }
    }
    count
}

fn set(profile: &mut Profile, name: &str, value: Value) -> Result<(), String> {
    use serde_json::from_value as read;

    let result = match name {
        "name" => read(value).map(|name| profile.name = name),
        "roundoff" => read(value).map(|roundoff| profile.roundoff = roundoff),
        "models" => {
            let names = Model::ALL.map(Model::name);
            let has = chosen(names, value)?;
            let models = Model::ALL.into_iter().zip(has);
            profile.models = models
                .filter_map(|(model, has)| has.then_some(model))
                .collect();
            Ok(())
        }
        "ambient" => read(value).map(|ambient| profile.ambient = ambient),
        "lights" => {
            [
                profile.directional_lights,
                profile.point_lights,
                profile.spot_lights,
            ] = chosen(["directional", "point", "spot"], value)?;
            Ok(())
        }
        "most_lights" => read(value).map(|most| profile.most_lights = most),
        "most_shiny" => read(value).map(|most| profile.most_shiny = most),
        "integer_shininess" => read(value).map(|integer| profile.integer_shininess = integer),
        "unit_vectors" => read(value).map(|unit| profile.unit_vectors = unit),
        "clamps" => read(value).map(|range| profile.clamps = range),
        "srgb" => read(value).map(|srgb| profile.srgb = srgb),
        "bits" => read(value).map(|bits| profile.bits = bits),
        "whole_angle" => read(value).map(|whole| profile.whole_angle = whole),
        "attenuated_ambient" => read(value).map(|is| profile.attenuated_ambient = is),
        "unattenuated_highlight" => read(value).map(|is| profile.unattenuated_highlight = is),
        "highlight_on_the_dark_side" => {
            read(value).map(|has| profile.highlight_on_the_dark_side = has)
        }
        "normal_faces_eye" => read(value).map(|is| profile.normal_faces_eye = is),
        "black_without_lights" => read(value).map(|is| profile.black_without_lights = is),
        "unlit_without_lights" => read(value).map(|is| profile.unlit_without_lights = is),
        "unattenuated" => read(value).map(|is| profile.unattenuated = is),
        "gray_highlight" => read(value).map(|is| profile.gray_highlight = is),
        "spot_exponent" => read(value).map(|exponent| profile.spot_exponent = exponent),
        "ambient_times_diffuse" => read(value).map(|is| profile.ambient_times_diffuse = is),
        _ => return Err("there is no such member".into()),
    };
    result.map_err(|why| why.to_string())
}

/// Which of the names are in a list of names.
fn chosen(names: [&str; 3], list: Value) -> Result<[bool; 3], String> {
    let list: Vec<String> = serde_json::from_value(list).map_err(|why| why.to_string())?;
    match list.iter().find(|name| !names.contains(&name.as_str())) {
        Some(unknown) => Err(format!("{unknown:?} is none of {names:?}")),
        None => Ok(names.map(|name| list.iter().any(|chosen| chosen == name))),
    }
}

/// A color; also with the numbers that JSON lacks.
pub fn color(line: &str) -> Result<Triple, String> {
    let list = line.trim();
    let list = list
        .strip_prefix('[')
        .and_then(|list| list.strip_suffix(']'));
    let list = list.ok_or_else(|| format!("expected [red,green,blue], found {}", quoted(line)))?;
    let numbers: Vec<&str> = list.split(',').map(str::trim).collect();
    let numbers: Result<Vec<f64>, _> = numbers.into_iter().map(component).collect();
    let numbers = numbers.map_err(|why| format!("{why} in {}", quoted(line)))?;
    let count = numbers.len();
    Triple::try_from(numbers)
        .map_err(|_| format!("expected 3 numbers, found {count} in {}", quoted(line)))
}

fn component(text: &str) -> Result<f64, String> {
    text.parse().map_err(|_| match text {
        "" => "a number is missing".to_owned(),
        "null" => "null is no number; JavaScript writes it for NaN and Infinity".to_owned(),
        _ => format!("{} is no number", quoted(text)),
    })
}

/// The beginning of a text, in quotation marks and with its control characters escaped.
pub fn quoted(text: &str) -> String {
    const MOST: usize = 80;
    match text.char_indices().nth(MOST) {
        Some((end, _)) => format!("{:?}…", &text[..end]),
        None => format!("{text:?}"),
    }
}

#[cfg(test)]
mod tests {
    use shading_laws::{Light, Material, Scene};

    use super::*;

    /// A value, with every number as an `f64`.
    fn real(value: Value) -> Value {
        match value {
            Value::Number(number) => number.as_f64().into(),
            Value::Array(list) => list.into_iter().map(real).collect(),
            Value::Object(members) => {
                let members = members.into_iter();
                members.map(|(name, value)| (name, real(value))).collect()
            }
            other => other,
        }
    }

    /// The scene and the lights that `docs/format.md` shows, with their members in its order.
    #[test]
    fn scenes_are_written_as_the_page_shows() {
        let page = include_str!("../../docs/format.md");
        let shown = page
            .lines()
            .filter(|line| line.starts_with("{\"model") || line.starts_with("{\"kind"));
        let shown: Vec<String> = shown
            .map(|line| real(serde_json::from_str(line).expect("JSON")).to_string())
            .collect();
        let [scene, lights @ ..] = &shown[..] else {
            panic!("the page shows no scene");
        };
        let lights = format!(r#""lights":[{}]"#, lights.join(","));

        let [black, white] = [[0.0; 3], [1.0; 3]];
        let [position, attenuation] = [[0.0, 0.0, 2.0], [1.0, 0.0, 0.25]];
        let written = Scene {
            model: Model::BlinnPhong,
            p: black,
            n: [0.0, 0.0, 1.0],
            v: [0.0, 0.0, 2.0],
            material: Material {
                k_a: white,
                k_d: [0.5; 3],
                k_s: white,
                m: 8.0,
            },
            i_a: black,
            lights: vec![
                Light::Directional {
                    l: [0.0, 0.0, 1.0],
                    intensity: white,
                },
                Light::Point {
                    position,
                    intensity: white,
                    attenuation,
                },
                Light::Spot {
                    position,
                    intensity: white,
                    attenuation,
                    axis: [0.0, 0.0, -1.0],
                    half_angle: 0.5,
                },
            ],
        };
        assert_eq!(written.to_json(), scene.replace(r#""lights":[]"#, &lights));
    }

    #[test]
    fn every_member_of_the_page_is_read() {
        let page = include_str!("../../docs/format.md");
        let rows = page.lines().filter_map(|line| line.strip_prefix("| `\""));
        let rows: Vec<_> = rows.filter_map(|row| row.split_once("\"` | ")).collect();
        assert_eq!(rows.len(), 23);
        for (name, row) in rows {
            let default = row.split('`').nth(1).unwrap_or_default();
            let default = if name == "name" { "\"it\"" } else { default };
            let line = format!("{{\"{name}\":{default}}}");
            let expected = Profile {
                name: "it".into(),
                ..Profile::default()
            };
            assert_eq!(profile(&line, "it"), Ok(expected), "{line}");
        }
    }

    #[test]
    fn a_profile_says_what_the_renderer_has() {
        let line = r#"{"name":"it","roundoff":1e-3,"models":["phong"],"ambient":false,
            "lights":["spot"],"most_lights":4,"most_shiny":64.5,"integer_shininess":true,
            "unit_vectors":true,"clamps":[0,1],"srgb":true,"bits":8,"whole_angle":true,
            "attenuated_ambient":true,"unattenuated_highlight":true,
            "highlight_on_the_dark_side":true,"normal_faces_eye":true,"black_without_lights":true,
            "unattenuated":true,"gray_highlight":true,"spot_exponent":2,
            "ambient_times_diffuse":true}"#;
        let expected = Profile {
            name: "it".into(),
            roundoff: 1e-3,
            models: vec![Model::Phong],
            ambient: false,
            directional_lights: false,
            point_lights: false,
            spot_lights: true,
            most_lights: 4,
            most_shiny: 64.5,
            integer_shininess: true,
            unit_vectors: true,
            clamps: Some([0.0, 1.0]),
            srgb: true,
            bits: Some(8),
            whole_angle: true,
            attenuated_ambient: true,
            unattenuated_highlight: true,
            highlight_on_the_dark_side: true,
            normal_faces_eye: true,
            black_without_lights: true,
            unlit_without_lights: false, // goes with neither of two others
            unattenuated: true,
            gray_highlight: true,
            spot_exponent: 2.0,
            ambient_times_diffuse: true,
        };
        assert_eq!(profile(line, "the command"), Ok(expected));
        let unlit = profile(r#"{"unlit_without_lights":true}"#, "it");
        assert!(unlit.is_ok_and(|profile| profile.unlit_without_lights));
    }

    #[test]
    fn wrong_profiles_name_the_member() {
        for (line, named) in [
            ("{\"shading-laws\":1}", "\"shading-laws\": there is no such"),
            ("{\"roundoff\":\"f32\"}", "\"roundoff\": invalid type"),
            ("{\"most_lights\":1.5}", "\"most_lights\": invalid type"),
            ("{\"most_lights\":-1}", "\"most_lights\": invalid value"),
            ("{\"clamps\":[0]}", "\"clamps\": invalid length"),
            ("{\"models\":[\"pbr\"]}", "\"models\": \"pbr\" is none of"),
            ("{\"models\":[]}", "models is empty"),
            ("{\"bits\":1}", "bits is 1"),
            ("{\"bits\":8, \"bits\":8}", "\"bits\": it is there twice"),
            (
                "{\"bits\":8,\"\\u0062its\":8}",
                "\"bits\": it is there twice",
            ),
            ("{\"name\":\"\\\"bits\\\":8\",\"bits\":1}", "bits is 1"),
            ("[0,0,0]", "expected a JSON object"),
            ("ready", "expected a JSON object"),
        ] {
            let why = profile(line, "it").expect_err(line);
            assert!(why.contains(named), "{line}: {why}");
        }
    }

    #[test]
    fn colors_may_hold_what_json_lacks() {
        assert_eq!(color("[0.5, 1e-3,-2]"), Ok([0.5, 1e-3, -2.0]));
        assert_eq!(color(" [1,0.25,1e999]\r"), Ok([1.0, 0.25, f64::INFINITY]));
        let [infinite, negative, nan] = color("[Infinity,-inf,NaN]").expect("a color");
        assert!(infinite == f64::INFINITY && negative == f64::NEG_INFINITY && nan.is_nan());
        assert!(color("[nan,-nan,NAN]").is_ok_and(|color| color.iter().all(|x| x.is_nan())));
    }

    #[test]
    fn what_is_no_color_is_quoted() {
        for (line, part) in [
            ("", "expected [red,green,blue], found \"\""),
            ("0.5 0.5 0.5", "found \"0.5 0.5 0.5\""),
            ("[1,2]", "expected 3 numbers, found 2"),
            ("[1,2,3,4]", "expected 3 numbers, found 4"),
            ("[]", "a number is missing"),
            ("[1,2,red]", "\"red\" is no number"),
            ("[null,null,null]", "JavaScript"),
        ] {
            let why = color(line).expect_err(line);
            assert!(why.contains(part), "{line}: {why}");
        }
        assert!(quoted(&"é".repeat(1000)).len() < 200);
    }
}
