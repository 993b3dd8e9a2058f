//! Numbers, vectors and directions.

use shading::{Real, Rgb, UnitVec3, Vec3, half_vector, normal};
use shading_proofs::{Given, Goal, Range, Term};

use super::given::*;

pub fn length_of_numbers(given: Given) -> Vec<Goal> {
    let v = given.vector("v", Range::within(-INF, INF));
    within([v.length()], light())
}

pub fn unit_of_any(given: Given) -> Vec<Goal> {
    none_or_unit(any_vector(given, "v").unit())
}

pub fn unit_of_nothing(given: Given) -> Vec<Goal> {
    let v = without_direction(given, "v");
    none(match given.one_of(2) {
        0 => v.unit(),
        _ => normal::plane(v.x, v.y, v.z),
    })
}

pub fn unit_or_of_any(given: Given) -> Vec<Goal> {
    let fallback = UnitVec3::assume_unit(given.vector("fallback", component()));
    components(any_vector(given, "v").unit_or(fallback), component())
}

pub fn unit_or_of_nothing(given: Given) -> Vec<Goal> {
    let fallback = any_direction(given, "fallback");
    same(without_direction(given, "v").unit_or(fallback), fallback)
}

/// Whether |v|² is within 4ε of 1.
fn is_unit(given: Given, v: Vec3<Term>) -> bool {
    let off = dot(v, v) - Term::ONE;
    let four_epsilon = Term::of(8.0 * given.format().u());
    larger(off, -off) <= four_epsilon
}

pub fn direction_of_any(given: Given) -> Vec<Goal> {
    let v = any_vector(given, "v");
    if is_unit(given, v) {
        return vec![];
    }
    none_or_unit(UnitVec3::new(v.x, v.y, v.z))
}

pub fn direction_of_length_1(given: Given) -> Vec<Goal> {
    let v = any_vector(given, "v");
    if !is_unit(given, v) {
        return vec![];
    }
    UnitVec3::new(v.x, v.y, v.z).map_or(vec![], |made| {
        let size = Range::within(-1.01, 1.01);
        [same(*made, v), components(*made, size)].concat()
    })
}

pub fn direction_of_nothing(given: Given) -> Vec<Goal> {
    let v = without_direction(given, "v");
    none(UnitVec3::new(v.x, v.y, v.z))
}

pub fn half_vector_of_any(given: Given) -> Vec<Goal> {
    let (l, v) = (any_direction(given, "l"), any_direction(given, "v"));
    none_or_unit(half_vector(l, v))
}

pub fn half_vector_of_opposite(given: Given) -> Vec<Goal> {
    let l = any_direction(given, "l");
    none(half_vector(l, -l))
}

pub fn half_vector_of_broken(given: Given) -> Vec<Goal> {
    let broken = UnitVec3::assume_unit(broken(given, "l"));
    none(half_vector(broken, any_direction(given, "v")))
}

pub fn clamped(given: Given) -> Vec<Goal> {
    let [r, g, b] = ["r", "g", "b"].map(|name| given.any(name));
    components(
        Rgb::<Term>::new(r, g, b).clamped(),
        Range::unsigned(0.0, 1.0),
    )
}
