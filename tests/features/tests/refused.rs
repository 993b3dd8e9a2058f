//! Every type of the page's table refuses what its row says, and every unknown, missing or repeated field, every wrong type
//! and every number that is not finite.

use serde::de::DeserializeOwned;
use serde_json::{Map, Value};
use shading::{
    Attenuation, Cone, DirectionalLight, Light, Material, PointLight, Ranged, Rgb, SoftCone,
    SpotLight, UnitVec3, Vec3,
};

const PAGE: &str = include_str!("../../../docs/schema.md");

/// The types of the page's table, each with what it refuses.
fn rows_of_the_page() -> Vec<(&'static str, Vec<&'static str>)> {
    let rows = PAGE
        .lines()
        .skip_while(|line| !line.starts_with("| type |"))
        .skip(2);
    let rows = rows.take_while(|line| line.starts_with("| `"));
    rows.map(|row| {
        let name = row.split('`').nth(1).expect("a name");
        let refused = row
            .rsplit(" |")
            .nth(1)
            .expect("a cell")
            .trim()
            .trim_start_matches('|');
        let refused = refused
            .split([';', ':'])
            .map(str::trim)
            .filter(|what| !what.is_empty());
        (name, refused.collect())
    })
    .collect()
}

fn refuses<V: DeserializeOwned>(bad: &str) {
    assert!(serde_json::from_str::<V>(bad).is_err(), "{bad}");
}

/// The value, with each of its parts replaced by what `spoiled` makes of it.
fn each_spoiled(value: &Value, spoiled: &impl Fn(&Value) -> Vec<String>) -> Vec<String> {
    let mut all = spoiled(value);
    let mut part = |held: &Value, with: &dyn Fn(&str) -> String| {
        all.extend(each_spoiled(held, spoiled).iter().map(|bad| with(bad)));
    };
    match value {
        Value::Array(list) => {
            for (i, held) in list.iter().enumerate() {
                part(held, &|bad| {
                    let texts = list.iter().enumerate();
                    let texts = texts.map(|(k, other)| {
                        if i == k {
                            bad.to_owned()
                        } else {
                            other.to_string()
                        }
                    });
                    format!("[{}]", texts.collect::<Vec<_>>().join(","))
                });
            }
        }
        Value::Object(map) => {
            for (key, held) in map {
                part(held, &|bad| {
                    let mut others = map.clone();
                    others.remove(key);
                    with(&format!("\"{key}\": {bad}"), &others)
                });
            }
        }
        _ => {}
    }
    all
}

/// A map with a further entry.
fn with(entry: &str, others: &Map<String, Value>) -> String {
    let others = others
        .iter()
        .map(|(key, value)| format!("\"{key}\": {value}"));
    let all: Vec<_> = std::iter::once(entry.to_owned()).chain(others).collect();
    format!("{{{}}}", all.join(","))
}

/// Every way to spoil one value.
fn spoiled(value: &Value) -> Vec<String> {
    let others = [
        "null",
        "\"x\"",
        "[]",
        "[[]]",
        "{}",
        "{\"x\": 7}",
        "1e39",
        "-1e39",
        "1e999",
    ];
    let mut bad: Vec<_> = others.map(str::to_owned).to_vec();
    bad.push(if value.is_boolean() { "7" } else { "true" }.to_owned());
    if let Value::Array(list) = value {
        bad.push(Value::from(&list[1..]).to_string());
        bad.push(Value::from([&list[..], &list[..1]].concat()).to_string());
    }
    if let Value::Object(map) = value {
        bad.push(with("\"colour\": 1", map));
        for (key, held) in map {
            bad.push(with(&format!("\"{key}\": {held}"), map)); // twice
            let optional = [
                "clamped",
                "range",
                "unsquared",
                "smoothstep",
                "inner_half_angle",
                "inner_cosine",
            ];
            if !optional.contains(&&**key) {
                let mut others = map.clone();
                others.remove(key);
                bad.push(Value::from(others).to_string());
            }
        }
        // both an angle and a cosine, in any combination
        for (angle, cosine) in [
            ("half_angle", "cosine"),
            ("inner_half_angle", "inner_cosine"),
        ] {
            if map.contains_key(angle) {
                bad.push(with(&format!("\"{cosine}\": 0.5"), map));
            }
            if map.contains_key(cosine) {
                bad.push(with(&format!("\"{angle}\": 0.5"), map));
            }
        }
        if map.contains_key("half_angle") {
            bad.push(with("\"inner_cosine\": 0.99", map));
        }
        if map.contains_key("cosine") {
            bad.push(with("\"inner_half_angle\": 0.01", map));
        }
    }
    bad
}

