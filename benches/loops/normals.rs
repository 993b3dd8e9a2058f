//! Normals, beside the same on `glam`.

use glam::{Mat3, Vec3};
use nalgebra::SVector;
use num_dual::{DualNum, DualSVec32};
use shading::{Dual, Real, UnitVec3, normal};

use crate::data::{COUNT, Vectors, directions, triangles};
use crate::race::{Data, Limit, Race, limit, twice};

fn torus<T: Real>(p: shading::Vec3<T>) -> T {
    let ring = (p.x * p.x + p.y * p.y).sqrt() - T::of(2.0);
    ring * ring + p.z * p.z - T::of(0.25)
}

/// The same, differentiated by `num-dual`.
fn differentiated_torus(p: Vec3) -> Vec3 {
    let torus = |p: SVector<DualSVec32<3>, 3>| {
        let ring = (p[0] * p[0] + p[1] * p[1]).sqrt() - 2.0;
        ring * ring + p[2] * p[2] - 0.25
    };
    let (_, slopes) = num_dual::gradient(torus, &SVector::from(p.to_array()));
    Vec3::from_array(slopes.into())
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

fn corner(
    Vectors {
        glam: [a, b, c], ..
    }: &Vectors,
) -> Vec3 {
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

/// The same, except that a vector of length 0 has none. The compiler does not vectorize its loop.
fn plain_option(v: Vec3) -> Option<[f32; 3]> {
    (v.length_squared() > 0.0).then(|| plain(v))
}

fn mapped(
    Vectors {
        glam: [n, tangent, sample],
        ..
    }: &Vectors,
) -> Option<Vec3> {
    let b = n.cross(*tangent).try_normalize()?;
    let t = b.cross(*n);
    (t * sample.x + b * sample.y + n * sample.z).try_normalize()
}

/// As fast as on `glam`; by a call, the wider result counts.
const LIKE: Limit = limit(1.3, 1.4);
/// The compiler vectorizes the rival.
const VECTORIZED: Limit = limit(2.5, f64::INFINITY);
/// The rival thinks of no vector but that of length 0.
const OF_OPTION: Limit = limit(1.25, 1.4);

pub fn race() -> usize {
    let (triangles, directions) = (triangles(), directions(COUNT));
    of_points(&triangles) + of_functions(&triangles) + of_normals(&triangles, &directions)
}

/// Normals of points: of a vector, a triangle, its corner, a sphere.
fn of_points(triangles: &[Data<Vectors>]) -> usize {
    Race::of(
        "Vec3::unit",
        twice!(|Vectors { ours: [a, ..], .. }: &Vectors| a.unit()),
    )
    .against(
        "glam",
        LIKE,
        twice!(|Vectors { glam: [a, ..], .. }| a.try_normalize()),
    )
    .against(
        "plain",
        VECTORIZED,
        twice!(|Vectors { glam: [a, ..], .. }| plain(*a)),
    )
    .run(triangles)
        + Race::of(
            "normal::triangle",
            twice!(|Vectors {
                        ours: [a, b, c], ..
                    }: &Vectors| { normal::triangle(*a, *b, *c) }),
        )
        .against(
            "glam",
            LIKE,
            twice!(|Vectors {
                        glam: [a, b, c], ..
                    }| { (b - a).cross(c - a).try_normalize() }),
        )
        .against(
            "plain",
            VECTORIZED,
            twice!(|Vectors {
                        glam: [a, b, c], ..
                    }| plain((b - a).cross(c - a))),
        )
        .run(triangles)
        + Race::of(
            "normal::corner",
            twice!(|Vectors {
                        ours: [a, b, c], ..
                    }: &Vectors| { normal::corner(*a, *b, *c) }),
        )
        .against("glam, acos", limit(1.2, 1.2), twice!(corner))
        .run(triangles)
        + Race::of(
            "normal::sphere",
            twice!(|Vectors {
                        ours: [a, b, _], ..
                    }: &Vectors| { normal::sphere(*a, *b) }),
        )
        .against(
            "glam",
            LIKE,
            twice!(|Vectors {
                        glam: [a, b, _], ..
                    }| (b - a).try_normalize()),
        )
        .against(
            "plain",
            VECTORIZED,
            twice!(|Vectors {
                        glam: [a, b, _], ..
                    }| plain(b - a)),
        )
        .run(triangles)
}

/// Normals of surfaces.
fn of_functions(triangles: &[Data<Vectors>]) -> usize {
    Race::of(
        "normal::implicit",
        twice!(|Vectors { ours: [a, ..], .. }: &Vectors| { normal::implicit(torus::<Dual>, *a) }),
    )
    .against(
        "glam",
        limit(1.5, 1.5),
        twice!(|Vectors { glam: [a, ..], .. }| { torus_gradient(*a).try_normalize() }),
    )
    .against(
        "num-dual",
        limit(1.0, 1.0),
        twice!(|Vectors { glam: [a, ..], .. }| differentiated_torus(*a).try_normalize()),
    )
    .against(
        "plain",
        limit(3.3, f64::INFINITY),
        twice!(|Vectors { glam: [a, ..], .. }| plain(torus_gradient(*a))),
    )
    .against(
        "plain, an `Option`",
        OF_OPTION,
        twice!(|Vectors { glam: [a, ..], .. }| plain_option(torus_gradient(*a))),
    )
    .run(triangles)
        + Race::of(
            "normal::parametric",
            twice!(|Vectors { ours: [a, ..], .. }: &Vectors| {
                normal::parametric(saddle::<Dual>, a.x, a.y)
            }),
        )
        .against(
            "glam",
            limit(1.5, 1.5),
            twice!(|Vectors { glam: [a, ..], .. }| { saddle_cross(a.x, a.y).try_normalize() }),
        )
        .against(
            "plain",
            limit(3.0, f64::INFINITY),
            twice!(|Vectors { glam: [a, ..], .. }| plain(saddle_cross(a.x, a.y))),
        )
        .against(
            "plain, an `Option`",
            OF_OPTION,
            twice!(|Vectors { glam: [a, ..], .. }| plain_option(saddle_cross(a.x, a.y))),
        )
        .run(triangles)
        + Race::of(
            "normal::from_tangents",
            twice!(|Vectors {
                        ours: [a, b, _], ..
                    }: &Vectors| { normal::from_tangents(*a, *b) }),
        )
        .against(
            "glam",
            LIKE,
            twice!(|Vectors {
                        glam: [a, b, _], ..
                    }| a.cross(*b).try_normalize()),
        )
        .run(triangles)
}

/// Normals made from normals.
fn of_normals(triangles: &[Data<Vectors>], directions: &[Data<Vectors>]) -> usize {
    Race::of(
        "normal::transformed",
        twice!(|Vectors {
                    ours: [a, b, c], ..
                }: &Vectors| { normal::transformed(UnitVec3::Y, [*a, *b, *c]) }),
    )
    .against(
        "glam",
        limit(1.4, 1.4),
        twice!(|Vectors {
                    glam: [a, b, c], ..
                }| {
            (Mat3::from_cols(*a, *b, *c).inverse().transpose() * std::hint::black_box(Vec3::Y))
                .try_normalize()
        }),
    )
    .run(triangles)
        + Race::of(
            "normal::mapped",
            twice!(|Vectors {
                        ours: [a, b, c], ..
                    }: &Vectors| {
                normal::mapped(UnitVec3::assume_unit(*a), *b, 1.0, *c)
            }),
        )
        .against("glam", LIKE, twice!(mapped))
        .run(directions)
        + Race::of(
            "normal::facing",
            twice!(|Vectors {
                        ours: [a, b, _], ..
                    }: &Vectors| {
                normal::facing(UnitVec3::assume_unit(*a), UnitVec3::assume_unit(*b))
            }),
        )
        .against(
            "by hand",
            limit(1.3, 1.8),
            twice!(|Vectors {
                        glam: [a, b, _], ..
                    }| { if a.dot(*b) < 0.0 { -a } else { *a } }),
        )
        .run(directions)
}
