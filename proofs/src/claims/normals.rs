//! Normals of surfaces.

use shading::{Dual, Real, normal};
use shading_proofs::Range;

use super::*;

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
    normal::parametric(
        |_, _| surface(s_u, s_v, value),
        given.any("u"),
        given.any("v"),
    )
}
fn implicit(given: Given, gradient: Vec3<Term>) -> Option<UnitVec3<Term>> {
    let value = given.any("f");
    normal::implicit(|_| Dual { value, gradient }, any_vector(given, "p"))
}

/// A vector of any bits, but for its square between 1/p and p.
fn tame(given: Given, name: &str) -> Vec3<Term> {
    let v = any_vector(given, name);
    given.assume_above(v.dot(v), Term::ONE / Term::EXTREME);
    given.assume_above(Term::EXTREME, v.dot(v));
    v
}

claims! {
    triangle_of_any: "`normal::triangle` of any bits is `None` or finite" |given| {
        let [a, b, c] = ["v1", "v2", "v3"].map(|name| any_vector(given, name));
        none_or_finite(given, normal::triangle(a, b, c))
    }
    triangle_of_two_points: "`normal::triangle` is `None` if two vertices are equal" |given| {
        let (a, b) = (any_vector(given, "a"), any_vector(given, "b"));
        [normal::triangle(a, b, b), normal::triangle(a, a, b), normal::triangle(a, b, a)].map(none).concat()
    }
    triangle_of_broken: "`normal::triangle` is `None` if a vertex is infinite or NaN" |given| {
        let (a, b, c) = (broken(given, "a"), any_vector(given, "b"), any_vector(given, "c"));
        [normal::triangle(a, b, c), normal::triangle(b, a, c), normal::triangle(b, c, a)].map(none).concat()
    }
    sphere_of_any: "`normal::sphere` of any bits is `None` or finite" |given| {
        none_or_finite(given, normal::sphere(any_vector(given, "center"), any_vector(given, "p")))
    }
    sphere_at_center: "`normal::sphere` is `None` at the center" |given| {
        let center = any_vector(given, "center");
        none(normal::sphere(center, center))
    }
    sphere_of_broken: "`normal::sphere` is `None` if a coordinate is infinite or NaN" |given| {
        let (a, b) = (broken(given, "a"), any_vector(given, "b"));
        [normal::sphere(a, b), normal::sphere(b, a)].map(none).concat()
    }
    implicit_of_any: "`normal::implicit` of any function is `None` or finite" |given| {
        none_or_finite(given, implicit(given, any_vector(given, "gradient")))
    }
    implicit_without_gradient: "`normal::implicit` is `None` where ∇f is 0, infinite or NaN" |given| {
        let gradients = [zero(given, "zero"), broken(given, "broken")];
        gradients.map(|gradient| none(implicit(given, gradient))).concat()
    }
    parametric_of_any: "`normal::parametric` of any function is `None` or finite" |given| {
        none_or_finite(given, parametric(given, any_vector(given, "s_u"), any_vector(given, "s_v")))
    }
    parametric_of_one_tangent: "`normal::parametric` is `None` if the tangents are equal, or one is 0, infinite or NaN" |given| {
        let t = any_vector(given, "t");
        let (zero, broken) = (zero(given, "zero"), broken(given, "broken"));
        [(t, t), (t, zero), (zero, t), (t, broken), (broken, t)].map(|(u, v)| none(parametric(given, u, v))).concat()
    }
    parametric_of_noise: "`normal::parametric` is `None` if one tangent has a component 1 and none above, and the other none above 32 u" |given| {
        let noise = 32.0 * given.format().u();
        let mut t = given.vector("t", Range::within(-1.0, 1.0));
        t.x = Term::ONE;
        let small = given.vector("small", Range::within(-noise, noise));
        [none(parametric(given, t, small)), none(parametric(given, small, t))].concat()
    }
    from_gradient_of_none: "`normal::from_gradient` is `None` for 0, infinity and NaN" |given| {
        [zero(given, "zero"), broken(given, "broken")].map(|g| none(normal::from_gradient(g))).concat()
    }
    from_tangents_of_any: "`normal::from_tangents` of any bits is `None` or finite" |given| {
        none_or_finite(given, normal::from_tangents(any_vector(given, "s_u"), any_vector(given, "s_v")))
    }
    from_tangents_of_none: "`normal::from_tangents` is `None` if the tangents are equal, or one is 0, infinite or NaN" |given| {
        let t = any_vector(given, "t");
        let (zero, broken) = (zero(given, "zero"), broken(given, "broken"));
        [(t, t), (t, zero), (zero, t), (t, broken), (broken, t)].map(|(u, v)| none(normal::from_tangents(u, v))).concat()
    }
    facing_faces: "`normal::facing`: N·V is not negative, N and V of any numbers" |given| {
        let numbers = Range::within(-INF, INF);
        let n = UnitVec3::assume_unit(given.vector("n", numbers));
        let v = UnitVec3::assume_unit(given.vector("v", numbers));
        within([normal::facing(n, v).dot(v)], light().or_nan())
    }
    facing_stays: "`normal::facing` is N, to the bit, if N·V is 0 or above or NaN" |given| {
        let (n, v) = (any_direction(given, "n"), any_direction(given, "v"));
        if Term::ZERO > n.dot(v) {
            return vec![];
        }
        same(normal::facing(n, v), n)
    }
    transformed_to_point: "`normal::transformed` is `None` if all columns are 0" |given| {
        let n = any_direction(given, "n");
        none(normal::transformed(n, ["a", "b", "c"].map(|name| zero(given, name))))
    }
    transformed_of_any: "`normal::transformed` is `None` or finite, N of any bits, and each column of any bits whose |v|² is between 1/p and p" |given| {
        let columns = ["a", "b", "c"].map(|name| tame(given, name));
        none_or_finite(given, normal::transformed(any_direction(given, "n"), columns))
    }
    transformed_of_broken: "`normal::transformed` is `None` if N is infinite or NaN and the columns are as above" |given| {
        let columns = ["a", "b", "c"].map(|name| tame(given, name));
        none(normal::transformed(broken_direction(given, "n"), columns))
    }
    tangent_of_any: "`normal::tangent` of any bits is `None`, or finite with a handedness of 1 or −1" |given| {
        let vertices = ["a", "b", "c"].map(|name| any_vector(given, name));
        let map = ["1", "2", "3"].map(|i| ["x", "y"].map(|axis| given.any(&format!("{axis}{i}"))));
        normal::tangent(vertices, map).map_or(vec![], |(t, h)| [components(t, finite(given)), within([h], Range::within(-1.0, 1.0))].concat())
    }
    tangent_of_broken: "`normal::tangent` is `None` if a texture coordinate is NaN, or one is infinite and the others are finite" |given| {
        let vertices = ["a", "b", "c"].map(|name| any_vector(given, name));
        let is_nan = given.one_of(2) == 1;
        let (broken, others) = if is_nan { (Range::NAN, Range::ANY) } else { (Range { nan: false, ..Range::NOT_FINITE }, finite(given)) };
        let mut map = ["1", "2", "3"].map(|i| ["x", "y"].map(|axis| given.number(&format!("{axis}{i}"), others)));
        map[given.one_of(3) as usize][given.one_of(2) as usize] = given.number("broken", broken);
        none(normal::tangent(vertices, map))
    }
    tangent_of_one_point: "`normal::tangent` is `None` if two vertices have the same texture coordinates" |given| {
        let vertices = ["a", "b", "c"].map(|name| any_vector(given, name));
        let [p, q] = ["1", "2"].map(|i| ["x", "y"].map(|axis| given.any(&format!("{axis}{i}"))));
        none(normal::tangent(vertices, [[p, p, q], [p, q, p], [q, p, p]][given.one_of(3) as usize]))
    }
    corner_of_two_points: "`normal::corner` is 0 if two vertices are equal" |given| {
        let (a, b) = (any_vector(given, "a"), any_vector(given, "b"));
        [normal::corner(a, b, b), normal::corner(a, a, b), normal::corner(a, b, a)]
            .map(|share| components(share, Range::within(0.0, 0.0))).concat()
    }
    corner_of_broken: "`normal::corner` is 0 if a vertex is infinite or NaN" |given| {
        let (a, b, c) = (broken(given, "a"), any_vector(given, "b"), any_vector(given, "c"));
        [normal::corner(a, b, c), normal::corner(b, a, c), normal::corner(b, c, a)]
            .map(|share| components(share, Range::within(0.0, 0.0))).concat()
    }
    corner_of_any: "`normal::corner` of any bits is finite" |given| {
        let mut vertices = ["a", "b", "c"].map(|name| given.vector(name, finite(given)));
        if let Some(vertex) = vertices.get_mut(given.one_of(4) as usize) {
            *vertex = broken(given, "broken");
        } else {
            let [a, b, c] = vertices;
            let (e1, e2) = (decide_scale(a, b), decide_scale(a, c));
            decide_scale(Vec3::ZERO, e1.cross(e2));
            let _ = e1.dot(e2) > Term::ZERO;
        }
        let [a, b, c] = vertices;
        components(normal::corner(a, b, c), finite(given))
    }
    mapped_of_any: "`normal::mapped` of any bits is `None` or finite" |given| {
        let (n, t, s) = (any_direction(given, "n"), any_vector(given, "t"), any_vector(given, "s"));
        none_or_finite(given, normal::mapped(n, t, given.any("handedness"), s))
    }
    mapped_of_none: "`normal::mapped` is `None` if T is 0 or N, or the sample is 0" |given| {
        let (n, t, s) = (any_direction(given, "n"), any_vector(given, "t"), any_vector(given, "s"));
        let (zero, handedness) = (zero(given, "zero"), given.any("handedness"));
        [(zero, s), (*n, s), (t, zero)].map(|(t, s)| none(normal::mapped(n, t, handedness, s))).concat()
    }
    mapped_of_broken: "`normal::mapped` is `None` if N, T or the sample is infinite or NaN" |given| {
        let (n, t, s) = (any_direction(given, "n"), any_vector(given, "t"), any_vector(given, "s"));
        let (broken, h) = (broken(given, "broken"), given.any("handedness"));
        let as_n = UnitVec3::assume_unit(broken);
        [(as_n, t, s), (n, broken, s), (n, t, broken)].map(|(n, t, s)| none(normal::mapped(n, t, h, s))).concat()
    }
}
