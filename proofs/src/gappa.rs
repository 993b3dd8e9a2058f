//! The error bounds of `docs/precision.md`, as scripts for Gappa, which proves them from the recorded formulas.
//!
//! A number below 2⁻⁴⁰ is left out, because what underflow takes from it is no share of the result.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use shading::{Attenuation, Exponent, IncidentLight, PointLight, Real, Rgb, UnitVec3, Vec3};
use shading::{attenuation, half_vector, normal, term};
use shading_laws::proof::{Format, Given, Graph, Known, Node, Range, Term, Test, paths};

type Formula = fn(Given) -> Vec<Term>;

fn number(given: Given, name: &str, low: f64, high: f64) -> Term {
    given.number(name, Range::unsigned(low, high))
}
/// Numbers of any sign; Gappa gets their magnitude.
fn vector(given: Given, name: &str) -> Vec3<Term> {
    given.vector(name, Range::within(-40.0_f64.exp2(), 40.0_f64.exp2()))
}
fn direction(given: Given, name: &str) -> UnitVec3<Term> {
    UnitVec3::assume_unit(vector(given, name))
}
fn coefficients(given: Given) -> [Term; 3] {
    ["a", "b", "c"].map(|name| number(given, name, 0.01, 2.0))
}
fn lamp(given: Given) -> IncidentLight<Term> {
    let mut fields = coefficients(given).into_iter();
    let attenuation = Attenuation::<f32>::NONE.cast(|_| fields.next().unwrap());
    let intensity = Rgb::gray(number(given, "I", 0.1, 1.0));
    PointLight { position: vector(given, "s"), intensity, attenuation }.at(vector(given, "p"))
}
fn first(v: Option<UnitVec3<Term>>) -> Vec<Term> {
    v.map_or(vec![], |v| vec![v.x])
}

/// What an error is a share of.
#[derive(Clone, Copy)]
enum Of {
    Result,
    One,
    /// of the attenuation without a range
    Attenuation,
}

/// A cosine that is off by 3 u, the bound of `lambert`.
fn cosine(given: Given, low: f64) -> Term {
    number(given, COSINE, low, 1.0)
}
const COSINE: &str = "cosine";
/// The rows of the page, the bound in units of roundoff, and the formula.
const BOUNDS: &[(&str, f64, Of, Formula)] = &[
    ("length", 2.5, Of::Result, |given| vec![vector(given, "v").length()]),
    ("unit", 3.5, Of::Result, |given| first(vector(given, "v").unit())),
    ("sphere", 5.5, Of::Result, |given| first(normal::sphere(vector(given, "c"), vector(given, "p")))),
    ("half_vector", 5.5, Of::Result, |given| first(half_vector(direction(given, "l"), direction(given, "v")))),
    ("raise_32", 31.0, Of::Result, |given| vec![32_u32.raise(number(given, "c", 0.125, 1.0))]),
    ("raise_1000", 999.03, Of::Result, |given| vec![1000_u32.raise(number(given, "c", 0.94, 1.0))]),
    ("phong_32", 111.5, Of::One, |given| vec![32_u32.raise(cosine(given, 0.125))]),
    ("phong_normalization", 3.0, Of::Result, |given| {
        vec![term::phong_normalization(number(given, "m", (-40.0_f64).exp2(), 1e6))]
    }),
    ("blinn_normalization", 11.75, Of::Result, |given| {
        vec![term::blinn_normalization(number(given, "m", (-40.0_f64).exp2(), 1e6))]
    }),
    ("attenuation", 5.0, Of::Result, |given| {
        let [a, b, c] = coefficients(given);
        vec![attenuation(a, b, c, number(given, "q", (-30.0_f64).exp2(), 4.0))]
    }),
    ("ranged", 8.5, Of::Attenuation, |given| {
        let [q, r] = ["q", "r"].map(|name| number(given, name, (-30.0_f64).exp2(), 4.0));
        let mut fields = coefficients(given).into_iter().chain([r]);
        let ranged = Attenuation::<f32>::NONE.within(1.0).unwrap().cast(|_| fields.next().unwrap());
        given.assume_at_most(q / r, Term::ONE);
        vec![ranged.at(q)]
    }),
    ("lamp_direction", 6.5, Of::Result, |given| vec![lamp(given).l.x]),
    ("lamp_intensity", 13.0, Of::Result, |given| vec![lamp(given).intensity.r]),
];

