//! The formulas once more, as a shader spells them out, with every known mistake to choose from.
//!
//! `shading` gives the right color; this gives the bound on a renderer's error, and the colors of
//! mistakes. A test holds the two together.

mod given;
mod highlight;
mod light;
mod reply;
mod surface;
mod term;

use std::array::from_fn;

use crate::bounded::{Bounded, Bounded3, add, dot, scale};
use crate::mistake::{Fault, Mistake};
use crate::profile::Profile;
use crate::random::Random;
use crate::reply::to_srgb;
use crate::scene::{Scene, Triple};

use light::Arriving;

/// The formulas with these mistakes in them.
#[derive(Clone, Copy)]
pub struct Textbook<'a> {
    profile: &'a Profile,
    faults: &'a [Fault],
    /// The unit roundoff.
    u: f64,
}
impl<'a> Textbook<'a> {
    pub fn new(profile: &'a Profile, faults: &'a [Fault]) -> Self {
        let imprecise = faults.iter().find(|fault| fault.mistake.is_rough());
        let u = imprecise.map_or(profile.roundoff, |fault| (-fault.value).exp2());
        Self { profile, faults, u }
    }

    fn has(&self, mistake: Mistake) -> bool {
        self.faults.iter().any(|fault| fault.mistake == mistake)
    }

    /// The number in a mistake, if it is made.
    fn value_of(&self, mistake: Mistake) -> Option<f64> {
        let fault = self.faults.iter().find(|fault| fault.mistake == mistake)?;
        Some(fault.value)
    }

    /// The color in linear light, before the range of the renderer.
    pub fn linear(&self, scene: &Scene) -> Bounded3 {
        let surface = self.surface(scene);
        let mut lights: Vec<Arriving> = scene
            .lights
            .iter()
            .map(|light| self.arriving(light, scene))
            .collect();
        let ambient = self.ambient(scene, &surface, &lights);
        match self.value_of(Mistake::LightsAtMost) {
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a small count
            Some(most) => lights.truncate(most as usize),
            None if self.has(Mistake::FirstLightOnly) => lights.truncate(1),
            None if self.has(Mistake::LastLightOnly) => {
                lights.drain(..lights.len().saturating_sub(1));
            }
            None if self.has(Mistake::FirstLightForgotten) => {
                lights.drain(..lights.len().min(1));
            }
            None if self.has(Mistake::LastLightForgotten) => drop(lights.pop()),
            None => {}
        }

        let black = [Bounded::ZERO; 3];
        let (mut diffuse, mut specular) = (black, black);
        for (i, light) in lights.iter().enumerate() {
            let [mut matte, mut shiny] = self.reflected(light, &surface);
            if self.has(Mistake::HighlightOfFirstLightOnly) && i > 0 {
                shiny = black;
            }
            let whole = |f: &dyn Fn(Bounded) -> Bounded| add(matte, shiny).map(f);
            if self.has(Mistake::LightClampedBelow) {
                (matte, shiny) = (whole(&Bounded::at_least_zero), black);
            } else if self.has(Mistake::EachLightClamped) {
                (matte, shiny) = (whole(&|c| self.clamped(c)), black);
            } else if self.has(Mistake::EachLightEncoded) {
                (matte, shiny) = (whole(&|c| c.map(to_srgb)), black);
            } else if self.has(Mistake::BrightestLightOnly) {
                matte = max(add(diffuse, specular), add(matte, shiny));
                (shiny, diffuse, specular) = (black, black, black);
            }
            diffuse = add(diffuse, matte);
            specular = add(specular, shiny);
        }
        if self.has(Mistake::LightsAveraged) && !lights.is_empty() {
            #[allow(clippy::cast_precision_loss)] // the count of lights
            let count = Bounded::exact(lights.len() as f64);
            [diffuse, specular] = [diffuse, specular].map(|sum| sum.map(|c| c / count));
        }
        self.whole(ambient, diffuse, specular)
    }

    /// The sum of the terms, and what a mistake makes of it.
    fn whole(&self, ambient: Bounded3, mut diffuse: Bounded3, mut specular: Bounded3) -> Bounded3 {
        let clamped = |color: Bounded3| color.map(|c| self.clamped(c));
        if self.has(Mistake::TermsClamped) {
            (diffuse, specular) = (clamped(diffuse), clamped(specular));
        }
        let mut sum = add(ambient, diffuse);
        if self.has(Mistake::DiffuseClamped) {
            sum = clamped(sum);
        }
        sum = add(sum, specular);
        if self.has(Mistake::AmbientAtLeast) {
            sum = max(ambient, add(diffuse, specular));
        }
        if self.has(Mistake::EachLightEncoded) {
            sum = add(ambient.map(|c| c.map(to_srgb)), diffuse);
        }
        if self.has(Mistake::TotalClampedBelow) {
            sum = sum.map(Bounded::at_least_zero);
        }
        let [r, g, b] = sum;
        if self.has(Mistake::ChannelsSwapped) {
            sum = [b, g, r];
        } else if self.has(Mistake::RedAndGreenSwapped) {
            sum = [g, r, b];
        } else if self.has(Mistake::GreenAndBlueSwapped) {
            sum = [r, b, g];
        } else if let Some(places) = self.value_of(Mistake::ChannelsShifted) {
            sum = if places > 1.0 { [g, b, r] } else { [b, r, g] };
        } else if self.has(Mistake::Gray) {
            sum = [(r + g + b) / Bounded::exact(3.0); 3];
        } else if self.has(Mistake::Luminance) {
            let weights = [0.2126, 0.7152, 0.0722].map(|w| Bounded::given(w, self.u));
            sum = [dot(sum, weights); 3];
        } else if let Some(factor) = self.value_of(Mistake::Scaled) {
            sum = scale(sum, Bounded::given(factor, self.u));
        } else if self.has(Mistake::Black) {
            sum = [Bounded::ZERO; 3];
        } else if self.has(Mistake::Reinhard) {
            sum = sum.map(|c| c / (Bounded::exact(1.0) + c));
        } else if self.has(Mistake::ExponentialTone) {
            sum = sum.map(|c| c.map(|x| 1.0 - (-x).exp()).looser(4.0 * self.u));
        }
        sum
    }

    /// A color in the range of the renderer, or in that from 0 to 1.
    fn clamped(&self, c: Bounded) -> Bounded {
        let [low, high] = self.profile.range().unwrap_or([0.0, 1.0]);
        c.if_positive(c, Bounded::exact(low)).at_most(high)
    }
}

fn max(a: Bounded3, b: Bounded3) -> Bounded3 {
    from_fn(|i| a[i].max(b[i]))
}

/// For the tests of this package: a scene, its color by the textbook with the bound on its error, and that by `shading`.
#[doc(hidden)]
#[must_use]
pub fn compared(profile: &Profile, seed: u64) -> (Scene, [[f64; 2]; 3], Triple) {
    let scene = crate::generator::base(profile, &mut Random::new(seed, "textbook")).scene;
    let ours = Textbook::new(profile, &[]).linear(&scene);
    let right = crate::reference::color(&scene, profile);
    (scene, ours.map(|c| [c.value, c.error]), right)
}
