//! Claims in SMT-LIB 2, from the recorded formulas, for Bitwuzla, a solver of floating-point arithmetic.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use shading_proofs::{Format, Goal, Graph, Node, Range, Run, Test, paths};

use crate::claims;

/// What floats do with the bits of a number in `Real::any_outside`, translated by hand: true only outside or on
/// the limits, and false only within them. LOW and HIGH are the bits of the limits; a `low` of 0 uses the second
/// comparison. b is any bits, x the number with these bits.
const OUTSIDE: &str = "(let ((above (bvsub b LOW)) (range (bvsub HIGH LOW)))
  (let ((outside (COMPARED above range)))
    (and (=> outside (not (and (fp.lt low x) (fp.lt x high)))) (=> (not outside) (and (fp.leq low x) (fp.leq x high))))))";

/// Writes a script for each path of each claim, or of the one with this name; a script is satisfiable if some input violates the claim.
pub fn write(folder: &Path, only: &str) -> std::io::Result<()> {
    fs::create_dir_all(folder)?;
    for format in [Format::F32, Format::F64] {
        for claim in claims::solved().filter(|claim| only.is_empty() || only == claim.name) {
            let mut path = 0;
            let mut result = Ok(());
            paths(format, claim.formula, |run, goals| {
                path += 1;
                if !goals.is_empty() {
                    let file = folder.join(format!("{}.{format:?}.{path}.smt2", claim.name));
                    result = std::mem::replace(&mut result, Ok(()))
                        .and(fs::write(file, script(run, &goals)));
                }
            });
            result?;
        }
        let (low, high, zero, one) = match format {
            Format::F32 => ("#x0d800000", "#x71800000", "#x00000000", "#x3f800000"),
            Format::F64 => (
                "#x12f0000000000000",
                "#x6cf0000000000000",
                "#x0000000000000000",
                "#x3ff0000000000000",
            ),
        };
        for (name, low, high, compared) in [
            ("squares", low, high, "bvuge"),
            ("factors", zero, one, "bvugt"),
        ] {
            let file = folder.join(format!("outside_by_bits.{format:?}.{name}.smt2"));
            fs::write(file, by_bits(format, low, high, compared))?;
        }
    }
    Ok(())
}

fn by_bits(format: Format, low: &str, high: &str, compared: &str) -> String {
    let (bits, sort) = match format {
        Format::F32 => (32, "8 24"),
        Format::F64 => (64, "11 53"),
    };
    let number = |name: &str, bits: &str| {
        format!("(define-fun {name} () (_ FloatingPoint {sort}) ((_ to_fp {sort}) {bits}))\n")
    };
    let claim = OUTSIDE
        .replace("LOW", low)
        .replace("HIGH", high)
        .replace("COMPARED", compared);
    let numbers = number("x", "b") + &number("low", low) + &number("high", high);
    format!(
        "(set-logic QF_BVFP)\n(declare-const b (_ BitVec {bits}))\n{numbers}(assert (not {claim}))\n(check-sat)\n"
    )
}

fn sort(format: Format) -> &'static str {
    match format {
        Format::F32 => "8 24",
        Format::F64 => "11 53",
    }
}

fn constant(format: Format, x: f64) -> String {
    let bits = format!("((_ to_fp 11 53) #x{:016x})", x.to_bits());
    match format {
        Format::F32 => format!("((_ to_fp 8 24) RNE {bits})"),
        Format::F64 => bits,
    }
}

fn asserted(test: Test, answer: bool) -> String {
    let text = match test {
        Test::Above(a, b) => format!("(fp.gt n{a} n{b})"),
        Test::AtMost(a, b) => format!("(fp.leq n{a} n{b})"),
        Test::Equal(a, b) => format!("(fp.eq n{a} n{b})"),
        // either answer is right on the limits
        Test::Outside(x, low, high) if answer => {
            return format!("(not (and (fp.lt n{low} n{x}) (fp.lt n{x} n{high})))");
        }
        Test::Outside(x, low, high) => {
            return format!("(and (fp.leq n{low} n{x}) (fp.leq n{x} n{high}))");
        }
        Test::Case(_) => return "true".into(),
    };
    if answer {
        text
    } else {
        format!("(not {text})")
    }
}

fn within(format: Format, id: u32, range: Range) -> String {
    let mut number = format!("(and (not (fp.isNaN n{id}))");
    let _ = write!(number, " (fp.leq {} n{id})", constant(format, range.low));
    let _ = write!(number, " (fp.leq n{id} {})", constant(format, range.high));
    if !range.minus_zero {
        let _ = write!(
            number,
            " (not (and (fp.isZero n{id}) (fp.isNegative n{id})))"
        );
    }
    if !range.finite {
        let _ = write!(number, " (fp.isInfinite n{id})");
    }
    if range.nan {
        format!("(or (fp.isNaN n{id}) {number}))")
    } else {
        number + ")"
    }
}

fn goal(format: Format, goal: Goal) -> String {
    match goal {
        Goal::Within(term, range) => within(format, term.0, range),
        // all NaN are one in SMT-LIB
        Goal::Same(a, b) => format!("(= n{} n{})", a.0, b.0),
        Goal::AtMost(a, b) => format!("(fp.leq n{} n{})", a.0, b.0),
        Goal::Never => "false".into(),
    }
}

fn value(g: &Graph, node: Node) -> String {
    match node {
        Node::Constant(bits) => constant(g.format, f64::from_bits(bits)),
        Node::Max => constant(g.format, g.format.max()),
        Node::Extreme => constant(g.format, g.format.extreme()),
        Node::Neg(a) => format!("(fp.neg n{a})"),
        Node::Abs(a) => format!("(fp.abs n{a})"),
        Node::Sqrt(a) => format!("(fp.sqrt RNE n{a})"),
        Node::Add(a, b) => format!("(fp.add RNE n{a} n{b})"),
        Node::Sub(a, b) => format!("(fp.sub RNE n{a} n{b})"),
        Node::Mul(a, b) => format!("(fp.mul RNE n{a} n{b})"),
        Node::Div(a, b) => format!("(fp.div RNE n{a} n{b})"),
        Node::Select(test, a, b) => format!("(ite {} n{a} n{b})", asserted(test, true)),
        Node::Var(_) | Node::Call(..) | Node::Power(..) => {
            panic!("{node:?} has no value in SMT-LIB")
        }
    }
}

fn script(run: &Run, goals: &[Goal]) -> String {
    let g = &run.graph;
    let name = format!("(_ FloatingPoint {})", sort(g.format));
    let mut text = String::from("(set-logic QF_FP)\n");
    for (id, node) in (0..).zip(&g.nodes) {
        let _ = match *node {
            Node::Var(index) => {
                let range = within(g.format, id, g.names[index as usize].1);
                writeln!(text, "(declare-const n{id} {name})\n(assert {range})")
            }
            node => writeln!(text, "(define-fun n{id} () {name} {})", value(g, node)),
        };
    }
    for &(test, answer) in &run.path {
        let _ = writeln!(text, "(assert {})", asserted(test, answer));
    }
    let goals = goals.iter().fold("(and true".to_string(), |all, one| {
        all + " " + &goal(g.format, *one)
    });
    text + "(assert (not " + &goals + ")))\n(check-sat)\n"
}
