//! The formulas once more, as a shader spells them out, with every known mistake to choose from.
//!
//! `shading` gives the right color; this gives the bound on a renderer's error, and the colors of
//! mistakes. A test holds the two together.

use std::array::from_fn;
use std::f64::consts::PI;

use crate::bounded::{
    Bounded, Bounded3, add, dot, given3, length, multiply, rounded, scale, subtract, unit,
};
use crate::mistake::{Fault, Mistake};
use crate::profile::Profile;
use crate::random::Random;
use crate::reply::{from_srgb, to_srgb};
use crate::scene::{Light, Material, Model, Scene, Triple};

/// The formulas with these mistakes in them.
#[derive(Clone, Copy)]
pub struct Textbook<'a> {
    profile: &'a Profile,
    faults: &'a [Fault],
    /// The unit roundoff.
    u: f64,
}

/// A light as it arrives at the point.
struct Arriving {
    l: Bounded3,
    /// L before it is normalized.
    way: Bounded3,
    kind: Kind,
    intensity: Bounded3,
    attenuation: Bounded,
    /// The share that the cone lets through.
    cone: Bounded,
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Sun,
    Point,
    Spot,
}

/// A color that is given.
#[derive(Clone, Copy, PartialEq)]
enum Part {
    Light,
    AmbientLight,
    Ambient,
    Diffuse,
    Specular,
}

/// What a scene is shaded with.
struct Surface {
    n: Bounded3,
    /// N before it is normalized.
    raw_n: Bounded3,
    v: Bounded3,
    k_d: Bounded3,
    k_s: Bounded3,
    model: Model,
    m: f64,
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

    fn given(&self, triple: Triple) -> Bounded3 {
        given3(triple, self.u)
    }

