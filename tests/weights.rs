//! Why `normal::corner` weights by the angle. Angle weights, Max's weights, and area weights are
//! compared on meshes with the exact normals of the surfaces that the meshes lie on.
//!
//! The mean errors are the table in the documentation of `normal::corner`.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};
use std::fmt::Write;

use shading::f64::Vec3;
use shading::{Real, normal};

const PAGE: &str = include_str!("../src/normal/corner.rs");

#[test]
fn table_of_weights_has_the_measured_values() {
    let meshes = [
        ("the teapot, all squares split alike", teapot(false, 0.0)),
        ("the teapot, each square split at random", teapot(true, 0.0)),
        (
            "the same, with its vertices moved at random",
            teapot(true, 0.2),
        ),
        ("the bunny", bunny()),
        ("a sphere, equally irregular", sphere()),
    ];
    let mut measured = String::new();
    for (surface, mesh) in meshes {
        let [angle, max, area] = [normal::corner, by_max, by_area].map(|share| mesh.error(share));
        let row = format!("/// | {surface} | {angle:.2}° | {max:.2}° | {area:.2}° |");
        writeln!(measured, "{row}").expect("a string");
    }
    println!("{measured}");
    assert!(PAGE.contains(&measured), "the page lacks\n{measured}");
}

/// A triangle's contribution to the normal of its first vertex.
type Share = fn(Vec3, Vec3, Vec3) -> Vec3;

/// Source: N. Max, *Weights for computing vertex normals from facet normals*, 1999.
fn by_max(v1: Vec3, v2: Vec3, v3: Vec3) -> Vec3 {
    let (e1, e2) = (v2 - v1, v3 - v1);
    e1.cross(e2) / (e1.dot(e1) * e2.dot(e2))
}

fn by_area(v1: Vec3, v2: Vec3, v3: Vec3) -> Vec3 {
    (v2 - v1).cross(v3 - v1)
}

#[derive(Default)]
struct Mesh {
    positions: Vec<Vec3>,
    triangles: Vec<[usize; 3]>,
    /// The exact surface normals at those vertices that the mesh surrounds completely.
    exact: BTreeMap<usize, Vec3>,
}

impl Mesh {
    /// The mean angle in degrees between the vertex normals and the exact ones.
    fn error(&self, share: Share) -> f64 {
        let mut sums = vec![Vec3::ZERO; self.positions.len()];
        for &[a, b, c] in &self.triangles {
            for [i, j, k] in [[a, b, c], [b, c, a], [c, a, b]] {
                sums[i] += share(self.positions[i], self.positions[j], self.positions[k]);
            }
        }
        let angles = self.exact.iter().map(|(&i, exact)| {
            let n = sums[i].unit().expect("a normal");
            n.cross(*exact).length().atan2(n.dot(*exact)).to_degrees()
        });
        #[allow(clippy::cast_precision_loss)] // at most a few thousand
        let count = self.exact.len() as f64;
        angles.sum::<f64>() / count
    }

    /// Two triangles for a square, counter-clockwise, split along one diagonal or the other.
    fn square(&mut self, [a, b, c, d]: [usize; 4], other_way: bool) {
        self.triangles.extend(if other_way {
            [[a, b, d], [b, c, d]]
        } else {
            [[a, b, c], [a, c, d]]
        });
    }
}

/// Numbers in [−1, 1), the same in each run: Knuth's linear congruential generator.
struct Random(u64);

impl Random {
    #[allow(clippy::cast_possible_truncation)] // the upper bits
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        f64::from((self.0 >> 32) as i32) / f64::from(1_u32 << 31)
    }
}

/// The Utah teapot, with a separate grid for each patch.
fn teapot(either_way: bool, jitter: f64) -> Mesh {
    const N: usize = 16;
    let mut random = Random(1);
    let mut mesh = Mesh::default();
    for patch in patches() {
        let first = mesh.positions.len();
        for (i, j) in grid(N + 1, N + 1) {
            let mut parameter = |i: usize| {
                let moved = if 0 < i && i < N {
                    jitter * random.next()
                } else {
                    0.0
                };
                (as_f64(i) + moved) / as_f64(N)
            };
            let (u, v) = (parameter(i), parameter(j));
            if (1..N).contains(&i) && (1..N).contains(&j) {
                let n = normal::parametric(|u, v| bezier(&patch, u, v), u, v).expect("smooth");
                mesh.exact.insert(mesh.positions.len(), *n);
            }
            mesh.positions.push(bezier(&patch, u, v));
        }
        for (i, j) in grid(N, N) {
            let at = |i, j| first + i * (N + 1) + j;
            let corners = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            mesh.square(corners, either_way && random.next() < 0.0);
        }
    }
    mesh
}

fn grid(rows: usize, columns: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..rows * columns).map(move |i| (i / columns, i % columns))
}

