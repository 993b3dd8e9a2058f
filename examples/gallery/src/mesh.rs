//! Triangle meshes: a bounding volume hierarchy, the Stanford bunny, and the Utah teapot from its Bézier patches.

use shading::f32::{UnitVec3, Vec3};
use shading::{Real, normal};

use crate::render::{Meeting, Ray, Surface};

type Bounds = [[f32; 3]; 2];

/// The triangles whose boxes a ray enters (Kay and Kajiya, *Ray tracing complex scenes*, 1986).
enum Tree {
    Leaf(Bounds, Vec<usize>),
    Inner(Bounds, Box<[Tree; 2]>),
}

fn joined(a: Bounds, b: Bounds) -> Bounds {
    let each =
        |k: usize, choose: fn(f32, f32) -> f32| std::array::from_fn(|i| choose(a[k][i], b[k][i]));
    [each(0, f32::min), each(1, f32::max)]
}

impl Tree {
    fn new(bounds: &[Bounds], items: &mut [usize]) -> Self {
        let around = items
            .iter()
            .map(|&i| bounds[i])
            .reduce(joined)
            .expect("a triangle");
        if items.len() <= 4 {
            return Self::Leaf(around, items.to_vec());
        }
        let side = |axis: &usize| around[1][*axis] - around[0][*axis];
        let axis = (0..3)
            .max_by(|a, b| side(a).total_cmp(&side(b)))
            .unwrap_or(0);
        let center = |i: &usize| bounds[*i][0][axis] + bounds[*i][1][axis];
        let half = items.len() / 2;
        items.select_nth_unstable_by(half, |a, b| center(a).total_cmp(&center(b)));
        let (low, high) = items.split_at_mut(half);
        Self::Inner(
            around,
            Box::new([Self::new(bounds, low), Self::new(bounds, high)]),
        )
    }

    /// Calls `visit` for the triangles of each box that a ray enters before the limit, which `visit` may lower.
    fn walk(&self, ray: &Ray, limit: &mut f32, visit: &mut impl FnMut(usize, &mut f32)) {
        let (Self::Leaf(around, _) | Self::Inner(around, _)) = self;
        let [origin, along] = [ray.origin, *ray.along].map(<[f32; 3]>::from);
        let (mut enter, mut leave) = (0.0_f32, *limit);
        for i in 0..3 {
            let [a, b] = [0, 1].map(|end| (around[end][i] - origin[i]) / along[i]);
            // min and max ignore the NaN of a ray that lies in a side of the box
            (enter, leave) = (enter.max(a.min(b)), leave.min(a.max(b)));
        }
        match self {
            _ if enter > leave => {}
            Self::Leaf(_, items) => items.iter().for_each(|&item| visit(item, limit)),
            Self::Inner(_, children) => children
                .iter()
                .for_each(|child| child.walk(ray, limit, visit)),
        }
    }
}

/// The normal at a point of a triangle, from the weights of its corners.
type Normal = Box<dyn Fn(usize, [f32; 3]) -> (Option<Vec3>, Option<UnitVec3>) + Sync>;

pub struct Mesh {
    corners: Vec<[Vec3; 3]>,
    tree: Tree,
    normal: Normal,
}

impl Mesh {
    fn new(corners: Vec<[Vec3; 3]>, normal: Normal) -> Self {
        let bounds = |triangle: &[Vec3; 3]| {
            let [a, b, c] = triangle.map(|p| [<[f32; 3]>::from(p); 2]);
            joined(joined(a, b), c)
        };
        let bounds: Vec<_> = corners.iter().map(bounds).collect();
        let tree = Tree::new(&bounds, &mut (0..corners.len()).collect::<Vec<_>>());
        Self {
            corners,
            tree,
            normal,
        }
    }
}

impl Surface for Mesh {
    /// Möller and Trumbore, *Fast, minimum storage ray–triangle intersection*, 1997.
    fn meet(&self, ray: &Ray, mut limit: f32) -> Option<Meeting> {
        let mut nearest = None;
        self.tree.walk(ray, &mut limit, &mut |triangle, limit| {
            let [v1, v2, v3] = self.corners[triangle];
            let (e1, e2, s) = (v2 - v1, v3 - v1, ray.origin - v1);
            let (h, q) = (ray.along.cross(e2), s.cross(e1));
            let scale = 1.0 / e1.dot(h);
            let [b, c, t] = [s.dot(h), ray.along.dot(q), e2.dot(q)].map(|x| x * scale);
            let weights = [1.0 - b - c, b, c];
            // rounding must not open a gap between two triangles
            if weights.iter().all(|&w| w >= -1e-6) && 0.0 < t && t < *limit {
                *limit = t;
                nearest = Some(Meeting {
                    t,
                    triangle,
                    weights,
                });
            }
        });
        nearest
    }

    fn place(&self, ray: &Ray, meeting: &Meeting) -> (Vec3, Option<UnitVec3>) {
        let (p, n) = (self.normal)(meeting.triangle, meeting.weights);
        let [a, b, c] = self.corners[meeting.triangle];
        let face = normal::triangle(a, b, c);
        (
            p.unwrap_or(ray.at(meeting.t)),
            n.map(|n| normal::facing(n, -ray.along, face.unwrap_or(n))),
        )
    }
}

