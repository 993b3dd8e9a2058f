//! What is seen at each pixel: of a sphere, and of the Utah teapot with its exact normals.

use shading::f32::{UnitVec3, Vec3};
use shading::normal;

use patch::Patch;

#[path = "../../src/patch.rs"]
mod patch;

/// Looks from its eye at the origin.
#[derive(Clone, Copy)]
pub struct Camera {
    pub width: usize,
    pub height: usize,
    pub eye: Vec3,
    right: UnitVec3,
    up: UnitVec3,
    forward: UnitVec3,
    /// Pixels per unit at the distance 1.
    scale: f32,
}

/// Where the eye is as the page opens.
pub const EYE: Vec3 = Vec3::new(0.0, 1.0, 5.0);

/// A point as the camera sees it.
#[derive(Clone, Copy)]
pub struct Projected {
    pub x: f32,
    pub y: f32,
    /// The reciprocal of the depth.
    pub w: f32,
}

impl Camera {
    #[must_use]
    pub fn new(eye: Vec3, width: usize, height: usize) -> Self {
        let forward = (-eye).unit_or(UnitVec3::NEG_Z);
        let right = forward.cross(*UnitVec3::Y).unit_or(UnitVec3::X);
        Self {
            width,
            height,
            eye,
            right,
            up: UnitVec3::assume_unit(right.cross(*forward)),
            forward,
            scale: 1.75 * width.min(height) as f32,
        }
    }

    /// Through the center of a pixel.
    pub fn ray(&self, x: usize, y: usize) -> UnitVec3 {
        let right = (x as f32 + 0.5 - 0.5 * self.width as f32) / self.scale;
        let up = (0.5 * self.height as f32 - y as f32 - 0.5) / self.scale;
        (*self.forward + *self.right * right + *self.up * up).unit_or(self.forward)
    }

    /// Where a point appears; `None` behind the eye.
    #[must_use]
    pub fn project(&self, p: Vec3) -> Option<Projected> {
        let from_eye = p - self.eye;
        let depth = from_eye.dot(self.forward);
        (depth > 0.01).then(|| Projected {
            x: 0.5 * self.width as f32 + from_eye.dot(self.right) / depth * self.scale,
            y: 0.5 * self.height as f32 - from_eye.dot(self.up) / depth * self.scale,
            w: 1.0 / depth,
        })
    }

    /// The point that appears at this place, at the depth of another point.
    pub fn moved(&self, p: Vec3, [x, y]: [f32; 2]) -> Vec3 {
        let depth = (p - self.eye).dot(self.forward);
        let right = (x - 0.5 * self.width as f32) / self.scale;
        let up = (0.5 * self.height as f32 - y) / self.scale;
        self.eye + (*self.forward + *self.right * right + *self.up * up) * depth
    }
}

/// A visible point.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// The pixel, row by row.
    pub pixel: usize,
    pub p: Vec3,
    pub n: UnitVec3,
    pub v: UnitVec3,
}

/// The cosine and the sine of the angle by which the object is turned about y. The page computes both, because the
/// functions of two machines differ in their last bits.
pub type Turn = [f32; 2];

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Surface {
    Sphere,
    Teapot,
}

impl Surface {
    /// All visible points, in the order of their pixels.
    #[must_use]
    pub fn seen_by(self, camera: &Camera, turn: Turn) -> Vec<Point> {
        match self {
            Self::Sphere => sphere(camera),
            Self::Teapot => teapot(camera, turn),
        }
    }
}

/// Of radius 1 at the origin.
fn sphere(camera: &Camera) -> Vec<Point> {
    let seen = |pixel| {
        let ray = camera.ray(pixel % camera.width, pixel / camera.width);
        let b = camera.eye.dot(ray);
        let discriminant = b * b - camera.eye.dot(camera.eye) + 1.0;
        let root = (discriminant >= 0.0).then(|| discriminant.sqrt())?;
        let p = camera.eye - *ray * (b + root);
        let n = normal::sphere(Vec3::ZERO, p)?;
        Some(Point {
            pixel,
            p,
            n,
            v: -ray,
        })
    };
    (0..camera.width * camera.height).filter_map(seen).collect()
}

/// The number of squares along each side of a patch; each square has two triangles.
const FINENESS: usize = 16;

