//! Surfaces with a formula for the intersection with a ray.

use shading::{UnitVec3, Vec3, normal};

use super::ray::{Hit, Ray, Surface};

pub struct Sphere {
    pub center: Vec3<f32>,
    pub radius: f32,
}

impl Sphere {
    pub fn new(center: [f32; 3], radius: f32) -> Self {
        Self {
            center: center.into(),
            radius,
        }
    }

    /// The two distances at which the line of a ray intersects the sphere, the smaller first.
    pub fn crossings(&self, ray: &Ray) -> Option<[f32; 2]> {
        // computed from the point of the ray nearest to the center, to avoid cancellation for a
        // distant sphere
        let to_center = self.center - ray.origin;
        let middle = to_center.dot(ray.direction);
        let aside = to_center - *ray.direction * middle;
        let square = self.radius * self.radius - aside.dot(aside);
        (square > 0.0).then(|| [middle - square.sqrt(), middle + square.sqrt()])
    }

    fn first_crossing(&self, ray: &Ray, limit: f32) -> Option<f32> {
        let crossings = self.crossings(ray)?;
        crossings.into_iter().find(|&t| 0.0 < t && t < limit)
    }
}

impl Surface for Sphere {
    fn hit(&self, ray: &Ray, limit: f32) -> Option<Hit> {
        let t = self.first_crossing(ray, limit)?;
        let n = normal::sphere(self.center, ray.at(t))?;
        Some(Hit::new(ray, t, n))
    }

    fn blocks(&self, ray: &Ray, limit: f32) -> bool {
        self.first_crossing(ray, limit).is_some()
    }
}

/// The plane ax + by + cz + d = 0.
pub struct Plane {
    n: UnitVec3<f32>,
    point: Vec3<f32>,
}

impl Plane {
    /// `None` if a = b = c = 0, which is not a plane.
    pub fn new(a: f32, b: f32, c: f32, d: f32) -> Option<Self> {
        let abc = Vec3::new(a, b, c);
        Some(Self {
            n: normal::plane(a, b, c)?,
            point: abc * (-d / abc.dot(abc)),
        })
    }
}

impl Surface for Plane {
    fn hit(&self, ray: &Ray, limit: f32) -> Option<Hit> {
        let t = self.n.dot(self.point - ray.origin) / self.n.dot(ray.direction);
        (0.0 < t && t < limit).then(|| Hit::new(ray, t, self.n))
    }
}