/// Numbers of the lines that begin with a word.
fn lines<const N: usize>(text: &'static str, word: &'static str) -> impl Iterator<Item = [f32; N]> {
    text.lines().filter_map(move |line| {
        let numbers = line
            .strip_prefix(word)?
            .split_whitespace()
            .map(|number| number.parse().ok());
        numbers.collect::<Option<Vec<f32>>>()?.try_into().ok()
    })
}

fn weighted(weights: [f32; 3], corners: [Vec3; 3]) -> Vec3 {
    (0..3).map(|i| corners[i] * weights[i]).sum()
}

/// The bunny, two units high on the floor y = 0, with a normal for each triangle or for each vertex.
pub fn bunny(smooth: bool) -> Mesh {
    let file = include_str!("../data/bunny.obj");
    let points: Vec<Vec3> = lines(file, "v ").map(Vec3::from).collect();
    let faces: Vec<[usize; 3]> = lines(file, "f ")
        .map(|face: [f32; 3]| face.map(|i| i as usize - 1))
        .collect();
    let end = |axis: fn(&Vec3) -> f32, choose: fn(f32, f32) -> f32| {
        points.iter().map(axis).reduce(choose).unwrap_or(0.0)
    };
    let [x, z] = [|p: &Vec3| p.x, |p: &Vec3| p.z]
        .map(|axis| 0.5 * (end(axis, f32::min) + end(axis, f32::max)));
    let (floor, top) = (end(|p| p.y, f32::min), end(|p| p.y, f32::max));
    let place = |p: &Vec3| (*p - Vec3::new(x, floor, z)) * (2.0 / (top - floor));
    let points: Vec<Vec3> = points.iter().map(place).collect();
    let mut normals = vec![Vec3::ZERO; points.len()];
    for &[a, b, c] in &faces {
        for [i, j, k] in [[a, b, c], [b, c, a], [c, a, b]] {
            normals[i] += normal::corner(points[i], points[j], points[k]);
        }
    }
    let corners: Vec<_> = faces.iter().map(|face| face.map(|i| points[i])).collect();
    let triangles = corners.clone();
    let normal: Normal = Box::new(move |i, weights| {
        let [a, b, c] = triangles[i];
        let n = smooth.then(|| weighted(weights, faces[i].map(|k| normals[k])).unit());
        (None, n.unwrap_or_else(|| normal::triangle(a, b, c)))
    });
    Mesh::new(corners, normal)
}

/// A bicubic Bézier patch.
#[derive(Clone, Copy)]
struct Patch([Vec3; 16]);

impl Patch {
    /// Σ Bᵢ(u) Bⱼ(v) Pᵢⱼ with Bernstein's polynomials.
    fn at<T: Real>(&self, u: T, v: T) -> shading::Vec3<T> {
        let bernstein = |t: T| {
            let (s, three) = (T::ONE - t, T::of_f32(3.0));
            [s * s * s, three * s * s * t, three * s * t * t, t * t * t]
        };
        let (b_u, b_v) = (bernstein(u), bernstein(v));
        let term = |i: usize| self.0[i].map(T::of_f32) * (b_u[i / 4] * b_v[i % 4]);
        (1..16).fold(term(0), |sum, i| sum + term(i))
    }

    /// The outward normal: v comes before u. At a pole, where all v are one point, it is taken slightly inside.
    fn normal(&self, [u, v]: [f32; 2]) -> Option<UnitVec3> {
        let inside = |t: f32| t.clamp(1e-3, 1.0 - 1e-3);
        let mut places = [[u, v], [inside(u), inside(v)]].into_iter();
        places.find_map(|[u, v]| normal::parametric(|v, u| self.at(u, v), v, u))
    }
}

/// The teapot. Its mesh only finds the patch and (u, v); the point and the normal come from the patch itself.
pub fn teapot() -> Mesh {
    const N: usize = 24; // squares along each side of a patch
    let file = include_str!("../data/teapot.bezier");
    let points: Vec<Vec3> = lines(file, "v ")
        .map(|[x, y, z]| Vec3::new(x, z, -y) * 0.5)
        .collect();
    let patch = |indices: [f32; 16]| Patch(indices.map(|i| points[i as usize]));
    let mut found = Vec::new();
    for patch in lines(file, "p ").map(patch) {
        for square in 0..N * N {
            let at = |i: usize, j: usize| {
                [
                    (square / N + i) as f32 / N as f32,
                    (square % N + j) as f32 / N as f32,
                ]
            };
            let (a, c) = (at(0, 0), at(1, 1));
            // counter-clockwise from outside, where v comes before u
            found.extend([(patch, [a, c, at(1, 0)]), (patch, [a, at(0, 1), c])]);
        }
    }
    let corners = found
        .iter()
        .map(|(patch, uv)| uv.map(|[u, v]| patch.at(u, v)))
        .collect();
    let normal: Normal = Box::new(move |i, weights| {
        let (patch, uv) = &found[i];
        let [u, v] = [0, 1].map(|k| {
            (0..3)
                .map(|i| weights[i] * uv[i][k])
                .sum::<f32>()
                .clamp(0.0, 1.0)
        });
        (Some(patch.at(u, v)), patch.normal([u, v]))
    });
    Mesh::new(corners, normal)
}
