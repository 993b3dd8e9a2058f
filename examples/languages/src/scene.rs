//! The structures of `shading.h`, and the types of the crate that they become.

use shading::f32::{
    Attenuation, DirectionalLight, PointLight, Ranged, Rgb, SoftCone, SpotLight, UnitVec3, Vec3,
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

#[derive(Clone, Copy)]
#[repr(C)]
pub struct Material {
    k_a: [f32; 3],
    k_d: [f32; 3],
    k_s: [f32; 3],
    pub m: f32,
}

#[derive(Clone, Copy)]
#[repr(C)]
pub struct Light {
    kind: u32,
    position: [f32; 3],
    direction: [f32; 3],
    intensity: [f32; 3],
    attenuation: [f32; 3],
    range: f32,
    inner: f32,
    outer: f32,
    unsquared: u32,
}

// as in the callers
const _: () = assert!(size_of::<Light>() == 68 && size_of::<Material>() == 40);

pub type AnyLight = shading::Light<f32, SoftCone, Ranged>;

/// Light or a reflectance: neither negative nor infinite nor NaN.
pub fn color(color: [f32; 3]) -> Option<Rgb> {
    let is_light = |channel: &f32| (0.0..=f32::MAX).contains(channel);
    color.iter().all(is_light).then(|| color.into())
}

/// The material, with m in another type.
pub fn material<M>(given: Material, m: M) -> Result<shading::f32::Material<M>, Status> {
    let colors = || Some((color(given.k_a)?, color(given.k_d)?, color(given.k_s)?));
    let (k_a, k_d, k_s) = colors()
        .filter(|_| given.m >= 0.0)
        .ok_or(Status::Material)?;
    Ok(shading::f32::Material { k_a, k_d, k_s, m })
}

pub fn lights(given: &[Light]) -> Result<Vec<AnyLight>, Status> {
    let lights = given.iter().map(Light::checked).collect::<Option<_>>();
    lights.ok_or(Status::Light)
}

impl Light {
    fn checked(&self) -> Option<AnyLight> {
        match self.kind {
            0 => Some(self.directional()?.into()),
            1 => Some(self.point()?.into()),
            2 => Some(self.spot()?.into()),
            _ => None,
        }
    }

    fn directional(&self) -> Option<DirectionalLight> {
        Some(DirectionalLight {
            l: self.direction()?,
            intensity: color(self.intensity)?,
        })
    }

    fn point(&self) -> Option<PointLight<Ranged>> {
        let [a, b, c] = self.attenuation;
        Some(PointLight {
            position: self.position.into(),
            intensity: color(self.intensity)?,
            attenuation: self.window(Attenuation::new(a, b, c)?.within(self.range)?)?,
        })
    }

    fn window(&self, ranged: Ranged) -> Option<Ranged> {
        match self.unsquared {
            0 => Some(ranged),
            1 => Some(ranged.unsquared()),
            _ => None,
        }
    }

    fn spot(&self) -> Option<SpotLight<SoftCone, Ranged>> {
        Some(SpotLight {
            point: self.point()?,
            axis: self.direction()?,
            cone: SoftCone::from_half_angles(self.inner, self.outer)?,
        })
    }

    fn direction(&self) -> Option<UnitVec3> {
        Vec3::from(self.direction).unit()
    }
}
