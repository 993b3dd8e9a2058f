//! A recorded formula in the language of Gappa: n1 is the value of the node 1, and N1 what it would
//! be without rounding.

use std::fmt::Write;

use shading_proofs::{Graph, Known, Node, Range, Run, Term, Test};

use super::{Of, TINY};

/// A number as Gappa reads it without rounding: a whole number and a power of two.
fn binary(mut x: f64) -> String {
    let mut power = 0;
    while x.fract() != 0.0 {
        (x, power) = (x * 2.0, power - 1);
    }
    format!("{x}b{power}")
}

pub struct Script<'a> {
    g: &'a Graph,
    known: Known,
    /// A number that is taken as it is: by how many units of roundoff it is off, and its range without that error.
    taken: Option<(Term, f64, [f64; 2])>,
    definitions: String,
    facts: Vec<String>,
}

impl<'a> Script<'a> {
    pub fn new(run: &'a Run, taken: Option<(Term, f64, [f64; 2])>) -> Self {
        Self {
            g: &run.graph,
            known: run.known.clone(),
            taken,
            definitions: String::new(),
            facts: Vec::new(),
        }
    }

    fn digits(&self) -> i32 {
        self.g.format.shape().1
    }

    /// That the result is off by at most so many units of roundoff.
    pub fn error(mut self, result: Term, most: f64, of: Of) -> String {
        let root = self.define_below(result);
        for id in self.order(root) {
            self.bound(id, of);
        }
        let goal = match of {
            Of::Result => format!("|n{root} -/ N{root}|"),
            Of::One => format!("|n{root} - N{root}|"),
        };
        // the page leaves out terms in u², which get a fiftieth of u here
        let limit = ((most + 0.02) * 65_536.0).floor();
        let goal = format!("{goal} <= {limit}b-{}", self.digits() + 16);
        self.text(&format!("at most {most} u"), &goal, "")
    }

