//! Scripts for Gappa, from recorded formulas: the error bounds of `docs/precision.md` beside which
//! "Gappa" stands, and the claims that Gappa completes.
//!
//! A number below 2⁻⁴⁰ is left out of an error bound, because what underflow takes from it is no
//! share of the result.

mod script;

use std::fs;
use std::path::Path;

use shading::{Attenuation, IncidentLight, Lobe, PointLight, Rgb, UnitVec3, Vec3};
use shading::{attenuation, half_vector, normal, term};
use shading_proofs::{Format, Given, Goal, Graph, Node, Range, Term, Test, paths};

use crate::claims::claims;
use script::Script;

/// 2⁻⁴⁰
const TINY: f64 = 1.0 / 1_099_511_627_776.0;

fn number(given: Given, name: &str, low: f64, high: f64) -> Term {
    given.number(name, Range::unsigned(low, high))
}

/// Numbers of any sign, of which Gappa gets the magnitude.
fn vector(given: Given, name: &str) -> Vec3<Term> {
    given.vector(name, Range::within(-1.0 / TINY, 1.0 / TINY))
}

fn direction(given: Given, name: &str) -> UnitVec3<Term> {
    UnitVec3::assume_unit(vector(given, name))
}

fn coefficients(given: Given) -> [Term; 3] {
    ["a", "b", "c"].map(|name| number(given, name, 0.01, 2.0))
}

fn lamp(given: Given) -> IncidentLight<Term> {
    let [a, b, c] = coefficients(given);
    let lamp = PointLight {
        position: vector(given, "s"),
        intensity: Rgb::gray(number(given, "I", 0.1, 1.0)),
        attenuation: Attenuation::new(a, b, c).expect("valid coefficients"),
    };
    lamp.at(vector(given, "p"))
}

/// What is proved of a row of the page: its name, the most that it is off by, in units of roundoff of the
/// result, and its formula.
type Bound = (&'static str, f64, fn(Given) -> Option<Term>);

const BOUNDS: [Bound; 9] = [
    ("length", 2.5, |given| Some(vector(given, "v").length())),
    ("unit", 3.5, |given| Some(vector(given, "v").unit()?.x)),
    ("sphere", 5.5, |given| {
        Some(normal::sphere(vector(given, "c"), vector(given, "p"))?.x)
    }),
    ("half_vector", 5.5, |given| {
        Some(half_vector(direction(given, "l"), direction(given, "v"))?.x)
    }),
    ("raise_32", 31.0, |given| {
        Some(32_u32.raise(number(given, "c", 0.125, 1.0)))
    }),
    ("phong_normalization_of_m", 3.0, |given| {
        Some(term::phong_normalization(number(given, "m", TINY, 1e6)))
    }),
    ("attenuation", 5.0, |given| {
        let [a, b, c] = coefficients(given);
        let q = number(given, "q", 2.0_f64.powi(-30), 4.0);
        Some(attenuation(a, b, c, q))
    }),
    ("lamp_direction", 6.5, |given| Some(lamp(given).l().x)),
    ("lamp_intensity", 13.0, |given| {
        Some(lamp(given).intensity().r)
    }),
];

/// Whether a decision is that a number is out of the range where nothing is lost: a vector that
/// must be scaled, or a factor that must be limited.
fn is_rescued(g: &Graph, (test, answer): (Test, bool)) -> bool {
    let Test::Above(inside, _) = test else {
        return false;
    };
    let inside = g.nodes[inside as usize];
    !answer && matches!(inside, Node::Select(Test::AtMost(..), ..))
}

/// Writes one script for a share of each bound, format and way through the formula, but for ways
/// that rescue a number; and one for each goal of the claims that Gappa completes.
pub fn write(folder: &Path, share: f64) -> std::io::Result<()> {
    fs::create_dir_all(folder)?;
    for format in [Format::F32, Format::F64] {
        for (name, most, formula) in BOUNDS {
            let mut scripts = Vec::new();
            paths(format, formula, |run, result: Option<Term>| {
                if !run.path.iter().any(|fact| is_rescued(&run.graph, *fact)) {
                    let script = |result| Script::new(run).error(result, most * share);
                    scripts.extend(result.map(script));
                }
            });
            save(folder, name, format, &scripts)?;
        }
        for claim in claims().iter().filter(|claim| claim.by == "gappa") {
            let mut scripts = Vec::new();
            paths(format, claim.formula, |run, goals: Vec<Goal>| {
                scripts.extend(goals.iter().map(|goal| match *goal {
                    Goal::Within(term, range) => Script::new(run).within(term, range, share),
                    _ => panic!("{} is about more than ranges", claim.name),
                }));
            });
            save(folder, claim.name, format, &scripts)?;
        }
    }
    Ok(())
}

/// Coq takes the names of files for identifiers.
fn save(folder: &Path, name: &str, format: Format, scripts: &[String]) -> std::io::Result<()> {
    assert!(!scripts.is_empty(), "{name} has no way");
    for (way, script) in scripts.iter().enumerate() {
        fs::write(folder.join(format!("{name}_{format:?}_{way}.g")), script)?;
    }
    Ok(())
}
