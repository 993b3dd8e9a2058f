//! A ray tracer of spheres and a floor, once in the vectors of `glam` (`f32`) and once in those of
//! `nalgebra` (`f64`): shadows, and rows in parallel. It writes `glam.png` and `nalgebra.png`.

use std::error::Error;

use clients::write_png;
use rayon::prelude::*;
use shading::f32::{
    Attenuation, Cone, DirectionalLight, Light, PointLight, Rgb, SpotLight, UnitVec3, Vec3,
};
use shading::{Material, shade};

const LIGHTS: [Light; 3] = [
    Light::Directional(DirectionalLight {
        l: UnitVec3::const_new(0.48, 0.6, 0.64).unwrap(),
        intensity: Rgb::new(0.5, 0.48, 0.45),
    }),
    Light::Point(PointLight {
        position: Vec3::new(-3.0, 2.5, 1.0),
        intensity: Rgb::new(0.9, 0.3, 0.2),
        attenuation: Attenuation::const_new(0.5, 0.0, 0.06).unwrap(),
    }),
    Light::Spot(SpotLight {
        point: PointLight {
            position: Vec3::new(2.0, 4.0, 0.0),
            intensity: Rgb::new(0.2, 0.4, 0.9),
            attenuation: Attenuation::NONE,
        },
        axis: UnitVec3::const_new(-0.6, -0.8, 0.0).unwrap(),
        cone: Cone::const_from_half_angle(0.4).unwrap(),
    }),
];

/// Center, radius, color and m.
const SPHERES: [([f32; 3], f32, Rgb, u32); 3] = [
    ([1.4, 0.8, -0.6], 0.8, Rgb::new(0.8, 0.8, 0.8), 60),
    ([-1.0, 0.6, 0.7], 0.6, Rgb::new(0.7, 0.5, 0.1), 20),
    ([1.2, 0.4, 1.4], 0.4, Rgb::new(0.1, 0.6, 0.3), 200),
];

const SIZE: [usize; 2] = [640, 400];

macro_rules! tracer {
    ($name:ident, $number:ident, $vector:ty, $dot:expr) => {
        mod $name {
            use super::*;

            // glue
            fn ours(v: $vector) -> shading::Vec3<$number> {
                <[$number; 3]>::from(v).into()
            }
            fn direction(v: $vector) -> shading::UnitVec3<$number> {
                shading::UnitVec3::assume_unit(ours(v)) // normalized already
            }
            fn theirs(v: impl Into<[$number; 3]>) -> $vector {
                v.into().into()
            }
            // end of glue

            struct Hit {
                t: $number,
                n: $vector,
                color: Rgb,
                m: u32,
            }

            fn nearest(from: $vector, along: $vector, limit: $number) -> Option<Hit> {
                let floor = Hit {
                    t: -from.y / along.y,
                    n: theirs([0.0, 1.0, 0.0]),
                    color: Rgb::gray(0.5),
                    m: 5,
                };
                let spheres = SPHERES
                    .into_iter()
                    .filter_map(|(center, radius, color, m)| {
                        let toward = theirs(center.map($number::from)) - from;
                        let radius = $number::from(radius);
                        let b = $dot(toward, along);
                        let square = b * b - $dot(toward, toward) + radius * radius;
                        let t = b - (square > 0.0).then(|| square.sqrt())?;
                        let n = (along * t - toward) / radius;
                        Some(Hit { t, n, color, m })
                    });
                let hits = spheres.chain([floor]);
                let hits = hits.filter(|hit| 0.0 < hit.t && hit.t < limit.min(60.0));
                hits.min_by(|a, b| a.t.total_cmp(&b.t))
            }

            /// The light that comes back along a ray.
            fn seen(from: $vector, along: $vector) -> shading::Rgb<$number> {
                let Some(Hit { t, n, color, m }) = nearest(from, along, $number::MAX) else {
                    return shading::Rgb::BLACK;
                };
                let p = from + along * t;
                let start = p + n * 1e-3; // off the surface, so that it does not shadow itself
                let lights = LIGHTS
                    .iter()
                    .map(|light| light.cast($number::from).at(ours(p)));
                let lit = lights.filter(|light| {
                    let shading::Arrival { l, distance, .. } = light.arrival();
                    light.is_in_front(direction(n)) && nearest(start, theirs(l), distance).is_none()
                });
                let k_s = Rgb::gray(0.5);
                let material = Material {
                    k_a: color,
                    k_d: color,
                    k_s,
                    m,
                }
                .cast($number::from);
                let ambient = shading::Rgb::gray(0.08);
                shade::blinn_phong(direction(n), -direction(along), &material, ambient, lit).total()
            }

            pub fn picture() -> Vec<u8> {
                let [w, h] = SIZE.map(|side| side as $number);
                let pixel = |i: usize| {
                    let [x, y] = [i % SIZE[0], i / SIZE[0]].map(|k| k as $number);
                    let along: $vector = theirs([x / w - 0.5, (0.5 * h - y) / w - 0.19, -1.0]);
                    let light = seen(theirs([0.0, 2.0, 6.0]), along.normalize());
                    light.map(|c| c as f32).to_srgb8()
                };
                let pixels = (0..SIZE[0] * SIZE[1]).into_par_iter();
                pixels.flat_map_iter(pixel).collect()
            }
        }
    };
}

