//! The Utah teapot, directly from its 32 Bézier patches: the normals come from the function that
//! maps (u, v) to a point, and no derivative is written by hand.

use std::sync::Arc;

use shading::{DirectionalLight, Light, Real, Rgb, UnitVec3, Vec3, normal};

use super::{Picture, STUDIO, empty, floor, glossy, matte, toward};
use crate::render::mesh::{Mesh, MeshHit};
use crate::render::ray::{Camera, Hit, Ray, Surface};
use crate::render::scene::{Finish, Object, Scene};

const DATA: &str = include_str!("../../data/teapot.bezier");

pub fn pictures() -> Vec<Picture> {
    let copper = glossy(Rgb::new(0.5, 0.17, 0.07), 0.5, 60);
    vec![
        Picture::new(
            "16_teapot",
            &["the Utah teapot, from its B\u{e9}zier patches"],
            table(move |_| copper),
        )
        .for_readme(),
        Picture::new(
            "17_teapot_patches",
            &["its 32 patches"],
            table(|hit| patchwork(hit.part)),
        ),
    ]
}

fn table(paint: impl Fn(&Hit) -> Finish + Sync + 'static) -> Scene {
    let camera = Camera::perspective([-1.6, 3.0, 7.4], [0.1, 0.72, 0.0], 21.0);
    Scene {
        objects: vec![
            floor(matte(Rgb::gray(0.16))),
            Object::painted(Teapot::new(), paint),
        ],
        lights: vec![
            Light::Directional(DirectionalLight {
                l: toward(-0.7, 0.9, 0.6),
                intensity: Rgb::new(0.95, 0.9, 0.82),
            }),
            Light::Directional(DirectionalLight {
                l: toward(0.9, 0.5, 0.6),
                intensity: Rgb::new(0.14, 0.18, 0.25),
            }),
        ],
        ..empty(camera, STUDIO)
    }
}

/// A color for each patch, different from the neighbors' colors.
fn patchwork(patch: usize) -> Finish {
    const COLORS: [Rgb<f32>; 4] = [
        Rgb::new(0.62, 0.16, 0.08),
        Rgb::new(0.6, 0.42, 0.1),
        Rgb::new(0.07, 0.32, 0.34),
        Rgb::new(0.5, 0.46, 0.38),
    ];
    // four patches around the pot form a ring; the next ring begins with the next color
    glossy(COLORS[(patch + patch / 4) % 4], 0.4, 60)
}

/// A bicubic Bézier patch.
struct Patch([[Vec3<f32>; 4]; 4]);

impl Patch {
    /// Σ Bᵢ(u) Bⱼ(v) Pᵢⱼ with Bernstein polynomials.
    fn at<T: Real>(&self, u: T, v: T) -> Vec3<T> {
        let (b_u, b_v) = (bernstein(u), bernstein(v));
        let mut p = Vec3::ZERO;
        for (row, b_u) in self.0.iter().zip(b_u) {
            for (control, b_v) in row.iter().zip(b_v) {
                p += control.map(|c| T::of(c.into())) * (b_u * b_v);
            }
        }
        p
    }

    /// The outward normal. The patches are written such that ∂s/∂u × ∂s/∂v points inward, so v
    /// comes before u.
    fn normal(&self, u: f32, v: f32) -> Option<UnitVec3<f32>> {
        normal::parametric(|v, u| self.at(u, v), v, u)
    }
}

fn bernstein<T: Real>(t: T) -> [T; 4] {
    let (s, three) = (T::ONE - t, T::of(3.0));
    [s * s * s, three * s * s * t, three * s * t * t, t * t * t]
}

/// The patches, and a fine mesh of them that finds the patch and the point that a ray hits.
struct Teapot {
    patches: Vec<Patch>,
    mesh: Arc<Mesh>,
    /// The patch of each triangle, and the (u, v) of the triangle's corners.
    parameters: Vec<(usize, [[f32; 2]; 3])>,
}

impl Teapot {
    /// The number of squares along each side of a patch; each square has two triangles.
    const FINENESS: usize = 24;

    fn new() -> Self {
        let patches = patches(DATA);
        let mut positions = Vec::new();
        let mut triangles = Vec::new();
        let mut parameters = Vec::new();
        for (number, patch) in patches.iter().enumerate() {
            for corners in squares() {
                // at the poles of the lid and the bottom, one side of the square is a point
                let points = corners.map(|[u, v]| patch.at(u, v));
                if normal::triangle(points[0], points[1], points[2]).is_some() {
                    let first = positions.len();
                    positions.extend(points);
                    triangles.push([first, first + 1, first + 2]);
                    parameters.push((number, corners));
                }
            }
        }
        Self {
            patches,
            mesh: Arc::new(Mesh::new(positions, triangles)),
            parameters,
        }
    }
}

/// The triangles into which the square of all (u, v) is divided.
fn squares() -> impl Iterator<Item = [[f32; 2]; 3]> {
    const N: usize = Teapot::FINENESS;
    let at = |i: usize| i as f32 / N as f32;
    (0..N * N).flat_map(move |i| {
        let [u, v] = [i / N, i % N];
        let [a, b] = [[at(u), at(v)], [at(u + 1), at(v)]];
        let [c, d] = [[at(u + 1), at(v + 1)], [at(u), at(v + 1)]];
        [[a, b, c], [a, c, d]]
    })
}

impl Surface for Teapot {
    fn hit(&self, ray: &Ray, limit: f32) -> Option<Hit> {
        /// The step inward from a pole, where all v are one point and there is no tangent.
        const ASIDE: f32 = 1e-3;
        let MeshHit {
            t,
            triangle,
            weights,
        } = self.mesh.nearest(ray, limit)?;
        let (part, corners) = self.parameters[triangle];
        let [u, v] = [0, 1].map(|i| (0..3).map(|k| weights[k] * corners[k][i]).sum());
        let patch = &self.patches[part];
        let n = patch
            .normal(u, v)
            .or_else(|| patch.normal(u + ASIDE * (0.5 - u), v + ASIDE * (0.5 - v)))
            .unwrap_or(-ray.direction);
        // on the patch itself, so that its own mesh does not shade it
        Some(Hit {
            part,
            ..Hit::on(patch.at(u, v), t, n)
        })
    }

    fn blocks(&self, ray: &Ray, limit: f32) -> bool {
        self.mesh.blocks(ray, limit)
    }
}

/// Reads lines `v x y z`, and lines `p` with the indices of 16 points, counted from 0. In the file,
/// z points up; here y does, and a unit is half as long.
fn patches(data: &str) -> Vec<Patch> {
    let mut points: Vec<Vec3<f32>> = Vec::new();
    let mut patches = Vec::new();
    for line in data.lines() {
        let mut words = line.split_whitespace();
        let kind = words.next();
        let numbers: Vec<f32> = words.filter_map(|word| word.parse().ok()).collect();
        match (kind, &numbers[..]) {
            (Some("v"), &[x, y, z]) => points.push(Vec3::new(x, z, -y) * 0.5),
            (Some("p"), indices) if indices.len() == 16 => {
                let control = |i: usize, j: usize| points[indices[4 * i + j] as usize];
                patches.push(Patch(std::array::from_fn(|i| {
                    std::array::from_fn(|j| control(i, j))
                })));
            }
            _ => {}
        }
    }
    patches
}
