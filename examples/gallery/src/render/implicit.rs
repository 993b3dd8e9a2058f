//! Implicit surfaces f(x, y, z) = 0, found by sphere tracing.
//!
//! Source: J. C. Hart, *Sphere tracing*, The Visual Computer 12, 1996.

use shading::{Dual, Elementary, Vec3, normal};

use super::ray::{Hit, Ray, Surface};
use super::shape::Sphere;

const MAX_STEPS: usize = 400;
/// The distance from the surface at which the steps end and Newton's method takes over.
const NEAR: f32 = 1e-4;

/// A function whose zeros form a surface: it is negative inside, and |f| is never larger than the
/// distance to the surface. It is written once for every number type: with `f32` it finds the
/// surface, and with dual numbers it gives the normal.
pub trait Field: Sync {
    fn value<T: Elementary>(&self, p: Vec3<T>) -> T;
}

/// The surface of a field inside a bounding sphere.
pub struct Implicit<F> {
    pub field: F,
    pub bound: Sphere,
}

impl<F: Field> Implicit<F> {
    pub fn new(field: F, center: [f32; 3], radius: f32) -> Self {
        let bound = Sphere::new(center, radius);
        Self { field, bound }
    }

    /// Steps along the ray by the value of the field, since no part of the surface is nearer than
    /// that.
    fn trace(&self, ray: &Ray, limit: f32) -> Option<f32> {
        let [enter, leave] = self.bound.crossings(ray)?;
        let end = leave.min(limit);
        let mut t = enter.max(0.0);
        for _ in 0..MAX_STEPS {
            if t >= end {
                return None;
            }
            let f = self.field.value(ray.at(t));
            if f < NEAR {
                return Some(t);
            }
            t += f;
        }
        None
    }

    /// One step of Newton's method along the ray, with the exact slope ∇f·D.
    fn refined(&self, ray: &Ray, t: f32) -> f32 {
        let f = self.field.value(Dual::point(ray.at(t)));
        let slope = f.gradient.dot(ray.direction);
        // for a grazing ray, the curvature of the surface counts more than its slope
        if slope < -0.1 { t - f.value / slope } else { t }
    }
}

impl<F: Field> Surface for Implicit<F> {
    fn hit(&self, ray: &Ray, limit: f32) -> Option<Hit> {
        let t = self.refined(ray, self.trace(ray, limit)?);
        let n = normal::implicit(|p| self.field.value(p), ray.at(t));
        // where the field has no gradient, any normal that faces the eye will do
        Some(Hit::new(ray, t, n.unwrap_or(-ray.direction)))
    }

    fn blocks(&self, ray: &Ray, limit: f32) -> bool {
        self.trace(ray, limit).is_some()
    }
}
