//! The error bounds of `docs/precision.md`, as scripts for Gappa, which proves them from the recorded formulas.
//!
//! A number below 2⁻⁴⁰ is left out, because what underflow takes from it is no share of the result.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use shading::{Attenuation, Exponent, IncidentLight, PointLight, Real, Rgb, UnitVec3, Vec3};
use shading::{attenuation, half_vector, normal};
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

/// The rows of the page, the bound in units of roundoff, and the formula.
const BOUNDS: &[(&str, f64, Formula)] = &[
    ("length", 2.5, |given| vec![vector(given, "v").length()]),
    ("unit", 3.5, |given| first(vector(given, "v").unit())),
    ("sphere", 5.5, |given| first(normal::sphere(vector(given, "c"), vector(given, "p")))),
    ("half_vector", 5.5, |given| first(half_vector(direction(given, "l"), direction(given, "v")))),
    ("raise_32", 31.0, |given| {
        let cosine = number(given, "c", 0.125, 1.0);
        vec![32_u32.raise(cosine)]
    }),
    ("attenuation", 5.0, |given| {
        let [a, b, c] = coefficients(given);
        vec![attenuation(a, b, c, number(given, "q", (-30.0_f64).exp2(), 4.0))]
    }),
    ("lamp_direction", 6.5, |given| vec![lamp(given).l.x]),
    ("lamp_intensity", 13.0, |given| vec![lamp(given).intensity.r]),
];

/// One script for each bound, format and way through the formula, but for vectors that are rescaled.
pub fn write(folder: &Path) -> std::io::Result<()> {
    fs::create_dir_all(folder)?;
    for (name, bound, formula) in BOUNDS {
        for format in [Format::F32, Format::F64] {
            let mut scripts = Vec::new();
            paths(format, formula, |run, results| {
                let is_rescaled = |&(test, answer): &(Test, bool)| {
                    answer && matches!(test, Test::Outside(_, _, high) if high == Term::EXTREME.0)
                };
                if !run.path.iter().any(is_rescaled) {
                    let script = |result| script(&run.graph, run.known.clone(), result, *bound);
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
            Node::Neg(a) | Node::Sqrt(a) => stack.push((known.resolved(g, a), false)),
            Node::Add(a, b) | Node::Sub(a, b) | Node::Mul(a, b) | Node::Div(a, b) => {
                stack.extend([a, b].map(|part| (known.resolved(g, part), false)));
            }
            _ => {}
        }
    }
    order
}

/// n is a node's value and N what it would be without rounding.
fn script(g: &Graph, mut known: Known, result: Term, bound: f64) -> String {
    let (u, float) = match g.format {
        Format::F32 => (24, "float<ieee_32,ne>"),
        Format::F64 => (53, "float<ieee_64,ne>"),
    };
    let mut text = format!("# at most {bound} u\n@rnd = {float};\n");
    let (mut facts, root) = (Vec::new(), known.resolved(g, result.0));
    for id in order(g, &mut known, root) {
        let is_exact = |id: u32| matches!(g.nodes[id as usize], Node::Var(_) | Node::Constant(_));
        let exact = |id: u32| format!("{}{id}", if is_exact(id) { 'n' } else { 'N' });
        let mut binary = |known: &mut Known, sign: char, a: u32, b: u32| {
            let [a, b] = [a, b].map(|part| known.resolved(g, part));
            let _ = writeln!(text, "n{id} rnd= n{a} {sign} n{b};\nN{id} = {} {sign} {};", exact(a), exact(b));
            [a, b]
        };
        match g.nodes[id as usize] {
            Node::Var(index) => {
                let (name, range) = &g.names[index as usize];
                let _ = writeln!(text, "n{id} = rnd({});", name.replace('.', "_"));
                facts.push(if range.low >= 0.0 {
                    format!("n{id} in [{},{}]", range.low, range.high)
                } else {
                    format!("|n{id}| in [1b-40,1b40]")
                });
            }
            Node::Constant(bits) => {
                let _ = writeln!(text, "n{id} = {};", f64::from_bits(bits));
            }
            Node::Neg(a) => {
                let a = known.resolved(g, a);
                let _ = writeln!(text, "n{id} = -n{a};\nN{id} = -{};", exact(a));
            }
            Node::Sqrt(a) => {
                let a = known.resolved(g, a);
                let _ = writeln!(text, "n{id} rnd= sqrt(n{a});\nN{id} = sqrt({});", exact(a));
            }
            Node::Add(a, b) => {
                let [a, b] = binary(&mut known, '+', a, b);
                facts.push(if known.range(g, a).low >= 0.0 && known.range(g, b).low >= 0.0 {
                    format!("{} / N{id} in [0,1]", exact(a))
                } else {
                    format!("|N{id}| in [1b-40,1b40]")
                });
            }
            Node::Sub(a, b) => {
                binary(&mut known, '-', a, b);
                facts.push(format!("|N{id}| in [1b-40,1b40]"));
            }
            Node::Mul(a, b) => _ = binary(&mut known, '*', a, b),
            Node::Div(a, b) => _ = binary(&mut known, '/', a, b),
            node => panic!("{node:?} is not on this way"),
        }
    }
    // the page leaves out terms in u², which get a fiftieth of u here
    let limit = ((bound + 0.02) * 65_536.0).floor();
    let _ = writeln!(text, "{{ {}\n -> |n{root} -/ N{root}| <= {limit}b-{} }}", facts.join(" /\\ "), u + 16);
    text
}