/// One script for each bound, format and way through the formula, but for vectors that are rescaled.
pub fn write(folder: &Path) -> std::io::Result<()> {
    fs::create_dir_all(folder)?;
    for (name, bound, of, formula) in BOUNDS {
        for format in [Format::F32, Format::F64] {
            let mut scripts = Vec::new();
            paths(format, formula, |run, results| {
                let is_rescaled = |&(test, answer): &(Test, bool)| {
                    answer && matches!(test, Test::Outside(_, _, high) if high == Term::EXTREME.0)
                };
                if !run.path.iter().any(is_rescaled) {
                    let script = |result| script(&run.graph, run.known.clone(), result, *bound, *of);
                    scripts.extend(results.into_iter().map(script));
                }
            });
            assert!(!scripts.is_empty(), "{name} has no way");
            for (way, script) in scripts.into_iter().enumerate() {
                fs::write(folder.join(format!("{name}.{way}.{format:?}.g")), script)?;
            }
        }
    }
    Ok(())
}

/// The node itself, what a decided selection selects, or what 0 is added to.
fn plain(g: &Graph, known: &mut Known, id: u32) -> u32 {
    let id = known.resolved(g, id);
    let is_zero = |known: &mut Known, id| known.range(g, id).only() == Some(0.0);
    match g.nodes[id as usize] {
        Node::Add(a, b) if is_zero(known, b) => plain(g, known, a),
        Node::Add(a, b) if is_zero(known, a) => plain(g, known, b),
        _ => id,
    }
}

/// The nodes below one, each after its parts, with decided selections made.
fn order(g: &Graph, known: &mut Known, root: u32) -> Vec<u32> {
    let (mut order, mut stack) = (Vec::new(), vec![(root, false)]);
    while let Some((id, is_done)) = stack.pop() {
        if order.contains(&id) {
            continue;
        }
        if is_done {
            order.push(id);
            continue;
        }
        stack.push((id, true));
        match g.nodes[id as usize] {
            Node::Neg(a) | Node::Sqrt(a) => stack.push((plain(g, known, a), false)),
            Node::Add(a, b) | Node::Sub(a, b) | Node::Mul(a, b) | Node::Div(a, b) => {
                stack.extend([a, b].map(|part| (plain(g, known, part), false)));
            }
            _ => {}
        }
    }
    order
}

