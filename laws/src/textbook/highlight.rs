//! The specular term.

use std::f64::consts::PI;

use crate::bounded::{Bounded, Bounded3, add, dot, multiply, scale, subtract, unit};
use crate::mistake::Mistake;
use crate::scene::Model;

use super::Textbook;
use super::light::{Arriving, Kind};
use super::surface::Surface;

impl Textbook<'_> {
    pub(super) fn shiny(&self, light: &Arriving, n: Bounded3, surface: &Surface) -> Bounded3 {
        let v = surface.v;
        let cosine = dot(n, light.l);
        let of_n = if self.has(Mistake::NormalNotNormalizedInHighlight) {
            surface.raw_n
        } else {
            n
        };
        let of_l = if self.has(Mistake::LightNotNormalizedInHighlight) {
            light.way
        } else {
            light.l
        };
        let mut factor = self.highlight(of_l, of_n, surface);
        factor = self.left_in(factor, light, n, v);
        let of_kind = match light.kind {
            Kind::Sun => Mistake::HighlightNotGatedOfSuns,
            Kind::Point => Mistake::HighlightNotGatedOfPoints,
            Kind::Spot => Mistake::HighlightNotGatedOfSpots,
        };
        let is_gated = !(self.has(Mistake::HighlightNotGated)
            || self.has(of_kind)
            || self.has(Mistake::LightClampedBelow)
            || self.profile.highlight_on_the_dark_side);
        if is_gated {
            factor = cosine.if_positive(factor, Bounded::ZERO);
        }
        if self.has(Mistake::HighlightGatedOnEye) {
            factor = dot(n, v).if_positive(factor, Bounded::ZERO);
        }
        if self.has(Mistake::HighlightTimesCosine) {
            factor = factor * cosine.at_least_zero();
        } else if self.has(Mistake::HighlightOverCosine) {
            factor = cosine.if_positive(factor / cosine, Bounded::ZERO);
        } else if self.has(Mistake::HighlightOverPi) {
            factor = factor / Bounded::given(PI, self.u);
        } else if let Some(times) = self.value_of(Mistake::HighlightScaled) {
            factor = factor * Bounded::given(times, self.u);
        }
        if self.has(Mistake::HighlightAttenuatedTwice) {
            factor = factor * light.attenuation;
        }
        let is_attenuated =
            !(self.has(Mistake::HighlightNotAttenuated) || self.profile.unattenuated_highlight);
        if is_attenuated {
            factor = factor * light.attenuation;
        }
        let of_light = match () {
            () if self.has(Mistake::HighlightWithoutLight) => [light.cone; 3],
            () if self.has(Mistake::ConeNotOfHighlight) => light.intensity,
            () => scale(light.intensity, light.cone),
        };
        let k = self.specular(light.l, n, surface);
        scale(multiply(k, of_light), factor)
    }

    /// What the surface reflects in its highlight.
    pub(super) fn specular(&self, l: Bounded3, n: Bounded3, surface: &Surface) -> Bounded3 {
        let one = Bounded::exact(1.0);
        let Surface { v, k_d, k_s, .. } = *surface;
        let fresnel = if self.has(Mistake::Fresnel) {
            Some(dot(v, unit(add(l, v))))
        } else {
            let of_eye = self.has(Mistake::FresnelOfEye);
            of_eye.then(|| dot(n, v).at_least_zero())
        };
        match fresnel {
            Some(cosine) => {
                let grazing = (one - cosine.at_most(1.0)).at_least_zero().power(5.0);
                k_s.map(|c| c + (one - c) * grazing)
            }
            None if self.has(Mistake::HighlightTimesDiffuse) => multiply(k_s, k_d),
            None if self.has(Mistake::HighlightWithoutMaterial) => [one; 3],
            None if self.has(Mistake::HighlightByDiffuse) => k_d,
            None if self.has(Mistake::HighlightForgotten) => [Bounded::ZERO; 3],
            None if self.has(Mistake::HighlightInGray) => {
                [(k_s[0] + k_s[1] + k_s[2]) / Bounded::exact(3.0); 3]
            }
            None => k_s,
        }
    }

    /// (R·V)^m or (N·H)^m.
    pub(super) fn highlight(&self, l: Bounded3, n: Bounded3, surface: &Surface) -> Bounded {
        let Surface { v, m, model, .. } = *surface;
        let cosine = if model == Model::Phong {
            let times = if self.has(Mistake::ReflectionWithoutTwo) {
                1.0
            } else {
                2.0
            };
            let r = subtract(scale(n, Bounded::exact(times) * dot(n, l)), l);
            let cosine = dot(r, v);
            if self.has(Mistake::ReflectionReversed) {
                -cosine
            } else {
                cosine
            }
        } else {
            let sum = add(l, v);
            if self.has(Mistake::HalfVectorNotNormalized) {
                dot(n, sum)
            } else if self.has(Mistake::HalfVectorHalved) {
                dot(n, scale(sum, Bounded::exact(0.5)))
            } else if sum.iter().all(|c| c.value == 0.0) {
                // opposite directions have no half vector; where nothing rounds, any that a renderer takes has a power
                // from 0 to 1
                let is_exact = l.iter().all(|c| c.value.fract() == 0.0);
                return if is_exact {
                    Bounded::between(0.0, 1.0, self.u)
                } else {
                    Bounded::UNKNOWN
                };
            } else {
                dot(n, self.unit(sum))
            }
        };
        let is_whole = m.fract() == 0.0;
        let factor = if self.has(Mistake::CosineOfHighlightAbsolute) {
            cosine.abs().power(m)
        } else if self.has(Mistake::PowerOfSchlick) {
            let (c, m) = (cosine.at_least_zero(), Bounded::given(m, self.u));
            c / (m - m * c + c)
        } else if let Some(least) = self.value_of(Mistake::CosineOfHighlightAtLeast) {
            cosine.at_least_zero().at_least(least).power(m)
        } else if !self.has(Mistake::PowerNotClamped) {
            cosine.at_least_zero().power(m)
        } else if cosine.value < cosine.error && !is_whole {
            return Bounded::UNKNOWN; // a shader's power of a negative number may be anything
        } else if cosine.value < 0.0 && m % 2.0 == 1.0 {
            -cosine.abs().power(m)
        } else {
            cosine.abs().power(m)
        };
        match self.normalization(m) {
            Some(times) => factor * Bounded::computed(times, 16.0, self.u),
            None => factor,
        }
    }

    pub(super) fn normalization(&self, m: f64) -> Option<f64> {
        Some(if self.has(Mistake::NormalizedByEight) {
            (m + 8.0) / (8.0 * PI)
        } else if self.has(Mistake::NormalizedByTwo) {
            (m + 2.0) / (2.0 * PI)
        } else if self.has(Mistake::NormalizedByOne) {
            (m + 1.0) / (2.0 * PI)
        } else if self.has(Mistake::NormalizedByTwoOfEight) {
            (m + 2.0) / (8.0 * PI)
        } else if self.has(Mistake::NormalizedExactly) {
            (m + 2.0) * (m + 4.0) / (8.0 * PI * ((-m / 2.0).exp2() + m))
        } else {
            return None;
        })
    }
}
