//! Pixels and rays.

use shading::f32::{UnitVec3, Vec3};

/// Looks from `EYE` at the origin.
#[derive(Clone, Copy)]
pub struct Camera {
    pub width: usize,
    pub height: usize,
    right: UnitVec3,
    up: UnitVec3,
    forward: UnitVec3,
    /// Pixels per unit at the distance 1.
    scale: f32,
}

pub const EYE: Vec3 = Vec3::new(0.0, 1.0, 5.0);

/// A point as the camera sees it.
#[derive(Clone, Copy)]
pub struct Projected {
    pub x: f32,
    pub y: f32,
    /// The reciprocal of the depth.
    pub w: f32,
}

impl Camera {
    #[must_use]
    pub fn new(width: usize, height: usize) -> Self {
        let forward = (-EYE).unit_or(UnitVec3::NEG_Z);
        let right = forward.cross(*UnitVec3::Y).unit_or(UnitVec3::X);
        Self {
            width,
            height,
            right,
            up: UnitVec3::assume_unit(right.cross(*forward)),
            forward,
            scale: 1.75 * width.min(height) as f32,
        }
    }

    /// Through the center of a pixel.
    #[must_use]
    pub fn ray(&self, x: usize, y: usize) -> UnitVec3 {
        let right = (x as f32 + 0.5 - 0.5 * self.width as f32) / self.scale;
        let up = (0.5 * self.height as f32 - y as f32 - 0.5) / self.scale;
        (*self.forward + *self.right * right + *self.up * up).unit_or(self.forward)
    }

    /// Where a point appears; `None` behind the eye.
    #[must_use]
    pub fn project(&self, p: Vec3) -> Option<Projected> {
        let from_eye = p - EYE;
        let depth = from_eye.dot(self.forward);
        (depth > 0.01).then(|| Projected {
            x: 0.5 * self.width as f32 + from_eye.dot(self.right) / depth * self.scale,
            y: 0.5 * self.height as f32 - from_eye.dot(self.up) / depth * self.scale,
            w: 1.0 / depth,
        })
    }
}
