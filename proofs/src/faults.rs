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
    ("rgb", "channel.at_most(T::MAX)", "channel", "blinn_phong_even"),
    ("rgb", "channel.if_positive(channel.at_most(T::ONE), T::ZERO)", "channel.at_most(T::ONE)", "clamped"),
    ("attenuation", "factor.at_least(T::ZERO)", "factor", "attenuation_clamped"),
    ("attenuation", "if self.clamped == YES { T::ONE } else { T::MAX }", "T::MAX", "attenuation_clamped"),
    ("real/triple", "(T::ONE - square * square).at_least(T::ZERO)", "(T::ONE - square * square)", "ranged_beyond"),
    ("soft_cone", "t.at_least(T::ZERO)", "t", "soft_cone_of_any"),
    (
        "soft_cone",
        "(t * t * (T::ONE + T::ONE + T::ONE - (t + t))).at_most(T::ONE)",
        "t * t * (T::ONE + T::ONE + T::ONE - (t + t))",
        "soft_cone_of_any",
    ),
    ("term", "n.dot(l).at_least(T::ZERO)", "n.dot(l)", "lambert_of_any"),
    ("term", "m.at_most(T::MAX)", "m", "normalization_of_any"),
    ("real/triple", "(q / scale).at_most(T::MAX)", "(q / scale)", "point_light_of_any"),
    ("real/triple", "factor.at_least(T::ZERO).at_most(limit())", "factor.at_most(limit())", "dimmed_is_at"),
    ("real/triple", "factor.at_least(T::ZERO).at_most(limit())", "factor.at_least(T::ZERO)", "black_light"),
    ("real/whole_power", "cosine.if_above(top, T::ONE, cosine)", "cosine", "powers_of_one"),
    // a guard is missing
    ("unit", "(length > T::ZERO && length <= T::MAX)", "(length > T::ZERO)", "unit_of_broken"),
    ("unit", "(length > T::ZERO && length <= T::MAX)", "(length <= T::MAX)", "unit_of_zero"),
    ("unit", "length.if_above(T::MAX, T::ZERO, length)", "length", "unit_or_of_broken"),
    ("real/triple", "valid.if_positive(c * reciprocal, otherwise)", "(c * reciprocal)", "point_light_of_finite"),
    ("real/triple", "reciprocal * (T::MAX - reciprocal)", "reciprocal", "point_light_of_finite"),
    (
        "normal/corner",
        "sine.if_positive(angle(sine / lengths, e1.dot(e2) / lengths), T::ZERO)",
        "angle(sine / lengths, e1.dot(e2) / lengths)",
        "corner_of_two_points",
    ),
    ("normal/surface", "(largest(s_u), largest(s_v))", "(largest(s_u), largest(s_u))", "parametric_of_noise"),
    ("exponent/mod", "cosine.if_positive(T::ONE, T::ZERO)", "T::ONE", "powers_in_the_dark"),
    // a sign or a comparison is the wrong way round
    ("cone", "(self.cosine - (-axis).dot(l))", "((-axis).dot(l) - self.cosine)", "cone_on_its_axis"),
    (
        "cone",
        "(self.cosine - (-axis).dot(l)).if_positive(T::ZERO, T::ONE)",
        "((-axis).dot(l) - self.cosine).if_positive(T::ONE, T::ZERO)",
        "soft_cone_of_one_angle",
    ),
    ("normal/derived", "(-n).dot(v)", "n.dot(v)", "facing_faces"),
    ("normal/derived", "away.if_positive(-c, c)", "(-away).if_positive(c, -c)", "facing_stays"),
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
    ("range", "self.range * self.range + T::ONE / T::EXTREME", "self.range", "ranged_reaches"),
    ("range", "square.if_above(reach, T::ZERO, T::ONE)", "square.if_above(reach, T::ONE, T::ZERO)", "ranged_reaches"),
    // a formula is another
    ("term", "m.raise(n.dot(h))", "n.dot(h)", "powers_of_any"),
    (
        "attenuation",
        "T::ONE / (a + q * (b + c * q))",
        "(T::ONE / (q * (a + q * (b + c * q))))",
        "attenuation_over_overflow",
    ),
    ("shade", "n_dot_l.if_positive(cosine(l), T::ZERO)", "T::ONE", "opposite"),
    (
        "direction",
        "triple::reflection(n.into(), l.into())",
        "triple::reflection(l.into(), n.into())",
        "reflection_of_any",
    ),
    ("real/triple", "n_dot_l + n_dot_l", "n_dot_l", "reflection_of_any"),
    (
        "light/spot",
        "incident.intensity * self.cone.factor(self.axis, incident.l)",
        "incident.intensity * (T::ONE - self.cone.factor(self.axis, incident.l) - T::ONE)",
        "spot_light_of_any",
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

/// Plants all faults in a copy of the source.
pub fn plant(folder: &Path) -> Result<(), String> {
    let at = |file: &str| folder.join("src").join(file).with_extension("rs");
    let mut files: Vec<&str> = FAULTS.iter().map(|fault| fault.0).collect();
    files.sort_unstable();
    files.dedup();
    for file in files {
        let original = fs::read_to_string(at(file)).map_err(|e| format!("{file}: {e}"))?;
        let mut text = original.clone();
        let mut expressions: Vec<&str> = FAULTS.iter().filter(|fault| fault.0 == file).map(|fault| fault.1).collect();
        expressions.sort_by_key(|old| (usize::MAX - old.len(), *old)); // one may lie within another
        expressions.dedup();
        for old in expressions {
            if original.matches(old).count() != 1 {
                return Err(format!("{file} has not exactly one {old}"));
            }
            let of_it = FAULTS.iter().enumerate().filter(|(_, fault)| fault.0 == file && fault.1 == old);
            let choice = of_it.fold(String::new(), |choice, (number, (_, _, new, _))| {
                format!("{choice}if crate::planted({number}) {{ {new} }} else ")
            });
            text = text.replace(old, &format!("({choice}{{ {old} }})"));
        }
        fs::write(at(file), text).map_err(|e| format!("{file}: {e}"))?;
    }
    let root = fs::read_to_string(at("lib")).map_err(|e| e.to_string())?;
    fs::write(at("lib"), root + SWITCH).map_err(|e| e.to_string())
}
