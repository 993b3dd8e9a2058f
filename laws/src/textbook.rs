//! The formulas once more, as a shader spells them out, with every known mistake to choose from.
//!
//! `shading` gives the right color; this gives the bound on a renderer's error, and the colors of
//! mistakes. A test holds the two together.

use crate::bounded::{
    Bounded, Bounded3, add, dot, given3, length, multiply, scale, subtract, unit,
};
use crate::mistake::Mistake;
use crate::profile::Profile;
use crate::reply::to_srgb;
use crate::scene::{Light, Model, Scene};

/// The formulas with these mistakes in them.
#[derive(Clone, Copy)]
pub struct Textbook<'a> {
    pub profile: &'a Profile,
    pub mistakes: &'a [Mistake],
}

/// A light as it arrives at the point.
struct Arriving {
    l: Bounded3,
    intensity: Bounded3,
    attenuation: Bounded,
    /// The share that the cone lets through.
    cone: Bounded,
}

impl Textbook<'_> {
    fn has(&self, mistake: Mistake) -> bool {
        self.mistakes.contains(&mistake)
    }

    /// The color in linear light, before the range of the renderer.
    pub fn linear(&self, scene: &Scene) -> Bounded3 {
        let u = self.profile.roundoff;
        let given = |triple| given3(triple, u);
        let n = given(scene.n);
        let n = if self.has(Mistake::NormalNotNormalized) {
            n
        } else {
            unit(n)
        };
        let v = given(scene.v);
        let v = if self.has(Mistake::ViewNotNormalized) {
            v
        } else {
            unit(v)
        };
        let lights: Vec<Arriving> = scene
            .lights
            .iter()
            .map(|l| self.arriving(l, scene))
            .collect();

        let lit = match lights.len() {
            0 => 0..0,
            _ if self.has(Mistake::FirstLightOnly) => 0..1,
            count if self.has(Mistake::LastLightOnly) => count - 1..count,
            count => 0..count,
        };
        let clamp = self
            .profile
            .range()
            .filter(|_| self.has(Mistake::EachLightClamped));
        let mut sum = self.ambient(scene, &lights);
        for light in &lights[lit] {
            let mut lit = self.reflected(scene, light, n, v);
            if let Some([low, high]) = clamp {
                lit = lit.map(|c| c.if_positive(c, Bounded::exact(low)).at_most(high));
            }
            sum = add(sum, lit);
        }
        if self.has(Mistake::ChannelsSwapped) {
            sum.reverse();
        }
        sum
    }

    fn arriving(&self, light: &Light, scene: &Scene) -> Arriving {
        let u = self.profile.roundoff;
        let one = Bounded::exact(1.0);
        let mut intensity = given3(light.intensity(), u);
        if self.has(Mistake::LightInGray) {
            let mean = (intensity[0] + intensity[1] + intensity[2]) / Bounded::exact(3.0);
            intensity = [mean; 3];
        }
        let (position, coefficients) = match *light {
            Light::Directional { l, .. } => {
                let mut l = given3(l, u);
                if self.has(Mistake::LightReversed) {
                    l = l.map(|c| -c);
                }
                return Arriving {
                    l,
                    intensity,
                    attenuation: one,
                    cone: one,
                };
            }
            Light::Point {
                position,
                attenuation,
                ..
            }
            | Light::Spot {
                position,
                attenuation,
                ..
            } => (position, attenuation),
        };
        let mut way = subtract(given3(position, u), given3(scene.p, u));
        if self.has(Mistake::LightReversed) {
            way = way.map(|c| -c);
        }
        let q = length(way);
        let l = if self.has(Mistake::LightNotNormalized) {
            way
        } else {
            unit(way)
        };
        let mut coefficients = given3(coefficients, u);
        if self.has(Mistake::CoefficientsReversed) {
            coefficients.reverse();
        }
        let [a, b, c] = coefficients;
        let q = if self.has(Mistake::SquaredDistance) {
            q * q
        } else {
            q
        };
        let attenuation = if self.has(Mistake::NotAttenuated) {
            one
        } else {
            one / (a + b * q + c * (q * q))
        };
        let cone = match *light {
            Light::Spot {
                axis, half_angle, ..
            } if !self.has(Mistake::ConeForgotten) => {
                let mut against = -dot(given3(axis, u), l);
                if self.has(Mistake::ConeReversed) {
                    against = -against;
                }
                let angle = if self.has(Mistake::DegreesForRadians) {
                    half_angle.to_radians()
                } else if self.has(Mistake::HalfAngleHalved) {
                    half_angle / 2.0
                } else if self.has(Mistake::WholeAngleForHalf) {
                    half_angle * 2.0
                } else {
                    half_angle
                };
                // the edge itself is lit
                let outside = Bounded::given(angle, u).cos() - against;
                outside.if_positive(Bounded::ZERO, one)
            }
            _ => one,
        };
        Arriving {
            l,
            intensity,
            attenuation,
            cone,
        }
    }

    #[allow(clippy::cast_precision_loss)] // the count of lights
    fn ambient(&self, scene: &Scene, lights: &[Arriving]) -> Bounded3 {
        let u = self.profile.roundoff;
        let k_a = if self.has(Mistake::AmbientByDiffuse) {
            scene.material.k_d
        } else {
            scene.material.k_a
        };
        let ambient = multiply(given3(k_a, u), given3(scene.i_a, u));
        let factor = if self.has(Mistake::AmbientForgotten) {
            Bounded::ZERO
        } else if self.has(Mistake::AmbientPerLight) {
            Bounded::exact(lights.len() as f64)
        } else if self.has(Mistake::AmbientAttenuated) || self.profile.attenuated_ambient {
            let arriving = lights.iter().map(|light| light.attenuation);
            arriving.fold(Bounded::ZERO, |sum, light| sum + light)
        } else {
            Bounded::exact(1.0)
        };
        scale(ambient, factor)
    }

    fn reflected(&self, scene: &Scene, light: &Arriving, n: Bounded3, v: Bounded3) -> Bounded3 {
        let u = self.profile.roundoff;
        let (k_d, mut k_s) = (given3(scene.material.k_d, u), given3(scene.material.k_s, u));
        let cosine = dot(n, light.l);
        let arriving = scale(light.intensity, light.cone);

        let mut lambert = if self.has(Mistake::DiffuseNotClamped) {
            cosine
        } else if self.has(Mistake::DiffuseTwoSided) {
            cosine.abs()
        } else {
            cosine.at_least_zero()
        };
        if self.has(Mistake::DiffuseOverPi) {
            lambert = lambert / Bounded::exact(std::f64::consts::PI);
        }
        let diffuse = scale(multiply(k_d, arriving), lambert * light.attenuation);

        let mut factor = self.highlight(scene, light.l, n, v);
        let is_gated =
            !(self.has(Mistake::HighlightNotGated) || self.profile.highlight_on_the_dark_side);
        if is_gated {
            factor = cosine.if_positive(factor, Bounded::ZERO);
        }
        if self.has(Mistake::HighlightTimesCosine) {
            factor = factor * cosine.at_least_zero();
        }
        if self.has(Mistake::HighlightAttenuatedTwice) {
            factor = factor * light.attenuation;
        }
        let is_attenuated =
            !(self.has(Mistake::HighlightNotAttenuated) || self.profile.unattenuated_highlight);
        if is_attenuated {
            factor = factor * light.attenuation;
        }
        if self.has(Mistake::HighlightTimesDiffuse) {
            k_s = multiply(k_s, k_d);
        }
        let of_light = if self.has(Mistake::HighlightWithoutLight) {
            [light.cone; 3]
        } else {
            arriving
        };
        add(diffuse, scale(multiply(k_s, of_light), factor))
    }

    /// (R·V)^m or (N·H)^m.
    fn highlight(&self, scene: &Scene, l: Bounded3, n: Bounded3, v: Bounded3) -> Bounded {
        let is_phong = match scene.model {
            Model::Lambert => return Bounded::ZERO,
            Model::Phong => !self.has(Mistake::OtherModel),
            Model::BlinnPhong => self.has(Mistake::OtherModel),
        };
        let cosine = if is_phong {
            let twice = Bounded::exact(2.0) * dot(n, l);
            let r = subtract(scale(n, twice), l);
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
                // opposite directions have no half vector
                return Bounded::UNKNOWN;
            } else {
                dot(n, unit(sum))
            }
        };
        let m = scene.material.m;
        if !self.has(Mistake::PowerNotClamped) {
            cosine.at_least_zero().power(m)
        } else if cosine.value < cosine.error {
            Bounded::UNKNOWN // a shader's power of a negative number may be anything
        } else {
            cosine.power(m)
        }
    }

    /// The least and the largest reply that the renderer may give for each channel, where the
    /// formulas have an answer.
    pub fn reply(&self, scene: &Scene) -> [Option<[f64; 2]>; 3] {
        self.linear(scene).map(|c| {
            let ends = [c.value - c.error, c.value + c.error];
            let [low, high] = ends.map(|end| self.encoded(end));
            let slack = self.profile.reply_slack(low.abs().max(high.abs()));
            let below = match self.profile.level() {
                Some(level) if self.has(Mistake::LevelsTruncated) => slack.max(level),
                _ => slack,
            };
            c.error.is_finite().then_some([low - below, high + slack])
        })
    }

    fn encoded(&self, linear: f64) -> f64 {
        let is_clamped = !self.has(Mistake::EachLightClamped);
        let clamp = |x: f64| match self.profile.range() {
            Some([low, high]) if is_clamped => x.clamp(low, high),
            _ => x,
        };
        let x = clamp(linear);
        let is_encoded = self.profile.srgb && !self.has(Mistake::SrgbForgotten);
        let is_encoded = is_encoded || self.has(Mistake::SrgbUnasked);
        let x = match () {
            () if self.has(Mistake::Gamma22ForSrgb) => x.max(0.0).powf(1.0 / 2.2),
            () if is_encoded && self.has(Mistake::SrgbTwice) => to_srgb(to_srgb(x)),
            () if is_encoded => to_srgb(x),
            () => x,
        };
        clamp(x)
    }
}

