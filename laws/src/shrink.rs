//! Simpler scenes near a scene: what a failing case is made smaller by.

use serde_json::Value;

use crate::bounded::rounded;
use crate::edit::EDITS;
use crate::profile::Profile;
use crate::scene::{Light, Model, Scene, Triple, size};

const ZERO: Triple = [0.0; 3];

/// The paths of a scene's numbers, and of its lists of three.
fn paths(value: &Value, path: &str, found: &mut Vec<String>) {
    match value {
        Value::Number(_) => found.push(path.into()),
        Value::Array(list) => {
            if list.len() == 3 && list[0].is_number() {
                found.push(path.into());
            }
            for (i, value) in list.iter().enumerate() {
                paths(value, &format!("{path}/{i}"), found);
            }
        }
        Value::Object(members) => {
            members
                .iter()
                .for_each(|(name, value)| paths(value, &format!("{path}/{name}"), found));
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
    let mut found: Vec<Scene> = EDITS
        .iter()
        .filter_map(|edit| edit.of(scene, profile))
        .collect();
    found.extend(Model::ALL.map(|model| Scene {
        model,
        ..scene.clone()
    }));
    // half of the lights, all but one, or one
    let with = |lights: &[Light]| Scene {
        lights: lights.to_vec(),
        ..scene.clone()
    };
    let (first, second) = scene.lights.split_at(scene.lights.len() / 2);
    found.extend([first, second].map(with));
    for (i, light) in scene.lights.iter().enumerate().take(32) {
        found.push(with(&[*light]));
        found.push(with(&[&scene.lights[..i], &scene.lights[i + 1..]].concat()));
    }
    // all but one of the terms at once
    let Scene {
        k_a, k_d, k_s, i_a, ..
    } = *scene;
    for (k_a, k_d, k_s, i_a) in [
        (k_a, ZERO, ZERO, i_a),
        (ZERO, k_d, ZERO, ZERO),
        (ZERO, ZERO, k_s, ZERO),
    ] {
        found.push(Scene {
            k_a,
            k_d,
            k_s,
            i_a,
            ..scene.clone()
        });
    }
    let (json, mut places) = (serde_json::to_value(scene).unwrap_or_default(), Vec::new());
    paths(&json, "", &mut places);
    for path in places.iter().take(160) {
        let Some(old) = json.pointer(path) else {
            continue;
        };
        let shorter: Vec<Value> = match (old.as_f64(), serde_json::from_value(old.clone())) {
            (Some(number), _) => shorter_number(number)
                .into_iter()
                .map(Value::from)
                .collect(),
            (None, Ok(triple)) => shorter(triple)
                .into_iter()
                .map(|v| Value::from(v.to_vec()))
                .collect(),
            _ => continue,
        };
        for new in shorter {
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

/// Simple numbers, and the old one with fewer digits.
fn shorter_number(old: f64) -> Vec<f64> {
    let mut found = vec![0.0, 0.25, 0.5, 1.0, 1.5, 2.0, 8.0, 32.0, 128.0];
    found.extend([1.0, 2.0, 8.0, 256.0].map(|steps| (old * steps).round() / steps));
    // few significant bits, for numbers that are very small or large
    found.extend([1.0, 2.0, 4.0, 8.0].map(|bits: f64| rounded(old, (-bits).exp2())));
    found.into_iter().map(|c| c + 0.0).collect() // no -0
}

/// Simple vectors, and the old one along one axis or with fewer digits.
fn shorter(old: Triple) -> Vec<Triple> {
    let mut found = vec![ZERO, [1.0; 3], [0.5; 3]];
    for axis in 0..3 {
        for c in [
            1.0,
            -1.0,
            0.5,
            2.0,
            4.0,
            1024.0,
            16384.0,
            1.0 / 128.0,
            old[axis],
        ] {
            let mut v = ZERO;
            v[axis] = c;
            found.push(v);
        }
    }
    let largest = size(old).max(f64::MIN_POSITIVE).log2().floor().exp2();
    for unit in [1.0, largest] {
        found.extend(
            [1.0, 2.0, 8.0, 256.0]
                .map(|steps| old.map(|c| (c / unit * steps).round() * unit / steps)),
        );
    }
    found.into_iter().map(|v| v.map(|c| c + 0.0)).collect() // no -0
}