tracer!(on_glam, f32, glam::Vec3, |a: glam::Vec3, b| a.dot(b));
tracer!(
    on_nalgebra,
    f64,
    nalgebra::Vector3<f64>,
    |a: nalgebra::Vector3<f64>, b| a.dot(&b)
);

fn main() -> Result<(), Box<dyn Error>> {
    write_png("glam.png", SIZE[0], &on_glam::picture())?;
    write_png("nalgebra.png", SIZE[0], &on_nalgebra::picture())
}

/// Only the edges of shadows and spheres, where rays of `f32` and of `f64` may take other ways,
/// differ by more than a level.
#[test]
fn both_draw_the_same() {
    let [a, b] = [on_glam::picture(), on_nalgebra::picture()];
    let differs = |(a, b): &(&u8, &u8)| a.abs_diff(**b) > 1;
    let different = a.iter().zip(&b).filter(differs).count();
    println!("{different} of {} bytes differ", a.len());
    assert!(10_000 * different < a.len());
}

/// The floor in the shadow of the large ball: without the sun, outside of the cone, lit by the lamp alone.
#[test]
fn a_shadow_has_the_light_of_the_lamp_alone() {
    use glam::DVec3;
    let (eye, p) = (DVec3::new(0.0, 2.0, 6.0), DVec3::new(0.76, 0.0, -1.45));
    let way = DVec3::new(-3.0, 2.5, 1.0) - p;
    let (l, v, n) = (way.normalize(), (eye - p).normalize(), DVec3::Y);
    let highlight = n.dot((l + v).normalize()).powi(5);
    let arriving = DVec3::new(0.9, 0.3, 0.2) / (0.5 + 0.06 * way.length_squared());
    let light = arriving * (0.5 * n.dot(l) + 0.5 * highlight) + 0.5 * 0.08;

    let [x, y] = [p.x / (eye.z - p.z), (p.y - eye.y) / (eye.z - p.z)]; // on a picture at z = −1
    let [column, row] = [(x + 0.5) * 640.0, 200.0 - (y + 0.19) * 640.0].map(|c| c as usize);
    let pixel = &on_glam::picture()[3 * (row * SIZE[0] + column)..][..3];
    for (byte, light) in pixel.iter().zip(light.to_array()) {
        let exact = 255.0 * (1.055 * light.powf(1.0 / 2.4) - 0.055);
        assert!(
            (f64::from(*byte) - exact).abs() < 1.0,
            "{byte}, by hand {exact}"
        ); // within a pixel of p
    }
}
