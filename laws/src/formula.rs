//! The formulas, once: what bounds a renderer's error, gives the colors of mistakes, and plants them. Every ingredient
//! passes a hook, where a mistake may change it.

use crate::bounded::{Arithmetic, Bounded, Bounded3, given3};
use crate::mistakes::Fault;
use crate::profile::{Profile, to_srgb};
use crate::scene::{Kind, Light, Model, Scene, Triple, add, dot, length, mul, scale, sub, unit};

/// An ingredient, in the order of the computation. A number is a triple of three alike, so that one operation fits any.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Part {
    Model,
    P,
    V,
    N,
    Side,
    Kd,
    Ks,
    M,
    Ka,
    Ia,
    Ambient,
    Once,
    Intensity,
    Position,
    Way,
    Q,
    L,
    Abc,
    Denominator,
    Falloff,
    Against,
    Angle,
    Edge,
    Within,
    Cone,
    MatteLight,
    MatteFalloff,
    MatteCone,
    ShinyLight,
    ShinyFalloff,
    ShinyCone,
    OfThisLight,
    Lambert,
    Half,
    Cosine,
    Power,
    Gate,
    Reflectance,
    Diffuse,
    Specular,
    OfLight,
    AmbientToo,
    Sum,
    Clamp,
    Encode,
    Level,
}

/// What is known when an ingredient is computed: all before it.
#[derive(Clone, Default)]
pub struct At {
    /// The range of the renderer's colors, and the distance of their levels.
    range: Option<[f64; 2]>,
    pub level: Option<f64>,
    pub how: Arithmetic,
    /// The number of the mistake.
    pub value: f64,
    pub model: Model,
    pub p: Bounded3,
    pub raw_v: Bounded3,
    pub v: Bounded3,
    /// N as it is given, and N.
    pub raw_n: Bounded3,
    pub n: Bounded3,
    pub k_a: Bounded3,
    pub k_d: Bounded3,
    pub k_s: Bounded3,
    pub m: f64,
    pub i_a: Bounded3,
    pub ambient: Bounded3,
    /// The light, its place among the others, and their number.
    pub light: Option<Light>,
    pub i: f64,
    pub count: f64,
    pub intensity: Bounded3,
    pub position: Bounded3,
    pub way: Bounded3,
    pub q: Bounded,
    pub l: Bounded3,
    pub abc: Bounded3,
    pub denominator: Bounded,
    pub falloff: Bounded,
    /// The cosine of the angle to the axis of the cone, that of its edge, and what is left of the light within it.
    pub against: Bounded,
    pub edge: Bounded,
    pub within: Bounded,
    pub cone: Bounded,
    pub n_l: Bounded,
    /// L + V.
    pub sum: Bounded3,
    pub cosine: Bounded,
    /// The sums over the lights, and that of the ambient light.
    pub diffuse: Bounded3,
    pub specular: Bounded3,
    pub lit: Bounded3,
    pub ambients: Bounded3,
    /// What is clamped or encoded.
    pub linear: f64,
}

/// A direction, which the renderer may turn to another frame, such as that of the eye.
fn turned(v: Triple, how: Arithmetic) -> Bounded3 {
    let off = if how.rounds {
        0.0
    } else {
        4.0 * how.u * length(v)
    };
    given3(v, how).map(|c| c.looser(off))
}

pub type Change = fn(Bounded3, &At) -> Bounded3;

pub const ZERO: Bounded = Bounded::ZERO;
pub const ONE: Bounded = Bounded::exact(1.0);
pub const BLACK: Bounded3 = [ZERO; 3];

impl At {
    pub fn given(&self, x: f64) -> Bounded {
        Bounded::given(x, self.how)
    }

    /// The number of the mistake, as the renderer has it.
    pub fn number(&self) -> Bounded {
        self.given(self.value)
    }

    pub fn is_of(&self, kind: Kind) -> bool {
        self.light.is_some_and(|light| light.kind() == kind)
    }

    /// The axis and the half-angle of a spot.
    pub fn spot(&self) -> (Bounded3, f64) {
        match self.light {
            Some(Light::Spot {
                axis, half_angle, ..
            }) => (turned(axis, self.how), half_angle),
            _ => (BLACK, 0.0),
        }
    }

    /// R·V, where R = 2(N·L)N − L, or N·H.
    pub fn cosine_of(&self, n: Bounded3, l: Bounded3, twice: f64) -> Bounded {
        if self.model == Model::Phong {
            let r = sub(scale(n, Bounded::exact(twice) * dot(n, l)), l);
            dot(r, self.v)
        } else {
            dot(n, unit(add(l, self.v)))
        }
    }

