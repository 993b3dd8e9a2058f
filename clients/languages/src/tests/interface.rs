//! The calls of `interface.json`, which Python and JavaScript make too, and those that only C can
//! write.

use std::ffi::CStr;

use serde_json::{Map, Value};

use super::{refusal, scene, shade, sun};
use crate::c::{
    CScene, shading_default_light, shading_height_field, shading_implicit, shading_mesh_normals,
    shading_status_text,
};
use crate::light::Light;

const FILE: &str = include_str!("../../interface.json");
const HEADER: &str = include_str!("../../shading.h");

fn interface() -> Map<String, Value> {
    serde_json::from_str(FILE).expect("valid JSON")
}

#[allow(clippy::cast_possible_truncation)] // a number of C
fn number(value: &Value) -> f32 {
    match value {
        Value::String(name) if name == "nan" => f32::NAN,
        Value::String(name) if name == "inf" => f32::INFINITY,
        Value::Bool(is) => f32::from(u8::from(*is)),
        value => value.as_f64().expect("a number") as f32,
    }
}

/// Numbers, however deep they are.
fn numbers(value: &Value) -> Vec<f32> {
    match value {
        Value::Array(values) => values.iter().flat_map(numbers).collect(),
        value => vec![number(value)],
    }
}

fn triples(value: &Value) -> Vec<[f32; 3]> {
    let numbers = numbers(value);
    assert_eq!(numbers.len() % 3, 0);
    numbers.as_chunks().0.to_vec()
}

/// One number is gray.
fn color(value: &Value) -> [f32; 3] {
    let numbers = numbers(value);
    std::array::from_fn(|i| numbers[i.min(numbers.len() - 1)])
}

fn is_for_each(value: &Value, one: usize) -> bool {
    numbers(value).len() > one
}

fn light(described: &Value) -> Light {
    let (kind, arguments) = described
        .as_object()
        .and_then(|light| light.iter().next())
        .expect("a light");
    let kinds = ["directional", "point", "spot"];
    let kind = (0..3).find(|&i| kinds[i as usize] == kind).expect("a kind");
    let mut light = shading_default_light(kind);
    for (name, value) in arguments.as_object().expect("arguments") {
        match name.as_str() {
            "position" => light.position = color(value),
            "toward" => light.toward = color(value),
            "axis" => light.axis = color(value),
            "intensity" => light.intensity = color(value),
            "attenuation" => light.attenuation = color(value),
            "range" => light.range = number(value),
            "inner" => light.inner = number(value),
            "outer" => light.outer = number(value),
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // 0, 1 or 7
            "gltf" => light.gltf = number(value) as u32,
            name => panic!("C has no {name}"),
        }
    }
    light
}

type Refusal = (i32, usize, usize, String);

/// The arrays of a call, which live as long as its scene.
#[derive(Default)]
struct Arrays {
    triples: Vec<Vec<[f32; 3]>>,
    numbers: Vec<Vec<f32>>,
}

impl Arrays {
    fn triples(&mut self, value: &Value) -> *const [f32; 3] {
        self.triples.push(triples(value));
        self.triples[self.triples.len() - 1].as_ptr()
    }

    fn numbers(&mut self, value: &Value) -> *const f32 {
        self.numbers.push(numbers(value));
        self.numbers[self.numbers.len() - 1].as_ptr()
    }

    /// Sets an argument, for all points or for each.
    fn set(&mut self, scene: &mut CScene, name: &str, value: &Value, models: &[Value]) {
        match name {
            "points" => scene.points = self.triples(value),
            "normals" => scene.normals = self.triples(value),
            "eye" => scene.eye = color(value),
            "m" if is_for_each(value, 1) => scene.each.m = self.numbers(value),
            "m" => scene.material.m = number(value),
            "visible" => scene.each.visible = self.numbers(value),
            "k_a" if is_for_each(value, 3) => scene.each.k_a = self.triples(value),
            "k_d" if is_for_each(value, 3) => scene.each.k_d = self.triples(value),
            "k_s" if is_for_each(value, 3) => scene.each.k_s = self.triples(value),
            "ambient" if is_for_each(value, 3) => scene.each.ambient = self.triples(value),
            "k_a" => scene.material.k_a = color(value),
            "k_d" => scene.material.k_d = color(value),
            "k_s" => scene.material.k_s = color(value),
            "ambient" => scene.ambient = color(value),
            "model" => {
                let model = models.iter().position(|model| model == value);
                scene.model = u32::try_from(model.unwrap_or(models.len())).expect("few models");
            }
            "parts" => scene.parts = u32::from(value == &Value::Bool(true)),
            name => panic!("C has no {name}"),
        }
    }
}

