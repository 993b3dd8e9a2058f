//! A recorded formula in the language of Gappa: n1 is the value of the node 1, and N1 what it would be without rounding.

use std::fmt::Write;

use shading_proofs::{Format, Graph, Known, Node, Term, Test};

use super::{Formula, Of, TINY};

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
    formula: &'a Formula,
    definitions: String,
    facts: Vec<String>,
    rules: String,
}

impl<'a> Script<'a> {
    pub fn new(g: &'a Graph, known: Known, formula: &'a Formula) -> Self {
        Self {
            g,
            known,
            formula,
            definitions: String::new(),
            facts: Vec::new(),
            rules: String::new(),
        }
    }

    /// That the result is off by at most so many units of roundoff.
    pub fn text(mut self, result: Term, most: f64, of: Of) -> String {
        let digits = self.g.format.shape().1;
        let float = match self.g.format {
            Format::F64 => "float<ieee_64,ne>",
            _ => "float<ieee_32,ne>",
        };
        let root = self.plain(result.0);
        let named = self.formula.names.iter().map(|(_, term)| term.0);
        let mut defined = Vec::new();
        for root in [result.0].into_iter().chain(named) {
            let root = self.plain(root);
            for id in self.order(root) {
                if !defined.contains(&id) {
                    defined.push(id);
                    self.define(id, digits, of);
                }
            }
        }
        for &(term, [low, high]) in &self.formula.exact {
            let exact = self.exact(term.0);
            self.facts.push(format!("{exact} in [{low},{high}]"));
        }
        for &(name, term) in &self.formula.names {
            // what is named is named for its range, which is proved
            let id = self.name(name, term);
            let range = self.known.range(self.g, id);
            if range.low.abs().max(range.high.abs()) <= 2.0 {
                let [low, high] = [range.low, range.high].map(binary);
                self.facts.push(format!("n{id} in [{low},{high}]"));
            }
        }
        self.name('x', result);
        let goal = match of {
            Of::Result => format!("|n{root} -/ N{root}|"),
            Of::One => format!("|n{root} - N{root}|"),
            Of::Named('w') => "|(x - X) * W|".into(),
            Of::Named(name) => format!("|(x - X) / {}|", name.to_uppercase()),
            Of::Magnitudes => format!("|m{root} -/ M{root}|"),
            Of::Excess => format!("n{root} - 1"),
        };
        // the page leaves out terms in u², which get a fiftieth of u here
        let left_out = if of == Of::Excess { 0.0 } else { 0.02 };
        let limit = ((most + left_out) * 65_536.0).floor();
        let (definitions, facts, rules) = (self.definitions, self.facts.join(" /\\ "), self.rules);
        format!(
            "# at most {most} u\n@rnd = {float};\n{definitions}{{ {facts}\n -> {goal} <= {limit}b-{} }}\n{rules}{}",
            digits + 16,
            self.formula.rules
        )
    }

    fn name(&mut self, name: char, term: Term) -> u32 {
        let id = self.plain(term.0);
        let exact = self.exact(id);
        let _ = writeln!(
            self.definitions,
            "{name} = n{id};\n{} = {exact};",
            name.to_uppercase()
        );
        id
    }

    /// The node itself, what a decided selection selects, or what 0 is added to.
    fn plain(&mut self, id: u32) -> u32 {
        let id = self.known.resolved(self.g, id);
        match self.g.nodes[id as usize] {
            Node::Add(a, b) if self.is_zero(b) => self.plain(a),
            Node::Add(a, b) if self.is_zero(a) => self.plain(b),
            Node::Sub(a, b) if self.is_zero(b) => self.plain(a),
            Node::Mul(a, b) if self.is_one(b) => self.plain(a),
            Node::Mul(a, b) if self.is_one(a) => self.plain(b),
            // the larger of a number that is not negative, and 0
            Node::Select(Test::Above(x, zero), then, other)
                if (then, other) == (x, zero) && self.is_zero(zero) && self.is_positive(x) =>
            {
                self.plain(x)
            }
            _ => id,
        }
    }

