//! Faults planted in the source, each of which must make a claim fail.
//!
//! A copy of the source has all of them: each expression becomes `if planted(NUMBER) { fault } else { original }`, and
//! the environment variable `PLANTED` chooses one. So one build serves all.

use std::fs;
use std::path::Path;

/// A file, an expression that occurs in it once, a fault in its place, and the claim that must fail.
type Fault = (&'static str, &'static str, &'static str, &'static str);

pub const FAULTS: &[Fault] = &[
    // a limit is missing
    (
        "rgb",
        "channel.at_most(T::MAX)",
        "channel",
        "blinn_phong_even",
    ),
    (
        "rgb",
        "channel.if_positive(channel.at_most(T::ONE), T::ZERO)",
        "channel.at_most(T::ONE)",
        "clamped",
    ),
    (
        "attenuation",
        "factor.at_least(T::ZERO)",
        "factor",
        "attenuation_clamped",
    ),
    (
        "attenuation",
        "if self.clamped == YES { T::ONE } else { T::MAX }",
        "T::MAX",
        "attenuation_clamped",
    ),
    (
        "real/triple",
        "(T::ONE - square * square).at_least(T::ZERO)",
        "(T::ONE - square * square)",
        "ranged_beyond",
    ),
    ("soft_cone", "t.at_least(T::ZERO)", "t", "soft_cone_of_any"),
    (
        "soft_cone",
        "(t * t * (T::ONE + T::ONE + T::ONE - (t + t))).at_most(T::ONE)",
        "t * t * (T::ONE + T::ONE + T::ONE - (t + t))",
        "soft_cone_of_any",
    ),
    (
        "term",
        "n.dot(l).at_least(T::ZERO)",
        "n.dot(l)",
        "lambert_of_any",
    ),
    ("term", "m.at_most(T::MAX)", "m", "normalization_of_any"),
    (
        "real/triple",
        "(q / scale).at_most(T::MAX)",
        "(q / scale)",
        "point_light_of_any",
    ),
    (
        "real/triple",
        "factor.at_least(T::ZERO).at_most(limit())",
        "factor.at_most(limit())",
        "dimmed_is_at",
    ),
    (
        "real/triple",
        "factor.at_least(T::ZERO).at_most(limit())",
        "factor.at_least(T::ZERO)",
        "black_light",
    ),
    (
        "real/whole_power",
        "cosine.at_most(T::ONE)",
        "cosine",
        "powers_of_one",
    ),
    // a guard is missing
    (
        "real/triple",
        "length.if_above(T::MAX, T::ZERO, length)",
        "length",
        "unit_of_broken",
    ),
    (
        "unit",
        "(valid > T::ZERO)",
        "(valid <= T::MAX)",
        "unit_of_zero",
    ),
    (
        "real/triple",
        "length.if_above(T::MAX, T::ZERO, length)",
        "length",
        "unit_or_of_broken",
    ),
    (
        "real/triple",
        "valid.if_positive(c * reciprocal, otherwise)",
        "(c * reciprocal)",
        "point_light_of_finite",
    ),
    (
        "real/triple",
        "reciprocal * (T::MAX - reciprocal)",
        "reciprocal",
        "point_light_of_finite",
    ),
    (
        "normal/corner",
        "angle(product.length(), e1.dot(e2)).at_least(T::ZERO)",
        "angle(product.length(), e1.dot(e2))",
        "corner_of_two_points",
    ),
    (
        "normal/surface",
        "(largest(a), largest(b))",
        "(largest(a), largest(a))",
        "parametric_of_noise",
    ),
    (
        "exponent/mod",
        "cosine.if_positive(T::ONE, T::ZERO)",
        "T::ONE",
        "powers_in_the_dark",
    ),
    // a sign or a comparison is the wrong way round
    (
        "cone",
        "(self.cosine - (-axis).dot(l))",
        "((-axis).dot(l) - self.cosine)",
        "cone_on_its_axis",
    ),
    (
        "cone",
        "(self.cosine - (-axis).dot(l)).if_positive(T::ZERO, T::ONE)",
        "((-axis).dot(l) - self.cosine).if_positive(T::ONE, T::ZERO)",
        "soft_cone_of_one_angle",
    ),
    ("normal/derived", "(-n).dot(v)", "n.dot(v)", "facing_faces"),
    (
        "normal/derived",
        "away.if_positive(-c, c)",
        "(-away).if_positive(c, -c)",
        "facing_stays",
    ),
    (
        "light/incident",
        "n.dot(self.l).any_positive()",
        "(T::of_f32(0.01) - n.dot(self.l)).any_positive()",
        "sun_in_front",
    ),
    (
        "light/incident",
        "n.dot(self.l).any_positive()",
        "(n.dot(self.l) - T::of_f32(0.01)).any_positive()",
        "sun_in_front",
    ),
    (
        "light/in_front",
        "T::of_f32(-1.0 / 512.0)",
        "T::of_f32(-1.0 / 33_554_432.0)",
        "lamp_behind",
    ),
    (
        "light/in_front",
        "T::ONE / T::EXTREME",
        "T::ZERO",
        "lamp_behind",
    ),
    (
        "light/spot",
        "self.cone.factor(self.axis, incident.l).any_positive()",
        "(self.cone.factor(self.axis, incident.l) - T::of_f32(1.0e-30)).any_positive()",
        "spot_out_of_its_cone",
    ),
    (
        "cone",
        "T::NEG_ONE - two * slack",
        "T::NEG_ONE - slack",
        "cone_of_everything",
    ),
    (
        "range",
        "self.range * self.range",
        "(self.range * self.range).at_most(T::MAX)",
        "ranged_reaches_far",
    ),
    (
        "range",
        "self.range * self.range + T::ONE / T::EXTREME",
        "self.range",
        "ranged_reaches",
    ),
    (
        "range",
        "square.if_above(reach, T::ZERO, T::ONE)",
        "square.if_above(reach, T::ONE, T::ZERO)",
        "ranged_reaches",
    ),
    // a formula is another
    ("term", "m.raise(n.dot(h))", "n.dot(h)", "powers_of_any"),
    (
        "attenuation",
        "T::ONE / (a + q * (b + c * q))",
        "(T::ONE / (q * (a + q * (b + c * q))))",
        "attenuation_over_overflow",
    ),
    (
        "shade",
        "n_dot_l.if_positive(cosine(l), L::ZERO)",
        "L::ONE",
        "opposite",
    ),
    (
        "direction",
        "triple::reflection(n.into(), l.into())",
        "triple::reflection(l.into(), n.into())",
        "reflection_of_any",
    ),
    (
        "real/triple",
        "n_dot_l + n_dot_l",
        "n_dot_l",
        "reflection_of_any",
    ),
    (
        "light/spot",
        "incident.intensity * self.cone.factor(self.axis, incident.l)",
        "incident.intensity * (T::ONE - self.cone.factor(self.axis, incident.l) - T::ONE)",
        "spot_light_of_any",
    ),
    // what a constructor lets through
    ("attenuation", "a + T::ZERO", "a", "attenuation_of_any"),
    (
        "range",
        "(r > T::ZERO)",
        "(r >= T::ZERO)",
        "ranged_of_invalid",
    ),
    (
        "cone",
        "Self::with_slack(cosine + T::ZERO)",
        "Self::with_slack(cosine)",
        "cone_of_any_cosine",
    ),
    (
        "cone",
        "(cosine >= T::NEG_ONE && cosine <= T::ONE)",
        "(cosine >= T::NEG_ONE)",
        "cone_of_invalid_cosine",
    ),
    (
        "soft_cone",
        "(inner >= outer)",
        "(inner >= outer || outer >= inner)",
        "soft_cone_out_of_order",
    ),
    (
        "unit",
        "excess.abs() <= two * two * T::epsilon()",
        "excess <= two * two * T::epsilon()",
        "direction_of_broken",
    ),
    (
        "normal/tangent",
        "t.unit().filter(|_| d.abs() > T::ZERO)",
        "t.unit()",
        "tangent_of_broken",
    ),
    // a derivative is another
    (
        "dual/real",
        "T::divided(self.gradient.into(), root + root).into()",
        "self.gradient",
        "dual_root_at_zero",
    ),
    (
        "dual/real",
        "(-self.value).if_positive(ln, T::ONE / self.value)",
        "T::ONE / self.value",
        "dual_below_zero",
    ),
    (
        "dual/mod",
        "self.gradient * other.value + other.gradient * self.value",
        "self.gradient / other.value",
        "dual_sums_and_products",
    ),
    (
        "dual/mod",
        "self.value / other.value",
        "self.value / other.value + T::ONE",
        "dual_values",
    ),
];

