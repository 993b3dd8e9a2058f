//! Right renderers in other algebraic forms, in real floats: no law is broken.

#![allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap)] // small numbers
#![allow(missing_docs)]

use num_traits::Float;
use shading_laws::{Kind, Laws, Light, Model, Profile, Scene, Triple, from_fn};

/// How the renderer of a number computes.
#[derive(Clone, Copy)]
struct Form(usize);

impl Form {
    /// One of so many ways.
    fn way(self, divisor: usize, count: usize) -> usize {
        (self.0 / divisor) % count
    }
}

/// The color of a scene, in real numbers of a type.
#[allow(clippy::too_many_lines)] // a renderer in one piece
fn shade<T: Float>(form: Form, scene: &Scene, profile: &Profile) -> Triple {
    // by a quotient, by a product, or scaled by the largest component first
    let normalize = form.way(1, 3);
    // sums are fused, and run backwards
    let is_fused = form.way(1, 2) == 1;
    // R·V by R, by 2(N·L)(N·V) - L·V, or by the mirrored eye
    let reflection = form.way(2, 3);
    // N·H, (N·L + N·V)/|L + V|, or its square to m/2
    let half = (form.way(3, 3) + form.0) % 3;
    // a power, exp(m ln x), or by squaring where m is whole
    let by = form.way(5, 3);
    // Horner, a sum of powers, or by 1/q
    let attenuate = (form.way(7, 3) + form.0) % 3;
    // positions are relative to 0 in the world, the eye, or the point
    let frame = form.way(4, 3);
    // the lights run backwards
    let is_reversed = form.way(3, 2) == 1;
    let real = |x: f64| T::from(x).expect("a number");
    let of = |v: Triple| v.map(real);
    let (zero, two) = (T::zero(), real(2.0));
    let zip = |a: [T; 3], b: [T; 3], f: &dyn Fn(T, T) -> T| [0, 1, 2].map(|i| f(a[i], b[i]));
    let add = |a, b| zip(a, b, &|a, b| a + b);
    let sub = |a, b| zip(a, b, &|a, b| a - b);
    let mul = |a, b| zip(a, b, &|a, b| a * b);
    let scale = |v: [T; 3], factor: T| v.map(|c| c * factor);
    let dot = |a: [T; 3], b: [T; 3]| {
        if is_fused {
            a[2].mul_add(b[2], a[1].mul_add(b[1], a[0] * b[0]))
        } else {
            a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
        }
    };
    let unit = |mut v: [T; 3]| {
        if normalize == 2 {
            let largest = v[0].abs().max(v[1].abs()).max(v[2].abs());
            v = v.map(|c| c / largest);
        }
        let length = dot(v, v).sqrt();
        match normalize {
            0 => v.map(|c| c / length),
            _ => scale(v, length.recip()),
        }
    };
    let power = |x: T, m: f64| match by {
        1 if x > zero => (real(m) * x.ln()).exp(),
        2 if m.fract() == 0.0 => x.powi(m as i32),
        _ => x.powf(real(m)),
    };
    let (mut n, v) = (unit(of(scene.n)), unit(of(scene.v)));
    if profile.normal_faces_eye && dot(n, v) < zero {
        n = scale(n, -T::one());
    }
    let highlight = |l: [T; 3]| {
        let (n_l, n_v) = (dot(n, l), dot(n, v));
        let mirrored = |a: [T; 3], cosine: T| sub(scale(n, two * cosine), a);
        if scene.model == Model::Phong {
            let cosine = match reflection {
                0 => dot(mirrored(l, n_l), v),
                1 => two * n_l * n_v - dot(l, v),
                _ => dot(mirrored(v, n_v), l),
            };
            return power(cosine.max(zero).min(T::one()), scene.m);
        }
        let sum = add(l, v);
        let square = dot(sum, sum);
        let cosine = dot(n, sum).max(zero);
        match half {
            _ if square <= zero => zero, // where L = -V there is no H
            0 => power(dot(n, unit(sum)).max(zero), scene.m),
            1 => power(((n_l + n_v) / square.sqrt()).max(zero), scene.m),
            _ => power(cosine * cosine / square, scene.m / 2.0),
        }
    };
    let origin = match frame {
        0 => [zero; 3],
        1 => add(of(scene.p), of(scene.v)),
        _ => of(scene.p),
    };
    let local = |p: Triple| sub(of(p), origin);
    let (k_d, k_s) = (of(scene.k_d), of(scene.k_s));
    let mut ambient = mul(of(scene.k_a), of(scene.i_a));
    if profile.ambient_times_diffuse {
        ambient = mul(ambient, k_d);
    }
    let is_dark = scene.lights.is_empty();
    let mut sum = ambient;
    if profile.attenuated_ambient || profile.black_without_lights && is_dark {
        sum = [zero; 3];
    } else if profile.unlit_without_lights && is_dark {
        sum = add(sum, k_d);
    }
    let (mut matte, mut shiny) = ([zero; 3], [zero; 3]);
    let mut lights = scene.lights.clone();
    if is_reversed {
        lights.reverse();
    }
    for light in &lights {
        let (mut l, mut falloff) = ([zero; 3], T::one());
        if let Light::Directional { l: way, .. } = light {
            l = of(*way);
        }
        if let Some((position, attenuation)) = light.lamp() {
            let way = sub(local(position), local(scene.p));
            let square = dot(way, way);
            let q = square.sqrt();
            l = unit(way);
            let [a, b, c] = of(attenuation);
            let inverse = q.recip();
            falloff = match attenuate {
                0 => (a + q * (b + q * c)).recip(),
                1 => (c * square + b * q + a).recip(),
                _ => inverse * inverse / (c + inverse * (b + inverse * a)),
            };
        }
        if profile.attenuated_ambient {
            sum = add(sum, scale(ambient, falloff));
        }
        let mut intensity = of(light.intensity());
        if let Light::Spot {
            axis, half_angle, ..
        } = *light
        {
            let part = if profile.whole_angle { 0.5 } else { 1.0 };
            let cosine = -dot(of(axis), l);
            if cosine < real(half_angle * part).cos() {
                continue;
            }
            if profile.spot_exponent > 0.0 {
                intensity = scale(
                    intensity,
                    cosine.max(zero).powf(real(profile.spot_exponent)),
                );
            }
        }
        let n_dot_l = dot(n, l);
        if n_dot_l > zero {
            matte = add(matte, scale(intensity, n_dot_l * falloff));
        } else if !profile.highlight_on_the_dark_side {
            continue;
        }
        if scene.model != Model::Lambert {
            let unattenuated = profile.unattenuated_highlight;
            let left = if unattenuated { T::one() } else { falloff };
            shiny = add(shiny, scale(intensity, left * highlight(l)));
        }
    }
    let lit = add(mul(k_d, matte), mul(k_s, shiny));
    add(lit, sum).map(|c| c.to_f64().expect("a number"))
}

