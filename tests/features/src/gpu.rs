use bytemuck::{Pod, Zeroable};
use shading::f32::{Light, Material, Rgb, SpotLight, Vec3};

#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub struct GpuLight {
    position: Vec3, // of a directional light: L
    is_directional: f32,
    intensity: Rgb,
    cosine: f32, // of the half-angle; −1 lights everything
    coefficients: [f32; 3],
    limit: f32, // of the attenuation
    axis: Vec3,
    padding: f32,
}

impl From<&Light> for GpuLight {
    fn from(light: &Light) -> Self {
        let (point, axis, cosine) = match light {
            Light::Point(point) => (point, Vec3::ZERO, -1.0),
            Light::Spot(SpotLight { point, axis, cone }) => (point, **axis, cone.cosine()),
            Light::Directional(light) => {
                return Self {
                    position: *light.l,
                    is_directional: 1.0,
                    intensity: light.intensity,
                    ..Self::zeroed()
                };
            }
        };
        let clamped = point.attenuation.is_clamped();
        Self {
            position: point.position,
            intensity: point.intensity,
            coefficients: point.attenuation.coefficients(),
            limit: if clamped { 1.0 } else { f32::MAX },
            axis,
            cosine,
            ..Self::zeroed()
        }
    }
}

#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub struct GpuMaterial {
    k_a: Rgb,
    m: f32,
    k_d: Rgb,
    padding: f32,
    k_s: Rgb,
    padding_too: f32,
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
