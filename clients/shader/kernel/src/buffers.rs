//! What the buffers hold, laid out as on the library's page on buffers.

use bytemuck::{Pod, Zeroable};
use shading::f32::{
    Attenuation, Cone, DirectionalLight, IncidentLight, Material, PointLight, Rgb, Shaded,
    SpotLight, UnitVec3, Vec3,
};

/// A point that the CPU found by marching.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub struct Point {
    pub p: Vec3,
    /// The surface that it is on, and the number of its material.
    pub object: u32,
    pub v: Vec3,
    /// A bit for each light: whether nothing is between it and the point.
    pub lit: u32,
}

/// The light that a point reflects, part by part, and the sum.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub struct Reflected {
    pub ambient: Rgb,
    pub diffuse: Rgb,
    pub specular: Rgb,
    pub total: Rgb,
}

impl From<Shaded> for Reflected {
    fn from(shaded: Shaded) -> Self {
        let Shaded {
            ambient,
            diffuse,
            specular,
        } = shaded;
        Self {
            ambient,
            diffuse,
            specular,
            total: shaded.total(),
        }
    }
}

/// Any light: one without a cone has a cosine of −1.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub struct GpuLight {
    pub position: Vec3, // of a directional light: L
    pub is_directional: f32,
    pub intensity: Rgb,
    pub cosine: f32,
    pub coefficients: Vec3,
    pub padding: f32,
    pub axis: Vec3,
    pub padding_too: f32,
}

impl GpuLight {
    /// The light that reaches the front of a surface at p.
    pub fn in_front(&self, p: Vec3, n: UnitVec3) -> Option<IncidentLight> {
        let Self {
            position,
            intensity,
            coefficients: c,
            ..
        } = *self;
        if self.is_directional > 0.0 {
            let l = UnitVec3::assume_unit(position);
            return DirectionalLight { l, intensity }.in_front(p, n);
        }
        let attenuation = Attenuation::new(c.x, c.y, c.z).unwrap_or(Attenuation::NONE);
        let point = PointLight {
            position,
            intensity,
            attenuation,
        };
        let axis = UnitVec3::assume_unit(self.axis);
        let cone = Cone::from_cosine(self.cosine)?;
        SpotLight { point, axis, cone }.in_front(p, n)
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

impl GpuMaterial {
    /// With an m of any kind.
    pub fn with<M>(&self, m: M) -> Material<M> {
        let Self { k_a, k_d, k_s, .. } = *self;
        Material { k_a, k_d, k_s, m }
    }
}
