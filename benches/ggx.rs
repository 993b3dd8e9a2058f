//! A reflection of one's own over three lamps: by [`IncidentLight::arrival`], and the same by hand.
#![allow(clippy::inline_always)] // as a renderer's loop inlines it

use kit::Given;
use shading::{Arrival, Attenuation, IncidentLight, PointLight, Rgb, Vec3};

const ROUGHNESS: f32 = 0.4;
const F0: f32 = 0.04;

/// GGX with Smith's correlated masking and Schlick's Fresnel term, times N·L: Filament, *Physically Based
/// Rendering*, §4.4.
#[inline(always)]
fn ggx(n: Vec3<f32>, v: Vec3<f32>, l: Vec3<f32>, n_dot_l: f32) -> f32 {
    let h = l + v;
    let h = h * (1.0 / (h.x * h.x + h.y * h.y + h.z * h.z).sqrt());
    let dot = |a: Vec3<f32>, b: Vec3<f32>| a.x * b.x + a.y * b.y + a.z * b.z;
    let (n_dot_h, v_dot_h, n_dot_v) = (dot(n, h), dot(v, h), dot(n, v).abs() + 1e-5);
    let a2 = ROUGHNESS * ROUGHNESS * ROUGHNESS * ROUGHNESS;
    let d = (n_dot_h * n_dot_h) * (a2 - 1.0) + 1.0;
    let distribution = a2 / (core::f32::consts::PI * d * d);
    let masked = |of: f32, other: f32| other * (of * of * (1.0 - a2) + a2).sqrt();
    let visibility = 0.5 / (masked(n_dot_v, n_dot_l) + masked(n_dot_l, n_dot_v));
    let away = 1.0 - v_dot_h;
    let fresnel = F0 + (1.0 - F0) * (away * away) * (away * away) * away;
    distribution * visibility * fresnel * n_dot_l
}

fn lamps(g: &Given<f32>) -> [PointLight<f32>; 3] {
    // all in front
    [g.n * 2.0 + g.l, g.n * 3.0 + g.v, g.n * 4.0].map(|to_light| PointLight {
        position: g.p + to_light,
        intensity: g.rgb,
        attenuation: Attenuation::<f32>::const_new(1.0, 0.1, 0.05).unwrap(),
    })
}

#[inline(always)]
pub fn by_arrival(g: &Given<f32>) -> Rgb<f32> {
    let of_light = |light: IncidentLight<f32>| {
        let Arrival { l, intensity, .. } = light.arrival();
        intensity * ggx(*g.n, *g.v, *l, g.n.dot(l))
    };
    let lights = lamps(g).into_iter().map(|lamp| lamp.at(g.p));
    lights
        .filter(|light| light.is_in_front(g.n))
        .map(of_light)
        .sum()
}

#[inline(always)]
pub fn by_hand(g: &Given<f32>) -> Rgb<f32> {
    let n = *g.n;
    let mut sum = Rgb::new(0.0, 0.0, 0.0);
    for lamp in lamps(g) {
        let to_light = lamp.position - g.p;
        if n.x * to_light.x + n.y * to_light.y + n.z * to_light.z <= 0.0 {
            continue;
        }
        let square = to_light.x * to_light.x + to_light.y * to_light.y + to_light.z * to_light.z;
        let q = square.sqrt();
        let l = to_light * (1.0 / q);
        let n_dot_l = n.x * l.x + n.y * l.y + n.z * l.z;
        let [a, b, c] = lamp.attenuation.coefficients();
        let factor = 1.0 / (a + b * q + c * q * q);
        sum += lamp.intensity * factor * ggx(n, *g.v, l, n_dot_l);
    }
    sum
}
