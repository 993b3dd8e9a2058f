//! The structures of `shading.h`, and the types of the crate that they become. C uses them with
//! `f32`, Python also with `f64`.

use shading::{
    Attenuation, Cone, DirectionalLight, Elementary, IncidentLight, Lobe, PointLight, Rgb, Scalar,
    Shaded, SpotLight, UnitVec3, Vec3, shade,
};

use crate::Status;

#[derive(Clone, Copy)]
pub enum Model {
    Lambert,
    Phong,
    BlinnPhong,
}

impl Model {
    pub fn of(model: u32) -> Result<Self, Status> {
        match model {
            0 => Ok(Self::Lambert),
            1 => Ok(Self::Phong),
            2 => Ok(Self::BlinnPhong),
            _ => Err(Status::Model),
        }
    }
}

/// `f32` or `f64`.
pub trait Number: Elementary + Scalar + Lobe<Self> + Send + Sync {
    /// A whole shininess as an integer, which is faster.
    fn whole(self) -> Option<u32>;
}

macro_rules! numbers {
    ($($float:ident)*) => {$(
        impl Number for $float {
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // it is a whole number
            fn whole(self) -> Option<u32> {
                (self.fract() == 0.0 && (0.0..65_536.0).contains(&self)).then_some(self as u32)
            }
        }
    )*};
}
numbers!(f32 f64);

#[derive(Clone, Copy)]
#[repr(C)]
pub struct Material<T = f32> {
    pub k_a: [T; 3],
    pub k_d: [T; 3],
    pub k_s: [T; 3],
    pub m: T,
}

#[derive(Clone, Copy)]
#[repr(C)]
pub struct Light<T = f32> {
    pub kind: u32,
    pub position: [T; 3],
    pub direction: [T; 3],
    pub intensity: [T; 3],
    pub attenuation: [T; 3],
    pub range: T,
    pub inner: T,
    pub outer: T,
    pub gltf: u32,
}

// as in the callers
const _: () = assert!(size_of::<Light>() == 68 && size_of::<Material>() == 40);

/// Light or a reflectance: neither negative nor infinite nor NaN.
fn color<T: Number>(color: [T; 3]) -> Option<Rgb<T>> {
    let is_light = |channel: T| channel >= T::ZERO && channel <= T::MAX;
    color
        .iter()
        .all(|&channel| is_light(channel))
        .then(|| color.into())
}

impl<T: Number> Light<T> {
    pub fn checked(&self) -> Option<shading::Light<T>> {
        Some(match self.kind {
            0 => shading::Light::Directional(DirectionalLight {
                l: self.direction()?,
                intensity: color(self.intensity)?,
            }),
            1 => shading::Light::Point(self.point()?),
            2 => shading::Light::Spot(SpotLight {
                point: self.point()?,
                axis: self.direction()?,
                cone: Cone::from_half_angles(self.inner, self.outer)?,
            }),
            _ => return None,
        })
    }

    fn point(&self) -> Option<PointLight<T>> {
        let [a, b, c] = self.attenuation;
        let attenuation = Attenuation::new(a, b, c)?;
        Some(PointLight {
            position: self.position.into(),
            intensity: color(self.intensity)?,
            attenuation: match self.gltf {
                0 => attenuation.within(self.range)?,
                1 => attenuation.within_gltf(self.range)?,
                _ => return None,
            },
        })
    }

    fn direction(&self) -> Option<UnitVec3<T>> {
        Vec3::from(self.direction).unit()
    }
}

/// A point of a surface, and the eye that sees it.
#[derive(Clone, Copy)]
pub struct Place<T> {
    pub point: [T; 3],
    pub normal: [T; 3],
    pub eye: [T; 3],
}

/// The light that a point sends to the eye. It is black if the normal has no direction, or if the
/// point is at the eye.
#[inline]
pub fn shaded<T: Number>(
    model: Model,
    place: Place<T>,
    material: &Material<T>,
    i_a: Rgb<T>,
    lights: impl Iterator<Item = IncidentLight<T>>,
) -> Shaded<T> {
    let directions = Vec3::from(place.normal)
        .unit()
        .zip((Vec3::from(place.eye) - Vec3::from(place.point)).unit());
    let black = Rgb::BLACK;
    let [k_a, k_d, k_s] = [material.k_a, material.k_d, material.k_s].map(Rgb::from);
    let (integer, real) = (material.m.whole(), material.m);
    let Some((n, v)) = directions else {
        return Shaded {
            ambient: black,
            diffuse: black,
            specular: black,
        };
    };
    match (model, integer) {
        (Model::Lambert, _) => {
            let m = 1;
            shade::lambert(n, &shading::Material { k_a, k_d, k_s, m }, i_a, lights)
        }
        (Model::Phong, Some(m)) => {
            shade::phong(n, v, &shading::Material { k_a, k_d, k_s, m }, i_a, lights)
        }
        (Model::Phong, None) => {
            let m = real;
            shade::phong(n, v, &shading::Material { k_a, k_d, k_s, m }, i_a, lights)
        }
        (Model::BlinnPhong, Some(m)) => {
            shade::blinn_phong(n, v, &shading::Material { k_a, k_d, k_s, m }, i_a, lights)
        }
        (Model::BlinnPhong, None) => {
            let m = real;
            shade::blinn_phong(n, v, &shading::Material { k_a, k_d, k_s, m }, i_a, lights)
        }
    }
}

/// What lights many points, and their buffers.
pub struct Scene<'a> {
    pub model: Model,
    pub points: &'a [[f32; 3]],
    pub normals: &'a [[f32; 3]],
    pub eye: [f32; 3],
    pub material: Material,
    pub ambient: [f32; 3],
    pub lights: &'a [Light],
}

impl Scene<'_> {
    pub fn shade(&self, out: &mut [[f32; 3]]) -> Result<(), Status> {
        let mut material = self.material;
        if let Model::Lambert = self.model {
            (material.k_s, material.m) = ([0.0; 3], 1.0);
        }
        let colors = [material.k_a, material.k_d, material.k_s];
        let are_colors = colors.iter().all(|&channels| color(channels).is_some());
        if !(are_colors && material.m >= 0.0) {
            return Err(Status::Material);
        }
        let i_a = color(self.ambient).ok_or(Status::Material)?;
        let lights: Option<Vec<_>> = self.lights.iter().map(Light::checked).collect();
        let lights = lights.ok_or(Status::Light)?;
        for ((&point, &normal), out) in self.points.iter().zip(self.normals).zip(out) {
            let place = Place {
                point,
                normal,
                eye: self.eye,
            };
            let arriving = lights.iter().map(|light| light.at(point));
            *out = shaded(self.model, place, &material, i_a, arriving)
                .total()
                .into();
        }
        Ok(())
    }
}
