//! Terms: directions, factors and attenuation, beside the same on `glam` and by hand.

use shading::{Attenuation, UnitVec3, attenuation, half_vector, reflection, term};

use crate::data::{COUNT, Vectors, directions, triangles};
use crate::race::{Data, Limit, Race, limit, twice};

const LIKE: Limit = limit(1.3, 1.4);

const WHOLE_M: u32 = 50;
const REAL_M: f32 = 50.5;
const A: f32 = 1.0;
const B: f32 = 0.1;
const C: f32 = 0.05;
const CHECKED: Attenuation<f32> = Attenuation::<f32>::new(A, B, C).unwrap();

fn unit(v: shading::Vec3<f32>) -> UnitVec3<f32> {
    UnitVec3::assume_unit(v)
}

pub fn race() -> usize {
    of_vectors(&directions(COUNT)) + of_distances(&triangles())
}

fn of_vectors(directions: &[Data<Vectors>]) -> usize {
    Race::of(
        "reflection",
        twice!(|Vectors {
                    ours: [n, l, _], ..
                }: &Vectors| reflection(unit(*n), unit(*l))),
    )
    .against(
        "glam",
        LIKE,
        twice!(|Vectors {
                    glam: [n, l, _], ..
                }| (-l).reflect(*n)),
    )
    .run(directions)
        + Race::of(
            "half_vector",
            twice!(|Vectors {
                        ours: [l, _, v], ..
                    }: &Vectors| half_vector(unit(*l), unit(*v))),
        )
        .against(
            "glam",
            LIKE,
            twice!(|Vectors {
                        glam: [l, _, v], ..
                    }| (l + v).try_normalize()),
        )
        .run(directions)
        + Race::of(
            "term::lambert",
            twice!(|Vectors {
                        ours: [n, l, _], ..
                    }: &Vectors| term::lambert(unit(*n), unit(*l))),
        )
        .against(
            "glam",
            LIKE,
            twice!(|Vectors {
                        glam: [n, l, _], ..
                    }| n.dot(*l).max(0.0)),
        )
        .run(directions)
        + Race::of(
            "term::blinn, whole m",
            twice!(|Vectors {
                        ours: [n, h, _], ..
                    }: &Vectors| {
                term::blinn(unit(*n), unit(*h), std::hint::black_box(WHOLE_M))
            }),
        )
        .against(
            "powi",
            LIKE,
            twice!(|Vectors {
                        glam: [n, h, _], ..
                    }| {
                n.dot(*h)
                    .max(0.0)
                    .powi(std::hint::black_box(WHOLE_M.cast_signed()))
            }),
        )
        .run(directions)
        + Race::of(
            "term::blinn, real m",
            twice!(|Vectors {
                        ours: [n, h, _], ..
                    }: &Vectors| {
                term::blinn(unit(*n), unit(*h), std::hint::black_box(REAL_M))
            }),
        )
        .against(
            "powf",
            limit(2.0, 2.0),
            twice!(|Vectors {
                        glam: [n, h, _], ..
                    }| {
                n.dot(*h).max(0.0).powf(std::hint::black_box(REAL_M))
            }),
        )
        .against(
            "libm",
            limit(0.5, 0.5),
            twice!(|Vectors {
                        glam: [n, h, _], ..
                    }| {
                libm::powf(n.dot(*h).max(0.0), std::hint::black_box(REAL_M))
            }),
        )
        .run(directions)
}

/// Attenuation. The distance is the size of a coordinate.
fn of_distances(points: &[Data<Vectors>]) -> usize {
    let by_hand =
        |Vectors { glam: [p, ..], .. }: &Vectors| 1.0 / (A + p.x.abs() * (B + p.x.abs() * C));
    Race::of(
        "attenuation",
        twice!(|Vectors { ours: [p, ..], .. }: &Vectors| attenuation(A, B, C, p.x.abs())),
    )
    .against("by hand", LIKE, twice!(by_hand))
    .run(points)
        + Race::of(
            "Attenuation::at",
            twice!(|Vectors { ours: [p, ..], .. }: &Vectors| CHECKED.at(p.x.abs())),
        )
        .against("by hand", LIKE, twice!(by_hand))
        .run(points)
}
