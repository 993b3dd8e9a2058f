//! Right renderers in other algebraic forms: no law is broken at any seed.

use std::time::Duration;

use shading_laws::{Laws, Light, Model, Profile, Scene, from_fn};

use crate::by_hand::{Float, Short, Vec3, add, dot, mul, of, scale, sub};

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

    fn dot<T: Float>(self, a: Vec3<T>, b: Vec3<T>) -> T {
        if self.is_fused {
            a[2].mul_add(b[2], a[1].mul_add(b[1], a[0] * b[0]))
        } else {
            dot(a, b)
        }
    }

    fn unit<T: Float>(self, v: Vec3<T>) -> Vec3<T> {
        match self.normalize {
            0 => {
                let length = self.dot(v, v).sqrt();
                v.map(|c| c / length)
            }
            1 => scale(v, T::of(1.0) / self.dot(v, v).sqrt()),
            _ => {
                let largest = v[0].abs().max(v[1].abs()).max(v[2].abs());
                let v = v.map(|c| c / largest);
                scale(v, T::of(1.0) / self.dot(v, v).sqrt())
            }
        }
    }

    fn power<T: Float>(self, x: T, m: f64) -> T {
        match self.power {
            1 if x > T::of(0.0) => (T::of(m) * x.ln()).exp(),
            2 if m.fract() == 0.0 => x.powi(m as i32),
            _ => x.powf(T::of(m)),
        }
    }

    fn highlight<T: Float>(self, model: Model, n: Vec3<T>, l: Vec3<T>, v: Vec3<T>, m: f64) -> T {
        let (zero, two) = (T::of(0.0), T::of(2.0));
        let n_dot_l = self.dot(n, l);
        if model == Model::Phong {
            let cosine = match self.reflection {
                0 => self.dot(sub(scale(n, two * n_dot_l), l), v),
                1 => two * n_dot_l * self.dot(n, v) - self.dot(l, v),
                _ => self.dot(sub(scale(n, two * self.dot(n, v)), v), l),
            };
            return self.power(cosine.max(zero).min(T::of(1.0)), m);
        }
        let sum = add(l, v);
        let square = self.dot(sum, sum);
        // where L = -V there is no H
        if square <= zero {
            return zero;
        }
        match self.half {
            0 => self.power(self.dot(n, self.unit(sum)).max(zero), m),
            1 => {
                let cosine = (n_dot_l + self.dot(n, v)) / square.sqrt();
                self.power(cosine.max(zero), m)
            }
            _ => {
                let cosine = self.dot(n, sum).max(zero);
                self.power(cosine * cosine / square, m / 2.0)
            }
        }
    }

    fn shade<T: Float>(self, scene: &Scene) -> [f64; 3] {
        let (zero, one) = (T::of(0.0), T::of(1.0));
        let (n, v) = (self.unit(of::<T>(scene.n)), self.unit(of::<T>(scene.v)));
        let origin = match self.frame {
            0 => [zero; 3],
            1 => add(of::<T>(scene.p), of(scene.v)),
            _ => of(scene.p),
        };
        let p = sub(of::<T>(scene.p), origin);
        let material = &scene.material;
        let (k_d, k_s) = (of::<T>(material.k_d), of::<T>(material.k_s));
        let ambient = mul(of::<T>(material.k_a), of(scene.i_a));
        let mut sum = if self.is_factored { [zero; 3] } else { ambient };
        let (mut matte, mut shiny) = ([zero; 3], [zero; 3]);
        let count = scene.lights.len();
        for i in 0..count {
            let i = if self.is_factored { count - 1 - i } else { i };
            let light = &scene.lights[i];
            let mut intensity = of::<T>(light.intensity());
            let mut l = match light {
                Light::Directional { l, .. } => of::<T>(*l),
                Light::Point { .. } | Light::Spot { .. } => [zero; 3],
            };
            if let Light::Point {
                position,
                attenuation,
                ..
            }
            | Light::Spot {
                position,
                attenuation,
                ..
            } = light
            {
                let way = sub(sub(of::<T>(*position), origin), p);
                let square = self.dot(way, way);
                let q = square.sqrt();
                l = self.unit(way);
                let [a, b, c] = of::<T>(*attenuation);
                let left = match self.attenuation {
                    0 => one / (a + q * (b + q * c)),
                    1 => one / (c * square + b * q + a),
                    _ => {
                        let inverse = one / q;
                        inverse * inverse / (c + inverse * (b + inverse * a))
                    }
                };
                intensity = scale(intensity, left);
            }
            if let Light::Spot {
                axis, half_angle, ..
            } = light
            {
                if self.dot(of::<T>(*axis), scale(l, -one)) < T::of(*half_angle).cos() {
                    continue;
                }
            }
            let n_dot_l = self.dot(n, l);
            if n_dot_l <= zero {
                continue;
            }
            let factor = if scene.model == Model::Lambert {
                zero
            } else {
                self.highlight(scene.model, n, l, v, material.m)
            };
            if self.is_factored {
                matte = add(matte, scale(intensity, n_dot_l));
                shiny = add(shiny, scale(intensity, factor));
            } else {
                sum = add(sum, mul(k_d, scale(intensity, n_dot_l)));
                sum = add(sum, mul(scale(k_s, factor), intensity));
            }
        }
        if self.is_factored {
            sum = add(add(mul(k_d, matte), mul(k_s, shiny)), ambient);
        }
        sum.map(Float::get)
    }
}

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

