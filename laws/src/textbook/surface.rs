//! The surface: N, V and the material.

use crate::bounded::{Bounded, Bounded3, dot, subtract, unit};
use crate::mistake::Mistake;
use crate::reply::from_srgb;
use crate::scene::{Model, Scene, Triple};

use super::Textbook;
use super::given::Part;

/// What a scene is shaded with.
pub struct Surface {
    pub n: Bounded3,
    /// N before it is normalized.
    pub raw_n: Bounded3,
    pub v: Bounded3,
    pub k_d: Bounded3,
    pub k_s: Bounded3,
    pub model: Model,
    pub m: f64,
}

impl Textbook<'_> {
    pub(super) fn surface(&self, scene: &Scene) -> Surface {
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

    pub(super) fn reflectance(&self, k: Triple, part: Part) -> Bounded3 {
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

    pub(super) fn shininess(&self, m: f64, model: Model) -> f64 {
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
}

/// A vector on the side of another; on either side where they are perpendicular.
pub fn toward(side: Bounded3, v: Bounded3) -> Bounded3 {
    let cosine = dot(side, v);
    if cosine.value == 0.0 {
        return v.map(|c| c.looser(2.0 * c.value.abs()));
    }
    v.map(|c| cosine.if_positive(c, -c))
}
