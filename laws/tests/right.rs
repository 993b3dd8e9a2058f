//! Right renderers in other algebraic forms, in real floats: no law is broken.

#![allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap)] // small numbers
#![allow(missing_docs)]

use shading_laws::{Kind, Laws, Light, Model, Plan, Profile, Scene, from_fn};

/// How a right renderer computes.
#[derive(Clone, Copy, Debug)]
struct Form {
    /// 0: a quotient by the root; 1: a product with the inverse root; 2: scaled by the largest component first.
    normalize: usize,
    /// Sums are fused, and run backwards.
    is_fused: bool,
    /// 0: R·V by R; 1: 2(N·L)(N·V) − L·V; 2: by the mirrored eye.
    reflection: usize,
    /// 0: N·H; 1: (N·L + N·V)/|L + V|; 2: its square, to m/2.
    half: usize,
    /// 0: a power; 1: exp(m ln x); 2: by squaring where m is whole.
    power: usize,
    /// 0: Horner; 1: a sum of powers; 2: by 1/q.
    attenuation: usize,
    /// Positions are relative to 0: the world; 1: the eye; 2: the point.
    frame: usize,
    /// The lights run backwards, and their sum is multiplied by k_d and k_s once.
    is_factored: bool,
}

impl Form {
    fn number(i: usize) -> Self {
        Self {
            normalize: i % 3,
            is_fused: i % 2 == 1,
            reflection: (i / 2) % 3,
            half: (i / 3 + i) % 3,
            power: (i / 5) % 3,
            attenuation: (i / 7 + i) % 3,
            frame: (i / 4) % 3,
            is_factored: (i / 3) % 2 == 1,
        }
    }
}