fn encoded(color: Triple) -> Triple {
    color.map(|c| {
        let c = c.clamp(0.0, 1.0);
        let c = if c <= 0.003_130_8 {
            12.92 * c
        } else {
            1.055 * c.powf(1.0 / 2.4) - 0.055
        };
        (c * 255.0).round() / 255.0
    })
}

#[track_caller]
fn holds(profile: &Profile, seed: u64, color: impl FnMut(&Scene) -> Triple) {
    let laws = Laws {
        seed,
        cases: 32,
        ..Laws::default()
    };
    let report = laws.run(&mut from_fn(profile.clone(), color));
    let report = report.expect("a profile");
    assert!(report.passes(), "{report}");
}

/// Two thirds compute in `f32`, of which one half gives bytes, and a third in `f64`.
#[test]
fn forty_right_renderers_hold_at_two_seeds() {
    let single = Profile {
        most_shiny: 1024.0,
        ..Profile::default()
    };
    let double = Profile {
        roundoff: f64::EPSILON / 2.0,
        ..single.clone()
    };
    let bytes = Profile {
        srgb: true,
        bits: Some(8),
        ..single.clone()
    };
    for (seed, i) in (0..2).flat_map(|seed| (0..40).map(move |i| (seed, i))) {
        let form = Form(i);
        match (i + seed as usize) % 3 {
            0 => holds(&single, seed, |scene| shade::<f32>(form, scene, &single)),
            1 => holds(&double, seed, |scene| shade::<f64>(form, scene, &double)),
            _ => holds(&bytes, seed, |scene| {
                encoded(shade::<f32>(form, scene, &bytes))
            }),
        }
    }
}

/// Renderers that lack something, or depart from the formulas on purpose, as the format says it.
#[test]
fn what_differs_on_purpose_is_no_mistake() {
    for profile in [
        r#"{"models":["phong"],"lights":["point","spot"],"most_lights":1,"unit_vectors":true}"#,
        r#"{"models":["lambert","blinn_phong"],"lights":["directional"],"integer_shininess":true}"#,
        r#"{"whole_angle":true,"attenuated_ambient":true,"unattenuated_highlight":true,
            "highlight_on_the_dark_side":true}"#,
        r#"{"normal_faces_eye":true,"black_without_lights":true,"unattenuated":true,"gray_highlight":true,
            "spot_exponent":2,"ambient_times_diffuse":true}"#,
        r#"{"unlit_without_lights":true,"lights":["point","spot"],"most_lights":1024}"#,
    ] {
        let profile = Profile::from_json(profile).expect("a profile");
        let form = Form(1);
        for seed in 0..4 {
            holds(&profile, seed, |scene| shade::<f32>(form, scene, &profile));
        }
    }
}

/// Tolerances follow the precision: what holds for `f32` is broken for `f64`. A law that needs what a renderer lacks is
/// listed as not tried.
#[test]
fn single_precision_is_not_double() {
    let profile = Profile {
        roundoff: f64::EPSILON / 2.0,
        lights: vec![Kind::Directional],
        ..Profile::default()
    };
    let color = |scene: &Scene| shade::<f32>(Form(0), scene, &profile);
    let report = Laws::default().run(&mut from_fn(profile.clone(), color));
    let report = report.expect("a profile").to_string();
    for line in [
        "\nformula is BROKEN",
        "\nrotation is BROKEN",
        "distance is not tried: it has no point lights",
    ] {
        assert!(report.contains(line), "{report}");
    }
}
