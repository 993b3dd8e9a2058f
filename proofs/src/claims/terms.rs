//! The factors of the formulas.

use shading::{Exponent, Falloff, Real, attenuation as plain, term};
use shading_proofs::{Goal, Range};

use super::*;

/// Every m up to 1024, and the largest.
fn shininess() -> impl Iterator<Item = u32> {
    (0..=1024).chain([u32::MAX])
}
fn powers(given: Given, cosine: Range, ms: impl Iterator<Item = u32>, range: Range) -> Vec<Goal> {
    let cosine = given.number("cosine", cosine);
    within(ms.map(|m| m.raise(cosine)), range)
}
/// The denominator, as `Attenuation` computes it.
fn denominator([a, b, c]: [Term; 3], q: Term) -> Term {
    a + q * (b + c * q)
}
/// Any bits: up to 1, and from there octave by octave, so that m/m is not lost to the ends of an interval.
fn octave(given: Given) -> Range {
    let exponents = if is_single(given) { 128 } else { 1024 };
    match given.one_of(exponents + 1) {
        0 => Range {
            low: -INF,
            high: 1.0,
            ..Range::ANY
        },
        n => {
            let power = f64::from(n - 1).exp2();
            Range::within(power, if n == exponents { INF } else { 2.0 * power })
        }
    }
}

