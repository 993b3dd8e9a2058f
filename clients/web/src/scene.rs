//! The page's controls as a material, two lamps, a sun and an eye, and the light from one point.

use shading::f32::{
    Attenuation, Cone, DirectionalLight, IncidentLight, PointLight, Rgb, Shaded, SpotLight,
    UnitVec3, Vec3,
};
use shading::{Material, shade};

use crate::surface::{EYE, Point, Turn};

/// What the controls hold, in the order of `SETTINGS` in `page.js`.
pub const SETTINGS: usize = 39;

/// The light of the surroundings.
pub const WHITE: Rgb = Rgb::WHITE;

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Model {
    Lambert,
    Phong,
    BlinnPhong,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Part {
    Total,
    Ambient,
    Diffuse,
    Specular,
}

#[derive(Clone, Copy, Debug)]
pub struct Scene {
    pub model: Model,
    pub material: Material<f32, f32>,
    /// `None` where a = b = c = 0, or where the second lamp is off.
    pub lamps: [Option<SpotLight>; 2],
    pub sun: Option<DirectionalLight>,
    pub eye: Vec3,
    pub turn: Turn,
}

impl Scene {
    /// Accepts any numbers. One that is not finite counts as 0.
    #[must_use]
    pub fn new(settings: &[f32; SETTINGS]) -> Self {
        let finite = settings.map(|s| if s.is_finite() { s } else { 0.0 });
        let [
            _,
            model,
            k_a,
            k_d,
            k_s,
            m,
            x,
            y,
            z,
            a,
            b,
            c,
            angle,
            edge,
            second,
            x_2,
            y_2,
            z_2,
            e_x,
            e_y,
            e_z,
            cosine,
            sine,
            sun,
            s_x,
            s_y,
            s_z,
            ref colors @ ..,
        ] = finite;
        let color = |i: usize| {
            let bytes = [0, 1, 2].map(|channel| colors[3 * i + channel] as u8);
            Rgb::from_srgb8(bytes)
        };
        let body = color(0);
        let lamp = |position, intensity| lamp(position, intensity, [a, b, c], angle, edge);
        // from near the axis, or from within the object or far away, nothing is seen as the page means it
        let eye = Vec3::new(e_x, e_y, e_z);
        let is_eye = eye.x.hypot(eye.z) > 0.1 && (2.0..100.0).contains(&eye.length());
        let turned = Vec3::new(cosine, sine, 0.0).unit_or(UnitVec3::X);
        let [k_a, k_d, k_s] = [k_a, k_d, k_s].map(|k| k.clamp(0.0, 1.0));
        Self {
            model: match model {
                0.0 => Model::Lambert,
                1.0 => Model::Phong,
                _ => Model::BlinnPhong,
            },
            material: Material {
                k_a: body * k_a,
                k_d: body * k_d,
                k_s: Rgb::gray(k_s),
                m,
            },
            lamps: [
                lamp(Vec3::new(x, y, z), color(1)),
                lamp(Vec3::new(x_2, y_2, z_2), color(2)).filter(|_| second != 0.0),
            ],
            sun: (sun != 0.0).then(|| DirectionalLight {
                l: Vec3::new(s_x, s_y, s_z).unit_or(UnitVec3::Y),
                intensity: color(3),
            }),
            eye: if is_eye { eye } else { EYE },
            turn: [turned.x, turned.y],
        }
    }

    /// What arrives at a point from the lamps that are on, and from the sun.
    pub fn lights(&self, p: Vec3) -> impl Iterator<Item = IncidentLight> + '_ {
        let lamps = self.lamps.iter().flatten().map(move |lamp| lamp.at(p));
        lamps.chain(self.sun.iter().map(move |sun| sun.at(p)))
    }

    /// The light from a point, part by part.
    pub fn shaded(&self, &Point { p, n, v, .. }: &Point) -> Shaded {
        let lights = self.lights(p);
        match self.model {
            Model::Lambert => shade::lambert(n, &self.material, WHITE, lights),
            Model::Phong => shade::phong(n, v, &self.material, WHITE, lights),
            Model::BlinnPhong => shade::blinn_phong(n, v, &self.material, WHITE, lights),
        }
    }
}

/// A lamp that points to the origin. The soft edge begins `edge` degrees inside the cone.
fn lamp(
    position: Vec3,
    intensity: Rgb,
    [a, b, c]: [f32; 3],
    angle: f32,
    edge: f32,
) -> Option<SpotLight> {
    use std::f32::consts::PI;
    let radians = |degrees: f32| (degrees * (PI / 180.0)).clamp(0.0, PI);
    Some(SpotLight {
        point: PointLight {
            position,
            intensity,
            attenuation: Attenuation::new(a, b, c)?,
        },
        axis: (-position).unit_or(UnitVec3::NEG_Z),
        cone: Cone::from_half_angles(radians(angle - edge.max(0.0)), radians(angle))?,
    })
}

impl Part {
    pub fn of(self, shaded: Shaded) -> Rgb {
        match self {
            Self::Total => shaded.total(),
            Self::Ambient => shaded.ambient,
            Self::Diffuse => shaded.diffuse,
            Self::Specular => shaded.specular,
        }
    }
}