macro_rules! forms {
    ($float:ident) => {
        mod $float {
            use super::*;

            type Vector = [$float; 3];

            fn of(v: [f64; 3]) -> Vector {
                v.map(|c| c as $float)
            }

            fn zip(a: Vector, b: Vector, f: impl Fn($float, $float) -> $float) -> Vector {
                [0, 1, 2].map(|i| f(a[i], b[i]))
            }

            fn scale(v: Vector, factor: $float) -> Vector {
                v.map(|c| c * factor)
            }

            #[derive(Clone, Copy)]
            struct In(Form);

            impl In {
                fn dot(self, a: Vector, b: Vector) -> $float {
                    if self.0.is_fused {
                        a[2].mul_add(b[2], a[1].mul_add(b[1], a[0] * b[0]))
                    } else {
                        a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
                    }
                }

                fn unit(self, v: Vector) -> Vector {
                    let largest = v[0].abs().max(v[1].abs()).max(v[2].abs());
                    let v = if self.0.normalize == 2 {
                        v.map(|c| c / largest)
                    } else {
                        v
                    };
                    let length = self.dot(v, v).sqrt();
                    match self.0.normalize {
                        0 => v.map(|c| c / length),
                        _ => scale(v, 1.0 / length),
                    }
                }

                fn power(self, x: $float, m: f64) -> $float {
                    match self.0.power {
                        1 if x > 0.0 => (m as $float * x.ln()).exp(),
                        2 if m.fract() == 0.0 => x.powi(m as i32),
                        _ => x.powf(m as $float),
                    }
                }

                fn highlight(
                    self,
                    model: Model,
                    n: Vector,
                    l: Vector,
                    v: Vector,
                    m: f64,
                ) -> $float {
                    let (n_l, n_v) = (self.dot(n, l), self.dot(n, v));
                    let mirrored =
                        |a: Vector, cosine: $float| zip(scale(n, 2.0 * cosine), a, |r, a| r - a);
                    if model == Model::Phong {
                        let cosine = match self.0.reflection {
                            0 => self.dot(mirrored(l, n_l), v),
                            1 => 2.0 * n_l * n_v - self.dot(l, v),
                            _ => self.dot(mirrored(v, n_v), l),
                        };
                        return self.power(cosine.max(0.0).min(1.0), m);
                    }
                    let sum = zip(l, v, |l, v| l + v);
                    let square = self.dot(sum, sum);
                    match self.0.half {
                        _ if square <= 0.0 => 0.0, // where L = -V there is no H
                        0 => self.power(self.dot(n, self.unit(sum)).max(0.0), m),
                        1 => self.power(((n_l + n_v) / square.sqrt()).max(0.0), m),
                        _ => {
                            let cosine = self.dot(n, sum).max(0.0);
                            self.power(cosine * cosine / square, m / 2.0)
                        }
                    }
                }
            }

            pub fn shade(form: Form, scene: &Scene, profile: &Profile) -> [f64; 3] {
                let form = In(form);
                let (mut n, v) = (form.unit(of(scene.n)), form.unit(of(scene.v)));
                if profile.normal_faces_eye && form.dot(n, v) < 0.0 {
                    n = scale(n, -1.0);
                }
                let origin = match form.0.frame {
                    0 => [0.0; 3],
                    1 => zip(of(scene.p), of(scene.v), |p, v| p + v),
                    _ => of(scene.p),
                };
                let local = |p: [f64; 3]| zip(of(p), origin, |p, o| p - o);
                let (p, k_d, k_s) = (local(scene.p), of(scene.k_d), of(scene.k_s));
                let mut ambient = zip(of(scene.k_a), of(scene.i_a), |k, i| k * i);
                if profile.ambient_times_diffuse {
                    ambient = zip(ambient, k_d, |a, k| a * k);
                }
                let is_dark = scene.lights.is_empty();
                let mut sum = ambient;
                if profile.attenuated_ambient || profile.black_without_lights && is_dark {
                    sum = [0.0; 3];
                } else if profile.unlit_without_lights && is_dark {
                    sum = zip(sum, k_d, |a, k| a + k);
                }
                let (mut matte, mut shiny) = ([0.0; 3], [0.0; 3]);
                for i in 0..scene.lights.len() {
                    let i = if form.0.is_factored {
                        scene.lights.len() - 1 - i
                    } else {
                        i
                    };
                    let light = &scene.lights[i];
                    let mut falloff = 1.0;
                    let mut l = [0.0; 3];
                    if let Light::Directional { l: way, .. } = light {
                        l = of(*way);
                    }
                    if let Some((position, attenuation)) = light.lamp() {
                        let way = zip(local(position), p, |to, p| to - p);
                        let square = form.dot(way, way);
                        let q = square.sqrt();
                        l = form.unit(way);
                        let [a, b, c] = of(attenuation);
                        falloff = match form.0.attenuation {
                            0 => 1.0 / (a + q * (b + q * c)),
                            1 => 1.0 / (c * square + b * q + a),
                            _ => {
                                let inverse = 1.0 / q;
                                inverse * inverse / (c + inverse * (b + inverse * a))
                            }
                        };
                    }
                    if profile.attenuated_ambient {
                        sum = zip(sum, ambient, |sum, a| sum + a * falloff);
                    }
                    let mut intensity = of(light.intensity());
                    if let Light::Spot {
                        axis, half_angle, ..
                    } = light
                    {
                        let angle = if profile.whole_angle {
                            half_angle / 2.0
                        } else {
                            *half_angle
                        };
                        let cosine = -form.dot(of(*axis), l);
                        if cosine < (angle as $float).cos() {
                            continue;
                        }
                        if profile.spot_exponent > 0.0 {
                            let within = cosine.max(0.0).powf(profile.spot_exponent as $float);
                            intensity = scale(intensity, within);
                        }
                    }
                    let n_dot_l = form.dot(n, l);
                    if n_dot_l > 0.0 {
                        matte = zip(matte, intensity, |sum, c| sum + c * n_dot_l * falloff);
                    } else if !profile.highlight_on_the_dark_side {
                        continue;
                    }
                    if scene.model != Model::Lambert {
                        let left = if profile.unattenuated_highlight {
                            1.0
                        } else {
                            falloff
                        };
                        let factor = left * form.highlight(scene.model, n, l, v, scene.m);
                        shiny = zip(shiny, intensity, |sum, c| sum + c * factor);
                    }
                }
                let lit = zip(
                    zip(k_d, matte, |k, c| k * c),
                    zip(k_s, shiny, |k, c| k * c),
                    |a, b| a + b,
                );
                zip(lit, sum, |lit, sum| lit + sum).map(f64::from)
            }
        }
    };
}