claims! {
    limits: "`Real::at_least` of any bits is at least its limit, which is not NaN, and `Real::at_most` of any number is at most its limit" |given| {
        let (x, nan) = (given.any("x"), given.number("nan", Range::NAN));
        let number = |name| given.number(name, Range::within(-INF, INF));
        let (y, limit) = (number("y"), number("limit"));
        vec![Goal::AtMost(limit, x.at_least(limit)), Goal::AtMost(y.at_most(limit), limit), Goal::Same(nan.at_least(limit), limit)]
    }
    ambient: "`term::ambient` is in [0, ∞]" |given| {
        channels(term::ambient(given.rgb("k_a"), given.rgb("I_a")), light())
    }
    lambert_of_any: "`term::lambert` of any bits is in [0, ∞]" |given| {
        within([term::lambert(any_direction(given, "n"), any_direction(given, "l"))], light())
    }
    lambert_behind: "`term::lambert` is 0 if N·L ≤ 0" |given| {
        let (n, l) = (any_direction(given, "n"), any_direction(given, "l"));
        given.assume_at_most(n.dot(l), Term::ZERO);
        within([term::lambert(n, l)], Range::unsigned(0.0, 0.0))
    }
    lambert_of_nan: "`term::lambert` is 0 if L is NaN" |given| {
        let l = nan_direction(given, "l");
        within([term::lambert(any_direction(given, "n"), l)], Range::unsigned(0.0, 0.0))
    }
    lambert_of_units: "`term::lambert` of directions is at most 1 + 16 u" |given| {
        within([term::lambert(given.unit("n"), given.unit("l"))], Range::within(0.0, 1.0 + 16.0 * given.format().u()))
    }
    powers_of_any: "`term::phong`, `term::blinn` and `Exponent::raise` of any bits are in [0, 1], every m up to 1024 and 2³² − 1" |given| {
        let (n, h) = (any_direction(given, "n"), any_direction(given, "h"));
        let both = shininess().flat_map(|m| [term::phong(n, h, m), term::blinn(n, h, m)]);
        within(both, Range::unsigned(0.0, 1.0))
    }
    powers_in_the_dark: "`term::phong` and `term::blinn` are 0 for a cosine that is not above 0 or is NaN, the same m" |given| {
        let dark = Range::within(-INF, 0.0).or_nan();
        powers(given, dark, shininess(), Range::unsigned(0.0, 0.0))
    }
    powers_of_one: "`term::phong` and `term::blinn` are 1 for a cosine of 1 or above, the same m" |given| {
        powers(given, Range::within(1.0, INF), shininess(), Range::within(1.0, 1.0))
    }
    power_zero: "`term::phong` and `term::blinn` with m = 0 are 1 for every cosine above 0" |given| {
        powers(given, Range::within(given.format().tiny(), INF), 0..=0, Range::within(1.0, 1.0))
    }
    power_huge: "`term::phong` and `term::blinn` with m = 2³² − 1 are 0 for every cosine up to 1 − 2⁻²²" |given| {
        let cosine = Range::within(0.0, 1.0 - 2.0_f64.powi(-22));
        powers(given, cosine, [u32::MAX].into_iter(), Range::within(0.0, 0.0))
    }
    normalization_of_any: "`phong_normalization` of any bits is in [0.3, MAX]" |given| {
        within([term::phong_normalization(given.any("m"))], Range::within(0.3, given.format().max()))
    }
    blinn_normalization_of_any: "`blinn_normalization` of any bits is in [0.02, MAX], given that a power cᵐ is within [0, 1], and at least c − 2⁻²⁰ for m ≤ 1" |given| {
        within([term::blinn_normalization(given.number("m", octave(given)))], Range::within(0.02, given.format().max()))
    }
    normalization_of_zero: "`phong_normalization` and `blinn_normalization` of 0 are 1/π, to 8 u" |given| {
        let m = given.number("m", Range::within(0.0, 0.0));
        let (exact, error) = (std::f64::consts::FRAC_1_PI, 8.0 * given.format().u());
        let near = Range::within(exact * (1.0 - error), exact * (1.0 + error));
        within([term::phong_normalization(m), term::blinn_normalization(m)], near)
    }
    normalization_of_infinity: "`phong_normalization` and `blinn_normalization` of ∞ are those of the largest number, to the bit" |given| {
        let (m, max) = (given.number("m", Range::within(INF, INF)), Term::MAX);
        vec![
            Goal::Same(term::phong_normalization(m), term::phong_normalization(max)),
            Goal::Same(term::blinn_normalization(m), term::blinn_normalization(max)),
        ]
    }
    normalization_of_invalid: "`phong_normalization` and `blinn_normalization` below 0 and of NaN are those of 0, to the bit" |given| {
        let (m, zero) = (given.number("m", Range::within(-INF, 0.0).or_nan()), Term::ZERO);
        vec![
            Goal::Same(term::phong_normalization(m), term::phong_normalization(zero)),
            Goal::Same(term::blinn_normalization(m), term::blinn_normalization(zero)),
        ]
    }
    attenuation_without_denominator: "`attenuation` is ∞ if a = b = c = 0 and q is finite" |given| {
        let (q, zero) = (given.number("q", not_negative(given)), Term::ZERO);
        within([plain(zero, zero, zero, q)], Range::within(INF, INF))
    }
    attenuation_over_overflow: "`attenuation` is 0 if the denominator overflows" |given| {
        let [a, b, c] = ["a", "b", "c"].map(|name| given.any(name));
        let q = given.any("q");
        given.assume_above(denominator([a, b, c], q), Term::MAX);
        within([plain(a, b, c, q)], Range::unsigned(0.0, 0.0))
    }
    attenuation_at: "`Attenuation::at` of any q ≥ 0, ∞ too, is in [0, MAX]" |given| {
        within([attenuation(given).at(given.number("q", light()))], not_negative(given))
    }
    attenuation_clamped: "`Attenuation::clamped`: `Attenuation::at` of any bits is in [0, 1]" |given| {
        within([attenuation(given).clamped().at(given.any("q"))], UP_TO_ONE)
    }
    attenuation_at_no_denominator: "`Attenuation::at` is the largest number, and 1 if clamped, where a + bq + cq² = 0" |given| {
        let (abc, q) = (coefficients(given), given.number("q", not_negative(given)));
        given.assume_at_most(denominator(abc, q), Term::ZERO);
        let (max, falloff) = (given.format().max(), attenuation_of(abc));
        [within([falloff.at(q)], Range::within(max, max)), within([falloff.clamped().at(q)], Range::within(1.0, 1.0))].concat()
    }
    dimmed_is_at: "`Falloff::dim` of `Attenuation` is I·at(q), at most the largest number, to the bit" |given| {
        let (q, i, falloff) = (given.number("q", light()), given.rgb("I"), attenuation(given));
        let at = falloff.at(q);
        same(Falloff::dim(&falloff, &i, q), i.map(|i| (i * at).at_most(Term::MAX)))
    }
    ranged_at: "`Ranged::at` of any bits, also of `Ranged::unsquared`, is in [0, MAX]" |given| {
        let (falloff, q) = (any_ranged(given), given.any("q"));
        within([falloff.at(q), falloff.unsquared().at(q)], not_negative(given))
    }
    ranged_beyond: "`Ranged::at`, unsquared or not, is 0 for q ≥ r and for NaN" |given| {
        let (falloff, q) = (any_ranged(given), given.number("q", light()));
        let nan = given.number("nan", Range::NAN);
        given.assume_at_most(falloff.range(), q);
        let at = |q| [falloff.at(q), falloff.unsquared().at(q)];
        within([at(q), at(nan)].concat(), Range::within(0.0, 0.0))
    }
    ranged_without_end: "`Ranged::at` with r = ∞, unsquared or not, is `Attenuation::at`, to the bit" |given| {
        let (falloff, q) = (ranged(given, Range::within(INF, INF)), given.number("q", not_negative(given)));
        let free = falloff.attenuation().at(q);
        vec![Goal::Same(falloff.at(q), free), Goal::Same(falloff.unsquared().at(q), free)]
    }
    ranged_reaches: "a light that `Falloff::reaches` of `Ranged` leaves out by its squared distance has q ≥ r" |given| {
        let (falloff, square) = (any_ranged(given), given.number("square", light()));
        if Falloff::reaches(&falloff, square) {
            return vec![];
        }
        vec![Goal::AtMost(falloff.range(), square.sqrt())]
    }
    ranged_reaches_far: "`Falloff::reaches` of `Ranged` leaves out no light if r² overflows, as with r = ∞; squared distances of any bits" |given| {
        let (falloff, square) = (any_ranged(given), given.any("square"));
        given.assume_above(falloff.range() * falloff.range(), Term::MAX);
        if Falloff::reaches(&falloff, square) { vec![] } else { vec![Goal::Never] }
    }
    cone_of_any: "`Cone::factor` of any bits is in [0, 1]" |given| {
        let cone = cone(given.any("cosine"));
        within([cone.factor(any_direction(given, "axis"), any_direction(given, "l"))], UP_TO_ONE)
    }
    cone_of_nan: "`Cone::factor` is 1 if L is NaN" |given| {
        let l = nan_direction(given, "l");
        let factor = cone(given.any("cosine")).factor(any_direction(given, "axis"), l);
        within([factor], Range::within(1.0, 1.0))
    }
    cone_on_its_axis: "`Cone::factor` and `SoftCone::factor` are 1 on the axis, whatever `Cone::of_cosine` and `SoftCone::of_cosines` get" |given| {
        let (axis, one) = (given.unit("axis"), Range::within(1.0, 1.0));
        let (inner, outer) = (given.any("inner"), given.any("outer"));
        let hard = Cone::of_cosine(inner).map_or(vec![], |cone| within([cone.factor(axis, -axis)], one));
        let soft = SoftCone::of_cosines(inner, outer).map_or(vec![], |cone| within([cone.factor(axis, -axis)], one));
        [hard, soft].concat()
    }
    cone_of_everything: "`Cone::factor` and `SoftCone::factor` are 1 in every direction, for cosines of −1 and a half-angle of π" |given| {
        let (axis, l, minus) = (given.unit("axis"), given.unit("l"), Term::NEG_ONE);
        let cones = [Cone::of_cosine(minus), Cone::of_half_angle(number(std::f64::consts::PI))];
        let factors = cones.map(|cone| cone.expect("a cone").factor(axis, l));
        let soft = SoftCone::of_cosines(minus, minus).expect("a cone").factor(axis, l);
        within(factors.into_iter().chain([soft]), Range::within(1.0, 1.0))
    }
    soft_cone_of_any: "`SoftCone::factor` is in [0, 1], axis and L of any bits, with a smoothstep too" |given| {
        let (axis, l) = (any_direction(given, "axis"), any_direction(given, "l"));
        let soft = soft_cone(given);
        within([soft.factor(axis, l), soft.smoothstep().factor(axis, l)], UP_TO_ONE)
    }
    soft_cone_of_one_angle: "`SoftCone::factor` with inner = outer is `Cone::factor` and `Beam::factor`, to the bit, axis and L of any bits" |given| {
        let cosine = given.number("cosine", Range::within(-1.0 - slack(given), 1.0));
        let (axis, l) = (any_direction(given, "axis"), any_direction(given, "l"));
        let hard = cone(cosine).factor(axis, l);
        let soft = soft_cone_of(cosine, cosine);
        vec![Goal::Same(shading::Beam::factor(soft, axis, l), hard), Goal::Same(soft.factor(axis, l), hard), Goal::Same(soft.smoothstep().factor(axis, l), hard)]
    }
}
