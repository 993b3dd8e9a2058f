//! Falloff with distance, and beams.

use shading::{Attenuation, Cone, Real};
use shading_proofs::{Given, Goal, Range, Term};

use super::given::*;

pub fn attenuation_of_any(given: Given) -> Vec<Goal> {
    let [a, b, c] = ["a", "b", "c"].map(|name| given.any(name));
    let Some(made) = Attenuation::new(a, b, c) else {
        return vec![];
    };
    let [a, b, c] = made.coefficients();
    let max = given.format().max();
    let mut goals = within([b, c, made.at(given.any("q"))], not_negative(given));
    goals.push(Goal::Within(a, Range::unsigned(0.0, max)));
    goals
}

pub fn attenuation_of_invalid(given: Given) -> Vec<Goal> {
    let zeros = ["a", "b", "c"].map(|name| given.number(name, nothing()));
    let [mut abc, which] = [["x", "y", "z"].map(|name| given.any(name)), zeros];
    match given.one_of(4) {
        3 => abc = which,
        i => abc[i as usize] = invalid(given, "invalid"),
    }
    let [a, b, c] = abc;
    none(Attenuation::new(a, b, c))
}

pub fn attenuation_in_its_limit(given: Given) -> Vec<Goal> {
    let ([squared, gltf], q) = (both_windows(ranged(given)), given.any("q"));
    let mut goals = within([squared.at(q), gltf.at(q)], not_negative(given));
    let clamped = [squared.clamped().at(q), gltf.clamped().at(q)];
    goals.extend(within(clamped, share()));
    goals
}

/// The falloff with the window squared, and with glTF's.
fn both_windows(ranged: Attenuation<Term>) -> [Attenuation<Term>; 2] {
    let gltf = ranged.within_gltf(ranged.range()).unwrap_or(ranged);
    [ranged, gltf]
}

pub fn attenuation_never_rises(given: Given) -> Vec<Goal> {
    let free = match given.one_of(2) {
        0 => attenuation(given),
        _ => ranged(given),
    };
    let format = given.format();
    let near = match given.one_of(2) {
        0 => Term::ZERO,
        _ => given.number("near", Range::within(format.tiny(), format.max())),
    };
    let far = given.number("far", Range::within(format.tiny(), format.max()));
    given.assume_at_most(near, far);
    let [squared, gltf] = both_windows(free);
    [squared, gltf, squared.clamped(), gltf.clamped()]
        .map(|falloff| Goal::AtMost(falloff.at(far), falloff.at(near)))
        .into()
}

pub fn range_of_invalid(given: Given) -> Vec<Goal> {
    let r = given.number("r", Range::within(-INF, 0.0).or_nan());
    none(attenuation(given).within(r))
}

pub fn range_ends(given: Given) -> Vec<Goal> {
    let (falloff, q) = (ranged(given), given.number("q", light()));
    given.assume_at_most(falloff.range(), q);
    within(
        both_windows(falloff).map(|falloff| falloff.at(q)),
        nothing(),
    )
}

pub fn range_never_adds(given: Given) -> Vec<Goal> {
    let (falloff, q) = (attenuation(given), given.number("q", light()));
    let Some(ranged) = falloff.within(given.any("r")) else {
        return vec![];
    };
    let free = falloff.at(q);
    vec![
        Goal::AtMost(ranged.at(q), free),
        Goal::AtMost(both_windows(ranged)[1].at(q), free),
    ]
}

pub fn cone_of_any_cosines(given: Given) -> Vec<Goal> {
    cone(given).map_or(vec![], |cone| of_cone(given, cone))
}

pub fn cone_of_any_half_angles(given: Given) -> Vec<Goal> {
    let cone = Cone::from_half_angles(given.any("inner"), given.any("outer"));
    cone.map_or(vec![], |cone| of_cone(given, cone))
}

fn of_cone(given: Given, cone: Cone<Term>) -> Vec<Goal> {
    let (axis, l) = (any_direction(given, "axis"), any_direction(given, "l"));
    let factors = [cone, cone.smoothstep()].map(|cone| cone.factor(axis, l));
    let cosines = within(cone.cosines(), Range::within(-1.0, 1.0));
    [cosines, within(factors, share())].concat()
}

pub fn cone_of_invalid_cosines(given: Given) -> Vec<Goal> {
    let other = given.any("other");
    let (inner, outer) = match given.one_of(3) {
        0 => (outside(given, "inner", -1.0, 1.0), other),
        1 => (other, outside(given, "outer", -1.0, 1.0)),
        _ => {
            let outer = given.any("outer");
            given.assume_above(outer, other);
            (other, outer)
        }
    };
    none(Cone::from_cosines(inner, outer))
}

pub fn cone_of_invalid_half_angles(given: Given) -> Vec<Goal> {
    let other = given.any("other");
    let (inner, outer) = match given.one_of(3) {
        0 => (outside(given, "inner", 0.0, 3.15), other),
        1 => (other, outside(given, "outer", 0.0, 3.15)),
        _ => {
            let inner = given.any("inner");
            given.assume_above(inner, other);
            (inner, other)
        }
    };
    none(Cone::from_half_angles(inner, outer))
}

pub fn cone_on_its_axis(given: Given) -> Vec<Goal> {
    let axis = given.unit("axis");
    let one = Range::within(1.0, 1.0);
    cone(given).map_or(vec![], |cone| within([cone.factor(axis, -axis)], one))
}

pub fn cone_of_everything(given: Given) -> Vec<Goal> {
    let (axis, l, minus) = (given.unit("axis"), given.unit("l"), Term::NEG_ONE);
    let cone = Cone::from_cosine(minus).expect("a cone");
    within([cone.factor(axis, l)], Range::within(1.0, 1.0))
}
