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

use crate::claims::{By, CLAIMS};
use script::Script;

/// 2⁻⁴⁰
const TINY: f64 = 1.0 / 1_099_511_627_776.0;

/// What a bound records.
struct Formula {
    result: Option<Term>,
    /// A number that is off by so many units of roundoff, and the range without that error.
    taken: Option<(Term, f64, [f64; 2])>,
}

impl From<Term> for Formula {
    fn from(result: Term) -> Self {
        let result = Some(result);
        Self {
            result,
            taken: None,
        }
    }
}

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

fn first(v: Option<UnitVec3<Term>>) -> Formula {
    Formula {
        result: v.map(|v| v.x),
        taken: None,
    }
}

/// The power of a cosine that is off by so many u.
fn power(given: Given, m: u32, off: f64, low: f64) -> Formula {
    let cosine = number(given, "cosine", low, 1.0);
    Formula {
        result: Some(m.raise(cosine)),
        taken: Some((cosine, off, [low / 1.2, 1.0])),
    }
}

fn paraboloid(given: Given) -> Formula {
    let [u, v] = ["u", "v"].map(|name| given.number(name, Range::within(-1.0, 1.0)));
    let surface = |u, v| Vec3::new(u, v, u * u + u * v + v * v);
    first(normal::parametric(surface, u, v))
}

fn attenuated(given: Given) -> Formula {
    let ([a, b, c], q) = (
        coefficients(given),
        number(given, "q", 2.0_f64.powi(-30), 4.0),
    );
    attenuation(a, b, c, q).into()
}

/// What an error is a share of.
#[derive(Clone, Copy, PartialEq)]
enum Of {
    Result,
    One,
}

/// What is proved of a row of the page: its name, the most that it is off by, in units of roundoff,
/// of what, and its formula.
type Bound = (&'static str, f64, Of, fn(Given) -> Formula);

/// By how many u the cosine of two directions is off, which the page derives.
const COSINE: f64 = 3.0;

const BOUNDS: [Bound; 14] = [
    ("length", 2.5, Of::Result, |given| {
        vector(given, "v").length().into()
    }),
    ("unit", 3.5, Of::Result, |given| {
        first(vector(given, "v").unit())
    }),
    ("sphere", 5.5, Of::Result, |given| {
        first(normal::sphere(vector(given, "c"), vector(given, "p")))
    }),
    ("paraboloid", 5.4, Of::Result, paraboloid),
    ("half_vector", 5.5, Of::Result, |given| {
        first(half_vector(direction(given, "l"), direction(given, "v")))
    }),
    ("phong_32", 111.5, Of::One, |given| {
        power(given, 32, COSINE, 0.125)
    }),
    ("blinn_128", 447.5, Of::One, |given| {
        power(given, 128, COSINE, 0.6)
    }),
    ("raise_32", 31.0, Of::Result, |given| {
        32_u32.raise(number(given, "c", 0.125, 1.0)).into()
    }),
    ("raise_1000", 999.0, Of::Result, |given| {
        1000_u32.raise(number(given, "c", 0.94, 1.0)).into()
    }),
    ("phong_normalization_of_m", 3.0, Of::Result, |given| {
        term::phong_normalization(number(given, "m", TINY, 1e6)).into()
    }),
    ("blinn_normalization_of_m", 11.75, Of::Result, |given| {
        term::blinn_normalization(number(given, "m", TINY, 1e6)).into()
    }),
    ("attenuation", 5.0, Of::Result, attenuated),
    ("lamp_direction", 6.5, Of::Result, |given| {
        lamp(given).l().x.into()
    }),
    ("lamp_intensity", 13.0, Of::Result, |given| {
        lamp(given).intensity().r.into()
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
        for (name, most, of, formula) in BOUNDS {
            let mut scripts = Vec::new();
            paths(format, formula, |run, formula: Formula| {
                let g = &run.graph;
                if run.path.iter().any(|fact| is_rescued(g, *fact)) {
                    return;
                }
                let script =
                    |result| Script::new(run, formula.taken).error(result, most * share, of);
                scripts.extend(formula.result.map(script));
            });
            save(folder, name, format, &scripts)?;
        }
        for claim in CLAIMS.iter().filter(|claim| claim.by == By::Gappa) {
            let mut scripts = Vec::new();
            paths(format, claim.formula, |run, goals: Vec<Goal>| {
                scripts.extend(goals.iter().map(|goal| match *goal {
                    Goal::Within(term, range) => Script::new(run, None).within(term, range, share),
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
