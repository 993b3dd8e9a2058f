//! What the constructors let through, and what they make of it.

use shading::{Attenuation, Cone, Ranged, SoftCone, UnitVec3};
use shading_proofs::{Goal, Range};

use super::*;

/// Below 0, infinite or NaN.
fn invalid(given: Given, name: &str) -> Term {
    let below = Range {
        minus_zero: false,
        ..Range::within(-INF, -given.format().tiny())
    };
    given.number(name, [below, Range::NOT_FINITE][given.one_of(2) as usize])
}
/// Outside of [−limit, limit], or NaN.
fn beyond(given: Given, name: &str, limit: f64) -> Term {
    let above = Range::within(given.format().next_up(limit), INF).or_nan();
    given.number(name, [above, above.opposite()][given.one_of(2) as usize])
}
/// A zero of either sign.
fn zero_of(given: Given, name: &str) -> Term {
    given.number(name, Range::within(0.0, 0.0))
}
fn lit(given: Given, soft: SoftCone<Term>) -> Vec<Goal> {
    let (axis, l) = (any_direction(given, "axis"), any_direction(given, "l"));
    within(
        [soft.factor(axis, l), soft.smoothstep().factor(axis, l)],
        UP_TO_ONE,
    )
}

claims! {
    attenuation_of_any: "`Attenuation::of` of any bits is `None`, or its `Attenuation::coefficients` are in [0, MAX] and its `Attenuation::at` of any q ≥ 0 is in [0, MAX]" |given| {
        let [a, b, c] = ["a", "b", "c"].map(|name| given.any(name));
        let q = given.number("q", light());
        Attenuation::of(a, b, c).map_or(vec![], |made| {
            let [a, b, c] = made.coefficients();
            let mut goals = within([b, c, made.at(q)], not_negative(given));
            goals.push(Goal::Within(a, Range::unsigned(0.0, given.format().max())));
            goals
        })
    }
    attenuation_of_invalid: "`Attenuation::of` is `None` if a coefficient is negative, infinite or NaN, or all are 0" |given| {
        let (x, y, bad) = (given.any("x"), given.any("y"), invalid(given, "bad"));
        let [a, b, c] = ["a", "b", "c"].map(|name| zero_of(given, name));
        [(bad, x, y), (x, bad, y), (x, y, bad), (a, b, c)].map(|(a, b, c)| none(Attenuation::of(a, b, c))).concat()
    }
    ranged_of_any: "`Ranged::of` of any r above 0 keeps the bits of `Ranged::range` and `Ranged::attenuation`, and its `Ranged::at` of any bits is in [0, MAX]" |given| {
        let (plain, r, q) = (attenuation(given), given.any("r"), given.any("q"));
        Ranged::of(plain, r).map_or(vec![], |made| {
            let kept = same(made.attenuation().coefficients(), plain.coefficients());
            [kept, vec![Goal::Same(made.range(), r)], within([made.at(q)], not_negative(given))].concat()
        })
    }
    ranged_of_invalid: "`Ranged::of` is `None` for r ≤ 0 and NaN" |given| {
        none(Ranged::of(attenuation(given), given.number("r", Range::within(-INF, 0.0).or_nan())))
    }
    cone_of_any_cosine: "`Cone::of_cosine` of any bits is `None`, or its `Cone::cosine` is in [−1, 1] and never −0" |given| {
        let unsigned = Range::unsigned(-1.0, 1.0);
        Cone::of_cosine(given.any("cosine")).map_or(vec![], |cone| within([cone.cosine()], unsigned))
    }
    cone_of_invalid_cosine: "`Cone::of_cosine` and `SoftCone::of_cosines` are `None` for a cosine outside of [−1, 1] and for NaN" |given| {
        let (cosine, other) = (beyond(given, "cosine", 1.0), given.any("other"));
        [none(Cone::of_cosine(cosine)), none(SoftCone::of_cosines(cosine, other)), none(SoftCone::of_cosines(other, cosine))].concat()
    }
    cone_of_any_half_angle: "`Cone::of_half_angle` of any bits is `None`, or its `Cone::cosine` is in [−1, 1]" |given| {
        let cone = Cone::of_half_angle(given.any("angle"));
        cone.map_or(vec![], |cone| within([cone.cosine()], Range::within(-1.0, 1.0)))
    }
    cone_of_invalid_half_angle: "`Cone::of_half_angle` and `SoftCone::of_half_angles` are `None` for an angle below 0 or above 3.15, and for NaN" |given| {
        let invalid = [Range::within(3.15, INF), Range { minus_zero: false, ..Range::within(-INF, -given.format().tiny()) }];
        let (angle, other) = (given.number("angle", invalid[given.one_of(2) as usize].or_nan()), given.any("other"));
        [none(Cone::of_half_angle(angle)), none(SoftCone::of_half_angles(angle, other)), none(SoftCone::of_half_angles(other, angle))].concat()
    }
    soft_cone_of_any_cosines: "`SoftCone::of_cosines` of any bits is `None`, or its `SoftCone::cosines` are in [−1, 1] and its `SoftCone::factor` is in [0, 1], axis and L of any bits, with a `SoftCone::smoothstep` too" |given| {
        let soft = SoftCone::of_cosines(given.any("inner"), given.any("outer"));
        soft.map_or(vec![], |soft| [within(soft.cosines(), Range::within(-1.0, 1.0)), lit(given, soft)].concat())
    }
    soft_cone_of_any_half_angles: "`SoftCone::of_half_angles` of any bits is `None`, or its `SoftCone::cosines` are in [−1, 1] and its `SoftCone::factor` is in [0, 1], axis and L of any bits" |given| {
        let soft = SoftCone::of_half_angles(given.any("inner"), given.any("outer"));
        soft.map_or(vec![], |soft| [within(soft.cosines(), Range::within(-1.0, 1.0)), lit(given, soft)].concat())
    }
    soft_cone_out_of_order: "`SoftCone::of_cosines` and `SoftCone::of_half_angles` are `None` if the inner cosine is below the outer one, or the inner angle above the outer one" |given| {
        let (less, more) = (given.any("less"), given.any("more"));
        given.assume_above(more, less);
        [none(SoftCone::of_cosines(less, more)), none(SoftCone::of_half_angles(more, less))].concat()
    }
    direction_of_any: "`UnitVec3::of` of any bits is `None`, or its argument, each component in [−1.01, 1.01]" |given| {
        let v = any_vector(given, "v");
        UnitVec3::of(v.x, v.y, v.z).map_or(vec![], |made| [same(*made, v), components(*made, Range::within(-1.01, 1.01))].concat())
    }
    direction_of_broken: "`UnitVec3::of` is `None` for the zero vector, and if a component is infinite or NaN" |given| {
        [zero(given, "zero"), broken(given, "broken")].map(|v| none(UnitVec3::of(v.x, v.y, v.z))).concat()
    }
}