    /// That the cosine of two directions n and l, or of −n and l, lies in a range of which `share`
    /// is left beyond ±1: 2 N·L = |N|² + |L|² − |N − L|² = |N + L|² − |N|² − |L|², and each square
    /// is what the path has found it to be.
    pub fn within(mut self, cosine: Term, range: Range, share: f64) -> String {
        let root = self.define_below(cosine);
        let [a, b, c, e, f, g] = ["n.x", "n.y", "n.z", "l.x", "l.y", "l.z"].map(|name| {
            let is_named =
                |node: &Node| matches!(node, Node::Var(i) if self.g.names[*i as usize].0 == name);
            let id = self
                .g
                .nodes
                .iter()
                .position(is_named)
                .expect("a component of a direction");
            format!("n{id}")
        });
        let mut rules = String::new();
        let mut halves = Vec::new();
        for (x, y, z) in [(&a, &b, &c), (&e, &f, &g)] {
            self.facts
                .extend([x, y, z].map(|x| format!("{x} in [-1.000001,1.000001]")));
            let id = |name: &str| name[1..].parse::<u32>().expect("a number");
            let square = |x: &str| Node::Mul(id(x), id(x));
            let find = |node: Node| {
                let id = self.g.nodes.iter().position(|other| *other == node);
                u32::try_from(id.expect("a part of the square")).expect("fewer than 2³² nodes")
            };
            let [x, y, z] = [x, y, z].map(|x| find(square(x)));
            let sum = find(Node::Add(find(Node::Add(x, y)), z));
            self.define_below(Term(sum));
            let range = self.known.range(self.g, sum);
            let [low, high] = [range.low, range.high].map(binary);
            self.facts.push(format!("n{sum} in [{low},{high}]"));
            let _ = writeln!(rules, "N{sum} -> n{sum} - (n{sum} - N{sum});");
            halves.push(format!("N{sum}"));
        }
        // the cosine of −N is that of N with the other sign
        let is_opposite = matches!(self.g.nodes[root as usize], Node::Sub(..));
        let half = if is_opposite { "-2" } else { "2" };
        let squares = halves.join(" + ");
        let of = |sign: char| {
            let pairs = [(&a, &e), (&b, &f), (&c, &g)]
                .map(|(x, y)| format!("({x}{sign}{y})*({x}{sign}{y})"));
            pairs.join(" + ")
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

    /// The node itself, what a decided selection selects, or what 0 is added to.
    fn plain(&mut self, id: u32) -> u32 {
        let id = self.known.resolved(self.g, id);
        match self.g.nodes[id as usize] {
            Node::Add(a, b) if self.is(b, 0.0) => self.plain(a),
            Node::Add(a, b) if self.is(a, 0.0) => self.plain(b),
            Node::Sub(a, b) if self.is(b, 0.0) => self.plain(a),
            Node::Mul(a, b) if self.is(b, 1.0) => self.plain(a),
            Node::Mul(a, b) if self.is(a, 1.0) => self.plain(b),
            // the larger of a number that is not negative, and 0
            Node::Select(Test::Above(x, zero), then, other)
                if (then, other) == (x, zero) && self.is(zero, 0.0) && self.is_positive(x) =>
            {
                self.plain(x)
            }
            _ => id,
        }
    }

    /// Whether a node has no other value; −0 counts as 0.
    #[allow(clippy::float_cmp)] // 0 and 1 are exact
    fn is(&mut self, id: u32, value: f64) -> bool {
        let range = self.known.range(self.g, id);
        range.low == value && range.high == value
    }

    fn is_positive(&mut self, id: u32) -> bool {
        self.known.range(self.g, id).low >= 0.0
    }

    fn is_taken(&self, id: u32) -> bool {
        self.taken.is_some_and(|(term, ..)| term.0 == id)
    }

    fn parts(&mut self, id: u32) -> Vec<u32> {
        let parts = match self.g.nodes[id as usize] {
            Node::Neg(a) | Node::Sqrt(a) => vec![a],
            Node::Sub(a, b) if self.is(a, 0.0) => vec![b],
            Node::Add(a, b) | Node::Sub(a, b) | Node::Mul(a, b) | Node::Div(a, b) => vec![a, b],
            _ => vec![],
        };
        parts.into_iter().map(|part| self.plain(part)).collect()
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
    fn exact(&mut self, id: u32) -> String {
        let id = self.plain(id);
        let is_given = matches!(self.g.nodes[id as usize], Node::Var(_) | Node::Constant(_));
        let case = if is_given && !self.is_taken(id) {
            'n'
        } else {
            'N'
        };
        format!("{case}{id}")
    }

    /// Defines a term and what it is made of.
    fn define_below(&mut self, root: Term) -> u32 {
        let root = self.plain(root.0);
        for id in self.order(root) {
            if !self.definitions.contains(&format!("n{id} ")) {
                self.define(id);
            }
        }
        root
    }

    fn define(&mut self, id: u32) {
        let parts = self.parts(id);
        let exact: Vec<String> = parts.iter().map(|&part| self.exact(part)).collect();
        let rounded: Vec<String> = parts.iter().map(|part| format!("n{part}")).collect();
        let node = self.g.nodes[id as usize];
        let apply = |x: &[String]| match (node, x) {
            (Node::Sqrt(_), [x]) => format!("sqrt({x})"),
            (Node::Neg(_) | Node::Sub(..), [x]) => format!("-{x}"),
            (Node::Add(..), [x, y]) => format!("{x} + {y}"),
            (Node::Sub(..), [x, y]) => format!("{x} - {y}"),
            (Node::Mul(..), [x, y]) => format!("{x} * {y}"),
            (Node::Div(..), [x, y]) => format!("{x} / {y}"),
            _ => panic!("{node:?} is not on this way"),
        };
        let text = match node {
            Node::Constant(bits) => format!("n{id} = {};\n", binary(f64::from_bits(bits))),
            Node::Var(_) | Node::Power(..) => format!("n{id} = rnd(v{id});\n"),
            _ => {
                let is_exact = parts.len() == 1 && !matches!(node, Node::Sqrt(_))
                    || matches!(node, Node::Add(a, b) if a == b);
                let rnd = if is_exact { "" } else { "rnd" };
                let [rounded, exact] = [&rounded, &exact].map(|x| apply(x));
                format!("n{id} {rnd}= {rounded};\nN{id} = {exact};\n")
            }
        };
        self.definitions.push_str(&text);
    }

    /// What is known of a node whose error is bounded.
    fn bound(&mut self, id: u32, of: Of) {
        let (parts, digits) = (self.parts(id), self.digits());
        let is_constant = self.known.range(self.g, id).only().is_some();
        let fact = match (self.g.nodes[id as usize], self.taken) {
            (Node::Var(_), Some((term, off, [low, high]))) if term.0 == id => {
                let error = format!("{}b-{}", off * 65_536.0, digits + 16);
                let range = self.known.range(self.g, id);
                Some(format!(
                    "N{id} in [{low},{high}] /\\ |n{id} - N{id}| <= {error} /\\ n{id} in [{},{}]",
                    range.low, range.high
                ))
            }
            (Node::Var(index), _) => {
                let range = self.g.names[index as usize].1;
                Some(if range.low < 0.0 {
                    format!("|n{id}| in [{TINY},{}]", range.high)
                } else {
                    format!("n{id} in [{},{}]", range.low, range.high)
                })
            }
            // the power of √½ by m, which `power` makes of a cosine that is off by 0.71 u
            (Node::Power(..), _) => Some(format!(
                "n{id} in [0,1] /\\ N{id} in [0,1] /\\ |n{id} - N{id}| <= 19b-{}",
                digits + 2
            )),
            // m + 2^(−m/2) is least for m = 0
            (Node::Add(_, b), _) if matches!(self.g.nodes[b as usize], Node::Power(..)) => {
                Some(format!("N{id} >= 1"))
            }
            (Node::Add(..), _) if parts.iter().all(|&part| self.is_positive(part)) => {
                let first = self.exact(parts[0]);
                Some(format!("{first} / N{id} in [0,1]"))
            }
            (Node::Add(..) | Node::Sub(..), _)
                if parts.len() == 2 && of == Of::Result && !is_constant =>
            {
                Some(format!("|N{id}| in [{TINY},{}]", 1.0 / TINY))
            }
            _ => None,
        };
        self.facts.extend(fact);
    }
}