    /// A color in the range of the renderer, or in that from 0 to 1.
    pub fn clamped(&self, color: Bounded3) -> Bounded3 {
        let [low, high] = self.range.unwrap_or([0.0, 1.0]);
        color.map(|c| c.if_positive(c, Bounded::exact(low)).at_most(high))
    }
}

/// The formulas as a renderer has them: with what it departs from on purpose, and with these mistakes.
pub struct Formula<'a> {
    profile: &'a Profile,
    faults: Vec<Fault>,
    is_wrong: bool,
    how: Arithmetic,
}

impl<'a> Formula<'a> {
    pub fn new(profile: &'a Profile, faults: &[Fault]) -> Self {
        let is_made = |on_purpose: &Fault| {
            let mut made = faults.iter();
            !made.any(|fault| fault.mistake.id == on_purpose.mistake.id)
        };
        let departures = profile.departures().into_iter().filter(is_made);
        let rough = faults.iter().find(|fault| fault.mistake.is_rough());
        Self {
            profile,
            faults: faults.iter().copied().chain(departures).collect(),
            is_wrong: !faults.is_empty(),
            how: Arithmetic {
                u: rough.map_or(profile.roundoff, |fault| (-fault.value).exp2()),
                rounds: false,
            },
        }
    }

    /// The same as a renderer: it rounds every value.
    #[cfg(test)]
    pub fn rounding(mut self) -> Self {
        self.how.rounds = true;
        self
    }

    fn at(&self) -> At {
        At {
            how: self.how,
            range: self.profile.range(),
            level: self.profile.level(),
            ..At::default()
        }
    }

    fn hook(&self, part: Part, at: &mut At, right: Bounded3) -> Bounded3 {
        let mut x = right;
        for fault in &self.faults {
            for (of, change) in &fault.mistake.changes {
                if *of == part && (fault.of.has)(at) {
                    at.value = fault.value;
                    x = change(x, at);
                }
            }
        }
        x
    }

    fn number(&self, part: Part, at: &mut At, right: Bounded) -> Bounded {
        self.hook(part, at, [right; 3])[0]
    }

    /// The color in linear light, before the range of the renderer.
    pub fn linear(&self, scene: &Scene) -> Bounded3 {
        let at = &mut self.at();
        #[allow(clippy::cast_precision_loss)] // the count of lights
        let number = |count: usize| count as f64;
        at.count = number(scene.lights.len());
        self.surface(scene, at);
        let n = at.n;
        for (i, light) in scene.lights.iter().enumerate() {
            (at.light, at.i, at.n) = (Some(*light), number(i), n);
            self.arriving(scene, at);
            self.reflected(at);
        }
        at.light = None;
        let sum = add(at.ambients, at.lit);
        self.hook(Part::Sum, at, sum)
    }

    fn surface(&self, scene: &Scene, at: &mut At) {
        let how = self.how;
        at.model = scene.model;
        let model = Bounded::exact(f64::from(scene.model as u8));
        let model = self.number(Part::Model, at, model);
        at.model = match model.value {
            0.0 => Model::Lambert,
            1.0 => Model::Phong,
            _ => Model::BlinnPhong,
        };
        at.p = self.hook(Part::P, at, given3(scene.p, how));
        (at.raw_v, at.raw_n) = (turned(scene.v, how), turned(scene.n, how));
        at.v = self.hook(Part::V, at, unit(at.raw_v));
        let n = self.hook(Part::N, at, unit(at.raw_n));
        at.n = n;
        let side = self.number(Part::Side, at, ONE);
        (at.n, at.raw_n) = (scale(n, side), scale(at.raw_n, side));
        at.k_s = given3(scene.k_s, how);
        at.k_d = self.hook(Part::Kd, at, given3(scene.k_d, how));
        at.k_s = self.hook(Part::Ks, at, at.k_s);
        at.m = self.number(Part::M, at, Bounded::exact(scene.m)).value;
        at.k_a = self.hook(Part::Ka, at, given3(scene.k_a, how));
        at.i_a = self.hook(Part::Ia, at, given3(scene.i_a, how));
        at.ambient = self.hook(Part::Ambient, at, mul(at.k_a, at.i_a));
        at.ambients = self.hook(Part::Once, at, at.ambient);
    }

