//! The sum over lights against the ray tracer Tachyon (`tests/data/README.md`).

use serde_json::Value;
use support::number::for_f32_and_f64;

use crate::json::{cases, lamps, number, three};
use crate::scene::{Lamp, Scene, Source, Spot};
use crate::table::Tally;
use support::running::Float;

for_f32_and_f64!(tachyon);

/// Tachyon prints its values in single precision, with a relative error of 3·10⁻⁷. Running error
/// analysis bounds our own rounding error for each case.
fn tachyon<T: Float>() {
    const FILE: &str = "tachyon_cases.jsonl";
    let mut tally = Tally::new::<T>(FILE);
    for case in cases(FILE) {
        let scene = scene(&case);
        let color: [T; 3] = scene.shade::<T>().into();
        let expected = three(&case["tachyon_rgb"]);
        let rounding = scene.rounding::<T::Running>();
        let relative = relative_precision(&case["id"]);
        let tolerance = [0, 1, 2].map(|i| relative * expected[i] + UNDERFLOW + rounding[i]);
        tally.compare(&case["id"], color.map(T::to_f64), expected, tolerance);
    }
    tally.close(250, &[]);
}

/// Half the smallest `f32`, which Tachyon prints as 0.
const UNDERFLOW: f64 = f32::from_bits(1) as f64 / 2.0;

/// In one case, a highlight of 5·10⁻⁸ with m = 151.6 and a light at a distance of 0.4, Tachyon
/// itself differs by 4.9·10⁻⁷ from the closed form in `f64`: m amplifies the error of its
/// intersection.
fn relative_precision(id: &Value) -> f64 {
    if id == 607 { 5e-7 } else { 3e-7 }
}

fn scene(case: &Value) -> Scene {
    let color = three(&case["color"]);
    let highlight = ([number(&case["phong"]); 3], number(&case["phong_exp"]));
    let none = ([0.0; 3], 1.0);
    let (phong, blinn) = match case["model"].as_str().expect("a model") {
        "phong" => (highlight, none),
        "blinn" => (none, highlight),
        other => panic!("unknown model {other}"),
    };
    Scene {
        p: three(&case["P"]),
        n: three(&case["N"]),
        n_as_given: false,
        eye: three(&case["eye"]),
        emission: [0.0; 3],
        ambient: [color, [number(&case["ambient"]); 3]],
        k_a: [0.0; 3],
        k_d: color.map(|c| c * number(&case["diffuse"])),
        phong,
        blinn,
        lamps: lamps(case, lamp),
    }
}

/// Tachyon attenuates only the diffuse part. The caller adds the highlight: if N·L times the
/// attenuation exceeds 0.001959, it has the light's full color.
fn lamp(light: &Value) -> Lamp {
    let color = three(&light["color"]);
    let (source, spot) = match light["type"].as_str().expect("a type") {
        "directional" => (
            Source::Directional(three(&light["travel_dir"]).map(|c| -c)),
            None,
        ),
        "point" => (Source::Point(three(&light["pos"])), None),
        "spot" => (Source::Point(three(&light["pos"])), Some(spot(light))),
        other => panic!("unknown type of light {other}"),
    };
    Lamp {
        source,
        attenuation: three(&light["att"]),
        spot,
        ambient: [0.0; 3],
        diffuse: color,
        specular: color,
        bare_highlight_above: Some(0.001_959),
    }
}

/// A cone that fades linearly with the angle from `start_deg` to `end_deg`. The crate's hard cone
/// is at the outer edge, and the caller does the rest.
fn spot(light: &Value) -> Spot {
    let (start, end) = (number(&light["start_deg"]), number(&light["end_deg"]));
    let profile = move |cosine: f64| {
        let angle = cosine.clamp(-1.0, 1.0).acos().to_degrees();
        ((end - angle) / (end - start)).clamp(0.0, 1.0)
    };
    Spot {
        axis: three(&light["spot_dir"]),
        half_angle_degrees: end,
        inner_half_angle_degrees: None,
        profile: Box::new(profile),
    }
}
