//! What the programs have in common: a point, a surface, and lights with a separate color for each
//! part of the reflection, shaded by this crate.

use shading::f64::{
    Attenuation, Cone, DirectionalLight, IncidentLight, Material, PointLight, Rgb, SpotLight,
    UnitVec3, Vec3,
};
use shading::{shade, term};

/// A case with the numbers of its file.
#[derive(Default)]
pub struct Scene {
    pub p: [f64; 3],
    pub n: [f64; 3],
    /// Whether N is used as given; otherwise it is normalized first.
    pub n_as_given: bool,
    pub eye: [f64; 3],
    pub emission: [f64; 3],
    /// k_a and I_a of the scene.
    pub ambient: [[f64; 3]; 2],
    /// k_a for lights with ambient light of their own.
    pub k_a: [f64; 3],
    pub k_d: [f64; 3],
    /// k_s and m of each highlight.
    pub phong: ([f64; 3], f64),
    pub blinn: ([f64; 3], f64),
    pub lamps: Vec<Lamp>,
}

/// A light with a separate color for each part of the reflection.
#[derive(Default)]
pub struct Lamp {
    pub source: Source,
    /// a, b, c.
    pub attenuation: [f64; 3],
    pub spot: Option<Spot>,
    pub ambient: [f64; 3],
    pub diffuse: [f64; 3],
    pub specular: [f64; 3],
    /// For a program that does not attenuate the highlight: the threshold that N·L times the attenuation
    /// must exceed for a highlight.
    pub bare_highlight_above: Option<f64>,
}

pub enum Source {
    /// The direction to the light.
    Directional([f64; 3]),
    Point([f64; 3]),
}

impl Default for Source {
    fn default() -> Self {
        Self::Point([0.0; 3])
    }
}

pub struct Spot {
    pub axis: [f64; 3],
    /// Equal for a hard edge, else that of a smoothstep.
    pub half_angles_degrees: [f64; 2],
    /// The program's additional factor inside the cone as a function of −L·axis.
    pub profile: Box<dyn Fn(f64) -> f64>,
}

fn direction(v: [f64; 3]) -> UnitVec3 {
    Vec3::from(v).unit().expect("a direction")
}

impl Lamp {
    /// The light of this color that arrives at p.
    fn arriving(&self, p: Vec3, color: [f64; 3]) -> IncidentLight {
        let intensity = Rgb::from(color);
        let position = match self.source {
            Source::Directional(l) => {
                return DirectionalLight {
                    l: direction(l),
                    intensity,
                }
                .at(p);
            }
            Source::Point(position) => Vec3::from(position),
        };
        let [a, b, c] = self.attenuation;
        let attenuation = Attenuation::new(a, b, c).expect("coefficients");
        let point = PointLight {
            position,
            intensity,
            attenuation,
        };
        let Some(Spot {
            axis,
            half_angles_degrees,
            profile,
        }) = &self.spot
        else {
            return point.at(p);
        };
        let [inner, outer] = half_angles_degrees.map(f64::to_radians);
        let cone = Cone::from_half_angles(inner, outer)
            .expect("half-angles")
            .smoothstep();
        let axis = direction(*axis);
        let light = SpotLight { point, axis, cone }.at(p);
        light * profile(-light.l().dot(axis))
    }
}

impl Scene {
    /// The color of the point by the formulas of this crate.
    pub fn shade(&self) -> [f64; 3] {
        let [p, eye] = [self.p, self.eye].map(Vec3::from);
        let n = if self.n_as_given {
            UnitVec3::assume_unit(self.n.into())
        } else {
            direction(self.n)
        };
        let v = (eye - p).unit().expect("a view");
        let highlight_light = |lamp: &Lamp| {
            let light = lamp.arriving(p, lamp.specular);
            let Some(threshold) = lamp.bare_highlight_above else {
                return light;
            };
            let white = lamp.arriving(p, [1.0; 3]);
            let is_received = term::lambert(n, white.l()) * white.intensity().r > threshold;
            let intensity = if is_received {
                lamp.specular.into()
            } else {
                Rgb::BLACK
            };
            DirectionalLight {
                l: light.l(),
                intensity,
            }
            .at(p)
        };
        let mirror = |(k_s, m): ([f64; 3], f64)| Material::<f64> {
            k_a: Rgb::BLACK,
            k_d: Rgb::BLACK,
            k_s: k_s.into(),
            m,
        };
        let [k_a, i_a] = self.ambient.map(Rgb::from);
        let matte = Material {
            k_a,
            k_d: self.k_d.into(),
            k_s: Rgb::BLACK,
            m: 0,
        };
        let of_lamps = self
            .lamps
            .iter()
            .map(|lamp| term::ambient(self.k_a.into(), lamp.arriving(p, lamp.ambient).intensity()));
        let diffuse = self.lamps.iter().map(|lamp| lamp.arriving(p, lamp.diffuse));
        let shine = || self.lamps.iter().map(highlight_light);
        let sum = Rgb::from(self.emission)
            + of_lamps.sum()
            + shade::lambert(n, &matte, i_a, diffuse).total()
            + shade::phong(n, v, &mirror(self.phong), Rgb::BLACK, shine()).specular
            + shade::blinn_phong(n, v, &mirror(self.blinn), Rgb::BLACK, shine()).specular;
        sum.into()
    }
}
