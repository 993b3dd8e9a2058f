//! A recorded formula in the language of Gappa: n1 is the value of the node 1, and N1 what it would
//! be without rounding.

use std::fmt::Write;

use shading_proofs::{Known, Node, Range, Run, Term, Test};

use super::TINY;

/// A number as Gappa reads it without rounding: a whole number and a power of two.
fn binary(mut x: f64) -> String {
    let mut power = 0;
    while x.fract() != 0.0 {
        (x, power) = (x * 2.0, power - 1);
    }
    format!("{x}b{power}")
}

pub struct Script<'a> {
    run: &'a Run,
    known: Known,
    defined: Vec<u32>,
    definitions: String,
    facts: Vec<String>,
}

impl<'a> Script<'a> {
    pub fn new(run: &'a Run) -> Self {
        Self {
            run,
            known: run.known.clone(),
            defined: Vec::new(),
            definitions: String::new(),
            facts: Vec::new(),
        }
    }

    fn node(&self, id: u32) -> Node {
        self.run.graph.nodes[id as usize]
    }

    fn range(&mut self, id: u32) -> Range {
        self.known.range(&self.run.graph, id)
    }

    fn digits(&self) -> i32 {
        self.run.graph.format.shape().1
    }

    /// That the result is off by at most so many units of roundoff.
    pub fn error(mut self, result: Term, most: f64) -> String {
        let root = self.define_below(result.0);
        for id in self.order(root) {
            self.bound(id);
        }
        // the page leaves out terms in u², which get a fiftieth of u here
        let limit = ((most + 0.02) * 65_536.0).floor();
        let goal = format!("|n{root} -/ N{root}| <= {limit}b-{}", self.digits() + 16);
        self.text(&format!("at most {most} u"), &goal, "")
    }

    /// That the cosine of two directions n and l, or of −n and l, lies in a range of which `share`
    /// is left beyond ±1: 2 N·L = |N|² + |L|² − |N − L|² = |N + L|² − |N|² − |L|², and each square
    /// is what the path has found it to be.
    pub fn within(mut self, cosine: Term, range: Range, share: f64) -> String {
        let root = self.define_below(cosine.0);
        let (mut rules, mut squares, mut directions) = (String::new(), vec![], vec![]);
        for (test, _) in &self.run.path {
            let Test::AtMost(least, square) = *test else {
                continue;
            };
            if !matches!(self.node(least), Node::Constant(_)) {
                continue;
            }
            let mut components = self.order(square);
            components.retain(|id| matches!(self.node(*id), Node::Var(_)));
            components.sort_unstable();
            let of_component = |x| format!("n{x} in [-1.000001,1.000001]");
            self.facts.extend(components.iter().map(of_component));
            self.define_below(square);
            let range = self.range(square);
            let [low, high] = [range.low, range.high].map(binary);
            self.facts.push(format!("n{square} in [{low},{high}]"));
            let _ = writeln!(rules, "N{square} -> n{square} - (n{square} - N{square});");
            squares.push(format!("N{square}"));
            directions.push(components);
        }
        // the cosine of −N is that of N with the other sign
        let is_opposite = matches!(self.node(root), Node::Sub(..));
        let half = if is_opposite { "-2" } else { "2" };
        let squares = squares.join(" + ");
        let of = |sign: char| {
            let pairs = directions[0].iter().zip(&directions[1]);
            let terms = pairs.map(|(x, y)| format!("(n{x}{sign}n{y})*(n{x}{sign}n{y})"));
            terms.collect::<Vec<_>>().join(" + ")
        };
        let (less, more) = (of('-'), of('+'));
        let _ = write!(
            rules,
            "N{root} -> ({squares} - ({less})) / {half};\nN{root} -> ({more} - ({squares})) / {half};\n"
        );
        let middle = |end: f64| end - end.signum() * (1.0 - share) * (end.abs() - 1.0);
        let [low, high] = [range.low, range.high].map(|end| binary(middle(end)));
        let text = format!("{share} of the range");
        self.text(&text, &format!("n{root} in [{low},{high}]"), &rules)
    }

