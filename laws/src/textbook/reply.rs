//! What a renderer may reply for a color in linear light.

use std::array::from_fn;

use crate::bounded::{Bounded, Bounded3, add, rounded, unit};
use crate::mistake::Mistake;
use crate::reply::{from_srgb, to_srgb};
use crate::scene::{Material, Scene, Triple};

use super::Textbook;

impl Textbook<'_> {
    /// How far two colors of any renderer may be apart by rounding alone, whatever mistake it makes, relative to
    /// the most light that may come back; and that light.
    pub fn conditioning(&self, scene: &Scene) -> (f64, Triple) {
        let Material { k_a, k_d, k_s, m } = scene.material;
        let mut most = from_fn(|i| k_a[i] * scene.i_a[i]);
        let mut condition = 1.0_f64;
        for light in &scene.lights {
            let mut left = 1.0;
            if let Some((position, [a, b, c])) = light.lamp() {
                let way: Triple = from_fn(|i| position[i] - scene.p[i]);
                let q = way.iter().map(|c| c * c).sum::<f64>().sqrt();
                left = 1.0 / (a + b * q + c * q * q);
                condition = condition.max(1.0 + scene.extent(position) / q);
            }
            let intensity = light.intensity();
            most = from_fn(|i| most[i] + (k_d[i] + k_s[i]) * intensity[i] * left);
        }
        (32.0 * self.u * (m + 1.0) * condition, most)
    }

    /// Whether H has no direction for some light. NaN times a black k_s is NaN, so other models may be lost, too.
    fn has_no_half_vector(&self, scene: &Scene) -> bool {
        let v = unit(self.given(scene.v));
        scene.lights.iter().any(|light| {
            let sum = add(self.arriving(light, scene).l, v);
            sum.iter().all(|c| c.value.abs() <= c.error)
        })
    }

    /// Whether a channel is NaN or infinity, or what a clamp to the range leaves of them.
    fn is_lost(&self, c: f64) -> bool {
        !c.is_finite() || self.profile.range().is_some_and(|ends| ends.contains(&c))
    }

    /// Whether a renderer with the mistakes may give this color; nothing where it may give any.
    pub fn fits(&self, scene: &Scene, reply: Triple) -> Option<bool> {
        let is_lost =
            reply.iter().any(|c| !c.is_finite()) || reply.iter().all(|c| self.is_lost(*c));
        if self.has(Mistake::HalfVectorUnguarded) && is_lost && self.has_no_half_vector(scene) {
            return Some(true);
        }
        let fits = self.fits_linear(self.linear(scene), reply);
        // where the right color is not known either, the mistakes explain nothing
        let is_known = || {
            let right = Textbook::new(self.profile, &[]).linear(scene);
            right.iter().any(|c| c.error.is_finite())
        };
        fits.filter(|fits| !fits || !is_lost || is_known())
    }

    /// The same, where the color in linear light is known.
    pub fn fits_linear(&self, linear: Bounded3, reply: Triple) -> Option<bool> {
        if let Some(bits) = self.value_of(Mistake::InBits) {
            let off = |c: f64| (rounded(c, (-bits).exp2()) - c).abs();
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
                None if !self.faults.is_empty() && self.is_lost(c) => is_known = true,
                None if !c.is_finite() => return Some(false),
                None => {}
            }
        }
        is_known.then_some(true)
    }

    /// The least and the largest reply that the renderer may give for each channel, where the
    /// formulas have an answer.
    pub fn reply(&self, linear: Bounded3) -> [Option<[f64; 2]>; 3] {
        linear.map(|c| self.ends(c))
    }

    /// The same for a channel.
    fn ends(&self, c: Bounded) -> Option<[f64; 2]> {
        if !c.error.is_finite() {
            return None;
        }
        let ends = [c.value - c.error, c.value + c.error];
        let [low, high] = ends.map(|end| self.encoded(end));
        let slack = self.profile.slack(low.abs().max(high.abs()), self.u);
        let level = self.profile.level();
        let below = match level {
            Some(level) if self.has(Mistake::LevelsTruncated) => slack.max(level),
            Some(level) if self.has(Mistake::LevelsOf256) => slack.max(level),
            _ => slack,
        };
        let above = match level {
            Some(level) if self.has(Mistake::LevelsRoundedUp) => slack.max(level),
            _ => slack,
        };
        Some([low - below, high + above])
    }

    fn encoded(&self, linear: f64) -> f64 {
        let is_clamped = ![
            Mistake::EachLightClamped,
            Mistake::ClampForgotten,
            Mistake::LevelsOverflow,
            Mistake::EachLightEncoded,
        ]
        .into_iter()
        .any(|mistake| self.has(mistake));
        let clamp = |x: f64| match self.profile.range() {
            Some([low, high]) if is_clamped => x.clamp(low, high),
            None if self.has(Mistake::ClampedUnasked) => x.clamp(0.0, 1.0),
            _ => x,
        };
        let x = clamp(linear);
        let is_encoded = self.profile.srgb && !self.has(Mistake::SrgbForgotten);
        let is_encoded = is_encoded || self.has(Mistake::SrgbUnasked);
        let gamma = self.value_of(Mistake::GammaForSrgb);
        let x = match () {
            () if self.has(Mistake::EachLightEncoded) => x,
            () if self.has(Mistake::Gamma22ForSrgb) && self.profile.srgb => {
                x.max(0.0).powf(1.0 / 2.2)
            }
            () if self.has(Mistake::Gamma22Unasked) && !self.profile.srgb => {
                x.max(0.0).powf(1.0 / 2.2)
            }
            () if !self.profile.srgb && self.has(Mistake::GammaUnasked) => x
                .max(0.0)
                .powf(1.0 / self.value_of(Mistake::GammaUnasked).unwrap_or(1.0)),
            () if self.has(Mistake::SrgbDecoded) => from_srgb(x),
            () if is_encoded && self.has(Mistake::SrgbWithoutToe) => {
                (1.055 * x.max(0.0).powf(1.0 / 2.4) - 0.055).max(0.0)
            }
            () if is_encoded && gamma.is_some() => x.max(0.0).powf(1.0 / gamma.unwrap_or(1.0)),
            () if is_encoded && self.has(Mistake::SrgbTwice) => to_srgb(to_srgb(x)),
            () if is_encoded => to_srgb(x),
            () => x,
        };
        let x = if let Some(steps) = self.value_of(Mistake::ResultInSteps) {
            (x * steps).round() / steps
        } else if let Some(steps) = self.value_of(Mistake::ResultCut) {
            (x * steps).floor() / steps
        } else {
            x
        };
        let x = clamp(x);
        match self.profile.level() {
            Some(level) if self.has(Mistake::LevelsOverflow) && x > 1.0 => {
                let count = 1.0 / level;
                ((x * count).round() % (count + 1.0)) * level
            }
            Some(level) if self.has(Mistake::LevelsOf256) => (x * (1.0 + level)).min(1.0),
            Some(_) => match self.value_of(Mistake::FewerBits) {
                Some(bits) => {
                    let count = bits.exp2() - 1.0;
                    (x * count).round() / count
                }
                None => x,
            },
            None => x,
        }
    }
}
