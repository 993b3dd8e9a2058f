//! Triangle meshes: where a ray hits them, with flat or smooth shading.

use std::sync::Arc;

use shading::{UnitVec3, Vec3, normal};

use super::bvh::{Bounds, Bvh};
use super::ray::{Hit, Ray, Surface};

pub struct Mesh {
    positions: Vec<Vec3<f32>>,
    triangles: Vec<[usize; 3]>,
    bvh: Bvh,
}

/// A triangle's contribution to the normal of its first vertex.
pub type Share = fn(Vec3<f32>, Vec3<f32>, Vec3<f32>) -> Vec3<f32>;

/// Where a ray hits a mesh.
pub struct MeshHit {
    pub t: f32,
    pub triangle: usize,
    /// The weights of the three corners at the point.
    pub weights: [f32; 3],
}

impl Mesh {
    /// Takes triangles as the indices of their corners; there must be at least one triangle.
    pub fn new(positions: Vec<Vec3<f32>>, triangles: Vec<[usize; 3]>) -> Self {
        let bounds: Vec<_> = triangles
            .iter()
            .map(|corners| Bounds::around(corners.map(|i| positions[i])))
            .collect();
        Self {
            bvh: Bvh::new(&bounds),
            positions,
            triangles,
        }
    }

    pub fn nearest(&self, ray: &Ray, limit: f32) -> Option<MeshHit> {
        let mut nearest = None;
        self.bvh.walk(ray, limit, |triangle, limit| {
            match self.meet(ray, triangle, limit) {
                Some(hit) => nearest.insert(hit).t,
                None => limit,
            }
        });
        nearest
    }

    pub fn blocks(&self, ray: &Ray, limit: f32) -> bool {
        let mut blocked = false;
        self.bvh.walk(ray, limit, |triangle, limit| {
            blocked = blocked || self.meet(ray, triangle, limit).is_some();
            // nothing is nearer than that, so the walk ends
            if blocked { f32::NEG_INFINITY } else { limit }
        });
        blocked
    }

    fn corners(&self, triangle: usize) -> [Vec3<f32>; 3] {
        let [a, b, c] = self.triangles[triangle];
        [self.positions[a], self.positions[b], self.positions[c]]
    }

    /// Möller and Trumbore, *Fast, minimum storage ray–triangle intersection*, 1997.
    fn meet(&self, ray: &Ray, triangle: usize, limit: f32) -> Option<MeshHit> {
        // rounding must not open a gap between two triangles
        const EDGE: f32 = -1e-6;
        let [v1, v2, v3] = self.corners(triangle);
        let (e1, e2) = (v2 - v1, v3 - v1);
        let h = ray.direction.cross(e2);
        let scale = 1.0 / e1.dot(h);
        let s = ray.origin - v1;
        let b = s.dot(h) * scale;
        let q = s.cross(e1);
        let c = ray.direction.dot(q) * scale;
        let t = e2.dot(q) * scale;
        let a = 1.0 - b - c;
        (a >= EDGE && b >= EDGE && c >= EDGE && 0.0 < t && t < limit).then_some(MeshHit {
            t,
            triangle,
            weights: [a, b, c],
        })
    }

    /// The normal of the triangle on the side that the ray comes from: a mesh need not be closed,
    /// nor must all its triangles have the same orientation.
    fn facing(&self, ray: &Ray, triangle: usize) -> UnitVec3<f32> {
        let [v1, v2, v3] = self.corners(triangle);
        match normal::triangle(v1, v2, v3) {
            Some(n) if n.dot(ray.direction) <= 0.0 => n,
            Some(n) => -n,
            None => -ray.direction,
        }
    }

    /// For each vertex, the sum of the shares of the triangles around it.
    fn vertex_normals(&self, share: Share) -> Vec<Vec3<f32>> {
        let mut normals = vec![Vec3::ZERO; self.positions.len()];
        for &[a, b, c] in &self.triangles {
            for [i, j, k] in [[a, b, c], [b, c, a], [c, a, b]] {
                normals[i] += share(self.positions[i], self.positions[j], self.positions[k]);
            }
        }
        normals
    }
}

/// A mesh with the normal of each triangle.
pub struct Flat(pub Arc<Mesh>);

impl Surface for Flat {
    fn hit(&self, ray: &Ray, limit: f32) -> Option<Hit> {
        let MeshHit { t, triangle, .. } = self.0.nearest(ray, limit)?;
        Some(Hit::new(ray, t, self.0.facing(ray, triangle)))
    }

    fn blocks(&self, ray: &Ray, limit: f32) -> bool {
        self.0.blocks(ray, limit)
    }
}

/// A mesh with normals at the corners of its triangles, interpolated between them.
pub struct Smooth {
    mesh: Arc<Mesh>,
    normals: Vec<[UnitVec3<f32>; 3]>,
}

impl Smooth {
    /// Uses the given normals at each triangle's corners, and the triangle's own normal where there
    /// is none.
    pub fn new(mesh: Arc<Mesh>, normals: &[[Vec3<f32>; 3]]) -> Self {
        let normals = normals
            .iter()
            .enumerate()
            .map(|(triangle, corners)| {
                let [v1, v2, v3] = mesh.corners(triangle);
                let own = normal::triangle(v1, v2, v3).unwrap_or(UnitVec3::Y);
                corners.map(|n| n.unit_or(own))
            })
            .collect();
        Self { mesh, normals }
    }

    /// Uses normals averaged at the vertices.
    pub fn averaged(mesh: Arc<Mesh>, share: Share) -> Self {
        let vertex = mesh.vertex_normals(share);
        let corners: Vec<_> = mesh
            .triangles
            .iter()
            .map(|corners| corners.map(|i| vertex[i]))
            .collect();
        Self::new(mesh, &corners)
    }
}

impl Surface for Smooth {
    fn hit(&self, ray: &Ray, limit: f32) -> Option<Hit> {
        let MeshHit {
            t,
            triangle,
            weights,
        } = self.mesh.nearest(ray, limit)?;
        let flat = self.mesh.facing(ray, triangle);
        // turns the normals of the corners to the visible side
        let corners = self.normals[triangle].map(|n| if n.dot(flat) < 0.0 { -n } else { n });
        let n = weighted(weights, corners.map(|n| *n)).unit_or(flat);

        let hit = Hit::new(ray, t, n);
        Some(Hit {
            lifted: hit.lifted + bulge(hit.p, weights, self.mesh.corners(triangle), corners),
            ..hit
        })
    }

    fn blocks(&self, ray: &Ray, limit: f32) -> bool {
        self.mesh.blocks(ray, limit)
    }
}

/// The offset from a point of a triangle to the curved surface that its normals describe. Without
/// it, each flat triangle would cast a visible shadow near the line between light and shadow.
///
/// Source: J. Hanika, *Hacking the shadow terminator*, Ray Tracing Gems II, 2021.
fn bulge(
    p: Vec3<f32>,
    weights: [f32; 3],
    corners: [Vec3<f32>; 3],
    normals: [UnitVec3<f32>; 3],
) -> Vec3<f32> {
    let onto_tangent_plane = |i: usize| *normals[i] * (corners[i] - p).dot(normals[i]).max(0.0);
    weighted(weights, [0, 1, 2].map(onto_tangent_plane))
}

fn weighted(weights: [f32; 3], [a, b, c]: [Vec3<f32>; 3]) -> Vec3<f32> {
    a * weights[0] + b * weights[1] + c * weights[2]
}
