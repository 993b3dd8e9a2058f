//! Normals of surfaces.

use shading::{Dual, Real, UnitVec3, Vec3, normal};
use shading_proofs::{Given, Goal, Range, Term};

use super::given::*;

/// A point of a surface with the partial derivatives that a user's function may give.
fn surface(s_u: Vec3<Term>, s_v: Vec3<Term>, value: Term) -> Vec3<Dual<Term>> {
    let dual = |u, v| Dual {
        value,
        gradient: Vec3::new(u, v, Term::ZERO),
    };
    Vec3 {
        x: dual(s_u.x, s_v.x),
        y: dual(s_u.y, s_v.y),
        z: dual(s_u.z, s_v.z),
    }
}

fn parametric(given: Given, s_u: Vec3<Term>, s_v: Vec3<Term>) -> Option<UnitVec3<Term>> {
    let value = given.any("s");
    let (u, v) = (given.any("u"), given.any("v"));
    normal::parametric(|_, _| surface(s_u, s_v, value), u, v)
}

fn implicit(given: Given, gradient: Vec3<Term>) -> Option<UnitVec3<Term>> {
    let value = given.any("f");
    normal::implicit(|_| Dual { value, gradient }, any_vector(given, "p"))
}

/// Two tangents that are equal, or of which one is 0 or broken.
fn parallel(given: Given) -> (Vec3<Term>, Vec3<Term>) {
    let t = any_vector(given, "t");
    match given.one_of(3) {
        0 => (t, t),
        1 => (without_direction(given, "s_u"), t),
        _ => (t, without_direction(given, "s_v")),
    }
}

/// Three points of which two are equal, or one is broken.
fn degenerate(given: Given) -> [Vec3<Term>; 3] {
    let (a, b) = (any_vector(given, "a"), any_vector(given, "b"));
    let c = match given.one_of(2) {
        0 => b,
        _ => broken(given, "c"),
    };
    [[a, b, c], [c, a, b], [b, c, a]][given.one_of(3) as usize]
}

pub fn normals_of_any(given: Given) -> Vec<Goal> {
    let [a, b, c] = vertices(given);
    none_or_unit(match given.one_of(6) {
        5 => normal::plane(a.x, a.y, a.z),
        0 => normal::triangle(a, b, c),
        1 => normal::sphere(a, b),
        2 => implicit(given, a),
        3 => parametric(given, a, b),
        _ => normal::from_tangents(a, b),
    })
}

pub fn triangle_of_none(given: Given) -> Vec<Goal> {
    let [a, b, c] = degenerate(given);
    none(normal::triangle(a, b, c))
}

pub fn sphere_of_none(given: Given) -> Vec<Goal> {
    let a = any_vector(given, "a");
    let (center, p) = match given.one_of(3) {
        0 => (a, a),
        1 => (a, broken(given, "b")),
        _ => (broken(given, "b"), a),
    };
    none(normal::sphere(center, p))
}

pub fn implicit_of_none(given: Given) -> Vec<Goal> {
    none(implicit(given, without_direction(given, "gradient")))
}

pub fn parametric_of_none(given: Given) -> Vec<Goal> {
    let (s_u, s_v) = parallel(given);
    none(match given.one_of(2) {
        0 => parametric(given, s_u, s_v),
        _ => normal::from_tangents(s_u, s_v),
    })
}

/// Columns of any bits, but for their squares between 1/p and p.
fn columns(given: Given) -> [Vec3<Term>; 3] {
    let columns = vertices(given);
    for v in columns {
        assume_tame(given, v.into());
    }
    columns
}

pub fn transformed_of_any(given: Given) -> Vec<Goal> {
    let columns = columns(given);
    none_or_unit(normal::transformed(any_direction(given, "n"), columns))
}

pub fn transformed_of_none(given: Given) -> Vec<Goal> {
    let n = UnitVec3::assume_unit(without_direction(given, "n"));
    none(normal::transformed(n, columns(given)))
}

fn vertices(given: Given) -> [Vec3<Term>; 3] {
    ["a", "b", "c"].map(|name| any_vector(given, name))
}

pub fn tangent_of_any(given: Given) -> Vec<Goal> {
    let map = ["1", "2", "3"].map(|i| ["x", "y"].map(|axis| given.any(&format!("{axis}{i}"))));
    let made = normal::tangent(vertices(given), map);
    made.map_or(vec![], |(t, handedness)| {
        let sign = within([handedness], Range::within(-1.0, 1.0));
        [components(t, component()), sign].concat()
    })
}

pub fn tangent_of_none(given: Given) -> Vec<Goal> {
    let [p, q] = ["1", "2"].map(|i| ["x", "y"].map(|axis| given.any(&format!("{axis}{i}"))));
    let map = [[p, p, q], [p, q, p], [q, p, p]][given.one_of(3) as usize];
    none(normal::tangent(vertices(given), map))
}

pub fn corner_of_none(given: Given) -> Vec<Goal> {
    let [a, b, c] = degenerate(given);
    components(normal::corner(a, b, c), nothing())
}

pub fn mapped_of_any(given: Given) -> Vec<Goal> {
    let (n, t) = (any_direction(given, "n"), any_vector(given, "t"));
    let (handedness, s) = (given.any("handedness"), any_vector(given, "s"));
    none_or_unit(normal::mapped(n, t, handedness, s))
}

pub fn mapped_of_none(given: Given) -> Vec<Goal> {
    let (n, t) = (any_direction(given, "n"), any_vector(given, "t"));
    let (handedness, s) = (given.any("handedness"), any_vector(given, "s"));
    none(match given.one_of(3) {
        0 => normal::mapped(n, without_direction(given, "t'"), handedness, s),
        1 => normal::mapped(n, t, handedness, without_direction(given, "s'")),
        _ => normal::mapped(n, *n, handedness, s),
    })
}
