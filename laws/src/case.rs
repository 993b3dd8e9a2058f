//! Cases as lines of JSON, to be stored and tried again.

use serde_json::{Value, json};

use crate::generator::Base;
use crate::law::LAWS;
use crate::scene::{Light, Material, Model, Scene, Triple};

/// A case of a law as a line.
pub fn write(law: &str, base: &Base) -> String {
    let Base {
        scene,
        ways,
        factors,
    } = base;
    json!({"law": law, "scene": scene.json(), "ways": ways, "factors": factors}).to_string()
}

/// The law and the case of a line.
pub fn read(line: &str) -> Result<(String, Base), String> {
    let value: Value = serde_json::from_str(line).map_err(|why| why.to_string())?;
    let law = value["law"].as_str().ok_or("no \"law\"")?;
    if !LAWS.iter().any(|known| known.name == law) {
        return Err(format!("there is no law {law}"));
    }
    let ways = value["ways"].as_array().ok_or("no \"ways\"")?;
    let way = |i: usize| {
        ways.get(i)
            .map_or(Err("too few ways".into()), |way| triple(way, "ways"))
    };
    let base = Base {
        scene: scene(&value["scene"])?,
        ways: [way(0)?, way(1)?, way(2)?],
        factors: triple(&value["factors"], "factors")?,
    };
    Ok((law.to_owned(), base))
}

/// A scene as the format has it.
pub fn scene(value: &Value) -> Result<Scene, String> {
    let name = value["model"].as_str().unwrap_or_default();
    let model = Model::ALL.into_iter().find(|model| model.name() == name);
    let lights = value["lights"].as_array().ok_or("no \"lights\"")?;
    let of = |name: &str| triple(&value[name], name);
    Ok(Scene {
        model: model.ok_or_else(|| format!("there is no model {name:?}"))?,
        p: of("p")?,
        n: of("n")?,
        v: of("v")?,
        material: Material {
            k_a: of("k_a")?,
            k_d: of("k_d")?,
            k_s: of("k_s")?,
            m: number(&value["m"], "m")?,
        },
        i_a: of("i_a")?,
        lights: lights.iter().map(light).collect::<Result<_, _>>()?,
    })
}

fn light(value: &Value) -> Result<Light, String> {
    let of = |name: &str| triple(&value[name], name);
    let intensity = of("intensity")?;
    Ok(match value["kind"].as_str().unwrap_or_default() {
        "directional" => Light::Directional {
            l: of("l")?,
            intensity,
        },
        "point" => Light::Point {
            position: of("position")?,
            intensity,
            attenuation: of("attenuation")?,
        },
        "spot" => Light::Spot {
            position: of("position")?,
            intensity,
            attenuation: of("attenuation")?,
            axis: of("axis")?,
            half_angle: number(&value["angle"], "angle")?,
        },
        kind => return Err(format!("there is no light {kind:?}")),
    })
}

fn number(value: &Value, name: &str) -> Result<f64, String> {
    value
        .as_f64()
        .ok_or_else(|| format!("\"{name}\" is no number"))
}

fn triple(value: &Value, name: &str) -> Result<Triple, String> {
    let list = value.as_array().map_or(&[][..], Vec::as_slice);
    let numbers: Option<Vec<f64>> = list.iter().map(Value::as_f64).collect();
    let triple = numbers.and_then(|numbers| Triple::try_from(numbers).ok());
    triple.ok_or_else(|| format!("\"{name}\" is not three numbers"))
}
