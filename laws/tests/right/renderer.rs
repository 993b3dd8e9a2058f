//! A right renderer, in any of many algebraic forms and in any type of numbers.

use num_traits::Float;
use shading_laws::{Light, Model, Profile, Scene, Triple};

/// How a renderer computes: a number whose digits choose one of several ways of each step.
#[derive(Clone, Copy)]
pub struct Form(pub usize);

impl Form {
    /// One of so many ways. Each step has a stride of its own, so that 120 forms mix them.
    fn way(self, stride: usize, count: usize) -> usize {
        (self.0 * stride / 3 + self.0) % count
    }
}

fn real<T: Float>(x: f64) -> T {
    T::from(x).expect("a number")
}

/// The matrix of a view: an orthonormal one, the reflection at a plane with the normal u. Two rows exchanged,
/// it turns; otherwise it is a mirrored frame, such as a left-handed one.
fn view<T: Float>(form: Form) -> [[T; 3]; 3] {
    let i = f64::from(form.0 as u32);
    let u = match form.way(11, 3) {
        0 => [(i * 0.7).sin(), (i * 1.1).cos(), (i * 1.7).sin()],
        1 => [1.0, 0.0, 0.0],
        _ => [1.0, -1.0, 0.0],
    };
    let square = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
    let entry = |i: usize, j: usize| f64::from(u8::from(i == j)) - 2.0 * u[i] * u[j] / square;
    let mut rows = [0, 1, 2].map(|i| [0, 1, 2].map(|j| real(entry(i, j))));
    if form.way(13, 2) == 1 {
        rows.swap(1, 2);
    }
    rows
}

/// A renderer in one piece, in the numbers of a type.
struct Renderer<'a, T> {
    form: Form,
    profile: &'a Profile,
    view: [[T; 3]; 3],
}

