//! Ranges and soft edges against three.js as rendered by Chromium (`tests/data/README.md`).

use core::f64::consts::FRAC_1_PI;

use shading::{Attenuation, Material, PointLight, Rgb, SpotLight, UnitVec3, shade};
use support::number::{Number, direction, for_f32_and_f64, vector};

use crate::table::{Row, Tally, rows};
use support::running::{Bounded, Float, Running};

for_f32_and_f64!(three_js);

fn three_js<T: Float>() {
    const FILE: &str = "three_js.csv";
    let mut tally = Tally::new::<T>(FILE);
    for (i, row) in rows(FILE).iter().enumerate() {
        let expected = ["r", "g", "b"].map(|channel| row.number(channel));
        let actual = pixel::<T>(row).map(T::to_f64);
        let ours = pixel::<T::Running>(row).map(Bounded::error);
        // The shader computes the same in single precision, but OpenGL ES and Vulkan allow an error
        // of 5u for a division and a root, which round by 1u here. For the power q^decay = 2^(decay
        // log₂ q) with |log₂ q| ≤ 2, they allow 16u for the logarithm and 22u for the exponential.
        let single = pixel::<Running<24>>(row).map(Bounded::error);
        let power = 38.0 * f64::from(f32::EPSILON) / 2.0;
        let tolerance = [0, 1, 2].map(|i| ours[i] + 5.0 * single[i] + power * expected[i]);
        tally.compare(i + 2, actual, expected, tolerance);
    }
    tally.close(704, &[]);
}

/// The light of one pixel of the white plane z = 0, in an engine whose diffuse term has a factor of
/// 1/π.
fn pixel<T: Number>(row: &Row) -> [T; 3] {
    let [one, white] = [FRAC_1_PI, 1.0].map(|x| Rgb::gray(T::of(x)));
    let plane = Material {
        k_a: white,
        k_d: one,
        k_s: white,
        m: 1,
    };
    let p = vector([row.number("px"), row.number("py"), 0.0]);
    let position = ["x", "y", "z"].map(|axis| row.number(axis));
    let point = PointLight {
        position: vector(position),
        intensity: Rgb::from([4.0, 2.0, 1.0].map(T::of)),
        attenuation: ranged(row),
    };
    let incident = match row.text("light") {
        "point" => point.at(p),
        "spot" => {
            let to = row.vector("to_{}");
            let axis = direction([0, 1, 2].map(|i| to[i] - position[i]));
            let cone = T::soft_cone(["inner_deg", "outer_deg"].map(|angle| row.number(angle)));
            let cone = cone.expect("two half-angles").smoothstep();
            SpotLight { point, axis, cone }.at(p)
        }
        other => panic!("unknown light {other}"),
    };
    shade::lambert(UnitVec3::Z, &plane, Rgb::BLACK, [incident])
        .diffuse
        .into()
}

/// In three.js the attenuation is 1/q^decay times a window, and a range of 0 means no range.
fn ranged<T: Number>(row: &Row) -> Attenuation<T> {
    let [a, b, c] = match row.text("decay") {
        "0" => [1.0, 0.0, 0.0],
        "1" => [0.0, 1.0, 0.0],
        "2" => [0.0, 0.0, 1.0],
        other => panic!("unknown decay {other}"),
    };
    let range = match row.text("range") {
        "0" => f64::INFINITY,
        _ => row.number("range"),
    };
    let attenuation = Attenuation::<f64>::new(a, b, c).expect("coefficients");
    attenuation.within(range).expect("a range").cast(T::of)
}
