//! What is recorded: a graph of operations, in which equal ones are one, and the decisions on the way.

use std::cell::RefCell;
use std::collections::HashMap;

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Op {
    Add,
    Sub,
    Mul,
    Div,
    Min,
    Max,
}

/// A comparison of two nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Test {
    Above(usize, usize),
    AtLeast(usize, usize),
    /// Outside of the range in which squares are exact.
    Extreme(usize),
}

#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// A name, and which of its components.
    Var(String, Option<usize>),
    /// The bits of an `f32`.
    Const(u32),
    Binary(Op, usize, usize),
    Neg(usize),
    Dot([usize; 3], [usize; 3]),
    Select(Test, usize, usize),
    Call(&'static str, Vec<usize>),
    /// One number of the result of a call.
    Part(usize, usize),
}

/// The constants of a number, which every graph begins with.
pub const ZERO: usize = 0;
pub const ONE: usize = 1;
pub const NEG_ONE: usize = 2;
pub const MAX: usize = 3;
pub const EXTREME: usize = 4;
const CONSTANTS: [f32; 5] = [0.0, 1.0, -1.0, f32::MAX, f32::from_bits((127 + 100) << 23)];

#[derive(Default)]
pub struct Graph {
    pub nodes: Vec<Node>,
    index: HashMap<Node, usize>,
    /// The function that is recorded: a call of it is written out.
    pub defining: &'static str,
    /// Whether a mask chooses between two results, as in lanes, where it would otherwise decide on one path.
    pub selects: bool,
    /// Whether a product with 0 is 0. A derivative has many.
    pub drops_zeros: bool,
    /// Whether each decision is known to be true, and each number finite.
    assumes: bool,
    /// The decisions of this run.
    pub path: Vec<(Test, bool)>,
    /// How the first of them are to be answered; the others are `true`.
    pub given: Vec<bool>,
}

thread_local!(static GRAPH: RefCell<Graph> = RefCell::default());

pub fn with<R>(f: impl FnOnce(&mut Graph) -> R) -> R {
    GRAPH.with(|graph| f(&mut graph.borrow_mut()))
}

/// What `f` gives if each decision in it is true: the precondition of a constructor.
pub fn assuming<R>(f: impl FnOnce() -> R) -> R {
    with(|g| g.assumes = true);
    let result = f();
    with(|g| g.assumes = false);
    result
}

/// The answer to a test in this run.
pub fn decide(test: Test) -> bool {
    with(|g| {
        if let Some(answer) = g.known(test).or(g.assumes.then_some(true)) {
            return answer;
        }
        let answer = g.given.get(g.path.len()).copied().unwrap_or(true);
        g.path.push((test, answer));
        answer
    })
}

impl Graph {
    pub fn new(defining: &'static str, selects: bool, drops_zeros: bool) -> Self {
        let mut graph = Self {
            defining,
            selects,
            drops_zeros,
            ..Self::default()
        };
        for constant in CONSTANTS {
            graph.constant(constant);
        }
        graph
    }

    pub fn node(&mut self, node: Node) -> usize {
        if let Some(&known) = self.index.get(&node) {
            return known;
        }
        self.nodes.push(node.clone());
        self.index.insert(node, self.nodes.len() - 1);
        self.nodes.len() - 1
    }

    pub fn constant(&mut self, x: f32) -> usize {
        self.node(Node::Const(x.to_bits()))
    }

    pub fn value(&self, n: usize) -> Option<f32> {
        match self.nodes[n] {
            Node::Const(bits) => Some(f32::from_bits(bits)),
            _ => None,
        }
    }

    /// Whether the function that is recorded gets or gives numbers that overflow: most have finite arguments.
    fn can_overflow(&self) -> bool {
        ["", "measured", "attenuation", "arrival", "total"].contains(&self.defining)
    }

    /// Whether the function takes a light, of whose kind and falloff others decide.
    pub fn is_lit(&self) -> bool {
        self.defining == "arrival" || self.defining.starts_with("add_")
    }

    /// Whether it is the length of a direction.
    pub fn is_length(&self, n: usize) -> bool {
        match self.nodes[n] {
            Node::Part(call, 3) => matches!(self.nodes[call], Node::Call("measured", _)),
            _ => false,
        }
    }

