//! Cases in JSON, one object per line.

use serde_json::Value;

use crate::scene::Lamp;
use crate::table::read;

pub fn cases(file: &str) -> Vec<Value> {
    let text = read(file);
    let lines = text.lines().map(serde_json::from_str);
    lines.map(|case| case.expect("a JSON object")).collect()
}

pub fn lamps(case: &Value, lamp: fn(&Value) -> Lamp) -> Vec<Lamp> {
    let lights = case["lights"].as_array().expect("lights");
    lights.iter().map(lamp).collect()
}

pub fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| panic!("{value} is not a number"))
}

pub fn three(value: &Value) -> [f64; 3] {
    [0, 1, 2].map(|i| number(&value[i]))
}
