//! The terms of the model, and numbers that differentiate.

use shading::{Dual, Lobe, Real, UnitVec3, Vec3, term};
use shading_proofs::{Given, Goal, Range, Term};

use super::given::*;

pub fn lambert_of_any(given: Given) -> Vec<Goal> {
    let (n, l) = (any_direction(given, "n"), any_direction(given, "l"));
    within([term::lambert(n, l)], light())
}

/// The ends of what rounding makes of the cosine of two directions.
fn cosines(given: Given) -> Range {
    let most = 1.0 + 16.0 * given.format().u();
    Range::within(-most, most)
}

pub fn cosine_of_units(given: Given) -> Vec<Goal> {
    let (n, l) = (given.unit("n"), given.unit("l"));
    within([dot(n, l), dot([-n.x, -n.y, -n.z], l)], cosines(given))
}

pub fn lambert_of_units(given: Given) -> Vec<Goal> {
    let (n, l) = (any_direction(given, "n"), any_direction(given, "l"));
    given.assume_at_most(dot(n, l), Term::of(cosines(given).high));
    within(
        [term::lambert(n, l)],
        Range::within(0.0, cosines(given).high),
    )
}

/// Small ones, odd and even, and the largest: what a power by squaring does with bits.
pub const SHININESS: [u32; 9] = [0, 1, 2, 3, 5, 32, 127, 1000, u32::MAX];

/// The factors of both highlights, for a cosine of a range.
fn highlights(given: Given, cosine: Range, ms: &[u32], range: Range) -> Vec<Goal> {
    let cosine = Vec3::new(given.number("cosine", cosine), Term::ZERO, Term::ZERO);
    let cosine = UnitVec3::assume_unit(cosine);
    let of = |m| {
        [
            term::phong(cosine, UnitVec3::X, m),
            term::blinn(UnitVec3::X, cosine, m),
        ]
    };
    within(ms.iter().flat_map(|m| of(*m)), range)
}

pub fn highlights_of_any(given: Given) -> Vec<Goal> {
    highlights(given, Range::ANY, &SHININESS, Range::unsigned(0.0, 1.0))
}

pub fn highlights_in_the_dark(given: Given) -> Vec<Goal> {
    let dark = Range::within(-INF, 0.0).or_nan();
    highlights(given, dark, &SHININESS, Range::unsigned(0.0, 0.0))
}

pub fn highlights_of_one(given: Given) -> Vec<Goal> {
    let (one, bright) = (Range::within(1.0, 1.0), Range::within(1.0, INF));
    let lit = Range::within(given.format().tiny(), INF);
    match given.one_of(2) {
        0 => highlights(given, bright, &SHININESS, one),
        _ => highlights(given, lit, &[0], one),
    }
}

/// Powers as the sums take them: of a cosine in [0, 1], and of its square.
pub fn powers_in_their_range(given: Given) -> Vec<Goal> {
    let cosine = given.number("cosine", share());
    let m = SHININESS[given.one_of(9) as usize];
    within([m.raise(cosine), m.raise_root(cosine)], share())
}

/// One step of a power by squaring: of the base, and of the power so far.
pub fn one_squaring(given: Given) -> Vec<Goal> {
    let [base, power] = ["base", "power"].map(|name| given.number(name, share()));
    within([base.whole_power(2), power * base], share())
}

pub fn phong_normalization(given: Given) -> Vec<Goal> {
    let range = Range::within(0.3, given.format().max());
    within([term::phong_normalization(given.any("m"))], range)
}

/// Any bits, in parts: up to 1, and then by powers of two of which each halves what is left of the exponents, so
/// that m/m is not lost to the ends of an interval.
fn in_parts(given: Given) -> Range {
    let largest = 1 << (given.format().shape().0 - 1);
    let mut parts = vec![Range::within(-INF, 0.0).or_nan(), Range::within(0.0, 1.0)];
    let mut exponent = 0;
    while exponent < largest - 1 {
        let next = exponent + (largest - exponent + 1) / 2;
        let next = next.min(largest - 1);
        parts.push(Range::within(2.0_f64.powi(exponent), 2.0_f64.powi(next)));
        exponent = next;
    }
    parts.push(Range::within(2.0_f64.powi(exponent), INF));
    parts[given.one_of(u32::try_from(parts.len()).expect("few")) as usize]
}

pub fn blinn_normalization(given: Given) -> Vec<Goal> {
    let m = given.number("m", in_parts(given));
    let range = Range::within(0.02, given.format().max());
    within([term::blinn_normalization(m)], range)
}

pub fn dual_values(given: Given) -> Vec<Goal> {
    let dual = |name| Dual {
        value: given.any(name),
        gradient: any_vector(given, &format!("∇{name}")),
    };
    let (f, g) = (dual("f"), dual("g"));
    let (x, y) = (f.value, g.value);
    let pairs = [
        (f + g, x + y),
        (f - g, x - y),
        (f * g, x * y),
        (f / g, x / y),
        (f.sqrt(), x.sqrt()),
        (-f, -x),
    ];
    pairs
        .map(|(dual, number)| Goal::Same(dual.value, number))
        .into()
}
