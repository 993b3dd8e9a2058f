//! The shader behind pipes, in the format of `shading-laws`.

use std::error::Error;
use std::io::{BufRead, Write, stdin, stdout};

use serde_json::Value;
use shader::{PHONG, Shader};
use shading_laws::{Light, Material, Model, Renderer, Scene, Triple};

fn main() -> Result<(), Box<dyn Error>> {
    let mut shader = Shader::new(PHONG)?;
    let (mut out, mut lines) = (stdout().lock(), stdin().lock().lines());
    lines.next().ok_or("no version")??;
    writeln!(out, r#"{{"name":"a WGSL shader"}}"#)?;
    let mut batch = Vec::new();
    for line in lines {
        let line = line?;
        if !line.is_empty() {
            batch.push(read_scene(&serde_json::from_str(&line)?).ok_or(line)?);
            continue;
        }
        for [r, g, b] in shader.shade(&batch)? {
            writeln!(
                out,
                "{}",
                format!("[{r},{g},{b}]").replace("inf", "Infinity")
            )?;
        }
        out.flush()?;
        batch.clear();
    }
    Ok(())
}

fn read_scene(scene: &Value) -> Option<Scene> {
    let name = scene["model"].as_str()?;
    Some(Scene {
        model: Model::ALL.into_iter().find(|model| model.name() == name)?,
        p: triple(&scene["p"])?,
        n: triple(&scene["n"])?,
        v: triple(&scene["v"])?,
        material: Material {
            k_a: triple(&scene["k_a"])?,
            k_d: triple(&scene["k_d"])?,
            k_s: triple(&scene["k_s"])?,
            m: scene["m"].as_f64()?,
        },
        i_a: triple(&scene["i_a"])?,
        lights: scene["lights"]
            .as_array()?
            .iter()
            .map(read_light)
            .collect::<Option<_>>()?,
    })
}

fn read_light(light: &Value) -> Option<Light> {
    let intensity = triple(&light["intensity"])?;
    Some(match light["kind"].as_str()? {
        "directional" => Light::Directional {
            l: triple(&light["l"])?,
            intensity,
        },
        "point" => Light::Point {
            position: triple(&light["position"])?,
            intensity,
            attenuation: triple(&light["attenuation"])?,
        },
        _ => Light::Spot {
            position: triple(&light["position"])?,
            intensity,
            attenuation: triple(&light["attenuation"])?,
            axis: triple(&light["axis"])?,
            half_angle: light["angle"].as_f64()?,
        },
    })
}

fn triple(array: &Value) -> Option<Triple> {
    Some([array[0].as_f64()?, array[1].as_f64()?, array[2].as_f64()?])
}
