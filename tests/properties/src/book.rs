//! The formulas as the books print them, in `f64`: what the crate computes is compared with these.
//! Nothing here calls a formula of the crate.

use shading::{Attenuation, Cone, Light, PointLight, Rgb, UnitVec3, Vec3};

use crate::given::Scene;

pub type Triple = [f64; 3];

pub fn xyz(v: impl Into<Vec3<f64>>) -> Triple {
    let v = v.into();
    [v.x, v.y, v.z]
}

pub fn dot([a, b, c]: Triple, [x, y, z]: Triple) -> f64 {
    a * x + b * y + c * z
}

pub fn cross([a, b, c]: Triple, [x, y, z]: Triple) -> Triple {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

pub fn plus([a, b, c]: Triple, [x, y, z]: Triple) -> Triple {
    [a + x, b + y, c + z]
}

pub fn minus([a, b, c]: Triple, [x, y, z]: Triple) -> Triple {
    [a - x, b - y, c - z]
}

pub fn times(s: f64, v: Triple) -> Triple {
    v.map(|x| s * x)
}

/// v times a power of two, so that its squares neither overflow nor vanish; and that power.
fn tamed(v: Triple) -> (Triple, f64) {
    let largest = v.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    let scale = match largest {
        x if x > 1e150 => 2.0_f64.powi(-600),
        x if x < 1e-150 => 2.0_f64.powi(600),
        _ => 1.0,
    };
    (times(scale, v), scale)
}

pub fn length(v: Triple) -> f64 {
    let (v, scale) = tamed(v);
    dot(v, v).sqrt() / scale
}

/// v/|v|, if it has a length.
pub fn direction(v: Triple) -> Option<Triple> {
    let (v, _) = tamed(v);
    let length = dot(v, v).sqrt();
    (length > 0.0 && length.is_finite()).then(|| v.map(|x| x / length))
}

/// max(0, N·L).
pub fn lambert(n: UnitVec3<f64>, l: UnitVec3<f64>) -> f64 {
    dot(xyz(n), xyz(l)).max(0.0)
}

/// 2(N·L)N − L, for a direction of any length.
pub fn reflected(n: Triple, l: Triple) -> Triple {
    minus(times(2.0 * dot(n, l), n), l)
}

/// (L + V)/|L + V|.
pub fn halfway(l: Triple, v: Triple) -> Option<Triple> {
    direction(plus(l, v))
}

/// max(0, cosine)ᵐ, with a cosine of at most 1; 0 for a cosine of 0, whatever m is.
pub fn highlight(cosine: f64, m: u32) -> f64 {
    if cosine > 0.0 {
        cosine
            .min(1.0)
            .powi(m.try_into().expect("a small exponent"))
    } else {
        0.0
    }
}

/// 1/(a + bq + cq²).
pub fn attenuation([a, b, c]: [f64; 3], q: f64) -> f64 {
    1.0 / (a + b * q + c * q * q)
}

/// 1 − (q/r)⁴, as glTF has it, or 0 beyond r; others square it.
pub fn window(q: f64, r: f64) -> f64 {
    (1.0 - (q / r).powi(4)).max(0.0)
}

/// What arrives after the distance q.
pub fn falloff(falloff: Attenuation<f64>, q: f64) -> f64 {
    let free = attenuation(falloff.coefficients(), q).min(falloff.limit().unwrap_or(f64::INFINITY));
    match (falloff.range(), falloff.is_gltf()) {
        (None, _) => free,
        (Some(r), false) => free * window(q, r).powi(2),
        (Some(r), true) => free * window(q, r),
    }
}

/// How far a cosine is from the outer edge of a cone to the inner one: 1 from the inner one on.
pub fn across([inner, outer]: [f64; 2], cosine: f64) -> f64 {
    if cosine >= inner {
        1.0
    } else if cosine < outer {
        0.0
    } else {
        (cosine - outer) / (inner - outer)
    }
}

/// t², or t²(3 − 2t) for a smoothstep.
pub fn cone(cone: Cone<f64>, cosine: f64) -> f64 {
    let t = across(cone.cosines(), cosine);
    if cone.is_smoothstep() {
        t * t * (3.0 - 2.0 * t)
    } else {
        t * t
    }
}

/// L and I as they arrive at p: none at the light itself.
pub fn arriving(light: &Light<f64>, p: Triple) -> Option<(Triple, Triple)> {
    let color = |i: Rgb<f64>| [i.r, i.g, i.b];
    let lamp = |lamp: &PointLight<f64>| {
        let way = minus(xyz(lamp.position), p);
        let (l, q) = (direction(way)?, length(way));
        Some((
            l,
            times(falloff(lamp.attenuation, q), color(lamp.intensity)),
        ))
    };
    match light {
        Light::Directional(sun) => Some((xyz(sun.l), color(sun.intensity))),
        Light::Point(point) => lamp(point),
        Light::Spot(spot) => {
            let (l, i) = lamp(&spot.point)?;
            let cosine = -dot(xyz(spot.axis), l);
            Some((l, times(cone(spot.cone, cosine), i)))
        }
    }
}

/// The three illumination models.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Model {
    Lambert,
    Phong,
    Blinn,
}

/// k_a I_a, Σ k_d I max(0, N·L) and Σ k_s I highlight, over the lights with N·L > 0.
pub fn shaded(scene: &Scene<f64>, model: Model) -> [Triple; 3] {
    let (n, v) = (xyz(scene.n), xyz(scene.v));
    let material = scene.material;
    let through = |k: Rgb<f64>, i: Triple| [k.r * i[0], k.g * i[1], k.b * i[2]];
    let (mut diffuse, mut specular) = ([0.0; 3], [0.0; 3]);
    for light in &scene.lights {
        let Some((l, i)) = arriving(light, xyz(scene.p)) else {
            continue;
        };
        let n_dot_l = dot(n, l);
        if n_dot_l > 0.0 {
            let cosine = match model {
                Model::Lambert => 0.0,
                Model::Phong => dot(reflected(n, l), v),
                Model::Blinn => halfway(l, v).map_or(0.0, |h| dot(n, h)),
            };
            diffuse = plus(diffuse, times(n_dot_l, i));
            specular = plus(specular, times(highlight(cosine, material.m), i));
        }
    }
    let ambient = [scene.ambient.r, scene.ambient.g, scene.ambient.b];
    [
        through(material.k_a, ambient),
        through(material.k_d, diffuse),
        through(material.k_s, specular),
    ]
}