    /// A color that is given, as it is stored.
    fn color(&self, triple: Triple, part: Part) -> Bounded3 {
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
    fn position(&self, triple: Triple) -> Bounded3 {
        self.given(if self.has(Mistake::PositionsInHalf) {
            triple.map(half)
        } else {
            triple
        })
    }

    /// A vector at length 1.
    fn unit(&self, a: Bounded3) -> Bounded3 {
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
    fn fast_inverse_root(&self, x: Bounded, steps: f64) -> Bounded {
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

    fn surface(&self, scene: &Scene) -> Surface {
        let mut raw_n = self.given(scene.n);
        let mut n = raw_n;
        if !self.has(Mistake::NormalNotNormalized) {
            n = self.unit(n);
        }
        if let Some(steps) = self.value_of(Mistake::NormalInSteps) {
            n = n.map(|c| c.map(|c| (c * steps).round() / steps));
        } else if let Some(steps) = self.value_of(Mistake::NormalInStepsUnit) {
            n = unit(n.map(|c| c.map(|c| (c * steps).round() / steps)));
        }
        let (p, mut v) = (self.position(scene.p), self.given(scene.v));
        if self.has(Mistake::EyeAtOrigin) {
            v = p.map(|c| -c);
        } else if self.has(Mistake::ViewTakenForEye) {
            v = subtract(v, p);
        } else if self.has(Mistake::ViewAlongZ) {
            v = [0.0, 0.0, 1.0].map(Bounded::exact);
        }
        let keeps_length = self.has(Mistake::ViewNotNormalized)
            || self.has(Mistake::ViewNotNormalizedOfPhong) && scene.model == Model::Phong
            || self.has(Mistake::ViewNotNormalizedOfBlinn) && scene.model == Model::BlinnPhong;
        if !keeps_length {
            v = self.unit(v);
        }
        if self.has(Mistake::ViewReversed) {
            v = v.map(|c| -c);
        }
        if self.has(Mistake::NormalReversed) {
            n = n.map(|c| -c);
        }
        if self.has(Mistake::NormalTowardEye) || self.profile.normal_faces_eye {
            (n, raw_n) = (toward(v, n), toward(v, raw_n));
        }
        let material = &scene.material;
        let model = match scene.model {
            Model::Lambert if self.has(Mistake::HighlightOnLambert) => Model::BlinnPhong,
            Model::Phong if self.has(Mistake::OtherModel) => Model::BlinnPhong,
            Model::BlinnPhong if self.has(Mistake::OtherModel) => Model::Phong,
            model => model,
        };
        Surface {
            n,
            raw_n,
            v,
            k_d: self.reflectance(material.k_d, Part::Diffuse),
            k_s: self.reflectance(material.k_s, Part::Specular),
            model,
            m: self.shininess(material.m, model),
        }
    }

    fn reflectance(&self, k: Triple, part: Part) -> Bounded3 {
        let k = self.color(k, part);
        let (is_diffuse, is_specular) = (part == Part::Diffuse, part == Part::Specular);
        if self.has(Mistake::MaterialDecoded)
            || self.has(Mistake::DiffuseDecoded) && is_diffuse
            || self.has(Mistake::SpecularDecoded) && is_specular
        {
            k.map(|c| c.map(from_srgb))
        } else if self.has(Mistake::MaterialGamma22)
            || self.has(Mistake::DiffuseGamma22) && is_diffuse
            || self.has(Mistake::SpecularGamma22) && is_specular
        {
            k.map(|c| c.power(2.2))
        } else {
            k
        }
    }

    fn shininess(&self, m: f64, model: Model) -> f64 {
        let value_of = |mistake| self.value_of(mistake);
        if self.has(Mistake::ShininessTruncated) {
            m.floor()
        } else if self.has(Mistake::ShininessRounded) {
            m.round()
        } else if let Some(off) = value_of(Mistake::ShininessOff) {
            (m + off).max(0.0)
        } else if let Some(factor) = value_of(Mistake::ShininessTimes) {
            m * factor
        } else if let Some(factor) = value_of(Mistake::ShininessOfBlinnTimes) {
            let is_blinn = model == Model::BlinnPhong;
            if is_blinn { m * factor } else { m }
        } else if let Some(least) = value_of(Mistake::ShininessAtLeast) {
            m.max(least)
        } else if self.has(Mistake::ShininessToPowerOfTwo) {
            m.log2().floor().exp2()
        } else if let Some(most) = value_of(Mistake::ShininessAtMost) {
            m.min(most)
        } else {
            m
        }
    }

    /// What a light shines.
    fn intensity(&self, light: &Light) -> Bounded3 {
        let mut intensity = self.color(light.intensity(), Part::Light);
        if self.has(Mistake::LightInGray) {
            let mean = (intensity[0] + intensity[1] + intensity[2]) / Bounded::exact(3.0);
            intensity = [mean; 3];
        } else if self.has(Mistake::LightInRed) {
            intensity = [intensity[0]; 3];
        } else if self.has(Mistake::LightDecoded) {
            intensity = intensity.map(|c| c.map(from_srgb));
        } else if self.has(Mistake::LightClamped) {
            intensity = intensity.map(|c| c.at_most(1.0));
        } else if let Some(factor) = self.value_of(Mistake::LightScaled) {
            intensity = scale(intensity, Bounded::given(factor, self.u));
        }
        let left_out = match light {
            Light::Directional { .. } => Mistake::SunsForgotten,
            Light::Point { .. } => Mistake::PointsForgotten,
            Light::Spot { .. } => Mistake::SpotsForgotten,
        };
        if self.has(left_out) {
            intensity = [Bounded::ZERO; 3];
        }
        intensity
    }

    fn arriving(&self, light: &Light, scene: &Scene) -> Arriving {
        let one = Bounded::exact(1.0);
        let mut intensity = self.intensity(light);
        let (position, coefficients) = match *light {
            Light::Directional { l, .. } => {
                let mut l = self.given(l);
                if self.has(Mistake::LightReversed) || self.has(Mistake::SunReversed) {
                    l = l.map(|c| -c);
                } else if self.has(Mistake::SunTakenForPosition) {
                    l = unit(subtract(l, self.given(scene.p)));
                }
                if self.has(Mistake::ArrivingClamped) {
                    intensity = intensity.map(|c| c.at_most(1.0));
                }
                return Arriving {
                    l,
                    way: l,
                    kind: Kind::Sun,
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
        let mut way = self.way(position, scene);
        let mut q = length(if self.has(Mistake::DistanceFromOrigin) {
            self.given(position)
        } else {
            way
        });
        if self.has(Mistake::ExpandedSquares) {
            let (a, b) = (self.given(position), self.given(scene.p));
            let twice = Bounded::exact(2.0) * dot(a, b);
            q = (dot(a, a) - twice + dot(b, b)).at_least_zero().sqrt();
        }
        if self.has(Mistake::LightReversed) || self.has(Mistake::LampReversed) {
            way = way.map(|c| -c);
        }
        let l = if self.has(Mistake::LightNotNormalized) {
            way
        } else if let Some(least) = self.value_of(Mistake::LampDistanceAtLeast) {
            q = q.at_least(least);
            way.map(|c| c / q)
        } else if self.has(Mistake::ExpandedSquares) {
            // the renderer may have taken the right length here
            way.map(|c| c / q)
        } else if self.has(Mistake::FastInverseRootBesideLamps) {
            unit(way)
        } else {
            // the renderer may divide by the distance, which it needs in any case
            let (l, other) = (self.unit(way), unit(way));
            let more = |i: usize| (l[i].value - other[i].value).abs();
            if self.has(Mistake::LengthPlus) || self.has(Mistake::LengthAtLeast) {
                from_fn(|i| l[i].looser(more(i)))
            } else {
                l
            }
        };
        let kind = match light {
            Light::Spot { .. } => Kind::Spot,
            _ => Kind::Point,
        };
        let is_unattenuated = match kind {
            Kind::Spot => self.has(Mistake::SpotsNotAttenuated),
            _ => self.has(Mistake::PointsNotAttenuated),
        };
        let mut attenuation = if is_unattenuated {
            one
        } else {
            self.attenuation(coefficients, q)
        };
        if self.has(Mistake::ArrivingClamped) {
            intensity = scale(intensity, attenuation).map(|c| c.at_most(1.0));
            attenuation = one;
        }
        Arriving {
            l,
            way,
            kind,
            intensity,
            attenuation,
            cone: self.cone(light, l, way),
        }
    }

    /// From the point to the lamp. The renderer may take both to another frame first, such as that of
    /// the eye, and round them there.
    fn way(&self, position: Triple, scene: &Scene) -> Bounded3 {
        let ends = (self.position(position), self.position(scene.p));
        if self.has(Mistake::PointForgotten) {
            return ends.0;
        }
        let size = |triple: Triple| triple.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
        let farthest = size(position) + size(scene.p) + size(scene.v);
        subtract(ends.0, ends.1).map(|c| c.looser(self.u * farthest))
    }

    fn attenuation(&self, coefficients: Triple, q: Bounded) -> Bounded {
        let (one, value_of) = (Bounded::exact(1.0), |mistake| self.value_of(mistake));
        let mut coefficients = self.given(coefficients);
        if self.has(Mistake::CoefficientsReversed) {
            coefficients.reverse();
        } else if self.has(Mistake::LinearForQuadratic) {
            coefficients.swap(1, 2);
        } else if self.has(Mistake::ConstantForgotten) {
            coefficients[0] = Bounded::ZERO;
        } else if self.has(Mistake::LinearForgotten) {
            coefficients[1] = Bounded::ZERO;
        } else if self.has(Mistake::QuadraticForgotten) {
            coefficients[2] = Bounded::ZERO;
        } else if self.has(Mistake::ConstantOne)
            || self.has(Mistake::ZeroConstantOne) && coefficients[0].value == 0.0
        {
            coefficients[0] = one;
        }
        let [a, b, c] = coefficients;
        let mut q = q;
        if self.has(Mistake::SquaredDistance) {
            q = q * q;
        } else if let Some(least) = value_of(Mistake::DistanceAtLeast) {
            q = q.at_least(least);
        }
        let square = if self.has(Mistake::QuadraticByDistance) {
            q
        } else {
            q * q
        };
        let mut sum = a + b * q + c * square;
        if let Some(more) = value_of(Mistake::DenominatorPlus) {
            sum = sum + Bounded::given(more, self.u);
        }
        if self.has(Mistake::NotAttenuated) {
            return one;
        } else if self.has(Mistake::AttenuationInverted) {
            return sum;
        }
        let denominator = match () {
            () if self.has(Mistake::InverseSquareAlone) => q * q,
            () if self.has(Mistake::InverseAlone) => q,
            () if self.has(Mistake::AttenuationRoot) => sum.sqrt(),
            () if self.has(Mistake::AttenuatedTwice) => sum * sum,
            () => sum,
        };
        let mut left = one / denominator;
        if let Some(most) = value_of(Mistake::AttenuationAtMost) {
            left = left.at_most(most);
        } else if let Some(least) = value_of(Mistake::AttenuationAtLeast) {
            left = left.at_least(least);
        } else if let Some(least) = value_of(Mistake::AttenuationCutBelow) {
            left = (left - Bounded::exact(least)).if_positive(left, Bounded::ZERO);
        } else if let Some(end) = value_of(Mistake::CulledBeyond) {
            left = (Bounded::exact(end) - q).if_positive(left, Bounded::ZERO);
        } else if let Some(end) = value_of(Mistake::Windowed) {
            let share = q / Bounded::exact(end);
            let square = share * share;
            let window = (one - square * square).at_least_zero();
            left = left * (window * window);
        } else if let Some(end) = value_of(Mistake::FadedTo) {
            left = left * (one - q / Bounded::exact(end)).at_least_zero();
        }
        left
    }

    /// What the cone of a light lets through.
    fn cone(&self, light: &Light, l: Bounded3, way: Bounded3) -> Bounded {
        let one = Bounded::exact(1.0);
        let Light::Spot {
            axis, half_angle, ..
        } = *light
        else {
            return one;
        };
        let by_way = self.has(Mistake::ConeByWay);
        let mut against = -dot(self.given(axis), if by_way { way } else { l });
        if self.has(Mistake::ConeReversed) {
            against = -against;
        }
        let degrees = half_angle.to_degrees();
        let angle = match () {
            () if self.has(Mistake::DegreesForRadians) => half_angle.to_radians(),
            () if self.has(Mistake::HalfAngleHalved) => half_angle / 2.0,
            () if self.has(Mistake::WholeAngleForHalf) => half_angle * 2.0,
            () if self.has(Mistake::ConeBySine) => PI / 2.0 - half_angle,
            () if self.has(Mistake::AngleTruncated) => degrees.floor().to_radians(),
            () if self.has(Mistake::AngleRounded) => degrees.round().to_radians(),
            () => half_angle,
        };
        let mut edge = Bounded::given(angle, self.u).cos();
        let whole = degrees.round();
        if self.has(Mistake::AngleTruncated) && (degrees - whole).abs() < 1e3 * self.u * degrees {
            // rounding decides to which side a whole number of degrees is cut
            let [wide, narrow] = [whole, whole - 1.0].map(|degrees| degrees.to_radians().cos());
            edge = Bounded::between(wide, narrow, self.u);
        } else if self.has(Mistake::ConeAngleForCosine) {
            edge = Bounded::given(half_angle, self.u);
        }
        let mut within = one;
        let exponent = self.value_of(Mistake::ConeExponent);
        let exponent = exponent.unwrap_or(self.profile.spot_exponent);
        if exponent > 0.0 {
            within = against.at_least_zero().power(exponent);
        }
        if self.has(Mistake::ConeFaded) || self.has(Mistake::ConeSmooth) {
            within = ((against - edge) / (one - edge)).at_least_zero();
            if self.has(Mistake::ConeSmooth) {
                within = within * within * (Bounded::exact(3.0) - within - within);
            }
        }
        let is_right = degrees >= 89.99;
        if self.has(Mistake::ConeForgotten) || is_right && self.has(Mistake::RightAngleForgotten) {
            return within;
        }
        // the edge itself is lit
        (edge - against).if_positive(Bounded::ZERO, within)
    }

    #[allow(clippy::cast_precision_loss)] // the count of lights
    fn ambient(&self, scene: &Scene, surface: &Surface, lights: &[Arriving]) -> Bounded3 {
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
    fn reflected(&self, light: &Arriving, surface: &Surface) -> [Bounded3; 2] {
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
    fn left_in(&self, factor: Bounded, light: &Arriving, n: Bounded3, v: Bounded3) -> Bounded {
        if let Some(least) = self.value_of(Mistake::CosineCutBelow) {
            let above = dot(n, light.l) - Bounded::given(least, self.u);
            above.if_positive(factor, Bounded::ZERO)
        } else if self.has(Mistake::LitFromEyeOnly) {
            dot(n, v).if_positive(factor, Bounded::ZERO)
        } else {
            factor
        }
    }

    fn matte(&self, light: &Arriving, n: Bounded3, surface: &Surface) -> Bounded3 {
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

    fn shiny(&self, light: &Arriving, n: Bounded3, surface: &Surface) -> Bounded3 {
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
    fn specular(&self, l: Bounded3, n: Bounded3, surface: &Surface) -> Bounded3 {
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
    fn highlight(&self, l: Bounded3, n: Bounded3, surface: &Surface) -> Bounded {
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

    fn normalization(&self, m: f64) -> Option<f64> {
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

    /// How far two colors of any renderer may be apart by rounding alone, whatever mistake it makes, relative to
    /// the most light that may come back; and that light.
    pub fn conditioning(&self, scene: &Scene) -> (f64, Triple) {
        let size = |triple: Triple| triple.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
        let Material { k_a, k_d, k_s, m } = scene.material;
        let mut most = from_fn(|i| k_a[i] * scene.i_a[i]);
        let mut condition = 1.0_f64;
        for light in &scene.lights {
            let mut left = 1.0;
            if let Light::Point {
                position,
                attenuation: [a, b, c],
                ..
            }
            | Light::Spot {
                position,
                attenuation: [a, b, c],
                ..
            } = *light
            {
                let way: Triple = from_fn(|i| position[i] - scene.p[i]);
                let q = way.iter().map(|c| c * c).sum::<f64>().sqrt();
                left = 1.0 / (a + b * q + c * q * q);
                let farthest = size(position) + size(scene.p) + size(scene.v);
                condition = condition.max(1.0 + farthest / q);
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
        self.fits_linear(self.linear(scene), reply)
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
        let expected = self.reply(linear);
        let mut is_known = false;
        for (ends, c) in expected.into_iter().zip(reply) {
            match ends {
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
        linear.map(|c| {
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
            c.error.is_finite().then_some([low - below, high + above])
        })
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

/// With 11 bits, as a number of half precision has.
fn half(x: f64) -> f64 {
    rounded(x, (-11_f64).exp2())
}

/// A vector on the side of another; on either side where they are perpendicular.
fn toward(side: Bounded3, v: Bounded3) -> Bounded3 {
    let cosine = dot(side, v);
    if cosine.value == 0.0 {
        return v.map(|c| c.looser(2.0 * c.value.abs()));
    }
    v.map(|c| cosine.if_positive(c, -c))
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