    fn is_zero(&mut self, id: u32) -> bool {
        let range = self.known.range(self.g, id);
        range.low == 0.0 && range.high == 0.0
    }

    fn is_one(&mut self, id: u32) -> bool {
        self.known.range(self.g, id).only() == Some(1.0)
    }

    fn is_constant(&mut self, id: u32) -> bool {
        let range = self.known.range(self.g, id);
        range.low >= range.high
    }

    fn is_positive(&mut self, id: u32) -> bool {
        self.known.range(self.g, id).low >= 0.0
    }

    /// By how much a node that is taken as it is is off, and its range without that error.
    fn taken(&mut self, id: u32) -> Option<(f64, [f64; 2])> {
        let formula = self.formula;
        formula
            .taken
            .iter()
            .find(|(term, ..)| self.plain(term.0) == id)
            .map(|&(_, off, range)| (off, range))
    }

    /// The node's parts, unless it is taken as it is.
    fn parts(&mut self, id: u32) -> Vec<u32> {
        if self.taken(id).is_some() {
            return vec![];
        }
        let parts = match self.g.nodes[id as usize] {
            Node::Neg(a) | Node::Sqrt(a) => vec![a],
            Node::Sub(a, b) if self.is_zero(a) => vec![b],
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
        let case = if is_given && self.taken(id).is_none() {
            'n'
        } else {
            'N'
        };
        format!("{case}{id}")
    }

    fn define(&mut self, id: u32, digits: i32, of: Of) {
        let parts = self.parts(id);
        let exact: Vec<String> = parts.iter().map(|&part| self.exact(part)).collect();
        let is_taken = self.taken(id).is_some();
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
            _ if is_taken => String::new(),
            Node::Constant(bits) => format!("n{id} = {};\n", f64::from_bits(bits)),
            Node::Var(_) | Node::Power(..) => format!("n{id} = rnd(v{id});\n"),
            _ => {
                let is_exact = parts.len() == 1 && !matches!(node, Node::Sqrt(_))
                    || matches!(node, Node::Add(a, b) if a == b);
                let rnd = if is_exact { "" } else { "rnd" };
                let [rounded, exact] = [&rounded, &exact].map(|x| apply(x));
                format!("n{id} {rnd}= {rounded};\nN{id} = {exact};\n")
            }
        };
        self.definitions += &text;
        if let Some((off, [low, high])) = self.taken(id) {
            let _ = writeln!(self.definitions, "n{id} = rnd(v{id});");
            let error = off * 65_536.0;
            self.facts.push(format!(
                "N{id} in [{low},{high}] /\\ |n{id} - N{id}| <= {error}b-{}",
                digits + 16
            ));
            let least = self.known.range(self.g, id).low;
            let is_given = matches!(self.g.nodes[id as usize], Node::Var(_));
            if least > 0.0 && !is_given {
                self.facts.push(format!("n{id} >= {least}"));
            }
        }
        self.bound(id, digits, of, &parts, &exact);
        if of == Of::Magnitudes {
            self.magnitude(id, &parts, &exact);
        }
    }

    /// What is known of a node.
    fn bound(&mut self, id: u32, digits: i32, of: Of, parts: &[u32], exact: &[String]) {
        let is_tame = of != Of::Magnitudes && !self.is_constant(id);
        match self.g.nodes[id as usize] {
            Node::Var(index) if of != Of::Excess => {
                let range = self.g.names[index as usize].1;
                self.facts.push(if range.low < 0.0 {
                    format!("|n{id}| in [{TINY},{}]", range.high)
                } else {
                    format!("n{id} in [{},{}]", range.low, range.high)
                });
            }
            Node::Power(..) => {
                // the power of √½ by m, which `power` makes of a cosine that is off by 0.71 u
                self.facts.push(format!(
                    "n{id} in [0,1] /\\ N{id} in [0,1] /\\ |n{id} - N{id}| <= 19b-{}",
                    digits + 2
                ));
            }
            Node::Add(_, b) if matches!(self.g.nodes[b as usize], Node::Power(..)) => {
                self.facts.push(format!("N{id} >= 1")); // m + 2^(−m/2) is least for m = 0
            }
            Node::Add(..)
                if parts.len() == 2
                    && of != Of::Magnitudes
                    && parts.iter().all(|&part| self.is_positive(part)) =>
            {
                self.facts.push(format!("{} / N{id} in [0,1]", exact[0]));
            }
            Node::Add(..) | Node::Sub(..) if parts.len() == 2 && is_tame && of == Of::Result => {
                self.facts
                    .push(format!("|N{id}| in [{TINY},{}]", 1.0 / TINY));
            }
            _ => {}
        }
    }