/// Two thirds compute in `f32`, of which one half gives bytes, and a third in `f64`.
#[test]
fn forty_right_renderers_hold_at_twenty_seeds() {
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
    let mut alarms = Vec::new();
    for seed in 0..20 {
        let laws = Laws::new().seed(seed).shrinking(20, Duration::from_secs(5));
        let laws = laws.cases(32);
        let [single, double, bytes] =
            [&single, &double, &bytes].map(|profile| (profile, laws.prepared(profile)));
        for i in 0..40 {
            let form = Form::number(i);
            let report = match (i + seed as usize) % 3 {
                0 => single.1.run(&mut from_fn(single.0.clone(), |scene| {
                    form.shade::<f32>(scene)
                })),
                1 => double.1.run(&mut from_fn(double.0.clone(), |scene| {
                    form.shade::<f64>(scene)
                })),
                _ => bytes.1.run(&mut from_fn(bytes.0.clone(), |scene| {
                    encoded(form.shade::<f32>(scene))
                })),
            };
            let report = report.expect("colors");
            if !report.passes() {
                alarms.push(format!("{form:?}, seed {seed}\n{report}"));
            }
        }
    }
    let first: Vec<String> = alarms.iter().take(3).cloned().collect();
    assert!(
        alarms.is_empty(),
        "{} alarms:\n{}",
        alarms.len(),
        first.join("\n")
    );
}

/// Each operation is rounded to 11 bits, as in half precision, or to 8, as in bfloat.
#[test]
fn right_renderers_of_few_digits_hold() {
    let profile = |bits: f64| Profile {
        roundoff: (-bits).exp2(),
        ..Profile::default()
    };
    let (half, bfloat) = (profile(11.0), profile(8.0));
    for seed in 0..3 {
        let laws = Laws::new().seed(seed).shrinking(20, Duration::from_secs(5));
        let laws = laws.cases(32);
        let [of_half, of_bfloat] = [&half, &bfloat].map(|profile| laws.prepared(profile));
        for i in 0..40 {
            let form = Form::number(i);
            let mut renderer = from_fn(half.clone(), |scene| form.shade::<Short<11>>(scene));
            let report = of_half.run(&mut renderer).expect("colors");
            assert!(report.passes(), "{form:?}, seed {seed}\n{report}");
            let mut renderer = from_fn(bfloat.clone(), |scene| form.shade::<Short<8>>(scene));
            let report = of_bfloat.run(&mut renderer).expect("colors");
            assert!(report.passes(), "{form:?}, seed {seed}\n{report}");
        }
    }
}
