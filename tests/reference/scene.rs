//! What the reference renderers have in common: a point, a surface, and lights with a separate
//! color for each part of the reflection, shaded by this crate in any number type.

use shading::{
    DirectionalLight, IncidentLight, Material, PointLight, Rgb, SpotLight, UnitVec3, shade, term,
};
use support::number::{Number, direction, vector};

use support::running::Bounded;

/// A reference case with the numbers of its file.
pub struct Scene {
    pub p: [f64; 3],
    pub n: [f64; 3],
    /// Whether N is used as given; otherwise it is normalized in the number type first.
    pub n_as_given: bool,
    pub eye: [f64; 3],
    pub emission: [f64; 3],
    /// k_a and I_a of the scene.
    pub ambient: [[f64; 3]; 2],
    /// k_a for lights with ambient light of their own.
    pub k_a: [f64; 3],
    pub k_d: [f64; 3],
    /// k_s and m of Phong's highlight.
    pub phong: ([f64; 3], f64),
    /// k_s and m of Blinn's highlight.
    pub blinn: ([f64; 3], f64),
    pub lamps: Vec<Lamp>,
}

/// A light with a separate color for each part of the reflection.
pub struct Lamp {
    pub source: Source,
    /// a, b, c.
    pub attenuation: [f64; 3],
    pub spot: Option<Spot>,
    pub ambient: [f64; 3],
    pub diffuse: [f64; 3],
    pub specular: [f64; 3],
    /// For a renderer that does not attenuate the highlight: the threshold that N·L times the
    /// attenuation must exceed for a highlight.
    pub bare_highlight_above: Option<f64>,
}

pub enum Source {
    /// The direction to the light.
    Directional([f64; 3]),
    /// The position of the light.
    Point([f64; 3]),
}

pub struct Spot {
    pub axis: [f64; 3],
    pub half_angle_degrees: f64,
    /// Where a soft edge with a smoothstep begins.
    pub inner_half_angle_degrees: Option<f64>,
    /// The renderer's additional factor inside the cone as a function of −L·axis. The caller
    /// multiplies the incident light by it.
    pub profile: Box<dyn Fn(f64) -> f64>,
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = dot(v, v).sqrt();
    v.map(|c| c / length)
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn rgb<T: Number>(color: [f64; 3]) -> Rgb<T> {
    Rgb::from(color).map(T::of)
}

impl Lamp {
    /// The crate's light of this color that arrives at p, without the profile.
    fn incident<T: Number>(&self, p: [f64; 3], color: [f64; 3]) -> IncidentLight<T> {
        let p = vector(p);
        let position = match self.source {
            Source::Directional(l) => {
                let (l, intensity) = (direction(l), rgb(color));
                return DirectionalLight { l, intensity }.at(p);
            }
            Source::Point(position) => vector(position),
        };
        let attenuation = T::attenuation(self.attenuation).expect("coefficients");
        let point = PointLight {
            position,
            intensity: rgb(color),
            attenuation,
        };
        let Some(spot) = &self.spot else {
            return point.at(p);
        };
        let (axis, outer) = (direction(spot.axis), spot.half_angle_degrees);
        if let Some(inner) = spot.inner_half_angle_degrees {
            let cone = T::soft_cone([inner, outer]).expect("two half-angles");
            let cone = cone.smoothstep();
            SpotLight { point, axis, cone }.at(p)
        } else {
            let cone = T::cone(outer).expect("a half-angle");
            SpotLight { point, axis, cone }.at(p)
        }
    }

    /// The renderer's additional factor inside its cone, from the exact inputs.
    fn profile(&self, p: [f64; 3]) -> f64 {
        match (&self.spot, &self.source) {
            (Some(spot), Source::Point(position)) => {
                (spot.profile)(-dot(unit(minus(*position, p)), unit(spot.axis)))
            }
            _ => 1.0,
        }
    }

    /// The light of this color that arrives at p.
    fn arriving<T: Number>(&self, p: [f64; 3], color: [f64; 3]) -> IncidentLight<T> {
        let incident = self.incident::<T>(p, color);
        let profile = T::of(self.profile(p));
        IncidentLight {
            intensity: incident.intensity * profile,
            ..incident
        }
    }
}

impl Scene {
    fn normal<T: Number>(&self) -> UnitVec3<T> {
        if self.n_as_given {
            UnitVec3::assume_unit(vector(self.n))
        } else {
            direction(self.n)
        }
    }

    fn material<T: Number>(k_d: [f64; 3], (k_s, m): ([f64; 3], f64)) -> Material<T, T> {
        Material {
            k_a: Rgb::BLACK,
            k_d: rgb(k_d),
            k_s: rgb(k_s),
            m: T::of(m),
        }
    }

    /// The light that makes a lamp's highlight.
    fn highlight_light<T: Number>(&self, lamp: &Lamp) -> IncidentLight<T> {
        let incident = lamp.arriving::<T>(self.p, lamp.specular);
        let Some(threshold) = lamp.bare_highlight_above else {
            return incident;
        };
        let white = lamp.arriving::<f64>(self.p, [1.0; 3]);
        let received = term::lambert(self.normal(), white.l) * white.intensity.r;
        let intensity = if received > threshold {
            rgb(lamp.specular)
        } else {
            Rgb::BLACK
        };
        IncidentLight {
            intensity,
            ..incident
        }
    }

    /// The color of the point by the formulas of this crate.
    pub fn shade<T: Number>(&self) -> Rgb<T> {
        const NONE: [f64; 3] = [0.0; 3];
        let n = self.normal::<T>();
        let v = (vector::<T>(self.eye) - vector(self.p))
            .unit()
            .expect("a view");

        let of_lamps = self.lamps.iter().map(|lamp| {
            term::ambient(rgb(self.k_a), lamp.arriving(self.p, lamp.ambient).intensity)
        });
        let diffuse_lights = self
            .lamps
            .iter()
            .map(|lamp| lamp.arriving(self.p, lamp.diffuse));
        let highlight_lights = || self.lamps.iter().map(|lamp| self.highlight_light(lamp));

        let matte = Self::material(self.k_d, (NONE, 0.0));
        let [k_a, i_a] = self.ambient.map(rgb);
        let matte = Material { k_a, ..matte };
        let phong = Self::material(NONE, self.phong);
        let blinn = Self::material(NONE, self.blinn);
        rgb(self.emission)
            + of_lamps.sum()
            + shade::lambert(n, &matte, i_a, diffuse_lights).total()
            + shade::phong(n, v, &phong, Rgb::BLACK, highlight_lights()).specular
            + shade::blinn_phong(n, v, &blinn, Rgb::BLACK, highlight_lights()).specular
    }

    /// The rounding error of each channel, bounded by computing in a number type with error bounds.
    pub fn rounding<T: Number + Bounded>(&self) -> [f64; 3] {
        <[T; 3]>::from(self.shade::<T>()).map(Bounded::error)
    }
}
