//! Falloff with distance, and beams.

use shading::{Attenuation, Cone, Real, UnitVec3, Vec3, attenuation};
use shading_proofs::{Given, Goal, Range, Term};

use super::given::*;

pub fn attenuation_of_any(given: Given) -> Vec<Goal> {
    let [a, b, c, q] = ["a", "b", "c", "q"].map(|name| given.any(name));
    let mut goals = within([attenuation(a, b, c, q)], not_negative(given));
    if let Some(made) = Attenuation::new(a, b, c) {
        let checked = Range::unsigned(0.0, given.format().max());
        goals.extend(within(made.coefficients(), checked));
    }
    goals
}

pub fn attenuation_of_invalid(given: Given) -> Vec<Goal> {
    let mut abc = ["a", "b", "c"].map(|name| given.any(name));
    match given.one_of(5) {
        3 => abc = ["x", "y", "z"].map(|name| given.number(name, nothing())),
        4 => {
            let free = unlimited(given);
            let x = given.number("x", Range::within(-INF, 0.0).or_nan());
            return none(match given.one_of(3) {
                0 => free.clamped_to(x),
                window => WINDOWS[window as usize].1(free, x),
            });
        }
        i => abc[i as usize] = invalid(given, "invalid"),
    }
    let [a, b, c] = abc;
    none(Attenuation::new(a, b, c))
}

pub fn attenuation_in_its_limits(given: Given) -> Vec<Goal> {
    let Some(falloff) = any_attenuation(given) else {
        return vec![];
    };
    let (q, max) = (given.any("q"), not_negative(given));
    let mut goals = within([falloff.at(q)], max);
    goals.push(Goal::AtMost(
        falloff.at(q),
        falloff.limit().unwrap_or(Term::MAX),
    ));
    goals.extend(within(falloff.coefficients(), max));
    goals.extend(within(falloff.range(), max));
    goals
}

/// A distance, and one that is not less. 0 is a case of its own, because ∞ · 0 is NaN.
fn distances(given: Given) -> [Term; 2] {
    let format = given.format();
    let near = match given.one_of(2) {
        0 => Term::ZERO,
        _ => given.number("near", Range::within(format.tiny(), format.max())),
    };
    let far = given.number("far", Range::within(format.tiny(), INF));
    given.assume_at_most(near, far);
    [near, far]
}

pub fn attenuation_never_rises(given: Given) -> Vec<Goal> {
    if given.one_of(2) == 0 {
        let [near, far] = distances(given);
        let falloff = any_attenuation(given);
        return falloff.map_or(vec![], |falloff| {
            vec![Goal::AtMost(falloff.at(far), falloff.at(near))]
        });
    }
    // the formula itself, with each of its numbers
    let mut numbers = ["a", "b", "c"].map(|name| checked(given, name)).to_vec();
    let format = given.format();
    numbers.push(match given.one_of(2) {
        0 => Term::ZERO,
        _ => given.number("q", Range::within(format.tiny(), format.max())),
    });
    let of = |x: &[Term]| attenuation(x[0], x[1], x[2], x[3]);
    let (before, which) = (of(&numbers), given.one_of(4) as usize);
    let more = given.number("more", Range::unsigned(format.tiny(), format.max()));
    given.assume_at_most(numbers[which], more);
    numbers[which] = more;
    vec![Goal::AtMost(of(&numbers), before)]
}

pub fn range_ends(given: Given) -> Vec<Goal> {
    let (q, free, format) = (given.number("q", light()), limited(given), given.format());
    let window = WINDOWS[1 + given.one_of(2) as usize].1;
    let below = Range::within(format.tiny(), format.next_down(format.max()));
    let Some(ranged) = free.and_then(|free| window(free, given.number("r", below))) else {
        return vec![];
    };
    given.assume_at_most(ranged.range().unwrap_or(Term::MAX), q);
    within([ranged.at(q)], nothing())
}

pub fn range_never_adds(given: Given) -> Vec<Goal> {
    let (q, free) = (given.number("q", light()), limited(given));
    let window = WINDOWS[1 + given.one_of(2) as usize].1;
    let pair = free.and_then(|free| Some((free, window(free, given.any("r"))?)));
    pair.map_or(vec![], |(free, ranged)| {
        vec![Goal::AtMost(ranged.at(q), free.at(q))]
    })
}

pub fn cone_of_any(given: Given) -> Vec<Goal> {
    let cone = match given.one_of(2) {
        0 => any_cone(given),
        _ => Cone::from_half_angles(given.any("inner"), given.any("outer")),
    };
    let (axis, l) = (any_direction(given, "axis"), any_direction(given, "l"));
    cone.map_or(vec![], |cone| {
        let cosines = within(cone.cosines(), Range::within(-1.0, 1.0));
        [cosines, within([cone.factor(axis, l)], share())].concat()
    })
}

pub fn cone_of_invalid(given: Given) -> Vec<Goal> {
    let (other, pi) = (
        given.any("other"),
        given.format().round(std::f64::consts::PI),
    );
    let are_angles = given.one_of(2) == 1;
    let (low, high) = if are_angles { (0.0, pi) } else { (-1.0, 1.0) };
    let (inner, outer) = match given.one_of(3) {
        0 => (outside(given, "inner", low, high), other),
        1 => (other, outside(given, "outer", low, high)),
        _ => {
            let beyond = given.any("beyond");
            given.assume_above(beyond, other);
            if are_angles {
                (beyond, other)
            } else {
                (other, beyond)
            }
        }
    };
    if are_angles {
        none(Cone::from_half_angles(inner, outer))
    } else {
        none(Cone::from_cosines(inner, outer))
    }
}

pub fn cone_on_its_axis(given: Given) -> Vec<Goal> {
    let axis = given.unit("axis");
    let one = Range::within(1.0, 1.0);
    any_cone(given).map_or(vec![], |cone| within([cone.factor(axis, -axis)], one))
}

pub fn cone_never_falls(given: Given) -> Vec<Goal> {
    // against −X, the cosine is the x of L
    let axis = UnitVec3::assume_unit(Vec3::new(Term::NEG_ONE, Term::ZERO, Term::ZERO));
    let [less, more] = ["less", "more"].map(|name| given.number(name, Range::within(-1.25, 1.25)));
    given.assume_at_most(less, more);
    let along = |x| UnitVec3::assume_unit(Vec3::new(x, Term::ZERO, Term::ZERO));
    let cone = Cone::from_cosines(given.any("inner"), given.any("outer"));
    cone.map_or(vec![], |cone| {
        let [less, more] = [less, more].map(|x| cone.factor(axis, along(x)));
        vec![Goal::AtMost(less, more)]
    })
}

/// A cone of half-angle π, in a direction whose cosine to the axis is what `cosine_of_units` proves.
pub fn cone_of_everything(given: Given) -> Vec<Goal> {
    let [axis, l] = ["axis", "l"].map(|name| any_direction(given, name));
    let least = -1.0 - 16.0 * given.format().u();
    given.assume_at_most(Term::of(least), dot([-axis.x, -axis.y, -axis.z], l));
    let cone = match given.one_of(2) {
        0 => Cone::from_cosine(Term::NEG_ONE),
        _ => Cone::from_cosines(Term::NEG_ONE, Term::NEG_ONE).map(Cone::smoothstep),
    };
    within(
        [cone.expect("a cone").factor(axis, l)],
        Range::within(1.0, 1.0),
    )
}