#[allow(clippy::cast_precision_loss)] // small numbers
fn as_f64(i: usize) -> f64 {
    i as f64
}

/// The control points of the teapot's patches.
fn patches() -> Vec<Vec<Vec3>> {
    let file = include_str!("../examples/gallery/data/teapot.bezier");
    let points: Vec<Vec3> = numbers(file, "v ")
        .map(|xyz| Vec3::new(xyz[0], xyz[1], xyz[2]))
        .collect();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // indices
    let patch = |indices: Vec<f64>| indices.into_iter().map(|i| points[i as usize]).collect();
    numbers(file, "p ").map(patch).collect()
}

/// The numbers on those lines of a file that begin with `beginning`.
fn numbers<'a>(file: &'a str, beginning: &'a str) -> impl Iterator<Item = Vec<f64>> + 'a {
    let lines = file
        .lines()
        .filter_map(move |line| line.strip_prefix(beginning));
    lines.map(|line| {
        let words = line.split_whitespace();
        words.map(|word| word.parse().expect("a number")).collect()
    })
}

/// Σ Bᵢ(u) Bⱼ(v) Pᵢⱼ
fn bezier<T: Real>(control: &[Vec3], u: T, v: T) -> shading::Vec3<T> {
    let bernstein = |t: T| {
        let (s, three) = (T::ONE - t, T::of(3.0));
        [s * s * s, three * s * s * t, three * s * t * t, t * t * t]
    };
    let (along_u, along_v) = (bernstein(u), bernstein(v));
    let points = control.iter().enumerate();
    points.fold(shading::Vec3::ZERO, |sum, (i, p)| {
        sum + p.map(T::of) * (along_u[i / 4] * along_v[i % 4])
    })
}

/// The Stanford bunny, with its vertices moved onto the limit surface of Loop subdivision, which
/// has exact normals there.
///
/// Source: Hoppe, DeRose et al., *Piecewise smooth surface reconstruction*, 1994, appendix.
fn bunny() -> Mesh {
    let file = include_str!("../examples/gallery/data/bunny.obj");
    let control: Vec<Vec3> = numbers(file, "v ")
        .map(|xyz| Vec3::new(xyz[0], xyz[1], xyz[2]))
        .collect();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // indices start at 1
    let triangles: Vec<[usize; 3]> = numbers(file, "f ")
        .map(|abc| [0, 1, 2].map(|i| abc[i] as usize - 1))
        .collect();
    // for each vertex: which neighbor follows which
    let mut next = vec![BTreeMap::new(); control.len()];
    for &[a, b, c] in &triangles {
        for [i, j, k] in [[a, b, c], [b, c, a], [c, a, b]] {
            next[i].insert(j, k);
        }
    }
    let mut mesh = Mesh {
        triangles,
        ..Mesh::default()
    };
    for (vertex, next) in next.iter().enumerate() {
        let mut neighbor = *next.keys().next().expect("a neighbor");
        let valence = as_f64(next.len());
        let c = 3.0 / 8.0 + (TAU / valence).cos() / 4.0;
        let omega = 3.0 / 8.0 * valence / (5.0 / 8.0 - c * c);
        let mut point = control[vertex] * omega;
        let mut tangents = [Vec3::ZERO; 2];
        for k in 0..next.len() {
            let (sin, cos) = (TAU * as_f64(k) / valence).sin_cos();
            point += control[neighbor];
            tangents[0] += control[neighbor] * cos;
            tangents[1] += control[neighbor] * sin;
            neighbor = next[&neighbor]; // the bunny has no holes
        }
        mesh.positions.push(point / (omega + valence));
        mesh.exact.insert(
            vertex,
            *normal::from_tangents(tangents[0], tangents[1]).expect("smooth"),
        );
    }
    mesh
}

/// A unit sphere of parallels and meridians, with its vertices moved at random.
fn sphere() -> Mesh {
    const ROWS: usize = 12;
    const COLUMNS: usize = 24;
    let mut random = Random(1);
    let mut mesh = Mesh::default();
    for (i, j) in grid(ROWS - 1, COLUMNS) {
        let polar = PI * (as_f64(i + 1) + 0.2 * random.next()) / as_f64(ROWS);
        let azimuth = TAU * (as_f64(j) + 0.2 * random.next()) / as_f64(COLUMNS);
        let p = Vec3::new(
            polar.sin() * azimuth.cos(),
            polar.sin() * azimuth.sin(),
            polar.cos(),
        );
        if (1..ROWS - 2).contains(&i) {
            mesh.exact.insert(mesh.positions.len(), p);
        }
        mesh.positions.push(p);
    }
    for (i, j) in grid(ROWS - 2, COLUMNS) {
        let at = |i, j| i * COLUMNS + j % COLUMNS;
        let corners = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        mesh.square(corners, random.next() < 0.0);
    }
    mesh
}
