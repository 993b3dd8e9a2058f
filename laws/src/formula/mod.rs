//! The formulas, once: what bounds a renderer's error, and what gives the colors of mistakes. Every
//! ingredient passes a hook, where a mistake may change it.

mod part;

use crate::bounded::{Bounded, Bounded3, given3};
use crate::profile::{Profile, to_srgb};
use crate::scene::{Light, Model, Scene, Triple, add, dot, length, mul, scale, size, sub, unit};
pub use part::{Applied, At, Change, Part};

pub const ZERO: Bounded = Bounded::exact(0.0);
pub const ONE: Bounded = Bounded::exact(1.0);
pub const BLACK: Bounded3 = [ZERO; 3];

/// A direction, which the renderer may turn to another frame, such as that of the eye. Each
/// coordinate is then a sum of three products, with factors that are rounded, too.
fn turned(v: Triple, u: f64) -> Bounded3 {
    given3(v, u).map(|c| c.looser(6.0 * u * length(v)))
}

/// The formulas as a renderer has them: with what it departs from on purpose, and with mistakes.
pub struct Formula<'a> {
    pub profile: &'a Profile,
    pub changes: Vec<Applied>,
    /// The roundoff.
    pub u: f64,
    /// Wrong formulas may divide by 0.
    pub is_wrong: bool,
}

