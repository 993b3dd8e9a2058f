//! The object as a coarse mesh, shaded once for each triangle or once for each of its corners.

use shading::f32::{Rgb, UnitVec3, Vec3};
use shading::normal;

use crate::scene::Scene;
use crate::surface::{Camera, Point, Raster, Surface, Turn, patches};

/// The squares along each side of a patch of the teapot, and the triangles along each edge of the octahedron that
/// becomes the sphere.
const OF_PATCH: usize = 3;
const OF_FACE: usize = 4;

/// Points of the surface and its normals there.
type Triangle = [(Vec3, UnitVec3); 3];

/// The light of each pixel where something is seen: mixed of the triangle's corners, as Gouraud did, or
/// that of its center and its face.
pub fn shaded(
    scene: &Scene,
    surface: Surface,
    turn: Turn,
    camera: &Camera,
    is_smooth: bool,
) -> Vec<(usize, Rgb)> {
    let triangles = match surface {
        Surface::Sphere => sphere(),
        Surface::Teapot => teapot(turn),
    };
    let mut raster = Raster::new(camera);
    for (number, triangle) in triangles.iter().enumerate() {
        // the raster's parameters are the shares of the second and the third corner
        if let [Some(a), Some(b), Some(c)] = triangle.map(|(p, _)| camera.project(p)) {
            raster.fill(number, [(a, [0.0, 0.0]), (b, [1.0, 0.0]), (c, [0.0, 1.0])]);
        }
    }
    let light = |(p, n): (Vec3, UnitVec3)| {
        let v = (camera.eye - p).unit_or(UnitVec3::Z);
        let n = normal::facing(n, v, n);
        scene.shaded(&Point { pixel: 0, p, n, v }).total()
    };
    let colors = triangles.iter().map(|triangle| {
        if is_smooth {
            return triangle.map(light);
        }
        let [a, b, c] = triangle.map(|(p, _)| p);
        let face = normal::triangle(a, b, c).unwrap_or(triangle[0].1);
        [light(((a + b + c) * (1.0 / 3.0), face)); 3]
    });
    let colors: Vec<[Rgb; 3]> = colors.collect();
    let found = raster.found.iter().enumerate();
    found
        .filter(|(_, found)| found.w > 0.0)
        .map(|(pixel, found)| {
            let [a, b, c] = colors[found.patch];
            let rest = (1.0 - found.u - found.v).max(0.0);
            (pixel, a * rest + b * found.u + c * found.v)
        })
        .collect()
}

/// Each face of an octahedron in small triangles, whose corners are moved to the sphere.
fn sphere() -> Vec<Triangle> {
    let mut triangles = Vec::new();
    for signs in 0..8 {
        let sign = |axis: usize| if signs >> axis & 1 == 1 { -1.0 } else { 1.0 };
        let corner = |i: usize, j: usize| {
            let [x, y, z] = [i, j, OF_FACE - i - j].map(|k| k as f32);
            let n = Vec3::new(sign(0) * x, sign(1) * y, sign(2) * z).unit_or(UnitVec3::Z);
            (*n, n)
        };
        for (i, j) in (0..OF_FACE * OF_FACE).map(|k| (k / OF_FACE, k % OF_FACE)) {
            if i + j < OF_FACE {
                triangles.push([corner(i, j), corner(i + 1, j), corner(i, j + 1)]);
            }
            if i + j + 1 < OF_FACE {
                triangles.push([corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)]);
            }
        }
    }
    triangles
}

/// The teapot's patches in squares, and these in two triangles each.
fn teapot(turn: Turn) -> Vec<Triangle> {
    let mut triangles = Vec::new();
    for patch in patches(turn) {
        let corner = |i: usize, j: usize| {
            let [u, v] = [i, j].map(|k| k as f32 / OF_PATCH as f32);
            let n = patch.normal(u, v).unwrap_or(UnitVec3::Y);
            (patch.at(u, v), n)
        };
        for (i, j) in (0..OF_PATCH * OF_PATCH).map(|k| (k / OF_PATCH, k % OF_PATCH)) {
            let [a, b, c, d] =
                [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| corner(i, j));
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    triangles
}
