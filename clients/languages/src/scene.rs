//! The structures of `shading.h`, and the types of the crate that they become.

use shading::f32::{
    Attenuation, Cone, DirectionalLight, PointLight, Rgb, SpotLight, UnitVec3, Vec3,
};
use shading::{Lobe, shade};

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

#[derive(Clone, Copy)]
#[repr(C)]
pub struct Material {
    pub k_a: [f32; 3],
    pub k_d: [f32; 3],
    pub k_s: [f32; 3],
    pub m: f32,
}

#[derive(Clone, Copy)]
#[repr(C)]
pub struct Light {
    pub kind: u32,
    pub position: [f32; 3],
    pub direction: [f32; 3],
    pub intensity: [f32; 3],
    pub attenuation: [f32; 3],
    pub range: f32,
    pub inner: f32,
    pub outer: f32,
    pub unsquared: u32,
}

// as in the callers
const _: () = assert!(size_of::<Light>() == 68 && size_of::<Material>() == 40);

/// Light or a reflectance: neither negative nor infinite nor NaN.
fn color(color: [f32; 3]) -> Option<Rgb> {
    let is_light = |channel: &f32| (0.0..=f32::MAX).contains(channel);
    color.iter().all(is_light).then(|| color.into())
}

impl Light {
    pub fn checked(&self) -> Option<shading::f32::Light> {
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

    fn point(&self) -> Option<PointLight> {
        let [a, b, c] = self.attenuation;
        let attenuation = Attenuation::new(a, b, c)?;
        Some(PointLight {
            position: self.position.into(),
            intensity: color(self.intensity)?,
            attenuation: match self.unsquared {
                0 => attenuation.within(self.range)?,
                1 => attenuation.within_gltf(self.range)?,
                _ => return None,
            },
        })
    }

    fn direction(&self) -> Option<UnitVec3> {
        Vec3::from(self.direction).unit()
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
        let mut given = self.material;
        if let Model::Lambert = self.model {
            (given.k_s, given.m) = ([0.0; 3], 1.0);
        }
        let m = given.m;
        let colors = || Some((color(given.k_a)?, color(given.k_d)?, color(given.k_s)?));
        let (k_a, k_d, k_s) = colors().filter(|_| m >= 0.0).ok_or(Status::Material)?;
        let i_a = color(self.ambient).ok_or(Status::Material)?;
        let lights: Option<Vec<_>> = self.lights.iter().map(Light::checked).collect();
        let lights = lights.ok_or(Status::Light)?;
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // it is a whole number
        if m.fract() == 0.0 && m < 65_536.0 {
            let m = m as u32;
            self.shade_with(&shading::Material { k_a, k_d, k_s, m }, i_a, &lights, out);
        } else {
            self.shade_with(&shading::Material { k_a, k_d, k_s, m }, i_a, &lights, out);
        }
        Ok(())
    }

    fn shade_with<M: Lobe<f32>>(
        &self,
        material: &shading::f32::Material<M>,
        i_a: Rgb,
        lights: &[shading::f32::Light],
        out: &mut [[f32; 3]],
    ) {
        let eye = Vec3::from(self.eye);
        for ((p, n), out) in self.points.iter().zip(self.normals).zip(out) {
            let p = Vec3::from(*p);
            let directions = Vec3::from(*n).unit().zip((eye - p).unit());
            *out = directions.map_or([0.0; 3], |(n, v)| {
                let arriving = lights.iter().map(|light| light.at(p));
                let shaded = match self.model {
                    Model::Lambert => shade::lambert(n, material, i_a, arriving),
                    Model::Phong => shade::phong(n, v, material, i_a, arriving),
                    Model::BlinnPhong => shade::blinn_phong(n, v, material, i_a, arriving),
                };
                shaded.total().into()
            });
        }
    }
}
