//! Normals, beside the same on `glam`.

use glam::{Mat3, Vec3};
use shading::{Dual, Real, UnitVec3, normal};

use crate::data::{Vectors, directions, triangles};
use crate::race::{Race, limit};

type V = shading::Vec3<f32>;

fn ours(v: Vec3) -> V {
    V::from(v.to_array())
}

fn unit(v: Vec3) -> UnitVec3<f32> {
    UnitVec3::assume_unit(ours(v))
}

fn torus<T: Real>(p: shading::Vec3<T>) -> T {
    let ring = (p.x * p.x + p.y * p.y).sqrt() - T::of(2.0);
    ring * ring + p.z * p.z - T::of(0.25)
}

/// The derivative of the torus by hand.
fn torus_gradient(p: Vec3) -> Vec3 {
    let from_axis = p.truncate().length();
    let ring = 2.0 * (from_axis - 2.0) / from_axis;
    Vec3::new(ring * p.x, ring * p.y, 2.0 * p.z)
}

fn saddle<T: Real>(u: T, v: T) -> shading::Vec3<T> {
    shading::Vec3::new(u, v, u * u - v * v)
}

fn saddle_cross(u: f32, v: f32) -> Vec3 {
    Vec3::new(1.0, 0.0, 2.0 * u).cross(Vec3::new(0.0, 1.0, -2.0 * v))
}

fn corner([a, b, c]: &Vectors) -> Vec3 {
    let (e1, e2) = (b - a, c - a);
    let angle = (e1.dot(e2) / (e1.length() * e2.length())).acos();
    e1.cross(e2)
        .try_normalize()
        .map_or(Vec3::ZERO, |n| n * angle)
}

/// As fast as it goes: neither a degenerate triangle nor an extreme one is thought of.
fn plain(v: Vec3) -> [f32; 3] {
    let [x, y, z] = v.to_array();
    let length = (x * x + y * y + z * z).sqrt();
    [x / length, y / length, z / length]
}

fn mapped([n, tangent, sample]: &Vectors) -> Option<Vec3> {
    let b = n.cross(*tangent).try_normalize()?;
    let t = b.cross(*n);
    (t * sample.x + b * sample.y + n * sample.z).try_normalize()
}

pub fn race() -> usize {
    let (triangles, directions) = (triangles(), directions());
    let like = limit(1.3, 1.3);
    let vectorized = limit(2.5, f64::INFINITY);
    Race::of("Vec3::unit", |[a, ..]: &Vectors| ours(*a).unit())
        .against("glam", like, |[a, ..]| a.try_normalize())
        .against("plain", vectorized, |[a, ..]| plain(*a))
        .run(&triangles)
        + Race::of("normal::triangle", |[a, b, c]: &Vectors| {
            normal::triangle(ours(*a), ours(*b), ours(*c))
        })
        .against("glam", like, |[a, b, c]| {
            (b - a).cross(c - a).try_normalize()
        })
        .against("plain", vectorized, |[a, b, c]| plain((b - a).cross(c - a)))
        .run(&triangles)
        + Race::of("normal::corner", |[a, b, c]: &Vectors| {
            normal::corner(ours(*a), ours(*b), ours(*c))
        })
        .against("glam, acos", limit(1.2, 1.2), corner)
        .run(&triangles)
        + Race::of("normal::sphere", |[a, b, _]: &Vectors| {
            normal::sphere(ours(*a), ours(*b))
        })
        .against("glam", like, |[a, b, _]| (b - a).try_normalize())
        .against("plain", vectorized, |[a, b, _]| plain(b - a))
        .run(&triangles)
        + Race::of("normal::implicit", |[a, ..]: &Vectors| {
            normal::implicit(torus::<Dual>, ours(*a))
        })
        .against("glam", limit(1.5, 1.5), |[a, ..]| {
            torus_gradient(*a).try_normalize()
        })
        .against("plain", vectorized, |[a, ..]| plain(torus_gradient(*a)))
        .run(&triangles)
        + Race::of("normal::parametric", |[a, ..]: &Vectors| {
            normal::parametric(saddle::<Dual>, a.x, a.y)
        })
        .against("glam", limit(1.5, 1.5), |[a, ..]| {
            saddle_cross(a.x, a.y).try_normalize()
        })
        .against("plain", vectorized, |[a, ..]| plain(saddle_cross(a.x, a.y)))
        .run(&triangles)
        + Race::of("normal::from_tangents", |[a, b, _]: &Vectors| {
            normal::from_tangents(ours(*a), ours(*b))
        })
        .against("glam", like, |[a, b, _]| a.cross(*b).try_normalize())
        .run(&triangles)
        + Race::of("normal::transformed", |[a, b, c]: &Vectors| {
            normal::transformed(UnitVec3::Y, [ours(*a), ours(*b), ours(*c)])
        })
        .against("glam", like, |[a, b, c]| {
            (Mat3::from_cols(*a, *b, *c).inverse().transpose() * std::hint::black_box(Vec3::Y))
                .try_normalize()
        })
        .run(&triangles)
        + Race::of("normal::mapped", |[a, b, c]: &Vectors| {
            normal::mapped(unit(*a), ours(*b), 1.0, ours(*c))
        })
        .against("glam", like, mapped)
        .run(&directions)
        + Race::of("normal::facing", |[a, b, _]: &Vectors| {
            normal::facing(unit(*a), unit(*b))
        })
        .against("by hand", limit(1.3, 1.3), |[a, b, _]| {
            if a.dot(*b) < 0.0 { -a } else { *a }
        })
        .run(&directions)
}
