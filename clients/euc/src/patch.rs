//! The teapot's Bézier patches, cut into triangles. The normals are those of the patches themselves.

use shading::f32::{UnitVec3, Vec3};
use shading::{Real, normal};

const DATA: &str = include_str!("../../../examples/gallery/data/teapot.bezier");

/// The number of squares along each side of a patch; each square has two triangles.
const FINENESS: usize = 16;

/// The corners of all triangles, with their normals.
pub fn triangles() -> impl Iterator<Item = (Vec3, UnitVec3)> {
    patches().into_iter().flat_map(|patch| {
        (0..FINENESS * FINENESS).flat_map(move |k| {
            let (i, j) = (k / FINENESS, k % FINENESS);
            let [a, b, c, d] =
                [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| patch.corner(i, j));
            [a, c, b, a, d, c] // counter-clockwise from outside
        })
    })
}

/// Σ Bᵢ(u) Bⱼ(v) Pᵢⱼ with Bernstein's polynomials.
#[derive(Clone, Copy)]
struct Patch([Vec3; 16]);

impl Patch {
    fn at<T: Real>(&self, u: T, v: T) -> shading::Vec3<T> {
        let (b_u, b_v) = (bernstein(u), bernstein(v));
        (0..16).fold(shading::Vec3::ZERO, |sum, i| {
            sum + self.0[i].map(T::of_f32) * (b_u[i / 4] * b_v[i % 4])
        })
    }

    /// The outward normal: v comes before u. At a pole, where all v are one point, it is taken slightly
    /// inside the patch.
    fn normal(&self, u: f32, v: f32) -> UnitVec3 {
        let inside = |t: f32| t.clamp(1e-3, 1.0 - 1e-3);
        let normal = |u, v| normal::parametric(|v, u| self.at(u, v), v, u);
        normal(u, v)
            .or_else(|| normal(inside(u), inside(v)))
            .unwrap_or(UnitVec3::Z)
    }

    fn corner(&self, i: usize, j: usize) -> (Vec3, UnitVec3) {
        let [u, v] = [i, j].map(|k| k as f32 / FINENESS as f32);
        (self.at(u, v), self.normal(u, v))
    }
}

fn bernstein<T: Real>(t: T) -> [T; 4] {
    let (s, three) = (T::ONE - t, T::of_f32(3.0));
    [s * s * s, three * s * s * t, three * s * t * t, t * t * t]
}

fn patches() -> Vec<Patch> {
    let numbers = |kind| {
        let lines = DATA.lines().filter_map(move |line| line.strip_prefix(kind));
        lines.map(|line| {
            line.split(' ')
                .filter_map(|word| word.parse().ok())
                .collect::<Vec<f32>>()
        })
    };
    let points: Vec<Vec3> = numbers("v ").map(|c| Vec3::new(c[0], c[1], c[2])).collect();
    let patch = |indices: Vec<f32>| Patch(std::array::from_fn(|i| points[indices[i] as usize]));
    numbers("p ").map(patch).collect()
}
