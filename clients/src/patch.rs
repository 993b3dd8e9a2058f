//! A bicubic Bézier patch: points and exact normals.

use shading::f32::{UnitVec3, Vec3};
use shading::{Real, normal};

#[derive(Clone, Copy)]
pub struct Patch(pub [Vec3; 16]);

impl Patch {
    /// Σ Bᵢ(u) Bⱼ(v) Pᵢⱼ with Bernstein's polynomials.
    pub fn at<T: Real>(&self, u: T, v: T) -> shading::Vec3<T> {
        let (b_u, b_v) = (bernstein(u), bernstein(v));
        let mut p = shading::Vec3::ZERO;
        for (row, b_u) in self.0.chunks(4).zip(b_u) {
            for (control, b_v) in row.iter().zip(b_v) {
                p += control.map(T::of_f32) * (b_u * b_v);
            }
        }
        p
    }

    /// The outward normal: v comes before u. At a pole, where all v are one point, it is taken slightly
    /// inside the patch.
    pub fn normal(&self, u: f32, v: f32) -> Option<UnitVec3> {
        let inside = [u, v].map(|t| t.clamp(1e-3, 1.0 - 1e-3));
        let mut places = [[u, v], inside].into_iter(); // one call, which is inlined once
        places.find_map(|[u, v]| normal::parametric(|v, u| self.at(u, v), v, u))
    }
}

fn bernstein<T: Real>(t: T) -> [T; 4] {
    let (s, three) = (T::ONE - t, T::of_f32(3.0));
    [s * s * s, three * s * s * t, three * s * t * t, t * t * t]
}