/// The triangles only find the patch and its parameters; point and normal come from the patch itself.
fn teapot(camera: &Camera, turn: Turn) -> Vec<Point> {
    let patches: Vec<Patch> = patches(turn).collect();
    let mut raster = Raster::new(camera);
    for (number, patch) in patches.iter().enumerate() {
        let corner = |i: usize, j: usize| {
            let uv = [i, j].map(|k| k as f32 / FINENESS as f32);
            camera.project(patch.at(uv[0], uv[1])).map(|at| (at, uv))
        };
        for (i, j) in (0..FINENESS * FINENESS).map(|k| (k / FINENESS, k % FINENESS)) {
            let [a, b, c, d] =
                [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| corner(i, j));
            for triangle in [[a, b, c], [a, c, d]] {
                if let [Some(a), Some(b), Some(c)] = triangle {
                    raster.fill(number, [a, b, c]);
                }
            }
        }
    }
    let seen = |(pixel, found)| {
        let &Found { w, patch, u, v } = found;
        let patch: &Patch = &patches[patch];
        let p = (w > 0.0).then(|| patch.at(u, v))?;
        let to_eye = (camera.eye - p).unit()?;
        let face = patch.normal(u, v)?; // exact, so it is the face's normal, too
        let n = normal::facing(face, to_eye, face);
        Some(Point {
            pixel,
            p,
            n,
            v: to_eye,
        })
    };
    raster.found.iter().enumerate().filter_map(seen).collect()
}

include!(concat!(env!("OUT_DIR"), "/teapot.rs"));

/// The file has z pointing up; here y does.
pub fn patches([cosine, sine]: Turn) -> impl Iterator<Item = Patch> {
    let point = move |[x, y, z]: [f32; 3]| {
        let Vec3 { x, y, z } = Vec3::new(x - 0.2, z - 1.5, -y) * 0.4;
        Vec3::new(cosine * x + sine * z, y, cosine * z - sine * x)
    };
    PATCHES
        .iter()
        .map(move |patch| Patch(patch.map(|i| point(POINTS[usize::from(i)]))))
}

/// The nearest surface at a pixel.
#[derive(Clone, Copy, Default)]
pub struct Found {
    /// The reciprocal of the depth; 0 where nothing is.
    pub w: f32,
    pub patch: usize,
    pub u: f32,
    pub v: f32,
}

pub struct Raster {
    width: usize,
    height: usize,
    pub found: Vec<Found>,
}

impl Raster {
    pub fn new(&Camera { width, height, .. }: &Camera) -> Self {
        Self {
            width,
            height,
            found: vec![Found::default(); width * height],
        }
    }

    /// Draws a triangle whose corners have parameters, at the pixels where nothing nearer was found.
    pub fn fill(&mut self, patch: usize, corners: [(Projected, [f32; 2]); 3]) {
        let [a, b, c] = corners.map(|(at, _)| at);
        let area = |p: [f32; 2], q: Projected, r: Projected| {
            (q.x - p[0]) * (r.y - p[1]) - (q.y - p[1]) * (r.x - p[0])
        };
        let whole = area([a.x, a.y], b, c);
        if whole == 0.0 {
            return; // a line or a point
        }
        // the pixels whose centers may be inside; a negative number becomes 0
        let ends = |along: [f32; 3], end| {
            let low = along[0].min(along[1]).min(along[2]) - 0.5;
            let high = along[0].max(along[1]).max(along[2]) + 0.5;
            (low as usize).min(end)..(high.max(0.0) as usize).min(end)
        };
        for y in ends([a.y, b.y, c.y], self.height) {
            for x in ends([a.x, b.x, c.x], self.width) {
                let center = [x as f32 + 0.5, y as f32 + 0.5];
                let shares = [area(center, b, c), area(center, c, a), area(center, a, b)]
                    .map(|part| part / whole);
                let [i, j, k] = shares;
                let w = i * a.w + j * b.w + k * c.w;
                let found = &mut self.found[y * self.width + x];
                if shares.iter().all(|&share| share >= 0.0) && w > found.w {
                    // linear on the surface, not on the screen
                    let [(_, s), (_, t), (_, r)] = corners;
                    let [u, v] =
                        [0, 1].map(|n| (i * a.w * s[n] + j * b.w * t[n] + k * c.w * r[n]) / w);
                    *found = Found {
                        w,
                        patch,
                        u: u.clamp(0.0, 1.0),
                        v: v.clamp(0.0, 1.0),
                    };
                }
            }
        }
    }
}
