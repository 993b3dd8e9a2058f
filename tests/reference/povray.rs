//! The sum over lights against POV-Ray (`tests/data/README.md`).

use serde_json::Value;
use support::number::for_f32_and_f64;

use crate::json::{cases, lamps, number, three};
use crate::scene::{Lamp, Scene, Source, Spot, minus};
use crate::table::Tally;
use support::running::Float;

for_f32_and_f64!(povray);

/// POV-Ray writes 16 bits per channel: the tolerance is half a step, plus the rounding error that
/// running error analysis bounds for each case.
fn povray<T: Float>() {
    const FILE: &str = "povray_cases.jsonl";
    let mut tally = Tally::new::<T>(FILE);
    for case in cases(FILE) {
        let scene = scene(&case);
        let color: [T; 3] = scene.shade::<T>().clamped().into();
        let expected = three(&case["pov_rgb16"]).map(|c| c / 65535.0);
        let tolerance = scene
            .rounding::<T::Running>()
            .map(|rounding| 0.5 / 65535.0 + rounding);
        tally.compare(&case["id"], color.map(T::to_f64), expected, tolerance);
    }
    tally.close(250, &[]);
}

fn scene(case: &Value) -> Scene {
    let factor = |key: &str| number(&case[key]);
    let pigment = three(&case["pigment"]);
    Scene {
        p: three(&case["P"]),
        n: three(&case["N"]),
        n_as_given: false,
        eye: three(&case["eye"]),
        emission: [0.0; 3],
        ambient: [
            pigment.map(|c| c * factor("ambient")),
            three(&case["ambient_light"]),
        ],
        k_a: [0.0; 3],
        k_d: pigment.map(|c| c * factor("diffuse")),
        phong: ([factor("phong"); 3], factor("phong_size")),
        blinn: ([factor("specular"); 3], factor("specular_exponent")),
        lamps: lamps(case, lamp),
    }
}

fn lamp(light: &Value) -> Lamp {
    let (position, color) = (three(&light["pos"]), three(&light["color"]));
    let toward = || minus(three(&light["at"]), position);
    let (source, spot) = match light["kind"].as_str().expect("a kind") {
        "parallel" => (Source::Directional(toward().map(|c| -c)), None),
        "point" => (Source::Point(position), None),
        "spot" => (Source::Point(position), Some(spot(light, toward()))),
        other => panic!("unknown kind of light {other}"),
    };
    Lamp {
        source,
        attenuation: fade(
            number(&light["fade_distance"]),
            number(&light["fade_power"]),
        ),
        spot,
        ambient: [0.0; 3],
        diffuse: color,
        specular: color,
        bare_highlight_above: None,
    }
}

/// 2/(1 + (q/d)^power) as 1/(a + bq + cq²).
#[allow(clippy::float_cmp)] // integers
fn fade(distance: f64, power: f64) -> [f64; 3] {
    match power {
        0.0 => [1.0, 0.0, 0.0],
        1.0 => [0.5, 0.5 / distance, 0.0],
        2.0 => [0.5, 0.0, 0.5 / (distance * distance)],
        _ => panic!("unknown fade power {power}"),
    }
}

/// A cone that is smooth between `radius` and `falloff`, and hard if they are equal. The caller
/// multiplies by the cosine to the power `tightness`.
fn spot(light: &Value, axis: [f64; 3]) -> Spot {
    let [radius, falloff, tightness] =
        ["radius", "falloff", "tightness"].map(|key| number(&light[key]));
    Spot {
        axis,
        half_angle_degrees: falloff,
        inner_half_angle_degrees: (radius < falloff).then_some(radius),
        profile: Box::new(move |cosine| cosine.max(0.0).powf(tightness)),
    }
}
