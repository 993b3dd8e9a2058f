//! Lights and the sum over four lights, beside the same on `glam`.

use glam::Vec3;
use shading::{Attenuation, Cone, Exponent, Material, PointLight, Rgb, SpotLight, UnitVec3, shade};

use crate::data::{MANY, Vectors, directions, triangles};
#[cfg(feature = "wide")]
use crate::race::Limit;
use crate::race::{Data, Race, limit, twice};

const LAMP: PointLight<f32> = lamp(1.0, 2.0, 3.0);
const SPOT: SpotLight<f32> = SpotLight {
    point: LAMP,
    axis: UnitVec3::<f32>::new(0.0, -0.6, -0.8).unwrap(),
    cone: Cone::<f32>::from_half_angle(0.5).unwrap(),
};
const COSINE: f32 = 0.877_582_6; // cos ½
const LAMPS: [PointLight<f32>; 4] = [
    LAMP,
    lamp(-3.0, 2.0, 1.0),
    lamp(0.5, -3.0, 2.0),
    lamp(1.0, 2.0, -3.5),
];
const WHOLE_M: u32 = 50;
const REAL_M: f32 = 50.5;
const WHOLE: Material<f32, u32> = material(WHOLE_M);
const REAL: Material<f32, f32> = material(REAL_M);
const AMBIENT: Rgb<f32> = Rgb::new(0.1, 0.1, 0.12);

const fn lamp(x: f32, y: f32, z: f32) -> PointLight<f32> {
    PointLight {
        position: shading::Vec3::new(x, y, z),
        intensity: Rgb::new(1.0, 0.9, 0.8),
        attenuation: Attenuation::<f32>::new(1.0, 0.1, 0.05).unwrap(),
    }
}

const fn material<M>(m: M) -> Material<f32, M> {
    Material {
        k_a: Rgb::new(0.3, 0.25, 0.2),
        k_d: Rgb::new(0.6, 0.5, 0.4),
        k_s: Rgb::new(0.4, 0.4, 0.35),
        m,
    }
}

fn glam(v: shading::Vec3<f32>) -> Vec3 {
    Vec3::from_array(v.into())
}

fn color(c: Rgb<f32>) -> Vec3 {
    Vec3::from_array(c.into())
}

/// L and what arrives.
fn arriving(light: &PointLight<f32>, p: Vec3) -> (Vec3, Vec3) {
    let to_light = glam(light.position) - p;
    let q = to_light.length();
    let [a, b, c] = light.attenuation.coefficients();
    (to_light / q, color(light.intensity) / (a + q * (b + c * q)))
}

fn summed(lamps: &[PointLight<f32>], [p, n, v]: [Vec3; 3], power: impl Fn(f32) -> f32) -> Vec3 {
    let k = material(());
    let mut sum = color(k.k_a) * color(AMBIENT);
    for lamp in lamps {
        let (l, intensity) = arriving(lamp, p);
        let n_dot_l = n.dot(l);
        if n_dot_l > 0.0 {
            let highlight = power(n.dot((l + v).normalize()).max(0.0));
            sum += intensity * (color(k.k_d) * n_dot_l + color(k.k_s) * highlight);
        }
    }
    sum
}

fn unit(v: shading::Vec3<f32>) -> UnitVec3<f32> {
    UnitVec3::assume_unit(v)
}

#[inline]
fn shaded<M: Exponent<f32>>(material: &Material<f32, M>, vectors: &Vectors) -> Rgb<f32> {
    let [p, n, v] = vectors.ours;
    let (n, v) = (unit(n), unit(v));
    let lights = std::hint::black_box(&LAMPS).iter();
    let lights = lights.filter_map(|light| light.in_front(p, n));
    shade::blinn_phong(n, v, material, AMBIENT, lights).total()
}

/// The same, four lights at a time.
#[cfg(feature = "wide")]
#[inline]
fn shaded_at_once<M: Exponent<wide::f32x4>>(
    material: &Material<f32, M>,
    vectors: &Vectors,
) -> Rgb<f32> {
    let [p, n, v] = vectors.ours;
    let lights = PointLight::all_at::<wide::f32x4>(std::hint::black_box(&LAMPS), p);
    shade::blinn_phong(unit(n), unit(v), material, AMBIENT, lights).total()
}