/// A file of the prover, an expression that occurs in it once, and a wrong rule in its place: the tests of the prover
/// must fail.
pub const RULES: &[(&str, &str, &str)] = &[
    // NaN is forgotten
    (
        "range",
        "self.nan || b.nan || opposite(self, b) || opposite(b, self)",
        "self.nan || b.nan",
    ),
    (
        "range",
        "self.has(0.0) && b.is_infinite() || b.has(0.0) && self.is_infinite()",
        "false",
    ),
    (
        "range",
        "self.has(0.0) && b.has(0.0) || self.is_infinite() && b.is_infinite()",
        "false",
    ),
    ("range", "self.nan || self.low < 0.0", "self.nan"),
    ("known", "a.nan || a.low == -INF || a.high == INF", "a.nan"),
    (
        "known",
        "self.learn(g, a, at_most(of_b.high).or_nan())",
        "self.learn(g, a, at_most(of_b.high))",
    ),
    (
        "known",
        "self.learn(g, b, at_least(of_a.low).or_nan())",
        "self.learn(g, b, at_least(of_a.low))",
    ),
    // −0 is forgotten
    ("range", "self.minus_zero && b.has(0.0)", "false"),
    (
        "range",
        "if b.minus_zero { &[1.0, -1.0] } else { &[1.0] }",
        "&[1.0]",
    ),
    (
        "known",
        "is_maximum && x.low >= 0.0 && !x.minus_zero && !x.nan",
        "is_maximum && x.low >= 0.0 && !x.nan",
    ),
    (
        "known",
        "is_zero(self.range(g, c)) && !self.range(g, d).minus_zero",
        "is_zero(self.range(g, c))",
    ),
    // an end is too near
    (
        "range",
        "or(self.high * b.high, 0.0, f)",
        "or(self.low * b.high, 0.0, f)",
    ),
    ("range", "b.low.max(f.tiny())", "b.low.max(1.0)"),
    (
        "known",
        "Range::within(f.next_up(x), INF)",
        "Range::within(f.next_up(f.next_up(x)), INF)",
    ),
    (
        "known",
        "f.next_up(f.round(f.next_up(now.high) + of_b.high))",
        "f.round(now.high)",
    ),
    (
        "known",
        "f.next_up(f.round(f.next_up(now.high).sqrt()))",
        "f.next_down(f.round(now.high.sqrt()))",
    ),
    ("known", "if both { now.high } else { INF }", "now.high"),
    // a relation that does not hold
    (
        "relation",
        "self.answer(g, Test::AtMost(b, a)) == Some(true)",
        "self.answer(g, Test::AtMost(a, b)) == Some(true)",
    ),
    (
        "relation",
        "(a.sqrt() * b.sqrt()) * (1.0 + 16.0 * f.u())",
        "(a.sqrt() * b.sqrt()) * 0.9",
    ),
    (
        "relation",
        "(1.0 + f.tiny() / (2.0 * least)).sqrt() * (1.0 + 16.0 * f.u())",
        "1.0",
    ),
    ("relation", "!pairs.iter().any(of_vectors)", "false"),
    (
        "relation",
        "straight.min(of(a, q) * of(b, p)) * (1.0 + lost)",
        "0.9",
    ),
    (
        "relation",
        "0.9 * (-c - 32.0 * u) > 16.0 * tiny * (lost * r.high + 1.0)",
        "true",
    ),
    (
        "relation",
        "grow * (shrink * length * (1.0 - 16.0 * u) - 2.0 * tiny) - 2.0 * tiny",
        "grow * length",
    ),
    ("relation", "is_added(r, by_r) && is_added(s, by_s)", "true"),
    (
        "relation",
        "k * (1.0 + 8.0 * g.format.u()) + 1.0",
        "k * 0.5",
    ),
    (
        "relation",
        "k * self.step(g, other, depth - 1)",
        "k * k * self.step(g, other, depth - 1)",
    ),
    (
        "mirror",
        "4.0 * n.high * (n.high - 1.0).max(0.0)",
        "2.0 * n.high * (n.high - 1.0).max(0.0)",
    ),
    ("relation", "0.5 * a + 0.5 * b", "a.min(b)"),
    ("known", "is_always && !x.nan && !y.nan", "is_always"),
    // the number that records is another
    (
        "graph",
        "Node::Mul(a.min(b), a.max(b))",
        "Node::Mul(a.min(b), a.min(b))",
    ),
    (
        "term",
        "Test::Above(self.0, threshold.0)",
        "Test::Above(threshold.0, self.0)",
    ),
];