/// What a type refuses, by the page's words, and some of it.
type Refused<'a> = &'a [(&'a str, &'a [&'a str])];

fn check<V: DeserializeOwned>(name: &str, good: &[&str], refused: Refused) {
    for good in good {
        assert!(serde_json::from_str::<V>(good).is_ok(), "{good}");
        let value: Value = serde_json::from_str(good).expect("JSON");
        for bad in each_spoiled(&value, &spoiled) {
            refuses::<V>(&bad);
        }
    }
    for (_, bad) in refused {
        bad.iter().for_each(|bad| refuses::<V>(bad));
    }
    let (_, said) = rows_of_the_page()
        .into_iter()
        .find(|(row, _)| *row == name)
        .expect("a row");
    let tried: Vec<_> = refused.iter().map(|(what, _)| *what).collect();
    assert_eq!(tried, said, "{name}");
}

const BAD_ANGLES: &[&str] = &[
    r#"{"half_angle": -0.001}"#,
    r#"{"half_angle": 3.1416}"#,
    r#"{"half_angle": 30}"#,
];
const BAD_COSINES: &[&str] = &[r#"{"cosine": 1.0001}"#, r#"{"cosine": -1.0001}"#];
const BOTH: &[&str] = &[
    r#"{"half_angle": 0.5, "cosine": 0.5}"#,
    r#"{"cosine": 0.5, "half_angle": 0.5}"#,
];
const SUN: &str = r#"{"l": [0, 0.6, 0.8], "intensity": [1, 2, 3]}"#;
const LAMP: &str = r#"{"position": [1, 2, 3], "intensity": [1, 2, 3], "attenuation": [1, 0, 2]}"#;
const FAR_LAMP: &str = r#"{"position": [1, 2, 3], "intensity": [1, 2, 3],
    "attenuation": {"coefficients": [1, 0, 2], "clamped": true, "range": 3}}"#;

const SOFT: &str = r#"{"half_angle": 0.5, "inner_half_angle": 0.25, "smoothstep": true}"#;

#[test]
fn parts_refuse_what_the_page_says() {
    // in single precision, in which 1e39 is not finite
    let three = "[1, -2, 1e5]";
    check::<Vec3<f32>>("Vec3", &[three], &[]);
    check::<Rgb<f32>>("Rgb", &[three], &[]);
    let length = r"\|v\|² that differs from 1 by more than 2⁻¹⁸";
    check::<UnitVec3<f32>>(
        "UnitVec3",
        &["[0, 0.6, 0.8]", "[0, 0.6, 0.800002]", "[0, 0.6, 0.799998]"],
        &[(
            length,
            &[
                "[0, 0, 0]",
                "[0, 0.6, 0.800003]",
                "[0, 0.6, 0.799997]",
                "[1, 1, 1]",
            ],
        )],
    );
    let negative: (&str, &[&str]) = (
        "a negative coefficient",
        &["[-1, 1, 1]", "[1, -1e-30, 1]", "[1, 1, -1]"],
    );
    let zero: (&str, &[&str]) = (
        "all three 0",
        &[
            "[0, 0, 0]",
            "[-0.0, 0, 0]",
            r#"{"coefficients": [0, 0, 0]}"#,
            "[[0, 0, 0], true]",
        ],
    );
    let list = "[1, 0, 0.25]";
    let clamped = r#"{"coefficients": [1, 0, 2], "clamped": true}"#;
    let ranged = r#"{"coefficients": [1, 0, 2], "clamped": true, "range": 3}"#;
    check::<Attenuation<f32>>("Attenuation", &[list, clamped], &[negative, zero]);
    refuses::<Attenuation<f32>>(ranged);
    let short: &[&str] = &[
        r#"{"coefficients": [1, 0, 2], "range": 0}"#,
        r#"{"coefficients": [1, 0, 2], "range": -1}"#,
    ];
    let of_gltf = r#"{"coefficients": [0, 0, 1], "range": 3, "unsquared": true}"#;
    refuses::<Attenuation<f32>>(r#"{"coefficients": [0, 0, 1], "unsquared": true}"#);
    check::<Ranged<f32>>(
        "Ranged",
        &[list, clamped, ranged, of_gltf],
        &[("a range of 0 or below", short)],
    );
    for (_, bad) in [negative, zero] {
        for bad in bad {
            refuses::<Ranged<f32>>(bad);
        }
    }

    let [of_angle, of_cosine] = [r#"{"half_angle": 0.5}"#, r#"{"cosine": 0.5}"#];
    check::<Cone<f32>>(
        "Cone",
        &[of_angle, of_cosine],
        &[
            ("an angle outside [0, π]", BAD_ANGLES),
            ("a cosine outside [−1, 1]", BAD_COSINES),
            ("both fields", BOTH),
        ],
    );
    let wide: &[&str] = &[
        r#"{"half_angle": 0.5, "inner_half_angle": 0.51}"#,
        r#"{"cosine": 0.5, "inner_cosine": 0.49}"#,
    ];
    let soft = [
        SOFT,
        r#"{"cosine": 0.5, "inner_cosine": 0.75, "smoothstep": true}"#,
    ];
    check::<SoftCone<f32>>(
        "SoftCone",
        &[of_angle, of_cosine, soft[0], soft[1]],
        &[("an inner cone wider than the outer one", wide)],
    );
    for bad in [BAD_ANGLES, BAD_COSINES, BOTH].concat() {
        refuses::<SoftCone<f32>>(bad);
    }
}

#[test]
fn lights_and_materials_refuse_what_the_page_says() {
    type Wide = Light<f32, SoftCone<f32>, Ranged<f32>>;
    let of_angle = r#"{"half_angle": 0.5}"#;
    let spot = format!(r#"{{"point": {LAMP}, "axis": [0, 0, 1], "cone": {of_angle}}}"#);
    let soft_spot = format!(r#"{{"point": {FAR_LAMP}, "axis": [0, 0, 1], "cone": {SOFT}}}"#);
    check::<DirectionalLight<f32>>("DirectionalLight", &[SUN], &[]);
    check::<PointLight<f32>>("PointLight", &[LAMP], &[]);
    check::<PointLight<f32, Ranged<f32>>>("PointLight", &[LAMP, FAR_LAMP], &[]);
    check::<SpotLight<f32>>("SpotLight", &[&spot], &[]);
    check::<SpotLight<f32, SoftCone<f32>, Ranged<f32>>>("SpotLight", &[&spot, &soft_spot], &[]);
    let named = [("directional", SUN), ("point", LAMP), ("spot", &spot)]
        .map(|(kind, light)| format!(r#"{{"{kind}": {light}}}"#));
    let kinds: (&str, &[&str]) = ("another kind", &[r#"{"area": {}}"#, r#""point""#]);
    let named: Vec<_> = named.iter().map(String::as_str).collect();
    check::<Light<f32>>("Light", &named, &[kinds]);
    let soft_spot = format!(r#"{{"spot": {soft_spot}}}"#);
    check::<Wide>("Light", &[&named[..], &[&soft_spot]].concat(), &[kinds]);
    let material = r#"{"k_a": [1, 0, 0.5], "k_d": [1, 0, 0.5], "k_s": [1, 0, 0.5], "m": 8}"#;
    let with_m = |m: &str| material.replace("8}", &format!("{m}}}"));
    let bad = [
        with_m("-1"),
        with_m("32.5"),
        with_m("32.0"),
        with_m("4294967296"),
    ];
    let bad = bad.each_ref().map(String::as_str);
    let refused: Refused = &[("for a `u32`", &[]), ("a negative m, a fraction", &bad)];
    check::<Material<f32, u32>>("Material", &[material], refused);
}