    /// A light where it arrives.
    fn arriving(&self, scene: &Scene, at: &mut At) {
        let (how, Some(light)) = (self.how, at.light) else {
            return;
        };
        (at.falloff, at.cone) = (ONE, ONE);
        at.intensity = self.hook(Part::Intensity, at, given3(light.intensity(), how));
        if let Light::Directional { l, .. } = light {
            at.way = turned(l, how);
            at.l = self.hook(Part::L, at, at.way);
        }
        if let Some((position, abc)) = light.lamp() {
            at.position = self.hook(Part::Position, at, given3(position, how));
            // the renderer may take both to another frame first, such as that of the eye, and round them there
            let off = 4.0 * how.u * scene.extent(position);
            let way = sub(at.position, at.p).map(|c| c.looser(off));
            at.way = self.hook(Part::Way, at, way);
            at.q = self.number(Part::Q, at, length(at.way));
            at.l = self.hook(Part::L, at, unit(at.way));
            at.abc = self.hook(Part::Abc, at, given3(abc, how));
            let [a, b, c] = at.abc;
            let denominator = a + b * at.q + c * (at.q * at.q);
            at.denominator = self.number(Part::Denominator, at, denominator);
            at.falloff = self.number(Part::Falloff, at, ONE / at.denominator);
        }
        if at.is_of(Kind::Spot) {
            let (axis, half_angle) = at.spot();
            at.against = self.number(Part::Against, at, -dot(axis, at.l));
            let angle = self.number(Part::Angle, at, Bounded::given(half_angle, how));
            at.edge = self.number(Part::Edge, at, angle.cos());
            at.within = self.number(Part::Within, at, ONE);
            // the edge itself is lit
            let cone = (at.edge - at.against).if_positive(ZERO, at.within);
            at.cone = self.number(Part::Cone, at, cone);
        }
    }

    fn reflected(&self, at: &mut At) {
        let falloff = self.number(Part::MatteFalloff, at, at.falloff);
        let cone = self.number(Part::MatteCone, at, at.cone);
        let matte = scale(
            self.hook(Part::MatteLight, at, at.intensity),
            falloff * cone,
        );
        at.n = self.hook(Part::OfThisLight, at, at.n);
        (at.n_l, at.sum) = (dot(at.n, at.l), add(at.l, at.v));
        let lambert = self.number(Part::Lambert, at, at.n_l.at_least_zero());
        let diffuse = scale(mul(at.k_d, matte), lambert);
        let diffuse = self.hook(Part::Diffuse, at, diffuse);
        let mut specular = BLACK;
        if at.model != Model::Lambert {
            let falloff = self.number(Part::ShinyFalloff, at, at.falloff);
            let cone = self.number(Part::ShinyCone, at, at.cone);
            let shiny = scale(
                self.hook(Part::ShinyLight, at, at.intensity),
                falloff * cone,
            );
            let power = self.power(at);
            let gate = self.number(Part::Gate, at, at.n_l.if_positive(ONE, ZERO));
            let k_s = self.hook(Part::Reflectance, at, at.k_s);
            let factor = (gate - Bounded::exact(0.5)).if_positive(power, ZERO);
            specular = self.hook(Part::Specular, at, scale(mul(k_s, shiny), factor));
        }
        let of_light = self.hook(Part::OfLight, at, add(diffuse, specular));
        let too = self.hook(Part::AmbientToo, at, BLACK);
        at.diffuse = add(at.diffuse, diffuse);
        at.specular = add(at.specular, specular);
        at.lit = add(at.lit, of_light);
        at.ambients = add(at.ambients, too);
    }

    fn power(&self, at: &mut At) -> Bounded {
        let cosine = if at.model == Model::Phong {
            at.cosine_of(at.n, at.l, 2.0)
        } else {
            let h = self.hook(Part::Half, at, unit(at.sum));
            if h.iter().all(|c| c.value.is_nan()) {
                // opposite directions have no half vector; where nothing rounds, any that a renderer takes has a power
                // from 0 to 1
                let is_exact = at.l.iter().all(|c| c.value.fract() == 0.0);
                let power = match () {
                    () if self.how.rounds => ZERO,
                    () if is_exact => Bounded::between(0.0, 1.0, self.how),
                    () => Bounded::UNKNOWN,
                };
                return self.number(Part::Power, at, power);
            }
            dot(at.n, h)
        };
        at.cosine = self.number(Part::Cosine, at, cosine);
        let power = at.cosine.at_least_zero().power(at.m);
        self.number(Part::Power, at, power)
    }

