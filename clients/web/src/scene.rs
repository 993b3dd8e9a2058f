//! The page's controls as a material and a lamp, and the light from one point.

use shading::f32::{Attenuation, Rgb, UnitVec3, Vec3};
use shading::{Exponent, Material, PointLight, Real, Shaded, SoftCone, SpotLight, shade};

/// What the controls hold, in the order of `SETTINGS` in `page.js`.
pub const SETTINGS: usize = 17;

/// The light of the surroundings and of the lamp.
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

pub type Lamp<T = f32> = SpotLight<T, SoftCone<T>>;

/// The scene, in scalars or in lanes.
#[derive(Clone, Copy, Debug)]
pub struct Scene<T = f32> {
    pub model: Model,
    pub material: Material<T, f32>,
    /// `None` where a = b = c = 0.
    pub lamp: Option<Lamp<T>>,
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
            red,
            green,
            blue,
        ] = finite;
        let body = Rgb::from_srgb8([red, green, blue].map(|byte| byte as u8));
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
            lamp: lamp(Vec3::new(x, y, z), [a, b, c], angle, edge),
        }
    }

    #[must_use]
    pub fn cast<U: Real>(self, mut f: impl FnMut(f32) -> U) -> Scene<U> {
        Scene {
            model: self.model,
            material: self.material.cast(&mut f),
            lamp: self.lamp.map(|lamp| lamp.cast(f)),
        }
    }
}

/// A lamp that points to the origin. The soft edge begins `edge` degrees inside the cone.
fn lamp(position: Vec3, [a, b, c]: [f32; 3], angle: f32, edge: f32) -> Option<Lamp> {
    use std::f32::consts::PI;
    let radians = |degrees: f32| (degrees * (PI / 180.0)).clamp(0.0, PI);
    Some(SpotLight {
        point: PointLight {
            position,
            intensity: WHITE,
            attenuation: Attenuation::new(a, b, c)?,
        },
        axis: (-position).unit_or(UnitVec3::NEG_Z),
        cone: SoftCone::<f32>::from_half_angles(radians(angle - edge.max(0.0)), radians(angle))?,
    })
}

impl<T: Real> Scene<T> {
    /// The light from a point, part by part.
    #[inline]
    pub fn shaded(
        &self,
        p: shading::Vec3<T>,
        n: shading::UnitVec3<T>,
        v: shading::UnitVec3<T>,
    ) -> Shaded<T>
    where
        f32: Exponent<T>,
    {
        let lights = self.lamp.iter().map(|lamp| lamp.at(p));
        let i_a = WHITE.map(T::of_f32);
        match self.model {
            Model::Lambert => shade::lambert(n, &self.material, i_a, lights),
            Model::Phong => shade::phong(n, v, &self.material, i_a, lights),
            Model::BlinnPhong => shade::blinn_phong(n, v, &self.material, i_a, lights),
        }
    }
}

impl Part {
    #[inline]
    pub fn of<T: Real>(self, shaded: Shaded<T>) -> shading::Rgb<T> {
        match self {
            Self::Total => shaded.total(),
            Self::Ambient => shaded.ambient,
            Self::Diffuse => shaded.diffuse,
            Self::Specular => shaded.specular,
        }
    }
}
