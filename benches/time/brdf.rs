//! A reflection of one's own over lamps, as a renderer writes it: what arrives by one call, beside
//! the same on `glam` by an expert.

use crate::hand::vec3 as hand;
use crate::ours::f32::{scene, unit};
use crate::race::{Pass, pass};
use crate::scene::List;
use shading::f32::{Arrival, Rgb, Vec3};
use std::hint::black_box;

const ROUGHNESS: f32 = 0.4;
const F0: f32 = 0.04;

/// GGX with Smith's correlated masking and Schlick's Fresnel term, times N·L: Filament, *Physically Based
/// Rendering*, §4.4.
macro_rules! ggx {
    ($vector:ty) => {
        |n: $vector, v: $vector, l: $vector, n_dot_l: f32| {
            let h = l + v;
            let h = h * (1.0 / h.dot(h).sqrt());
            let (n_dot_h, v_dot_h, n_dot_v) = (n.dot(h), v.dot(h), n.dot(v).abs() + 1e-5);
            let alpha = black_box(ROUGHNESS) * ROUGHNESS;
            let a2 = alpha * alpha;
            let d = n_dot_h * n_dot_h * (a2 - 1.0) + 1.0;
            let distribution = a2 / (std::f32::consts::PI * d * d);
            let masked = |of: f32, other: f32| other * (of * of * (1.0 - a2) + a2).sqrt();
            let visibility = 0.5 / (masked(n_dot_v, n_dot_l) + masked(n_dot_l, n_dot_v));
            let away = 1.0 - v_dot_h;
            let fresnel = F0 + (1.0 - F0) * (away * away) * (away * away) * away;
            distribution * visibility * fresnel * n_dot_l
        }
    };
}

/// Ours: L, I and q by [`arrival`](shading::IncidentLight::arrival).
pub fn ours((points, lamps): &(Vec<[List<f32>; 3]>, Vec<shading::f32::PointLight>)) -> Pass<'_> {
    pass::<false, _, _>(points, lamps.len(), move |&[n, v, p]| {
        let (n, v, p) = (unit(n), Vec3::from(v), Vec3::from(p));
        let mut sum = Rgb::BLACK;
        for light in lamps.iter().map(|lamp| lamp.at(p)) {
            if light.is_in_front(n) {
                let Arrival { l, intensity, .. } = light.arrival();
                sum += intensity * ggx!(Vec3)(*n, v, *l, n.dot(l));
            }
        }
        <[f32; 3]>::from(sum)
    })
}

/// By hand: the sign before the root, and one reciprocal for each vector.
pub fn by_hand((points, lamps): &hand::Scene) -> Pass<'_> {
    pass::<false, _, _>(points, lamps.len(), move |&[n, v, p]| {
        let mut sum = hand::V::ZERO;
        for lamp in lamps {
            let to_light = lamp.position - p;
            if n.dot(to_light) > 0.0 {
                let q = to_light.length();
                let l = to_light * (1.0 / q);
                let [a, b, c] = lamp.abc;
                let reflected = ggx!(hand::V)(n, v, l, n.dot(l));
                sum += lamp.intensity * (reflected * (1.0 / (a + b * q + c * q * q)));
            }
        }
        <[f32; 3]>::from(sum)
    })
}

pub fn both(points: &[List<List<f64>>], positions: &[List<f64>], race: impl FnOnce([Pass; 2])) {
    let (mine, theirs) = (scene(points, positions), hand::scene(points, positions));
    race([ours(&mine), by_hand(&theirs)]);
}