/// n is a node's value and N what it would be without rounding.
fn script(g: &Graph, mut known: Known, result: Term, bound: f64, of: Of) -> String {
    let (u, float) = match g.format {
        Format::F32 => (24, "float<ieee_32,ne>"),
        Format::F64 => (53, "float<ieee_64,ne>"),
    };
    let mut text = format!("# at most {bound} u\n@rnd = {float};\n");
    let (mut facts, mut hints, root) = (Vec::new(), String::new(), plain(g, &mut known, result.0));
    for id in order(g, &mut known, root) {
        let is_cosine = |index: u32| g.names[index as usize].0 == COSINE;
        let exact = |id: u32| match g.nodes[id as usize] {
            Node::Var(index) if !is_cosine(index) => format!("n{id}"),
            Node::Constant(_) | Node::Max | Node::Extreme => format!("n{id}"),
            _ => format!("N{id}"),
        };
        let mut binary = |known: &mut Known, sign: char, a: u32, b: u32| {
            let [a, b] = [a, b].map(|part| plain(g, known, part));
            let _ = writeln!(text, "n{id} rnd= n{a} {sign} n{b};\nN{id} = {} {sign} {};", exact(a), exact(b));
            [a, b]
        };
        match g.nodes[id as usize] {
            Node::Var(index) => {
                let (name, range) = &g.names[index as usize];
                let _ = writeln!(text, "n{id} = rnd({});", name.replace('.', "_"));
                let is_limited = range.low >= 0.0 || range.high <= 1.0;
                facts.push(if is_limited {
                    format!("n{id} in [{},{}]", range.low, range.high)
                } else {
                    format!("|n{id}| in [1b-40,1b40]")
                });
                if is_cosine(index) {
                    facts.push(format!("N{id} in [0,1] /\\ |n{id} - N{id}| <= 3b-{u}"));
                }
            }
            Node::Power(..) => {
                // the power of √½ by m, which `power` makes of a cosine that is off by 0.71 u
                let _ = writeln!(text, "n{id} = rnd(power);");
                facts.push(format!("n{id} in [0,1] /\\ N{id} in [0,1] /\\ |n{id} - N{id}| <= 19b-{}", u + 2));
            }
            Node::Constant(bits) => {
                let _ = writeln!(text, "n{id} = {};", f64::from_bits(bits));
            }
            Node::Neg(a) => {
                let a = plain(g, &mut known, a);
                let _ = writeln!(text, "n{id} = -n{a};\nN{id} = -{};", exact(a));
            }
            Node::Sqrt(a) => {
                let a = plain(g, &mut known, a);
                let _ = writeln!(text, "n{id} rnd= sqrt(n{a});\nN{id} = sqrt({});", exact(a));
            }
            Node::Add(a, b) => {
                let [a, b] = binary(&mut known, '+', a, b);
                if let Node::Power(..) = g.nodes[b as usize] {
                    facts.push(format!("N{id} >= 1")); // m + 2^(−m/2) is least for m = 0
                } else if known.range(g, a).low >= 0.0 && known.range(g, b).low >= 0.0 {
                    facts.push(format!("{} / N{id} in [0,1]", exact(a)));
                } else if !is_constant(g, &mut known, id) {
                    facts.push(format!("|N{id}| in [1b-40,1b40]"));
                }
            }
            Node::Sub(a, b) => {
                binary(&mut known, '-', a, b);
                if matches!(of, Of::Result) && !is_constant(g, &mut known, id) {
                    facts.push(format!("|N{id}| in [1b-40,1b40]"));
                }
            }
            Node::Mul(a, b) => _ = binary(&mut known, '*', a, b),
            Node::Div(a, b) => _ = binary(&mut known, '/', a, b),
            node => panic!("{node:?} is not on this way"),
        }
    }
    let parts = |known: &mut Known, id: u32| match g.nodes[id as usize] {
        Node::Add(a, b) | Node::Sub(a, b) | Node::Mul(a, b) | Node::Div(a, b) => [a, b].map(|id| plain(g, known, id)),
        node => panic!("{node:?} has no two parts"),
    };
    let goal = match of {
        Of::Result => format!("|n{root} -/ N{root}|"),
        Of::One => format!("|n{root} - N{root}|"),
        Of::Attenuation => {
            let [x, y] = parts(&mut known, root);
            let (f, w) = if matches!(g.nodes[x as usize], Node::Div(..)) { (x, y) } else { (y, x) };
            let [_, l] = parts(&mut known, f);
            let [d, _] = parts(&mut known, w);
            let [_, v] = parts(&mut known, d);
            let [square, _] = parts(&mut known, v);
            let [share, _] = parts(&mut known, square);
            for (name, id) in [("x", root), ("f", f), ("w", w), ("l", l), ("v", v), ("s", share)] {
                let _ = writeln!(text, "{name} = n{id};\n{} = N{id};", name.to_uppercase());
            }
            facts.push("S in [1b-30,1] /\\ v in [0,1]".into());
            hints += ATTENUATION;
            "|(x - X) / F|".into()
        }
    };
    // the page leaves out terms in u², which get a fiftieth of u here
    let limit = ((bound + 0.02) * 65_536.0).floor();
    let _ = writeln!(text, "{{ {}\n -> {goal} <= {limit}b-{} }}\n{hints}", facts.join(" /\\ "), u + 16);
    text
}

fn is_constant(g: &Graph, known: &mut Known, id: u32) -> bool {
    let range = known.range(g, id);
    range.low >= range.high
}

const ATTENUATION: &str = "$ S in 8;
(x - X) / F -> (x - f*w) / F + ((f - F) / F) * w + (w - W) { F <> 0 };
(x - f*w) / F -> (x - f*w) * L { F <> 0, L <> 0 };
";