forms!(f32);
forms!(f64);

fn encoded(color: [f64; 3]) -> [f64; 3] {
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

fn plan(profile: &Profile, seed: u64, cases: usize) -> Plan {
    let laws = Laws {
        seed,
        cases,
        ..Laws::default()
    };
    laws.plan(profile).expect("a profile")
}

#[track_caller]
fn holds(plan: &Plan, color: impl FnMut(&Scene) -> [f64; 3]) {
    let report = plan.run(&mut from_fn(plan.profile().clone(), color));
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
    for seed in 0..2 {
        let [single, double, bytes] =
            [&single, &double, &bytes].map(|profile| plan(profile, seed, 32));
        for i in 0..40 {
            let form = Form::number(i);
            match (i + seed as usize) % 3 {
                0 => holds(&single, |scene| f32::shade(form, scene, single.profile())),
                1 => holds(&double, |scene| f64::shade(form, scene, double.profile())),
                _ => holds(&bytes, |scene| {
                    encoded(f32::shade(form, scene, bytes.profile()))
                }),
            }
        }
    }
}

/// Renderers that lack something, or depart from the formulas on purpose.
#[test]
fn what_differs_on_purpose_is_no_mistake() {
    let all = Profile::default;
    for profile in [
        Profile {
            models: vec![Model::Phong],
            lights: vec![Kind::Point, Kind::Spot],
            most_lights: 1,
            unit_vectors: true,
            ..all()
        },
        Profile {
            models: vec![Model::Lambert, Model::BlinnPhong],
            lights: vec![Kind::Directional],
            integer_shininess: true,
            ..all()
        },
        Profile {
            whole_angle: true,
            attenuated_ambient: true,
            unattenuated_highlight: true,
            highlight_on_the_dark_side: true,
            ..all()
        },
        Profile {
            normal_faces_eye: true,
            black_without_lights: true,
            unattenuated: true,
            gray_highlight: true,
            spot_exponent: 2.0,
            ambient_times_diffuse: true,
            ..all()
        },
        Profile {
            unlit_without_lights: true,
            lights: vec![Kind::Point, Kind::Spot],
            ..all()
        },
    ] {
        let plan = plan(&profile, 0, 256);
        holds(&plan, |scene| f32::shade(Form::number(1), scene, &profile));
    }
}

/// Tolerances follow the precision: what holds for `f32` is broken for `f64`.
#[test]
fn single_precision_is_not_double() {
    let profile = Profile {
        roundoff: f64::EPSILON / 2.0,
        ..Profile::default()
    };
    let mut single = from_fn(profile.clone(), |scene| {
        f32::shade(Form::number(0), scene, &profile)
    });
    let report = plan(&profile, 0, 64).run(&mut single);
    let broken = |name: &str| {
        report
            .laws
            .iter()
            .any(|law| law.law == name && law.is_broken())
    };
    assert!(broken("formula") && broken("rotation"), "{report}");
}

/// A law that needs what a renderer lacks is listed as not tried, and a declaration that no scene can show is no pass.
#[test]
fn what_is_not_tried_has_not_passed() {
    let profile = Profile {
        lights: vec![Kind::Directional],
        most_lights: 4000,
        ..Profile::default()
    };
    let mut right = from_fn(profile.clone(), |scene| {
        f32::shade(Form::number(0), scene, &profile)
    });
    let report = plan(&profile, 0, 20).run(&mut right);
    let text = report.to_string();
    assert!(!report.is_broken() && !report.passes(), "{text}");
    assert!(
        text.contains("distance is not tried: it has no point lights"),
        "{text}"
    );
    let missing = "NOT exercised, so this is no pass: 1024 of 4000 lights in a scene";
    assert!(text.contains(missing), "{text}");
}
