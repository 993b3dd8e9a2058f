//! A ball and the Utah teapot under a sun, a lamp and a spot, point by point.

use bytemuck::{Pod, Zeroable};
use shading::f32::{
    Attenuation, Cone, DirectionalLight, Light, Material, PointLight, Rgb, SpotLight, UnitVec3,
    Vec3,
};
use shading::{normal, shade};

/// The width and the height of each of the two pictures.
pub const SIZE: usize = 256;

pub const AMBIENT: Rgb = Rgb::gray(0.2);
const EYE: Vec3 = Vec3::new(0.0, 0.0, 6.0);

/// A point of a surface, with a normal of any length; that of the ball is 0.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub struct Point {
    pub p: Vec3,
    pub is_seen: f32,
    pub n: Vec3,
    pub padding: f32,
}

pub fn lights() -> [Light; 3] {
    let lamp = PointLight {
        position: Vec3::new(2.0, 1.0, 2.0),
        intensity: Rgb::new(1.0, 0.8, 0.6),
        attenuation: Attenuation::const_new(1.0, 0.0, 0.25)
            .unwrap()
            .within(6.0)
            .unwrap(),
    };
    let sun = DirectionalLight {
        l: UnitVec3::assume_unit(Vec3::new(-0.6, 0.0, 0.8)),
        intensity: Rgb::new(0.2, 0.3, 0.5),
    };
    let spot = SpotLight {
        point: PointLight {
            position: Vec3::new(0.0, 3.0, 2.0),
            intensity: Rgb::new(0.3, 0.9, 0.4),
            attenuation: Attenuation::NONE,
        },
        axis: UnitVec3::assume_unit(Vec3::new(0.0, -0.8, -0.6)),
        cone: Cone::from_cosines(0.98, 0.9).unwrap().smoothstep(),
    };
    [lamp.into(), sun.into(), spot.into()]
}

pub fn material() -> Material<f32> {
    Material {
        k_a: Rgb::gray(0.1),
        k_d: Rgb::new(0.6, 0.5, 0.4),
        k_s: Rgb::gray(0.3),
        m: 32.0,
    }
}

/// What the crate computes.
pub fn color(point: &Point) -> Rgb {
    if point.is_seen <= 0.0 {
        return Rgb::BLACK;
    }
    let n = if point.n == Vec3::ZERO {
        normal::sphere(Vec3::ZERO, point.p)
    } else {
        point.n.unit()
    };
    let (Some(n), Some(v)) = (n, (EYE - point.p).unit()) else {
        return Rgb::BLACK;
    };
    let lights = lights().map(|light| light.at(point.p));
    shade::blinn_phong(n, v, &material(), AMBIENT, lights).total()
}

/// The points of the ball, and then those of the teapot.
pub fn points() -> Vec<Point> {
    let mut points = vec![Point::zeroed(); 2 * SIZE * SIZE];
    let place = |i: usize| (i as f32 + 0.5) / (SIZE / 2) as f32 - 1.0;
    for (i, point) in points[..SIZE * SIZE].iter_mut().enumerate() {
        let (x, y) = (place(i % SIZE), place(i / SIZE));
        let z2 = 1.0 - (x * x + y * y);
        if z2 > 0.0 {
            *point = Point {
                p: Vec3::new(x, y, z2.sqrt()),
                is_seen: 1.0,
                ..Point::zeroed()
            };
        }
    }
    let teapot = &mut points[SIZE * SIZE..];
    let corners: Vec<_> = clients::teapot()
        .iter()
        .map(|(p, n)| {
            (
                Vec3::new(p.x, p.z - 1.5, -p.y) * 0.3,
                Vec3::new(n.x, n.z, -n.y),
            )
        })
        .collect();
    for triangle in corners.chunks_exact(3) {
        let [(a, n_a), (b, n_b), (c, n_c)] = [triangle[0], triangle[1], triangle[2]];
        let side =
            |p: Vec3, q: Vec3, x: f32, y: f32| (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
        let area = side(a, b, c.x, c.y);
        let columns = (0..SIZE).filter(|&i| within(place(i), [a.x, b.x, c.x]));
        for i in columns {
            for j in (0..SIZE).filter(|&j| within(place(j), [a.y, b.y, c.y])) {
                let (x, y) = (place(i), place(j));
                let weights =
                    [side(b, c, x, y), side(c, a, x, y), side(a, b, x, y)].map(|s| s / area);
                if weights.iter().any(|w| w.is_nan() || *w < 0.0) {
                    continue;
                }
                let of = |[a, b, c]: [Vec3; 3]| a * weights[0] + b * weights[1] + c * weights[2];
                let (p, n) = (of([a, b, c]), of([n_a, n_b, n_c]));
                let point = &mut teapot[j * SIZE + i];
                if point.is_seen <= 0.0 || p.z > point.p.z {
                    *point = Point {
                        p,
                        is_seen: 1.0,
                        n,
                        padding: 0.0,
                    };
                }
            }
        }
    }
    points
}

fn within(x: f32, ends: [f32; 3]) -> bool {
    ends.iter().any(|end| *end <= x) && ends.iter().any(|end| *end >= x)
}