    fn text(self, about: &str, goal: &str, rules: &str) -> String {
        let bits = if self.digits() == 53 { 64 } else { 32 };
        let (definitions, facts) = (self.definitions, self.facts.join(" /\\ "));
        format!(
            "# {about}\n@rnd = float<ieee_{bits},ne>;\n{definitions}{{ {facts}\n -> {goal} }}\n{rules}"
        )
    }

    /// The node itself, what a decided selection selects, or what is added to 0.
    fn plain(&mut self, id: u32) -> u32 {
        let id = self.known.resolved(&self.run.graph, id);
        match self.node(id) {
            Node::Add(zero, x) if Range::within(0.0, 0.0).covers(self.range(zero)) => self.plain(x),
            _ => id,
        }
    }

    fn is_positive(&mut self, id: u32) -> bool {
        self.range(id).low >= 0.0
    }

    fn parts(&mut self, id: u32) -> Vec<u32> {
        let parts = self.node(id).parts();
        parts.map(|part| self.plain(part)).collect()
    }

    /// The nodes below one, each after its parts.
    fn order(&mut self, root: u32) -> Vec<u32> {
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
            stack.extend(self.parts(id).into_iter().map(|part| (part, false)));
        }
        order
    }

    /// The node without rounding: a variable is what it is.
    fn exact(&self, id: u32) -> String {
        match self.node(id) {
            Node::Var(_) | Node::Constant(_) => format!("n{id}"),
            _ => format!("N{id}"),
        }
    }

    /// Defines a node and what it is made of.
    fn define_below(&mut self, root: u32) -> u32 {
        let root = self.plain(root);
        for id in self.order(root) {
            if !self.defined.contains(&id) {
                self.define(id);
                self.defined.push(id);
            }
        }
        root
    }

    fn define(&mut self, id: u32) {
        let (node, parts) = (self.node(id), self.parts(id));
        let apply = |of: &dyn Fn(u32) -> String| {
            let x: Vec<String> = parts.iter().map(|part| of(*part)).collect();
            match node {
                Node::Neg(_) => format!("-{}", x[0]),
                Node::Sqrt(_) => format!("sqrt({})", x[0]),
                Node::Add(..) => x.join(" + "),
                Node::Sub(..) => x.join(" - "),
                Node::Mul(..) => x.join(" * "),
                Node::Div(..) => x.join(" / "),
                _ => panic!("{node:?} is not on this way"),
            }
        };
        let definition = match node {
            Node::Constant(bits) => format!("n{id} = {};\n", binary(f64::from_bits(bits))),
            Node::Var(_) => format!("n{id} = rnd(v{id});\n"),
            _ => {
                let rnd = if matches!(node, Node::Neg(_)) {
                    ""
                } else {
                    "rnd"
                };
                let rounded = apply(&|part| format!("n{part}"));
                let exact = apply(&|part| self.exact(part));
                format!("n{id} {rnd}= {rounded};\nN{id} = {exact};\n")
            }
        };
        self.definitions.push_str(&definition);
    }

    /// What is known of a node whose error is bounded.
    fn bound(&mut self, id: u32) {
        let fact = match self.node(id) {
            Node::Var(index) => {
                let range = self.run.graph.names[index as usize].1;
                if range.low < 0.0 {
                    format!("|n{id}| in [{TINY},{}]", range.high)
                } else {
                    format!("n{id} in [{},{}]", range.low, range.high)
                }
            }
            Node::Add(..) if self.parts(id).iter().all(|part| self.is_positive(*part)) => {
                let first = self.parts(id)[0];
                format!("{} / N{id} in [0,1]", self.exact(first))
            }
            Node::Add(..) | Node::Sub(..) => format!("|N{id}| in [{TINY},{}]", 1.0 / TINY),
            _ => return,
        };
        self.facts.push(fact);
    }
}
