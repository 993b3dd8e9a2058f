//! The lights: L, attenuation and cone.

use std::array::from_fn;
use std::f64::consts::PI;

use crate::bounded::{Bounded, Bounded3, dot, length, scale, subtract, unit};
use crate::mistake::Mistake;
use crate::reply::from_srgb;
use crate::scene::{Light, Scene, Triple};

use super::Textbook;
use super::given::Part;

/// A light as it arrives at the point.
pub struct Arriving {
    pub l: Bounded3,
    /// L before it is normalized.
    pub way: Bounded3,
    pub kind: Kind,
    pub intensity: Bounded3,
    pub attenuation: Bounded,
    /// The share that the cone lets through.
    pub cone: Bounded,
}

#[derive(Clone, Copy, PartialEq)]
pub enum Kind {
    Sun,
    Point,
    Spot,
}

impl Textbook<'_> {
    /// What a light shines.
    pub(super) fn intensity(&self, light: &Light) -> Bounded3 {
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

    pub(super) fn arriving(&self, light: &Light, scene: &Scene) -> Arriving {
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
    pub(super) fn way(&self, position: Triple, scene: &Scene) -> Bounded3 {
        let ends = (self.position(position), self.position(scene.p));
        if self.has(Mistake::PointForgotten) {
            return ends.0;
        }
        let off = self.u * scene.extent(position);
        subtract(ends.0, ends.1).map(|c| c.looser(off))
    }

    pub(super) fn attenuation(&self, coefficients: Triple, q: Bounded) -> Bounded {
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
    pub(super) fn cone(&self, light: &Light, l: Bounded3, way: Bounded3) -> Bounded {
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
}
