//! Lights and materials as the files have them.

use bytemuck::{Pod, Zeroable};
use shading::f32::{Light, Material, Rgb, SpotLight, Vec3};

#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub struct GpuLight {
    pub position: Vec3, // of a sun: L
    pub is_sun: f32,
    pub intensity: Rgb,
    pub limit: f32, // the largest factor of the attenuation
    pub coefficients: [f32; 3],
    pub range: f32,
    pub axis: Vec3,
    pub is_smoothstep: f32,
    pub cosines: [f32; 2], // of the inner and the outer half-angle; −1 lights everything
    pub is_gltf: f32,
    pub padding: f32,
}

impl From<&Light> for GpuLight {
    fn from(light: &Light) -> Self {
        let (point, spot) = match light {
            Light::Directional(sun) => {
                return Self {
                    position: *sun.l,
                    is_sun: 1.0,
                    intensity: sun.intensity,
                    ..Self::zeroed()
                };
            }
            Light::Point(point) => (point, None),
            Light::Spot(spot @ SpotLight { point, .. }) => (point, Some(spot)),
        };
        Self {
            position: point.position,
            intensity: point.intensity,
            limit: point.attenuation.limit().unwrap_or(f32::MAX),
            coefficients: point.attenuation.coefficients(),
            range: point.attenuation.range().unwrap_or(f32::MAX),
            is_gltf: f32::from(point.attenuation.is_gltf()),
            axis: spot.map_or(Vec3::ZERO, |spot| *spot.axis),
            is_smoothstep: f32::from(spot.is_some_and(|spot| spot.cone.is_smoothstep())),
            cosines: spot.map_or([-1.0; 2], |spot| spot.cone.cosines()),
            ..Self::zeroed()
        }
    }
}

#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub struct GpuMaterial {
    pub k_a: Rgb,
    pub m: f32,
    pub k_d: Rgb,
    pub padding: f32,
    pub k_s: Rgb,
    pub padding_too: f32,
}

impl From<&Material<f32>> for GpuMaterial {
    fn from(&Material { k_a, k_d, k_s, m }: &Material<f32>) -> Self {
        Self {
            k_a,
            m,
            k_d,
            k_s,
            ..Self::zeroed()
        }
    }
}