impl<T: Float> Renderer<'_, T> {
    fn dot(&self, a: [T; 3], b: [T; 3]) -> T {
        match self.form.way(1, 4) {
            0 => a[0] * b[0] + a[1] * b[1] + a[2] * b[2],
            1 => a[2].mul_add(b[2], a[1].mul_add(b[1], a[0] * b[0])),
            2 => a[2] * b[2] + a[1] * b[1] + a[0] * b[0],
            _ => a[0].mul_add(b[0], a[1] * b[1]) + a[2] * b[2],
        }
    }

    fn unit(&self, mut v: [T; 3]) -> [T; 3] {
        let way = self.form.way(2, 4);
        if way == 2 {
            let largest = v[0].abs().max(v[1].abs()).max(v[2].abs());
            v = v.map(|c| c / largest);
        }
        let square = self.dot(v, v);
        match way {
            0 => v.map(|c| c / square.sqrt()),
            1 => v.map(|c| c * square.sqrt().recip()),
            2 => v.map(|c| c / square.sqrt()),
            _ => v.map(|c| c * (T::one() / square).sqrt()),
        }
    }

    /// A vector in the frame of the renderer, by a matrix in rows or in columns.
    fn turned(&self, v: Triple) -> [T; 3] {
        let v: [T; 3] = v.map(real);
        let [r, s, t] = self.view;
        match self.form.way(5, 4) {
            0 => v, // it shades in the world
            1 => [self.dot(r, v), self.dot(s, v), self.dot(t, v)],
            _ => [0, 1, 2].map(|i| r[i] * v[0] + s[i] * v[1] + t[i] * v[2]),
        }
    }

    fn direction(&self, v: Triple) -> [T; 3] {
        let turned = self.turned(v);
        // that of a sun and the axis of a spot have length 1 already
        if self.form.way(7, 2) == 0 {
            turned
        } else {
            self.unit(turned)
        }
    }

    fn power(&self, x: T, m: f64) -> T {
        match self.form.way(4, 4) {
            0 if x > T::zero() => (real::<T>(m) * x.ln()).exp(),
            1 if x > T::zero() => (real::<T>(m) * x.log2()).exp2(),
            2 if m.fract() == 0.0 => x.powi(m as i32),
            _ => x.powf(real(m)),
        }
    }

    /// The power of R·V or of N·H.
    fn highlight(&self, model: Model, [n, l, v]: [[T; 3]; 3], m: f64) -> T {
        let (zero, two) = (T::zero(), real::<T>(2.0));
        let (n_l, n_v) = (self.dot(n, l), self.dot(n, v));
        let mirrored = |a: [T; 3], cosine: T| [0, 1, 2].map(|i| n[i] * (two * cosine) - a[i]);
        if model == Model::Phong {
            let cosine = match self.form.way(3, 3) {
                0 => self.dot(mirrored(l, n_l), v),
                1 => two * n_l * n_v - self.dot(l, v),
                _ => self.dot(mirrored(v, n_v), l),
            };
            return self.power(cosine.max(zero).min(T::one()), m);
        }
        let sum = [0, 1, 2].map(|i| l[i] + v[i]);
        let square = self.dot(sum, sum);
        if square <= zero {
            return zero; // where L = -V there is no H
        }
        let cosine = self.dot(n, sum).max(zero);
        match self.form.way(6, 4) {
            0 => self.power(self.dot(n, self.unit(sum)).max(zero), m),
            1 => self.power(((n_l + n_v) / square.sqrt()).max(zero).min(T::one()), m),
            2 => self.power(cosine * cosine / square, m / 2.0),
            _ => {
                let square = two + two * self.dot(l, v);
                if square <= zero {
                    zero
                } else {
                    self.power(((n_l + n_v) / square.sqrt()).max(zero).min(T::one()), m)
                }
            }
        }
    }

    fn falloff(&self, abc: Triple, square: T) -> T {
        let ([a, b, c], q) = (abc.map(real::<T>), square.sqrt());
        let inverse = q.recip();
        match self.form.way(8, 3) {
            0 => (a + q * (b + q * c)).recip(),
            1 => (c * square + b * q + a).recip(),
            _ => inverse * inverse / (c + inverse * (b + inverse * a)),
        }
    }

    fn shade(&self, scene: &Scene) -> Triple {
        let departs = |name: &str| self.profile.departs.iter().any(|it| it == name);
        let (zero, one) = (T::zero(), T::one());
        let mul = |a: [T; 3], b: [T; 3]| [0, 1, 2].map(|i| a[i] * b[i]);
        let add = |a: [T; 3], b: [T; 3]| [0, 1, 2].map(|i| a[i] + b[i]);
        let scale = |a: [T; 3], factor: T| a.map(|c| c * factor);
        let of = |v: Triple| v.map(real::<T>);
        let v = self.unit(self.turned(scene.v));
        let mut n = self.unit(self.turned(scene.n));
        if departs("NormalTowardEye") && self.dot(n, v) < zero {
            n = scale(n, -one);
        }
        // positions are relative to 0, to the point, or to the eye
        let origin = match self.form.way(9, 3) {
            0 => [0.0; 3],
            1 => scene.p,
            _ => [0, 1, 2].map(|i| scene.p[i] + scene.v[i]),
        };
        let local = |p: Triple| {
            let offset = [0, 1, 2].map(|i| {
                (real::<T>(p[i]) - real::<T>(origin[i]))
                    .to_f64()
                    .expect("a number")
            });
            self.turned(offset)
        };
        let p = local(scene.p);
        let (k_a, k_d, k_s) = (of(scene.k_a), of(scene.k_d), of(scene.k_s));
        let mut ambient = mul(k_a, of(scene.i_a));
        if departs("AmbientTimesDiffuse") {
            ambient = mul(ambient, k_d);
        }
        if departs("UnlitWithoutLights") && scene.lights.is_empty() {
            ambient = add(ambient, k_d);
        }
        let (mut sum, mut matte, mut shiny) = (ambient, [zero; 3], [zero; 3]);
        let mut lights = scene.lights.clone();
        if self.form.way(10, 2) == 1 {
            lights.reverse();
        }
        for light in &lights {
            let (mut l, mut falloff) = ([zero; 3], one);
            if let Light::Directional { l: to_light, .. } = light {
                l = self.direction(*to_light);
            }
            if let Some((position, abc)) = light.lamp() {
                let position = local(position);
                let to_light = [0, 1, 2].map(|i| position[i] - p[i]);
                falloff = self.falloff(abc, self.dot(to_light, to_light));
                l = self.unit(to_light);
            }
            if let Light::Spot {
                axis, half_angle, ..
            } = *light
            {
                let cosine = -self.dot(self.direction(axis), l);
                if cosine < real::<T>(half_angle).cos() {
                    continue;
                }
                if departs("ConeExponent=2") {
                    falloff = falloff * cosine.max(zero) * cosine.max(zero);
                }
            }
            let n_dot_l = self.dot(n, l);
            if n_dot_l <= zero && !departs("HighlightNotGated") {
                continue;
            }
            let arriving = scale(of(light.intensity()), falloff);
            let n_dot_l = n_dot_l.max(zero);
            let power = match scene.model {
                Model::Lambert => zero,
                model => self.highlight(model, [n, l, v], scene.m),
            };
            // one sum, or one for each term
            if self.form.way(12, 2) == 0 {
                let reflected = add(scale(k_d, n_dot_l), scale(k_s, power));
                sum = add(sum, mul(arriving, reflected));
            } else {
                matte = add(matte, scale(arriving, n_dot_l));
                shiny = add(shiny, scale(arriving, power));
            }
        }
        let color = add(sum, add(mul(k_d, matte), mul(k_s, shiny)));
        color.map(|c| c.to_f64().expect("a number"))
    }
}

pub fn renderer<T: Float>(form: Form, profile: &Profile) -> impl Fn(&Scene) -> Triple {
    let renderer = Renderer::<T> {
        form,
        profile,
        view: view(form),
    };
    move |scene| renderer.shade(scene)
}