fn shaded(call: &Value, interface: &Map<String, Value>) -> Result<Vec<[f32; 3]>, Refusal> {
    let mut arguments = interface["base"].as_object().expect("arguments").clone();
    if let Some(change) = call["change"].as_object() {
        arguments.extend(change.clone());
    }
    let lights = arguments.remove("lights").expect("lights");
    let lights: Vec<_> = match call.get("light") {
        Some(alone) => vec![light(alone)],
        None => lights
            .as_array()
            .expect("lights")
            .iter()
            .map(light)
            .collect(),
    };
    let (mut scene, mut arrays) = (scene(&lights), Arrays::default());
    scene.eye = super::shading_default_scene().eye;
    scene.material = super::shading_default_scene().material;
    for (name, value) in &arguments {
        if call["leave_out"] != Value::String(name.clone()) {
            let models = interface["models"].as_array().expect("models");
            arrays.set(&mut scene, name, value, models);
        }
    }
    shade(&scene)
}

fn height_field(field: &Value) -> Result<Vec<[f32; 3]>, Refusal> {
    let step = |name| field.get(name).map_or(1.0, number);
    let (z, rows) = (
        numbers(&field["z"]),
        field["z"].as_array().expect("rows").len(),
    );
    let mut out = vec![[0.0; 3]; z.len()];
    let columns = z.len() / rows;
    // SAFETY: the arrays are as long as they say
    refusal(|error| unsafe {
        shading_height_field(
            rows,
            columns,
            z.as_ptr(),
            step("dx"),
            step("dy"),
            out.as_mut_ptr(),
            error,
        )
    })?;
    Ok(out)
}

fn implicit(surface: &Value) -> Result<Vec<[f32; 3]>, Refusal> {
    let step = |name| surface.get(name).map_or(1.0, number);
    let (values, points) = (numbers(&surface["values"]), triples(&surface["points"]));
    let length = |value: &Value| value.as_array().expect("an array").len();
    let (layers, rows) = (length(&surface["values"]), length(&surface["values"][0]));
    let columns = length(&surface["values"][0][0]);
    let mut out = vec![[0.0; 3]; points.len()];
    // SAFETY: the arrays are as long as they say
    refusal(|error| unsafe {
        shading_implicit(
            layers,
            rows,
            columns,
            values.as_ptr(),
            step("dx"),
            step("dy"),
            step("dz"),
            points.len(),
            points.as_ptr(),
            out.as_mut_ptr(),
            error,
        )
    })?;
    Ok(out)
}

fn mesh_normals(mesh: &Value) -> Result<Vec<[f32; 3]>, Refusal> {
    let vertices = triples(&mesh["vertices"]);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // indices
    let faces: Vec<[u32; 3]> = triples(&mesh["faces"])
        .iter()
        .map(|face| face.map(|i| i as u32))
        .collect();
    let crease = mesh.get("crease").map_or(-1.0, number);
    let corners = if crease < 0.0 {
        vertices.len()
    } else {
        3 * faces.len()
    };
    let mut out = vec![[0.0; 3]; corners];
    // SAFETY: the arrays are as long as they say
    refusal(|error| unsafe {
        let (count, face_count) = (vertices.len(), faces.len());
        shading_mesh_normals(
            count,
            vertices.as_ptr(),
            face_count,
            faces.as_ptr(),
            crease,
            out.as_mut_ptr(),
            error,
        )
    })?;
    Ok(out)
}

#[test]
fn each_call_ends_as_in_the_other_languages() {
    let interface = interface();
    let calls = ["calls", "normals"].map(|kind| interface[kind].as_array().expect("calls"));
    for call in calls.into_iter().flatten() {
        let what = &call["what"];
        let of = |name: &str| call.get(name);
        let result = match (of("height_field"), of("implicit"), of("mesh_normals")) {
            (Some(field), ..) => height_field(field),
            (_, Some(surface), _) => implicit(surface),
            (.., Some(mesh)) => mesh_normals(mesh),
            _ => shaded(call, &interface),
        };
        if let Some(expected) = call.get("value") {
            let colors = result.unwrap_or_else(|error| panic!("{what}: {error:?}"));
            let expected = triples(expected);
            for (i, color) in colors.iter().enumerate() {
                let right = expected[i % expected.len()];
                for (x, right) in color.iter().zip(right) {
                    assert!((x - right).abs() <= 1e-7, "{what}: {color:?} for {right:?}");
                }
            }
        } else {
            let sentence = call
                .get("c")
                .unwrap_or(&call["error"])
                .as_str()
                .expect("a sentence");
            let (status, .., text) = result.expect_err(&what.to_string());
            assert!(text.contains(sentence), "{what}: {text}");
            // what the status says is about the same argument
            // SAFETY: the sentence ends in a zero byte
            let general = unsafe { CStr::from_ptr(shading_status_text(status)) };
            let general = general.to_str().expect("ASCII");
            let name = text
                .split(':')
                .next()
                .expect("a name")
                .replace("lights[0].", "");
            let is_named = name.split(", ").all(|name| general.contains(name));
            assert!(
                is_named || name == "vertices",
                "{what}: {general} for {text}"
            );
        }
    }
}

/// The members of a structure of the header.
fn members(structure: &str) -> Vec<String> {
    let body = HEADER
        .split(&format!("typedef struct {structure} {{"))
        .nth(1)
        .expect("the structure");
    let body = body.split('}').next().expect("its end");
    let code: String = body
        .split("/*")
        .map(|part| part.split("*/").last().unwrap_or(""))
        .collect();
    code.split(';')
        .flat_map(|member| member.split(','))
        .filter_map(|member| {
            member
                .split('[')
                .next()?
                .split([' ', '*', '\n'])
                .rfind(|word| !word.is_empty())
        })
        .map(str::to_owned)
        .collect()
}

