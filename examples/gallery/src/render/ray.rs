//! Rays, their hits, and the camera that sends them.

use shading::{Elementary, UnitVec3, Vec3};

/// The height above its surface at which a shadow ray starts, so that rounding does not make the
/// surface shade itself. The scenes are a few units large.
const LIFT: f32 = 1e-3;

/// A half-line.
#[derive(Clone, Copy)]
pub struct Ray {
    pub origin: Vec3<f32>,
    pub direction: UnitVec3<f32>,
}

impl Ray {
    pub fn at(&self, t: f32) -> Vec3<f32> {
        self.origin + *self.direction * t
    }
}

/// Where a ray hits a surface.
#[derive(Clone, Copy)]
pub struct Hit {
    /// The distance from the ray's origin.
    pub t: f32,
    pub p: Vec3<f32>,
    pub n: UnitVec3<f32>,
    /// The origin of shadow rays: slightly above `p`.
    pub lifted: Vec3<f32>,
    /// The index of the part that was hit, for surfaces made of several.
    pub part: usize,
}

impl Hit {
    pub fn new(ray: &Ray, t: f32, n: UnitVec3<f32>) -> Self {
        Self::on(ray.at(t), t, n)
    }

    /// A hit whose point is known more accurately than from the distance along the ray.
    pub fn on(p: Vec3<f32>, t: f32, n: UnitVec3<f32>) -> Self {
        Self {
            t,
            p,
            n,
            lifted: p + *n * LIFT,
            part: 0,
        }
    }
}

/// Anything that rays can hit.
pub trait Surface: Sync {
    /// The nearest hit before the distance `limit`.
    fn hit(&self, ray: &Ray, limit: f32) -> Option<Hit>;

    /// Whether there is any hit before the distance `limit`, which is all that a shadow ray needs.
    fn blocks(&self, ray: &Ray, limit: f32) -> bool {
        self.hit(ray, limit).is_some()
    }
}

/// The camera: where it is, where it looks, and how wide it sees.
pub struct Camera {
    eye: Vec3<f32>,
    forward: UnitVec3<f32>,
    right: UnitVec3<f32>,
    up: UnitVec3<f32>,
    lens: Lens,
}

enum Lens {
    /// The tangent of half the angle from the lower to the upper edge.
    Perspective(f32),
    /// Half the height of the visible area.
    Parallel(f32),
}

impl Camera {
    /// Sees `degrees` from the lower to the upper edge of the picture.
    pub fn perspective(eye: [f32; 3], at: [f32; 3], degrees: f32) -> Self {
        let half = degrees.to_radians() / 2.0;
        let tangent = Elementary::sin(half) / Elementary::cos(half);
        Self::new(eye.into(), at.into(), Lens::Perspective(tangent))
    }

    /// Sees `height` units from the lower to the upper edge along parallel rays. V is the same
    /// everywhere, so that objects side by side can be compared.
    pub fn parallel(eye: [f32; 3], at: [f32; 3], height: f32) -> Self {
        Self::new(eye.into(), at.into(), Lens::Parallel(height / 2.0))
    }

    fn new(eye: Vec3<f32>, at: Vec3<f32>, lens: Lens) -> Self {
        let forward = (at - eye).unit_or(-UnitVec3::Z);
        let right = forward.cross(UnitVec3::Y).unit_or(UnitVec3::X);
        let up = right.cross(forward).unit_or(UnitVec3::Y);
        Self {
            eye,
            forward,
            right,
            up,
            lens,
        }
    }

    /// The ray through the point (x, y) of the picture. y is −1 at its lower and 1 at its upper
    /// edge, and x grows at the same rate to the right.
    pub fn ray(&self, x: f32, y: f32) -> Ray {
        let aside = *self.right * x + *self.up * y;
        match self.lens {
            Lens::Perspective(tangent) => Ray {
                origin: self.eye,
                direction: (*self.forward + aside * tangent).unit_or(self.forward),
            },
            Lens::Parallel(half_height) => Ray {
                origin: self.eye + aside * half_height,
                direction: self.forward,
            },
        }
    }
}