/// A file, an expression that occurs in it once, the same with a rounding more, and the error bound that must fail.
pub const ROUNDINGS: &[Fault] = &[
    (
        "real/triple",
        "T::divided(v, square.sqrt())",
        "T::scaled(v, T::ONE / square.sqrt())",
        "unit",
    ),
    (
        "term",
        "(valid(m) + T::of_f32(2.0))",
        "(valid(m) + T::of_f32(2.0)) * T::of_f32(3.0)",
        "phong_normalization",
    ),
    (
        "attenuation",
        "T::ONE / (a + q * (b + c * q))",
        "(T::of_f32(3.0) / (T::of_f32(3.0) * (a + q * (b + c * q))))",
        "attenuation",
    ),
];

const SWITCH: &str = "
extern crate std;
/// Whether this fault was chosen.
pub(crate) fn planted(number: usize) -> bool {
    static CHOSEN: std::sync::OnceLock<usize> = std::sync::OnceLock::new();
    let chosen = || std::env::var(\"PLANTED\").ok().and_then(|text| text.parse().ok());
    *CHOSEN.get_or_init(|| chosen().unwrap_or(usize::MAX)) == number
}
";

/// Faults in what the trait derives, each with the claim that Bitwuzla must refute.
pub const DERIVATIONS: &[Fault] = &[
    (
        "real/mod",
        "(self - threshold).if_positive(then, otherwise)",
        "(threshold - self).if_positive(otherwise, then)",
        "if_above_as_derived",
    ),
    ("real/mod", "self + -self", "self", "abs_as_derived"),
    (
        "real/mod",
        "(self - low).if_positive(Self::ZERO, Self::ONE)",
        "Self::ZERO",
        "outside_as_derived",
    ),
];

/// Their numbers, each with its claim.
pub fn derivations() -> impl Iterator<Item = (usize, &'static str)> {
    (FAULTS.len() + RULES.len() + ROUNDINGS.len()..).zip(DERIVATIONS.iter().map(|fault| fault.3))
}

/// The numbers of the faults that are roundings, each with its bound.
pub fn roundings() -> impl Iterator<Item = (usize, &'static str)> {
    (FAULTS.len() + RULES.len()..).zip(ROUNDINGS.iter().map(|fault| fault.3))
}

/// Plants all faults and all wrong rules in a copy of the source.
pub fn plant(folder: &Path) -> Result<(), String> {
    let first = FAULTS.len() + RULES.len();
    let numbered = FAULTS
        .iter()
        .enumerate()
        .chain((first..).zip(ROUNDINGS.iter().chain(DERIVATIONS)));
    let faults = numbered.map(|(number, &(file, old, new, _))| (number, file, old, new));
    plant_in(&folder.join("src"), &faults.collect::<Vec<_>>())?;
    let number_of = |rule: usize| FAULTS.len() + rule;
    let rules = RULES
        .iter()
        .enumerate()
        .map(|(rule, &(file, old, new))| (number_of(rule), file, old, new));
    plant_in(&folder.join("proofs/src"), &rules.collect::<Vec<_>>())?;
    for root in ["src/lib.rs", "proofs/src/lib.rs"] {
        let root = folder.join(root);
        let text = fs::read_to_string(&root).map_err(|e| e.to_string())?;
        fs::write(&root, text + SWITCH).map_err(|e| e.to_string())?;
    }
    Ok(())
}

/// A number, a file, an expression and what stands in its place.
type Change = (usize, &'static str, &'static str, &'static str);

fn plant_in(folder: &Path, changes: &[Change]) -> Result<(), String> {
    let at = |file: &str| folder.join(file).with_extension("rs");
    let mut files: Vec<&str> = changes.iter().map(|change| change.1).collect();
    files.sort_unstable();
    files.dedup();
    for file in files {
        let original = fs::read_to_string(at(file)).map_err(|e| format!("{file}: {e}"))?;
        let mut text = original.clone();
        let mut expressions: Vec<&str> = changes
            .iter()
            .filter(|change| change.1 == file)
            .map(|change| change.2)
            .collect();
        expressions.sort_by_key(|old| (usize::MAX - old.len(), *old)); // one may lie within another
        expressions.dedup();
        for old in expressions {
            if original.matches(old).count() != 1 {
                return Err(format!("{file} has not exactly one {old}"));
            }
            let of_it = changes
                .iter()
                .filter(|change| change.1 == file && change.2 == old);
            let choice = of_it.fold(String::new(), |choice, (number, _, _, new)| {
                format!("{choice}if crate::planted({number}) {{ {new} }} else ")
            });
            text = text.replace(old, &format!("({choice}{{ {old} }})"));
        }
        fs::write(at(file), text).map_err(|e| format!("{file}: {e}"))?;
    }
    Ok(())
}