    /// M1 is what the formula gives of magnitudes, without signs. m1 is off from it by what n1 is off from N1, so that the
    /// share m1 is off by is that of n1 in M1; and such shares Gappa can add.
    fn magnitude(&mut self, id: u32, parts: &[u32], exact: &[String]) {
        let is_taken = self.taken(id).is_some();
        let e = self.exact(id);
        let share = |part: u32| format!("((m{part} - M{part}) / M{part})");
        let mut rule = |text: String| _ = writeln!(self.rules, "{text};");
        let magnitude = match (self.g.nodes[id as usize], parts, exact) {
            (Node::Add(..), [a, b], _) => {
                self.facts.push(format!("M{a} / M{id} in [0,1]"));
                let (sum, all) = (
                    format!("(n{a} + n{b})"),
                    format!("((m{a} + m{b}) - M{id}) / M{id}"),
                );
                let off = format!("(n{id} - {sum})");
                rule(format!(
                    "(m{id} - M{id}) / M{id} -> {all} + {off} / M{id} {{ M{id} <> 0 }}"
                ));
                rule(format!(
                    "{off} / M{id} -> ({off} / {sum}) * ({sum} / M{id}) {{ M{id} <> 0, {sum} <> 0 }}"
                ));
                rule(format!(
                    "{sum} / M{id} -> {e} / M{id} + {all} {{ M{id} <> 0 }}"
                ));
                format!("M{a} + M{b}")
            }
            (Node::Mul(..), [a, b], [x, y]) => {
                let product = format!("(n{a} * n{b})");
                let mut error =
                    format!("((n{id} - {product}) / {product}) * ((n{a} / M{a}) * (n{b} / M{b}))");
                let mut both = Vec::new();
                for (part, exact, rest) in [
                    (a, x, format!("({y} / M{b})")),
                    (b, y, format!("({x} / M{a})")),
                ] {
                    if exact.starts_with('N') {
                        let of = share(*part);
                        rule(format!(
                            "n{part} / M{part} -> {exact} / M{part} + {of} {{ M{part} <> 0 }}"
                        ));
                        let _ = write!(error, " + {rest} * {of}");
                        both.push(of);
                    }
                }
                if let [a, b] = &both[..] {
                    let _ = write!(error, " + {a} * {b}");
                }
                rule(format!(
                    "(m{id} - M{id}) / M{id} -> {error} {{ M{a} <> 0, M{b} <> 0, {product} <> 0 }}"
                ));
                format!("M{a} * M{b}")
            }
            (Node::Neg(_), [a], _) => format!("M{a}"),
            (_, [], _) if is_taken => {
                rule(format!("(m{id} - M{id}) / M{id} -> n{id} - {e}"));
                "1".into()
            }
            (_, [], _) => format!("|{e}|"),
            (node, ..) => panic!("{node:?} has no magnitude"),
        };
        let error = if e.starts_with('N') {
            format!(" + (n{id} - {e})")
        } else {
            String::new()
        };
        let _ = writeln!(
            self.definitions,
            "M{id} = {magnitude};\nm{id} = M{id}{error};"
        );
        self.facts.push(format!("{e} / M{id} in [-1,1]"));
    }
}