    /// How far two colors of any renderer may be apart by rounding alone, whatever mistake it makes, relative to
    /// the most light that may come back; and that light.
    pub fn conditioning(&self, scene: &Scene) -> (f64, Triple) {
        let mut most = mul(scene.k_a, scene.i_a);
        let mut condition = 1.0_f64;
        for light in &scene.lights {
            if let Some((position, _)) = light.lamp() {
                let q = length(sub(position, scene.p));
                condition = condition.max(1.0 + scene.extent(position) / q);
            }
            let (intensity, left) = (light.intensity(), light.falloff(scene.p));
            most = [0, 1, 2].map(|i| most[i] + (scene.k_d[i] + scene.k_s[i]) * intensity[i] * left);
        }
        (32.0 * self.how.u * (scene.m + 1.0) * condition, most)
    }

    /// Whether a channel is NaN or infinity, or what a clamp to the range leaves of them.
    fn is_lost(&self, c: f64) -> bool {
        !c.is_finite() || self.profile.range().is_some_and(|ends| ends.contains(&c))
    }

    /// Whether a renderer like this may give this color; nothing where it may give any.
    pub fn fits(&self, scene: &Scene, reply: Triple) -> Option<bool> {
        let fits = self.fits_linear(self.linear(scene), reply);
        let mut channels = reply.iter();
        let is_lost = channels.any(|c| !c.is_finite()) || reply.iter().all(|c| self.is_lost(*c));
        // where the right color is not known either, the mistakes explain nothing
        let is_known = || {
            let right = Formula::new(self.profile, &[]).linear(scene);
            let mut made = self.faults.iter();
            made.any(|fault| fault.mistake.id == "HalfVectorUnguarded")
                || right.iter().any(|c| c.error.is_finite())
        };
        fits.filter(|fits| !fits || !is_lost || is_known())
    }

    /// The same, where the color in linear light is known.
    pub fn fits_linear(&self, linear: Bounded3, reply: Triple) -> Option<bool> {
        let in_bits = self.faults.iter().find(|f| f.mistake.id == "InBits");
        if let Some(Fault { value: bits, .. }) = in_bits {
            let off = |c: f64| (crate::bounded::rounded(c, (-bits).exp2()) - c).abs();
            // a decimal fraction may be cut off
            let is_one = |c: f64| !c.is_finite() || off(c) <= self.profile.roundoff * c.abs();
            if !reply.into_iter().all(is_one) {
                return Some(false);
            }
        }
        let mut is_known = false;
        for (linear, c) in linear.into_iter().zip(reply) {
            match self.ends(linear) {
                Some([low, high]) if !(low..=high).contains(&c) => return Some(false),
                Some(_) => is_known = true,
                // a division by 0 or the power of a negative number
                None if self.is_wrong && self.is_lost(c) => is_known = true,
                None if !c.is_finite() => return Some(false),
                None => {}
            }
        }
        is_known.then_some(true)
    }

    /// The least and the largest reply that the renderer may give for a channel, where the formulas have an answer.
    pub fn ends(&self, c: Bounded) -> Option<[f64; 2]> {
        if !c.error.is_finite() {
            return None;
        }
        let ends = [c.value - c.error, c.value + c.error].map(|end| self.encoded(end));
        let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        let slack = self.profile.slack(low.abs().max(high.abs()), self.how.u);
        Some([low - slack, high + slack])
    }

    /// The reply of a renderer like this.
    pub fn reply(&self, scene: &Scene) -> Triple {
        self.linear(scene).map(|c| self.encoded(c.value))
    }

    /// What becomes of linear light on its way out.
    fn encoded(&self, linear: f64) -> f64 {
        let at = &mut self.at();
        let mut of = |part, before: f64, x: f64| {
            at.linear = before;
            self.number(part, at, Bounded::exact(x)).value
        };
        let clamped = |of: &mut dyn FnMut(Part, f64, f64) -> f64, x: f64| {
            let right = match self.profile.range() {
                // as in a shader, NaN becomes the lower end
                Some([low, high]) => x.max(low).min(high),
                None => x,
            };
            of(Part::Clamp, x, right)
        };
        let x = clamped(&mut of, linear);
        let right = if self.profile.srgb { to_srgb(x) } else { x };
        let y = of(Part::Encode, x, right);
        let y = clamped(&mut of, y);
        match self.profile.level() {
            Some(level) => {
                let right = if self.how.rounds {
                    (y / level).round() * level
                } else {
                    y
                };
                of(Part::Level, y, right)
            }
            None if self.how.rounds => self.profile.rounded(y),
            None => y,
        }
    }
}