pub fn race() -> usize {
    let (points, directions) = (triangles(), directions(MANY));
    #[cfg(feature = "wide")]
    let at_once = of_sums_at_once(directions.clone());
    #[cfg(not(feature = "wide"))]
    let at_once = 0;
    of_lights(&points) + of_sums(&directions) + at_once
}

fn of_lights(points: &[Data<Vectors>]) -> usize {
    Race::of(
        "PointLight::at",
        twice!(|Vectors { ours: [p, ..], .. }: &Vectors| LAMP.at(*p)),
    )
    .against(
        "glam",
        limit(2.0, 1.4),
        twice!(|Vectors { glam: [p, ..], .. }| arriving(&LAMP, *p)),
    )
    .run(points)
        + Race::of(
            "SpotLight::at",
            twice!(|Vectors { ours: [p, ..], .. }: &Vectors| SPOT.at(*p)),
        )
        .against(
            "glam",
            limit(2.9, 1.4),
            twice!(|Vectors { glam: [p, ..], .. }| {
                let (l, intensity) = arriving(&LAMP, *p);
                let inside = -l.dot(glam(*SPOT.axis)) >= COSINE;
                (l, if inside { intensity } else { Vec3::ZERO })
            }),
        )
        .run(points)
}

/// Four lights at a point. The data sets are directions, of which the first is the point, too.
fn of_sums(directions: &[Data<Vectors>]) -> usize {
    Race::of(
        "four lights, whole m",
        twice!(|vectors: &Vectors| shaded(std::hint::black_box(&WHOLE), vectors)),
    )
    .against(
        "glam, powi",
        limit(1.2, 1.2),
        twice!(|Vectors { glam, .. }| {
            let m = std::hint::black_box(WHOLE_M.cast_signed());
            summed(std::hint::black_box(&LAMPS), *glam, |cosine| cosine.powi(m))
        }),
    )
    .run(directions)
        + Race::of(
            "four lights, real m",
            twice!(|vectors: &Vectors| shaded(std::hint::black_box(&REAL), vectors)),
        )
        .against(
            "glam, powf",
            limit(1.2, 1.2),
            twice!(|Vectors { glam, .. }| {
                let m = std::hint::black_box(REAL_M);
                summed(std::hint::black_box(&LAMPS), *glam, |cosine| cosine.powf(m))
            }),
        )
        .run(directions)
}

/// Four lights at a time. Where the same lights are in front of every point, rivals predict each branch.
#[cfg(feature = "wide")]
fn of_sums_at_once(directions: Vec<Data<Vectors>>) -> usize {
    let (smooth, others): (Vec<_>, Vec<_>) = directions
        .into_iter()
        .partition(|(kind, _)| *kind == "smooth");
    of_four_at_once(&smooth, [limit(0.85, 0.85); 2])
        + of_four_at_once(&others, [limit(0.45, 0.45); 2])
}

#[cfg(feature = "wide")]
fn of_four_at_once(directions: &[Data<Vectors>], [whole, real]: [Limit; 2]) -> usize {
    Race::of(
        "four at once, whole m",
        twice!(|vectors: &Vectors| shaded_at_once(std::hint::black_box(&WHOLE), vectors)),
    )
    .against(
        "glam, powi",
        whole,
        twice!(|Vectors { glam, .. }| {
            let m = std::hint::black_box(WHOLE_M.cast_signed());
            summed(std::hint::black_box(&LAMPS), *glam, |cosine| cosine.powi(m))
        }),
    )
    .run(directions)
        + Race::of(
            "four at once, real m",
            twice!(|vectors: &Vectors| shaded_at_once(std::hint::black_box(&REAL), vectors)),
        )
        .against(
            "glam, powf",
            real,
            twice!(|Vectors { glam, .. }| {
                let m = std::hint::black_box(REAL_M);
                summed(std::hint::black_box(&LAMPS), *glam, |cosine| cosine.powf(m))
            }),
        )
        .run(directions)
}