#[cfg(test)]
mod tests {
    use proptest::strategy::{Strategy, ValueTree};
    use proptest::test_runner::TestRunner;

    use super::*;
    use crate::{generator, reference};

    /// `shading` and the textbook agree, and the bounds are tight: all but 5 % are below 10⁻¹²
    /// of the color in `f64`. The others are of faint highlights and of lights on an edge.
    #[test]
    fn the_textbook_gives_the_color_of_shading() {
        let precise = Profile {
            roundoff: f64::EPSILON / 2.0,
            ..Profile::default()
        };
        let of_its_own = Profile {
            attenuated_ambient: true,
            unattenuated_highlight: true,
            highlight_on_the_dark_side: true,
            ..precise.clone()
        };
        for profile in [precise, of_its_own] {
            let textbook = Textbook {
                profile: &profile,
                mistakes: &[],
            };
            let mut runner = TestRunner::deterministic();
            let strategy = generator::base(&profile);
            let mut loose = 0;
            for _ in 0..2000 {
                let scene = strategy
                    .new_tree(&mut runner)
                    .expect("a scene")
                    .current()
                    .scene;
                let (ours, other) = (textbook.linear(&scene), reference::color(&scene, &profile));
                for (bounded, right) in ours.into_iter().zip(other) {
                    let off = (bounded.value - right).abs();
                    assert!(
                        off <= bounded.error,
                        "{bounded:?} is not {right} in\n{scene}"
                    );
                    loose += u32::from(bounded.error > 1e-12 * right);
                }
            }
            assert!(loose < 300, "{loose} of 6000 bounds are loose");
        }
    }
}
