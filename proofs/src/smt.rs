//! A claim in SMT-LIB 2, for a solver of floating-point arithmetic such as Bitwuzla. The claim holds if no query
//! has a solution. What the rules answered on the way is queried, too, so they need not be believed.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use super::graph::{Graph, Node, Test};
use super::run::{Run, explore};
use super::{Format, Given, Goal, Range};

/// The queries of a claim, each once.
pub fn queries(format: Format, claim: impl Fn(Given) -> Vec<Goal>) -> Vec<String> {
    let mut queries = Vec::new();
    let mut add = |query: String| {
        if !queries.contains(&query) {
            queries.push(query);
        }
    };
    explore(format, &|| claim(Given(format)), |run, goals| {
        // the other answer must not be possible
        for &(length, test, answer) in &run.answered {
            let other = assertion(test, !answer);
            add(query(
                run,
                &run.path[..length],
                &test.parts().collect::<Vec<_>>(),
                &other,
            ));
        }
        match goals {
            None => add(query(run, &run.path, &[], "true")),
            Some(goals) if goals.is_empty() => {}
            Some(goals) => {
                let nodes: Vec<u32> = goals.iter().flat_map(Goal::nodes).collect();
                let goals = goals.iter().map(|goal| violated(format, *goal));
                let any: Vec<String> = goals.collect::<BTreeSet<_>>().into_iter().collect();
                let any = format!("(or false {})", any.join(" "));
                add(query(run, &run.path, &nodes, &any));
            }
        }
    });
    queries
}

fn sort(format: Format) -> String {
    let (exponent, digits) = format.shape();
    format!("{exponent} {digits}")
}

/// A number of the format.
fn constant(format: Format, x: f64) -> String {
    let bits = format!("((_ to_fp 11 53) #x{:016x})", x.to_bits());
    match format {
        Format::F64 => bits,
        _ => format!("((_ to_fp {}) RNE {bits})", sort(format)),
    }
}

fn assertion(test: Test, answer: bool) -> String {
    let text = match test {
        Test::Above(a, b) => format!("(fp.gt n{a} n{b})"),
        Test::AtMost(a, b) => format!("(fp.leq n{a} n{b})"),
        Test::Equal(a, b) => format!("(fp.eq n{a} n{b})"),
        Test::Case(_) => return "true".into(),
    };
    if answer {
        text
    } else {
        format!("(not {text})")
    }
}

fn within(format: Format, id: u32, range: Range) -> String {
    let range = range.of_format(format);
    let [low, high] = [range.low, range.high].map(|x| constant(format, x));
    let mut number = format!("(fp.leq {low} n{id}) (fp.leq n{id} {high})");
    if !range.minus_zero {
        let _ = write!(
            number,
            " (not (and (fp.isZero n{id}) (fp.isNegative n{id})))"
        );
    }
    if !range.finite {
        let _ = write!(number, " (fp.isInfinite n{id})");
    }
    let nan = if range.nan {
        format!("(fp.isNaN n{id})")
    } else {
        "false".into()
    };
    format!("(or {nan} (and {number}))")
}

fn violated(format: Format, goal: Goal) -> String {
    match goal {
        Goal::Within(term, range) => format!("(not {})", within(format, term.0, range)),
        // all NaN are one in SMT-LIB
        Goal::Same(a, b) => format!("(not (= n{} n{}))", a.0, b.0),
        Goal::AtMost(a, b) => format!("(not (fp.leq n{} n{}))", a.0, b.0),
        Goal::Never => "true".into(),
    }
}

/// What a node is, or what is known of it.
fn defined(g: &Graph, id: u32) -> String {
    let f = g.format;
    let name = format!("(_ FloatingPoint {})", sort(f));
    let declared = |known| format!("(declare-const n{id} {name})\n(assert {known})\n");
    let value = match g.nodes[id as usize] {
        Node::Var(index) => return declared(within(f, id, g.names[index as usize].1)),
        Node::Power(c, m) => return declared(raised(f, id, c, m)),
        Node::Constant(bits) => constant(f, f64::from_bits(bits)),
        Node::Neg(a) => format!("(fp.neg n{a})"),
        Node::Sqrt(a) => format!("(fp.sqrt RNE n{a})"),
        Node::Add(a, b) => format!("(fp.add RNE n{a} n{b})"),
        Node::Sub(a, b) => format!("(fp.sub RNE n{a} n{b})"),
        Node::Mul(a, b) => format!("(fp.mul RNE n{a} n{b})"),
        Node::Div(a, b) => format!("(fp.div RNE n{a} n{b})"),
        Node::Select(test, a, b) => format!("(ite {} n{a} n{b})", assertion(test, true)),
    };
    format!("(define-fun n{id} () {name} {value})\n")
}

/// Whether there is an input that takes this path, and then this.
fn query(run: &Run, path: &[(Test, bool)], nodes: &[u32], then: &str) -> String {
    let g = &run.graph;
    let mut is_needed = vec![false; g.nodes.len()];
    let of_path = path.iter().flat_map(|(test, _)| test.parts());
    let mut stack: Vec<u32> = of_path.chain(nodes.iter().copied()).collect();
    while let Some(id) = stack.pop() {
        if !std::mem::replace(&mut is_needed[id as usize], true) {
            stack.extend(g.nodes[id as usize].parts());
        }
    }
    let mut text = String::from("(set-logic QF_FP)\n");
    for (id, _) in (0..).zip(is_needed).filter(|(_, is_needed)| *is_needed) {
        text += &defined(g, id);
    }
    let path = path.iter().map(|(test, answer)| assertion(*test, *answer));
    for assertion in path.chain([then.into()]) {
        let _ = writeln!(text, "(assert {assertion})");
    }
    text + "(check-sat)\n"
}

/// What is known of a power.
fn raised(f: Format, id: u32, c: u32, m: u32) -> String {
    let [zero, one, lack] = [0.0, 1.0, 2.0_f64.powi(-20)].map(|x| constant(f, x));
    let least = format!("(fp.sub RNE n{c} {lack})");
    format!(
        "(=> (and (fp.leq {zero} n{c}) (fp.leq n{c} {one})) \
         (and (fp.leq {zero} n{id}) (fp.leq n{id} {one}) (not (fp.isNegative n{id})) \
         (=> (fp.gt n{c} {zero}) \
         (ite (fp.gt n{m} {zero}) (=> (fp.leq n{m} {one}) (fp.leq {least} n{id})) (= n{id} {one})))))"
    )
}
