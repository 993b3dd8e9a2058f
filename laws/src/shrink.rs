//! Simpler scenes near a scene: what a failing case is made smaller by.

use serde_json::Value;

use crate::bounded::rounded;
use crate::edit::EDITS;
use crate::profile::Profile;
use crate::scene::{Model, Scene, Triple, size};

/// The paths of a scene's numbers and lists.
fn paths(value: &Value, path: &str, found: &mut Vec<String>) {
    match value {
        Value::Number(_) => found.push(path.into()),
        Value::Array(list) => {
            found.push(path.into());
            for (i, value) in list.iter().enumerate() {
                paths(value, &format!("{path}/{i}"), found);
            }
        }
        Value::Object(members) => {
            for (name, value) in members {
                paths(value, &format!("{path}/{name}"), found);
            }
        }
        _ => {}
    }
}

/// How much there is to read in a scene: zeros are nothing, and a highlight is something.
pub fn cost(scene: &Scene) -> u32 {
    let of_byte = |byte| match byte {
        b'0' => 0,
        b'1'..=b'9' => 8 + u32::from(byte - b'0'),
        _ => 4,
    };
    let shown: u32 = scene.to_json().bytes().map(of_byte).sum();
    shown + if scene.model == Model::Lambert { 0 } else { 16 }
}

/// Simpler scenes, the simplest first.
pub fn simpler(scene: &Scene, profile: &Profile) -> Vec<Scene> {
    let edited = EDITS.iter().filter_map(|edit| edit.of(scene, profile));
    let mut found: Vec<Scene> = edited.collect();
    let (json, mut places) = (serde_json::to_value(scene).unwrap_or_default(), Vec::new());
    paths(&json, "", &mut places);
    for path in places.iter().take(160) {
        for new in json.pointer(path).map(shorter).unwrap_or_default() {
            let mut edited = json.clone();
            if let Some(place) = edited.pointer_mut(path) {
                *place = new;
            }
            found.extend(serde_json::from_value::<Scene>(edited));
        }
    }
    let limit = cost(scene);
    let found = found.into_iter().map(|scene| profile.fitted(scene));
    let found = found.map(|scene| (cost(&scene), scene));
    let is_simpler = |(cost, scene): &(u32, Scene)| *cost < limit && profile.has_all_of(scene);
    let mut found: Vec<_> = found.filter(is_simpler).collect();
    found.sort_by_key(|(cost, _)| *cost);
    found.dedup_by(|a, b| a.1 == b.1);
    found.into_iter().map(|(_, scene)| scene).collect()
}

/// Simpler numbers and vectors, and one light or all but one of the lights.
fn shorter(old: &Value) -> Vec<Value> {
    if let Some(number) = old.as_f64() {
        return numbers(number).into_iter().map(Value::from).collect();
    }
    if let Ok(vector) = serde_json::from_value(old.clone()) {
        return vectors(vector).map(|v| Value::from(v.to_vec())).collect();
    }
    let lights = old.as_array().map_or(&[][..], Vec::as_slice);
    let some = (0..lights.len().min(32)).flat_map(|i| {
        let others = [&lights[..i], &lights[i + 1..]].concat();
        [vec![lights[i].clone()], others].map(Value::from)
    });
    some.collect()
}

/// Simple numbers, and the old one with fewer digits.
fn numbers(old: f64) -> Vec<f64> {
    let mut found = vec![0.0, 0.25, 0.5, 1.0, 1.5, 2.0, 8.0, 32.0, 128.0];
    found.extend([1.0, 2.0, 8.0, 256.0].map(|steps| (old * steps).round() / steps));
    // few significant bits, for numbers that are very small or large
    found.extend([1.0, 2.0, 4.0, 8.0].map(|bits: f64| rounded(old, (-bits).exp2())));
    found.into_iter().map(|c| c + 0.0).collect() // no -0
}

/// Simple vectors, and the old one along one axis or with fewer digits.
fn vectors(old: Triple) -> impl Iterator<Item = Triple> {
    let on_axes = (0..3).flat_map(move |axis| {
        [1.0, -1.0, 2.0, 1024.0, 1.0 / 128.0, old[axis]].map(|c| {
            let mut v = [0.0; 3];
            v[axis] = c;
            v
        })
    });
    let largest = size(old).max(f64::MIN_POSITIVE).log2().floor().exp2();
    let of_few = [1.0, 2.0, 8.0, 256.0]
        .map(|steps| old.map(|c| (c / largest * steps).round() * largest / steps));
    let simple = [[0.0; 3], [0.5; 3], [1.0; 3]].into_iter();
    let all = simple.chain(on_axes).chain(of_few);
    all.map(|v| v.map(|c| c + 0.0)) // no -0
}