impl Formula<'_> {
    fn at(&self) -> At {
        At {
            u: self.u,
            level: self.profile.level().map(|it| it / self.profile.white),
            ..At::default()
        }
    }

    fn hook(&self, part: Part, at: &mut At, right: Bounded3) -> Bounded3 {
        let of_part = self.changes.iter().filter(|(of, ..)| *of == part);
        of_part.fold(right, |x, (_, change, value)| {
            at.value = *value;
            change(x, at)
        })
    }

    fn number(&self, part: Part, at: &mut At, right: Bounded) -> Bounded {
        self.hook(part, at, [right; 3])[0]
    }

    /// The color in linear light, before the range of the renderer.
    pub fn linear(&self, scene: &Scene) -> Bounded3 {
        let at = &mut self.at();
        at.is_unlit = scene.lights.is_empty();
        self.surface(scene, at);
        for light in &scene.lights {
            at.light = Some(*light);
            self.arriving(scene, *light, at);
            self.reflected(at);
            at.i += 1.0;
        }
        at.light = None;
        let sum = add(at.ambients, at.lit);
        self.hook(Part::Sum, at, sum)
    }

    fn surface(&self, scene: &Scene, at: &mut At) {
        let u = self.u;
        at.model = scene.model;
        at.p = given3(scene.p, u);
        // the renderer may know the position of the eye, and subtract p from it
        let of_eye = 2.0 * u * (size(scene.p) + size(scene.v));
        at.raw_v = turned(scene.v, u).map(|c| c.looser(of_eye));
        at.raw_n = turned(scene.n, u);
        at.v = self.hook(Part::V, at, unit(at.raw_v));
        at.n = self.hook(Part::N, at, unit(at.raw_n));
        let side = self.number(Part::Side, at, ONE);
        (at.n, at.raw_n) = (scale(at.n, side), scale(at.raw_n, side));
        at.k_d = given3(scene.k_d, u);
        at.k_s = given3(scene.k_s, u);
        at.m = self.number(Part::M, at, Bounded::exact(scene.m)).value;
        let ambient = mul(given3(scene.k_a, u), given3(scene.i_a, u));
        at.ambient = self.hook(Part::Ambient, at, ambient);
        at.ambients = self.hook(Part::Once, at, at.ambient);
    }

    /// A light where it arrives.
    fn arriving(&self, scene: &Scene, light: Light, at: &mut At) {
        let u = self.u;
        (at.falloff, at.cone) = (ONE, ONE);
        at.intensity = self.hook(Part::Intensity, at, given3(light.intensity(), u));
        if let Light::Directional { l, .. } = light {
            at.to_light = turned(l, u);
            at.l = self.hook(Part::L, at, at.to_light);
        }
        if let Some((position, abc)) = light.lamp() {
            at.position = given3(position, u);
            // the renderer may take both to another frame first, such as that of the eye, and round them there
            let off = 4.0 * u * scene.extent(position);
            let to_light = sub(at.position, at.p).map(|c| c.looser(off));
            at.to_light = self.hook(Part::ToLight, at, to_light);
            at.q = self.number(Part::Q, at, length(at.to_light));
            at.l = self.hook(Part::L, at, unit(at.to_light));
            let [a, b, c] = given3(abc, u);
            let denominator = a + b * at.q + c * (at.q * at.q);
            at.falloff = self.number(Part::Falloff, at, ONE / denominator);
        }
        if let Some((axis, half_angle)) = light.cone() {
            at.against = self.number(Part::Against, at, -dot(turned(axis, u), at.l));
            let angle = self.number(Part::Angle, at, Bounded::given(half_angle, u));
            at.edge = angle.cos();
            at.within = self.number(Part::Within, at, ONE);
            // the edge itself is lit
            let cone = (at.edge - at.against).if_positive(ZERO, at.within);
            at.cone = self.number(Part::Cone, at, cone);
        }
    }

    fn reflected(&self, at: &mut At) {
        let left = at.falloff * at.cone;
        (at.n_dot_l, at.sum) = (dot(at.n, at.l), add(at.l, at.v));
        let lambert = self.number(Part::Lambert, at, at.n_dot_l.at_least_zero());
        let diffuse = scale(mul(at.k_d, scale(at.intensity, left)), lambert);
        let diffuse = self.hook(Part::Diffuse, at, diffuse);
        let mut specular = BLACK;
        if at.model != Model::Lambert {
            let left = self.number(Part::ShinyFalloff, at, at.falloff) * at.cone;
            let light = scale(at.intensity, left);
            let power = self.power(at);
            let gate = self.number(Part::Gate, at, at.n_dot_l.if_positive(ONE, ZERO));
            let factor = (gate - Bounded::exact(0.5)).if_positive(power, ZERO);
            specular = self.hook(Part::Specular, at, scale(mul(at.k_s, light), factor));
        }
        let of_light = self.hook(Part::OfLight, at, add(diffuse, specular));
        let too = self.hook(Part::AmbientToo, at, BLACK);
        at.lit = add(at.lit, of_light);
        at.ambients = add(at.ambients, too);
    }

    /// The power of R·V, where R = 2(N·L)N − L, or of N·H.
    fn power(&self, at: &mut At) -> Bounded {
        let cosine = if at.model == Model::Phong {
            let r = sub(scale(at.n, Bounded::exact(2.0) * at.n_dot_l), at.l);
            dot(r, at.v)
        } else {
            let h = self.hook(Part::Half, at, unit(at.sum));
            if h.iter().all(|c| c.value.is_nan()) {
                // opposite directions have no half vector; where nothing rounds, any that a
                // renderer takes has a power from 0 to 1
                let is_exact = at.l.iter().all(|c| c.value.fract() == 0.0);
                let power = if is_exact {
                    Bounded::exact(0.5).looser(0.5)
                } else {
                    ZERO.looser(f64::INFINITY)
                };
                return self.number(Part::Power, at, power);
            }
            // the renderer may take (N·L + N·V)/√(2 + 2 L·V), whose root cancels where L is nearly −V
            let square = dot(at.sum, at.sum).value;
            let cosine = dot(at.n, h);
            cosine.looser(cosine.value.abs() * 8.0 * self.u / square)
        };
        at.cosine = self.number(Part::Cosine, at, cosine);
        let power = at.cosine.at_least_zero().power(at.m);
        self.number(Part::Power, at, power)
    }

    /// Whether a renderer like this may give this color; nothing where it may give any.
    pub fn fits(&self, scene: &Scene, reply: Triple) -> Option<bool> {
        self.fits_linear(self.linear(scene), reply)
    }

    /// The same, where the color in linear light is known.
    pub fn fits_linear(&self, linear: Bounded3, reply: Triple) -> Option<bool> {
        let mut is_known = false;
        let ends = self.profile.ends();
        // NaN or infinity, or what a clamp to the range leaves of them
        let is_lost = |c: f64| !c.is_finite() || ends.is_some_and(|ends| ends.contains(&c));
        for (linear, c) in linear.into_iter().zip(reply) {
            match self.ends(linear) {
                Some([low, high]) if !(low..=high).contains(&c) => return Some(false),
                Some(_) => is_known = true,
                // a division by 0 or the power of a negative number
                None if self.is_wrong && is_lost(c) => is_known = true,
                None if !c.is_finite() => return Some(false),
                None => {}
            }
        }
        is_known.then_some(true)
    }

    /// The least and the largest reply that the renderer may give for a channel, where the formulas have one.
    pub fn ends(&self, c: Bounded) -> Option<[f64; 2]> {
        if !c.error.is_finite() {
            return None;
        }
        let ends = [c.value - c.error, c.value + c.error].map(|end| self.encoded(end));
        let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        let slack = self.profile.slack(low.abs().max(high.abs()), self.u);
        Some([low - slack, high + slack])
    }

    /// How far a finite reply is off and how far it may be, where that is too far.
    pub fn excess(&self, c: Bounded, reply: f64) -> Option<(f64, f64)> {
        let [low, high] = self.ends(c).filter(|_| reply.is_finite())?;
        let right = self.encoded(c.value);
        let end = if reply > right { high } else { low };
        let is_off = !(low..=high).contains(&reply);
        is_off.then_some((reply - right, (end - right).abs()))
    }

    /// The reply of a renderer like this.
    pub fn reply(&self, scene: &Scene) -> Triple {
        let level = self.profile.level();
        let at_level = |c: f64| level.map_or(c, |level| (c / level).round() * level);
        let linear = self.linear(scene);
        linear.map(|c| at_level(self.encoded(c.value)))
    }

    /// What becomes of linear light on its way out, in the numbers of the renderer.
    fn encoded(&self, linear: f64) -> f64 {
        let at = &mut self.at();
        let mut of = |part, before: f64, right: f64| {
            at.linear = before;
            self.number(part, at, Bounded::exact(right)).value
        };
        let range = self.profile.range();
        // as in a shader, NaN becomes the lower end
        let clamped = |x: f64| range.map_or(x, |[low, high]| x.max(low).min(high));
        let x = clamped(linear);
        let right = if self.profile.srgb { to_srgb(x) } else { x };
        let y = clamped(of(Part::Encode, x, right));
        let is_level = self.profile.bits.is_some();
        let y = if is_level { of(Part::Level, y, y) } else { y };
        y * self.profile.white
    }
}
