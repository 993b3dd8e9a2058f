//! The gallery's scene of four pictures: the points that the eye sees, found by marching.
//!
//! Source: J. C. Hart, *Sphere tracing*, The Visual Computer 12, 1996.

use bytemuck::Zeroable;
use kernel::buffers::{GpuLight, GpuMaterial, Point};
use kernel::scene::{BALL, CUBE, FLOOR, RING, surface};
use shading::f32::{Rgb, UnitVec3, Vec3};
use shading::normal;

const FARTHEST: f32 = 40.0;
const NEAR: f32 = 1e-5;
const STEPS: usize = 600;
/// How far above its surface a shadow ray starts.
const LIFT: f32 = 1e-3;

const EYE: Vec3 = Vec3::new(0.0, 2.7, 7.2);
const TARGET: Vec3 = Vec3::new(0.16, 0.7, 0.0);
/// The tangent of half of 41°.
const TANGENT: f32 = 0.373_884_7;

pub fn lights() -> [GpuLight; 1] {
    [GpuLight {
        position: Vec3::new(-3.2, 5.2, 4.2),
        intensity: Rgb::gray(0.95),
        cosine: -1.0,
        coefficients: Vec3::new(1.0, 0.0, 0.0),
        ..GpuLight::zeroed()
    }]
}

/// In the order of the surfaces.
pub fn materials() -> [GpuMaterial; 4] {
    let glossy = |color, k_s, m| GpuMaterial {
        k_a: color,
        m,
        k_d: color,
        k_s: Rgb::gray(k_s),
        ..GpuMaterial::zeroed()
    };
    [
        glossy(Rgb::gray(0.24), 0.25, 12.0),
        glossy(Rgb::new(0.66, 0.07, 0.05), 0.8, 30.0),
        glossy(Rgb::new(0.72, 0.42, 0.06), 0.8, 25.0),
        glossy(Rgb::new(0.06, 0.2, 0.55), 0.8, 20.0),
    ]
}

/// What is visible at a place of the picture: x and y go from −1 to 1, to the right and up.
pub fn seen(x: f32, y: f32) -> Option<Point> {
    let forward = (TARGET - EYE).unit()?;
    let right = forward.cross(*UnitVec3::Y).unit()?;
    let up = right.cross(*forward);
    let ray = (*forward + (*right * x + up * y) * TANGENT).unit()?;
    let (p, object) = march(EYE, ray, FARTHEST)?;
    let n = normal::implicit(|p| surface(object, p), p)?;
    let is_lit = |light: &GpuLight| {
        let lifted = p + *n * LIFT;
        let way = light.position - lifted;
        way.unit()
            .is_some_and(|l| march(lifted, l, way.length()).is_none())
    };
    let lit = (0..)
        .zip(&lights())
        .map(|(i, light)| u32::from(is_lit(light)) << i)
        .sum();
    Some(Point {
        p,
        object,
        v: *-ray,
        lit,
    })
}

/// Steps along a ray by the distance to the nearest surface.
fn march(from: Vec3, ray: UnitVec3, limit: f32) -> Option<(Vec3, u32)> {
    let mut t = 0.0;
    for _ in 0..STEPS {
        let p = from + *ray * t;
        let objects = [FLOOR, BALL, RING, CUBE].map(|object| (surface(object, p), object));
        let (distance, object) = objects.into_iter().min_by(|a, b| a.0.total_cmp(&b.0))?;
        if distance < NEAR {
            return Some((p, object));
        }
        t += distance;
        if t >= limit {
            return None;
        }
    }
    None
}

/// Whether the sign of N·L may differ on a device that rounds differently: a highlight may end there.
pub fn is_on_horizon(point: &Point) -> bool {
    let n = normal::implicit(|p| surface(point.object, p), point.p);
    lights().iter().any(|light| {
        let l = (light.position - point.p).unit();
        n.zip(l).is_none_or(|(n, l)| n.dot(*l).abs() < 1.0 / 4096.0)
    })
}

/// How much of the light the picture shows: the floor fades into black, and so has no horizon.
pub fn visible(point: &Point) -> f32 {
    if point.object != FLOOR {
        return 1.0;
    }
    let x = ((point.p.length() - 1.6) / 3.6).clamp(0.0, 1.0);
    1.0 - x * x * (3.0 - 2.0 * x)
}