    fn known(&self, test: Test) -> Option<bool> {
        let both = |a, b| self.value(a).zip(self.value(b));
        let by_value = match test {
            Test::Above(MAX, _) if self.is_lit() => Some(true), // whether there is a range asks the falloff
            Test::Above(a, b) => both(a, b).map(|(a, b)| a > b),
            Test::AtLeast(a, b) => both(a, b).map(|(a, b)| a >= b),
            Test::Extreme(_) => None,
        };
        let by_path = || self.path.iter().find(|(known, _)| *known == test);
        by_value.or_else(|| by_path().map(|known| known.1))
    }

    /// Whether a mask holds, if that is known or must be decided.
    pub fn holds(&self, test: Test, lanes: Option<bool>) -> Option<bool> {
        self.known(test).or(lanes.filter(|_| self.selects))
    }

    pub fn binary(&mut self, op: Op, a: usize, b: usize) -> usize {
        let (x, y) = (self.value(a), self.value(b));
        if let (Some(x), Some(y)) = (x, y) {
            return self.constant(match op {
                Op::Add => x + y,
                Op::Sub => x - y,
                Op::Mul => x * y,
                Op::Div => x / y,
                Op::Min => x.min(y),
                Op::Max => x.max(y),
            });
        }
        match (op, x, y) {
            (Op::Mul, Some(0.0), _) if self.drops_zeros => a,
            (Op::Mul, _, Some(0.0)) if self.drops_zeros => b,
            (Op::Sub, Some(0.0), _) if self.drops_zeros => self.neg(b),
            (Op::Add, Some(0.0), _) | (Op::Mul, Some(1.0), _) => b,
            (Op::Add | Op::Sub, _, Some(0.0)) | (Op::Mul | Op::Div, _, Some(1.0)) => a,
            (Op::Min, _, Some(f32::MAX)) if self.assumes || !self.can_overflow() => a,
            _ => self.node(Node::Binary(op, a, b)),
        }
    }

    pub fn dot(&mut self, a: [usize; 3], b: [usize; 3]) -> usize {
        if a[1..] == [ZERO; 2] || b[1..] == [ZERO; 2] {
            return self.binary(Op::Mul, a[0], b[0]);
        }
        self.node(Node::Dot(a, b))
    }

    pub fn neg(&mut self, a: usize) -> usize {
        match self.nodes[a] {
            Node::Const(bits) => self.constant(-f32::from_bits(bits)),
            Node::Neg(b) => b,
            _ => self.node(Node::Neg(a)),
        }
    }

    /// A choice. What both sides have in common is outside of it.
    pub fn select(&mut self, test: Test, then: usize, otherwise: usize) -> usize {
        if then == otherwise {
            return then;
        }
        if let Some(answer) = self.known(test) {
            return if answer { then } else { otherwise };
        }
        match (
            test,
            self.nodes[then].clone(),
            self.nodes[otherwise].clone(),
        ) {
            // max and min, as the crate derives them
            (Test::Above(a, b), ..) if (a, b) == (then, otherwise) => self.binary(Op::Max, a, b),
            (Test::Above(a, b), ..) if (b, a) == (then, otherwise) => self.binary(Op::Min, a, b),
            (_, Node::Binary(op, a, x), Node::Binary(same, b, y)) if op == same && a == b => {
                let right = self.select(test, x, y);
                self.binary(op, a, right)
            }
            (_, Node::Binary(op, a, x), Node::Binary(same, b, y)) if op == same && x == y => {
                let left = self.select(test, a, b);
                self.binary(op, left, x)
            }
            (_, Node::Binary(Op::Mul, a, x), _) if a == otherwise => {
                let right = self.select(test, x, ONE);
                self.binary(Op::Mul, a, right)
            }
            (_, Node::Select(t, a, x), Node::Select(same, b, y)) if t == same && x == y => {
                let then = self.select(test, a, b);
                self.select(t, then, x)
            }
            _ => self.node(Node::Select(test, then, otherwise)),
        }
    }
}