#[test]
fn arguments_and_defaults_are_those_of_the_other_languages() {
    let interface = interface();
    let light_members = members("shading_light");
    let kinds = interface["lights"].as_object().expect("lights");
    for (kind, (name, defaults)) in (0..).zip(kinds) {
        let arguments = defaults.as_object().expect("arguments");
        for argument in arguments.keys() {
            assert!(
                light_members.contains(argument),
                "shading_light has no {argument}"
            );
        }
        let mut given = arguments.clone();
        given.retain(|_, value| !value.is_null());
        let written = serde_json::json!({ name: given });
        let (default, written) = (shading_default_light(kind), light(&written));
        // as text, in which NaN is equal to NaN
        assert_eq!(format!("{default:?}"), format!("{written:?}"), "{name}");
    }
    let mut scene_members = members("shading_scene");
    scene_members.extend(members("shading_material"));
    for argument in interface["shade"].as_object().expect("arguments").keys() {
        let is_member =
            scene_members.contains(argument) || members("shading_each").contains(argument);
        assert!(is_member, "there is no {argument}");
    }
    for function in interface["functions"].as_array().expect("functions") {
        let name = function.as_str().expect("a name");
        let is_light = kinds.contains_key(name);
        assert!(
            is_light || HEADER.contains(&format!("shading_{name}(")),
            "{name}"
        );
    }
}

#[test]
fn every_status_has_a_constant_and_a_sentence() {
    let constants = HEADER
        .split("enum shading_status {")
        .nth(1)
        .and_then(|rest| rest.split("};").next());
    let constants = constants
        .expect("the statuses")
        .lines()
        .filter(|line| line.contains("SHADING_"));
    let count = i32::try_from(constants.clone().count()).expect("few");
    // SAFETY: the sentences end in a zero byte
    let text = |status| {
        unsafe { CStr::from_ptr(shading_status_text(status)) }
            .to_str()
            .expect("ASCII")
    };
    for (status, line) in (0..).zip(constants) {
        assert!(
            line.contains(&format!("= {status},")) || line.contains(&format!("= {status} ")),
            "{line}"
        );
        assert_ne!(text(status), text(count), "{line}");
    }
    assert_eq!(text(count), "there is no such status");
    assert_eq!(text(-1), "there is no such status");
}

#[test]
fn a_structure_of_zeros_is_refused() {
    let lights = [sun()];
    let mut zeros = scene(&lights);
    zeros.material = crate::c::Material {
        k_a: [0.0; 3],
        k_d: [0.0; 3],
        k_s: [0.0; 3],
        m: 0.0,
    };
    assert_eq!(
        shade(&zeros).expect_err("all is 0").3,
        "k_d: expected a reflectance, such as 0.6, in k_d, k_a or k_s, got none"
    );
    zeros.material.m = 1.0; // black on purpose
    assert_eq!(shade(&zeros), Ok(vec![[0.0; 3]; 2]));
    // a light of zeros has no direction
    let zero = Light {
        kind: 0,
        toward: [0.0; 3],
        ..sun()
    };
    assert_eq!(
        shade(&scene(&[sun(), zero])).expect_err("no direction").1,
        1
    );
}

#[test]
fn an_error_says_which_light_and_which_point() {
    let dark = Light {
        intensity: [0.0, -1.0, 0.0],
        ..sun()
    };
    let lights = [sun(), sun(), dark];
    let (status, light, index, text) = shade(&scene(&lights)).expect_err("negative");
    assert_eq!((status, light, index), (18, 2, usize::MAX));
    assert_eq!(
        text,
        "lights[2].intensity: expected finite numbers of 0 or more, got (0, -1, 0)"
    );
    let points = [[0.0; 3], [f32::NAN; 3]];
    let lights = [sun()];
    let mut scene = scene(&lights);
    scene.points = points.as_ptr();
    let (status, light, index, _) = shade(&scene).expect_err("NaN");
    assert_eq!((status, light, index), (7, usize::MAX, 1));
    // without room for the error, there is still the status
    let mut out = [[0.0; 3]; 2];
    // SAFETY: the arrays have two rows
    let status =
        unsafe { super::shading_shade(&raw const scene, out.as_mut_ptr(), std::ptr::null_mut()) };
    assert_eq!(status, 7);
}

#[test]
fn lambert_ignores_the_highlight() {
    let lights = [sun()];
    let mut lambert = scene(&lights);
    lambert.model = 0;
    let expected = shade(&lambert);
    for (k_s, m) in [(f32::NAN, 32.0), (-1.0, 32.0), (0.5, f32::NAN), (0.5, -1.0)] {
        lambert.material.k_s = [k_s; 3];
        lambert.material.m = m;
        assert_eq!(shade(&lambert), expected);
        let phong = CScene {
            model: 1,
            ..lambert
        };
        assert!(shade(&phong).is_err());
    }
}
