//! The ambient and the diffuse term.

use std::f64::consts::PI;

use crate::bounded::{Bounded, Bounded3, add, dot, multiply, scale};
use crate::mistake::Mistake;
use crate::scene::{Model, Scene};

use super::Textbook;
use super::given::Part;
use super::light::Arriving;
use super::surface::{Surface, toward};

impl Textbook<'_> {
    #[allow(clippy::cast_precision_loss)] // the count of lights
    pub(super) fn ambient(
        &self,
        scene: &Scene,
        surface: &Surface,
        lights: &[Arriving],
    ) -> Bounded3 {
        let (k_a, k_d) = (
            self.reflectance(scene.material.k_a, Part::Ambient),
            surface.k_d,
        );
        let i_a = self.color(scene.i_a, Part::AmbientLight);
        let (one, count) = (Bounded::exact(1.0), Bounded::exact(lights.len() as f64));
        let sum = |share: &dyn Fn(&Arriving) -> Bounded| {
            let shares = lights.iter().map(share);
            shares.fold(Bounded::ZERO, |sum, share| sum + share)
        };
        let in_front = || sum(&|light| dot(surface.n, light.l).if_positive(one, Bounded::ZERO));
        let mut ambient = match () {
            () if self.has(Mistake::AmbientByDiffuse) => multiply(k_d, i_a),
            () if self.has(Mistake::AmbientWithoutMaterial) => i_a,
            () if self.has(Mistake::AmbientWithoutLight) => k_a,
            () => multiply(k_a, i_a),
        };
        if self.has(Mistake::AmbientTimesDiffuse) || self.profile.ambient_times_diffuse {
            ambient = multiply(ambient, k_d);
        }
        let is_black = self.has(Mistake::BlackWithoutLights) || self.profile.black_without_lights;
        let factor = if self.has(Mistake::AmbientForgotten) || is_black && lights.is_empty() {
            Bounded::ZERO
        } else if self.has(Mistake::AmbientPerLight) {
            count
        } else if self.has(Mistake::AmbientPerLightToo) {
            one + count
        } else if self.has(Mistake::AmbientPerLightInFront) {
            in_front()
        } else if self.has(Mistake::AmbientPerLightInFrontToo) {
            one + in_front()
        } else if self.has(Mistake::AmbientArriving) {
            sum(&|light| light.attenuation * light.cone)
        } else if self.has(Mistake::AmbientAttenuated) || self.profile.attenuated_ambient {
            sum(&|light| light.attenuation)
        } else if self.has(Mistake::AmbientTwice) {
            Bounded::exact(2.0)
        } else {
            one
        };
        let is_unlit = self.has(Mistake::UnlitWithoutLights) || self.profile.unlit_without_lights;
        let unlit = if is_unlit && lights.is_empty() {
            k_d
        } else {
            [Bounded::ZERO; 3]
        };
        add(scale(ambient, factor), unlit)
    }

    /// Diffuse and specular light.
    pub(super) fn reflected(&self, light: &Arriving, surface: &Surface) -> [Bounded3; 2] {
        let n = if self.has(Mistake::NormalTowardLight) {
            toward(light.l, surface.n)
        } else {
            surface.n
        };
        let mut shiny = [Bounded::ZERO; 3];
        if surface.model != Model::Lambert {
            shiny = self.shiny(light, n, surface);
        }
        [self.matte(light, n, surface), shiny]
    }

    /// The factor of a term, and 0 where a mistake leaves the whole light out.
    pub(super) fn left_in(
        &self,
        factor: Bounded,
        light: &Arriving,
        n: Bounded3,
        v: Bounded3,
    ) -> Bounded {
        if let Some(least) = self.value_of(Mistake::CosineCutBelow) {
            let above = dot(n, light.l) - Bounded::given(least, self.u);
            above.if_positive(factor, Bounded::ZERO)
        } else if self.has(Mistake::LitFromEyeOnly) {
            dot(n, v).if_positive(factor, Bounded::ZERO)
        } else {
            factor
        }
    }

    pub(super) fn matte(&self, light: &Arriving, n: Bounded3, surface: &Surface) -> Bounded3 {
        let one = Bounded::exact(1.0);
        let Surface { v, k_d, k_s, .. } = *surface;
        let cosine = dot(n, light.l);
        let of_diffuse = if self.has(Mistake::NormalNotNormalizedInDiffuse) {
            dot(surface.raw_n, light.l)
        } else if self.has(Mistake::LightNotNormalizedInDiffuse) {
            dot(n, light.way)
        } else {
            cosine
        };

        let is_signed = [
            Mistake::DiffuseNotClamped,
            Mistake::LightClampedBelow,
            Mistake::TotalClampedBelow,
        ]
        .into_iter()
        .any(|mistake| self.has(mistake));
        let half = || (cosine + one) / Bounded::exact(2.0);
        let mut lambert = match self.value_of(Mistake::Wrapped) {
            Some(wrap) => {
                let wrap = Bounded::given(wrap, self.u);
                ((cosine + wrap) / (one + wrap)).at_least_zero()
            }
            None if is_signed => cosine,
            None if self.has(Mistake::DiffuseTwoSided) => cosine.abs(),
            None if self.has(Mistake::HalfLambert) => half(),
            None if self.has(Mistake::HalfLambertSquared) => half() * half(),
            None if self.has(Mistake::CosineForgotten) => cosine.if_positive(one, Bounded::ZERO),
            None => of_diffuse.at_least_zero(),
        };
        if self.has(Mistake::DiffuseOverPi) {
            lambert = lambert / Bounded::given(PI, self.u);
        } else if self.has(Mistake::DiffuseTimesPi) {
            lambert = lambert * Bounded::given(PI, self.u);
        } else if self.has(Mistake::CosineSquared) {
            lambert = lambert * lambert;
        } else if self.has(Mistake::DiffuseForgotten) {
            lambert = Bounded::ZERO;
        }
        if !self.has(Mistake::DiffuseNotAttenuated) {
            lambert = lambert * light.attenuation;
        }
        let of_light = match () {
            () if self.has(Mistake::DiffuseWithoutLight) => [light.cone; 3],
            () if self.has(Mistake::ConeNotOfDiffuse) => light.intensity,
            () => scale(light.intensity, light.cone),
        };
        let k = if self.has(Mistake::DiffuseMinusSpecular) {
            multiply(k_d, k_s.map(|c| one - c))
        } else if self.has(Mistake::DiffuseMinusLargest) {
            scale(k_d, one - k_s[0].max(k_s[1]).max(k_s[2]))
        } else {
            k_d
        };
        scale(multiply(k, of_light), self.left_in(lambert, light, n, v))
    }
}
