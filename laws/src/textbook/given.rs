//! What a scene gives: colors, positions and directions, as a renderer stores them.

use crate::bounded::{Bounded, Bounded3, dot, given3, length, rounded, scale, unit};
use crate::mistake::Mistake;
use crate::scene::Triple;

use super::Textbook;

/// A color that is given.
#[derive(Clone, Copy, PartialEq)]
pub enum Part {
    Light,
    AmbientLight,
    Ambient,
    Diffuse,
    Specular,
}

impl Textbook<'_> {
    pub(super) fn given(&self, triple: Triple) -> Bounded3 {
        given3(triple, self.u)
    }

    /// A color that is given, as it is stored.
    pub(super) fn color(&self, triple: Triple, part: Part) -> Bounded3 {
        #[allow(clippy::enum_glob_use)] // twenty of them
        use Mistake::*;
        let mut triple = triple;
        for fault in self.faults {
            let is_stored_so = match fault.mistake {
                ColorsInSteps | ColorsCut | ColorsInHalf | ColorsInBfloat => true,
                LightsInSteps | LightsCut | LightsInHalf | LightsInBfloat => part == Part::Light,
                ReflectancesInSteps | ReflectancesCut | ReflectancesInHalf
                | ReflectancesInBfloat => {
                    matches!(part, Part::Ambient | Part::Diffuse | Part::Specular)
                }
                DiffuseInSteps | DiffuseCut | DiffuseInHalf | DiffuseInBfloat => {
                    part == Part::Diffuse
                }
                SpecularInSteps | SpecularCut | SpecularInHalf | SpecularInBfloat => {
                    part == Part::Specular
                }
                _ => false,
            };
            let steps = fault.value;
            triple = triple.map(|c| match fault.mistake {
                _ if !is_stored_so => c,
                ColorsInHalf | LightsInHalf | ReflectancesInHalf | DiffuseInHalf
                | SpecularInHalf => half(c),
                ColorsInBfloat | LightsInBfloat | ReflectancesInBfloat | DiffuseInBfloat
                | SpecularInBfloat => rounded(c, (-8_f64).exp2()),
                ColorsCut | LightsCut | ReflectancesCut | DiffuseCut | SpecularCut => {
                    (c * steps).floor() / steps
                }
                _ => (c * steps).round() / steps,
            });
        }
        self.given(triple)
    }

    /// A position that is given, as it is stored.
    pub(super) fn position(&self, triple: Triple) -> Bounded3 {
        self.given(if self.has(Mistake::PositionsInHalf) {
            triple.map(half)
        } else {
            triple
        })
    }

    /// A vector at length 1.
    pub(super) fn unit(&self, a: Bounded3) -> Bounded3 {
        let beside_lamps = self.value_of(Mistake::FastInverseRootBesideLamps);
        if let Some(steps) = beside_lamps.or(self.value_of(Mistake::FastInverseRoot)) {
            return scale(a, self.fast_inverse_root(dot(a, a), steps));
        }
        if let Some(more) = self.value_of(Mistake::LengthPlus) {
            let length = length(a) + Bounded::given(more, self.u);
            return a.map(|c| c / length);
        }
        if let Some(least) = self.value_of(Mistake::LengthAtLeast) {
            let length = length(a).at_least(least);
            return a.map(|c| c / length);
        }
        unit(a)
    }

    /// 1/√x as *Quake III Arena* computes it, with some steps of Newton's method.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // in the precision of the renderer
    pub(super) fn fast_inverse_root(&self, x: Bounded, steps: f64) -> Bounded {
        let guess = if self.u > f64::EPSILON {
            let bits = 0x5f37_59df_u32.wrapping_sub((x.value as f32).to_bits() >> 1);
            f64::from(f32::from_bits(bits))
        } else {
            f64::from_bits(0x5fe6_eb50_c7b5_37a9_u64.wrapping_sub(x.value.to_bits() >> 1))
        };
        let step = |y: f64, _| y * (1.5 - 0.5 * x.value * y * y);
        let root = (0..steps as u32).fold(guess, step);
        // the error of x moves the root by half of it
        let off = root * x.error / x.value;
        Bounded::computed(root, 16.0, self.u).looser(off)
    }
}

/// With 11 bits, as a number of half precision has.
pub fn half(x: f64) -> f64 {
    rounded(x, (-11_f64).exp2())
}
