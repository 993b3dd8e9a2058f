//! Numbers, vectors and directions.

use shading::{Elementary, Real, Rgb, UnitVec3, half_vector, reflection};
use shading_proofs::{Goal, Range, Term};

use super::*;

claims! {
    root_below_zero: "`Real::sqrt` of a number below 0 is NaN" |given| {
        let below = Range { minus_zero: false, ..Range::within(-INF, -given.format().tiny()) };
        within([given.number("x", below).sqrt()], Range::NAN)
    }
    logarithm_below_zero: "`Elementary::ln` of a number below 0 is NaN, given that `libm::log` is" |given| {
        let below = Range { minus_zero: false, ..Range::within(-INF, -given.format().tiny()) };
        within([given.number("x", below).ln()], Range::NAN)
    }
    small_products: "`Vec3::dot` and `Vec3::cross` of components up to 2⁶² are finite" |given| {
        let size = Range::within(-2.0_f64.powi(62), 2.0_f64.powi(62));
        let (a, b) = (given.vector("a", size), given.vector("b", size));
        let mut goals = components(a.cross(b), finite(given));
        goals.push(Goal::Within(a.dot(b), finite(given)));
        goals
    }
    length_of_numbers: "`Vec3::length` of any numbers is in [0, ∞]" |given| {
        within([given.vector("v", Range::within(-INF, INF)).length()], light())
    }
    length_of_infinite: "`Vec3::length` is ∞ if a component is infinite and none is NaN" |given| {
        let mut v = given.vector("v", Range::within(-INF, INF));
        let infinite = given.number("infinite", Range { nan: false, ..Range::NOT_FINITE });
        *[&mut v.x, &mut v.y, &mut v.z][given.one_of(3) as usize] = infinite;
        within([v.length()], Range::within(INF, INF))
    }
    length_of_nan: "`Vec3::length` is NaN if a component is" |given| {
        let v = with_one(given, "v", Range::NAN);
        within([v.length()], Range::NAN)
    }
    unit_of_any: "`Vec3::unit` of any bits is `None` or finite" |given| {
        none_or_finite(given, any_vector(given, "v").unit())
    }
    unit_of_zero: "`Vec3::unit` and `normal::plane` of the zero vector are `None`" |given| {
        none(zero(given, "v").unit())
    }
    unit_of_broken: "`Vec3::unit` and `normal::plane` are `None` if a component is infinite or NaN" |given| {
        none(broken(given, "v").unit())
    }
    unit_or_of_any: "`Vec3::unit_or` of any bits, with a finite fallback, is finite" |given| {
        let fallback = UnitVec3::assume_unit(given.vector("fallback", finite(given)));
        components(any_vector(given, "v").unit_or(fallback), finite(given))
    }
    unit_or_of_zero: "`Vec3::unit_or` of the zero vector is the fallback, to the bit" |given| {
        let fallback = any_direction(given, "fallback");
        same(zero(given, "v").unit_or(fallback), fallback)
    }
    unit_or_of_broken: "`Vec3::unit_or` is the fallback if a component is infinite or NaN, to the bit" |given| {
        let fallback = any_direction(given, "fallback");
        same(broken(given, "v").unit_or(fallback), fallback)
    }
    assumed: "`UnitVec3::assume_unit` changes no bit" |given| {
        let v = any_vector(given, "v");
        same(UnitVec3::assume_unit(v), v)
    }
    half_vector_of_any: "`half_vector` of any bits is `None` or finite" |given| {
        none_or_finite(given, half_vector(any_direction(given, "l"), any_direction(given, "v")))
    }
    half_vector_of_opposite: "`half_vector` of L and −L, any bits, is `None`" |given| {
        let l = any_direction(given, "l");
        none(half_vector(l, -l))
    }
    half_vector_of_broken: "`half_vector` is `None` if a component is infinite or NaN" |given| {
        none(half_vector(broken_direction(given, "l"), any_direction(given, "v")))
    }
    reflection_of_any: "`reflection` of any bits is 2(N·L)N − L, rounded operation by operation" |given| {
        let (n, l) = (any_direction(given, "n"), any_direction(given, "l"));
        let n_dot_l = n.x * l.x + n.y * l.y + n.z * l.z;
        same(reflection(n, l), *n * (n_dot_l + n_dot_l) - *l)
    }
    reflection_of_units: "`reflection` of directions: no component is above 1 + 48 u in size, and |R|² is within 104 u of 1" |given| {
        let (r, u) = (reflection(given.unit("n"), given.unit("l")), given.format().u());
        let (limit, square) = (1.0 + 48.0 * u, Range::within(1.0 - 104.0 * u, 1.0 + 104.0 * u));
        [components(r, Range::within(-limit, limit)), within([r.dot(*r)], square)].concat()
    }
    clamped: "`Rgb::clamped` of any bits is in [0, 1]" |given| {
        let [r, g, b] = ["r", "g", "b"].map(|name| given.any(name));
        channels(Rgb::new(r, g, b).clamped(), Range::unsigned(0.0, 1.0))
    }
    clamped_nan: "`Rgb::clamped` of NaN is 0" |given| {
        let nan = given.number("nan", Range::NAN);
        channels(Rgb::<Term>::gray(nan).clamped(), Range::unsigned(0.0, 0.0))
    }
}
