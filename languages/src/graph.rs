//! What is recorded: a graph of values, in which equal ones are one, and the decisions on the way.

use std::cell::RefCell;
use std::collections::HashMap;

use crate::kind::Kind;
use crate::table::functions;

/// How a value comes from others.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Op {
    Parameter(&'static str),
    /// The bits of an `f32`.
    Constant(u32),
    /// A field of a struct, or a component of a vector.
    Field(&'static str),
    /// A call of a function of the files.
    Call(&'static str),
    /// A call of a function that the languages have.
    Own(&'static str),
    Add,
    Sub,
    Mul,
    /// A vector times a number.
    Scale,
    Div,
    Neg,
    Above,
    AtLeast,
    All,
    Any,
    /// Where the first holds, the second, and elsewhere the third.
    Select,
}

pub const MINIMUM: Op = Op::Own("min");
pub const MAXIMUM: Op = Op::Own("max");
pub const VECTOR: Op = Op::Own("vector");
pub const DOT: Op = Op::Own("dot");

#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Node {
    pub op: Op,
    pub kind: Kind,
    pub of: Vec<usize>,
}

/// The constants of a number, which every graph begins with.
pub const ZERO: usize = 0;
pub const ONE: usize = 1;
pub const NEG_ONE: usize = 2;
pub const MAX: usize = 3;
pub const EXTREME: usize = 4;
const CONSTANTS: [f32; 5] = [0.0, 1.0, -1.0, f32::MAX, f32::from_bits((127 + 100) << 23)];

/// The most decisions on a path; in a loop until a number is small, they would not end.
const MOST_DECISIONS: usize = 64;

#[derive(Default)]
pub struct Graph {
    pub nodes: Vec<Node>,
    index: HashMap<Node, usize>,
    /// The function that is recorded.
    pub defining: &'static str,
    /// Whether the language has quotients, minima and maxima of vectors.
    pub divides_vectors: bool,
    /// Whether each decision is known to be true.
    assumes: bool,
    /// The decisions of this run.
    pub path: Vec<(usize, bool)>,
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

impl Graph {
    /// Begins with a function of the files, or with one that has no name among them.
    pub fn begin(&mut self, defining: &'static str, divides_vectors: bool) {
        *self = Self::default();
        (self.defining, self.divides_vectors) = (defining, divides_vectors);
        for constant in CONSTANTS {
            self.constant(constant);
        }
    }

    pub fn add(&mut self, op: Op, kind: Kind, of: &[usize]) -> usize {
        let of = of.to_vec();
        let node = Node { op, kind, of };
        if let Some(&known) = self.index.get(&node) {
            return known;
        }
        self.nodes.push(node.clone());
        self.index.insert(node, self.nodes.len() - 1);
        self.nodes.len() - 1
    }

    pub fn constant(&mut self, x: f32) -> usize {
        self.add(Op::Constant(x.to_bits()), Kind::Number, &[])
    }

    /// The numbers of a parameter.
    pub fn parameter(&mut self, name: &'static str, kind: Kind) -> Vec<usize> {
        let parameter = self.add(Op::Parameter(name), kind, &[]);
        self.numbers(parameter)
    }

    /// The numbers of the result of a call, given those of its arguments.
    pub fn call(&mut self, name: &'static str, arguments: &[usize]) -> Vec<usize> {
        let function = functions().iter().find(|function| function.name == name);
        let (of, result) = match function {
            Some(function) => (self.values(function.parameters, arguments), function.result),
            // what takes the bits of a number is not in the table
            None => (arguments.to_vec(), Kind::Number),
        };
        let call = self.add(Op::Call(name), result, &of);
        self.numbers(call)
    }

    /// Whether the function that is recorded gets or gives numbers that overflow: most have finite arguments.
    fn can_overflow(&self) -> bool {
        ["", "measured", "attenuation", "arrival", "total"].contains(&self.defining)
    }

    /// Whether a product with 0 is 0; in one function, it tells what is not finite. A derivative has many.
    fn drops_zeros(&self) -> bool {
        self.defining != "normal_transformed"
    }

    /// Whether the function takes a light, of whose kind and falloff others decide.
    pub fn is_lit(&self) -> bool {
        self.defining == "arrival" || self.defining.starts_with("add_")
    }

    /// The answer to a test in this run.
    pub fn decide(&mut self, test: usize) -> bool {
        let assumed = self.assumes.then_some(true);
        if let Some(answer) = self.known(test).or(assumed) {
            return answer;
        }
        let count = self.path.len();
        assert!(
            count < MOST_DECISIONS,
            "a formula takes more than {MOST_DECISIONS} decisions"
        );
        let answer = self.given.get(count).copied().unwrap_or(true);
        self.path.push((test, answer));
        answer
    }

    pub fn known(&self, test: usize) -> Option<bool> {
        let mut known = [(ONE, true), (ZERO, false)].iter().chain(&self.path);
        known.find(|known| known.0 == test).map(|known| known.1)
    }

    /// Whether another comparison holds where a test holds, as far as it is known.
    pub fn implied(&self, test: usize, other: usize) -> Option<bool> {
        let [test, other] = [test, other].map(|n| &self.nodes[n]);
        let is_reversed = test.of.iter().eq(other.of.iter().rev());
        match (test.op, other.op) {
            (Op::Above, Op::AtLeast) if test.of == other.of => Some(true),
            (Op::Above, Op::Above | Op::AtLeast) if is_reversed => Some(false),
            _ => None,
        }
    }

    /// An operation on one number or two.
    pub fn number(&mut self, op: Op, of: &[usize]) -> usize {
        let (a, b) = (of[0], of[of.len() - 1]);
        let [x, y] = [a, b].map(|n| match self.nodes[n].op {
            Op::Constant(bits) => Some(f32::from_bits(bits)),
            _ => None,
        });
        if let Some(known) = x.zip(y).and_then(|(x, y)| computed(op, x, y)) {
            return self.constant(known);
        }
        let [left, right] = [a, b].map(|n| self.nodes[n].clone());
        match (op, x, y) {
            (Op::Neg, ..) if left.op == Op::Neg => left.of[0],
            (Op::Mul, Some(0.0), _) if self.drops_zeros() => a,
            (Op::Mul, _, Some(0.0)) if self.drops_zeros() => b,
            (Op::Sub, Some(0.0), _) if self.drops_zeros() => self.number(Op::Neg, &[b]),
            (Op::Add, Some(0.0), _) | (Op::Mul, Some(1.0), _) => b,
            (Op::Add | Op::Sub, _, Some(0.0)) | (Op::Mul | Op::Div, _, Some(1.0)) => a,
            (MINIMUM, _, Some(f32::MAX)) if !self.can_overflow() => a,
            (MINIMUM, ..) if left.op == MAXIMUM => {
                self.add(Op::Own("clamp"), Kind::Number, &[left.of[0], left.of[1], b])
            }
            (MAXIMUM, ..) if right.op == Op::Neg && right.of[0] == a => {
                self.add(Op::Own("abs"), Kind::Number, &[a])
            }
            // whether there is a range asks the falloff
            (Op::Above, Some(f32::MAX), _) if self.is_lit() => ONE,
            (Op::Above | Op::AtLeast, ..) => self.add(op, Kind::Flag, of),
            _ => self.add(op, Kind::Number, of),
        }
    }

    pub fn dot(&mut self, a: [usize; 3], b: [usize; 3]) -> usize {
        if b[1..] == [ZERO; 2] {
            return self.number(Op::Mul, &[a[0], b[0]]);
        }
        let of = [a, b].map(|numbers| self.value(&numbers));
        self.add(DOT, Kind::Number, &of)
    }

    /// A choice. What both sides have in common is outside of it.
    pub fn select(&mut self, test: usize, then: usize, otherwise: usize) -> usize {
        let [above, yes, no] = [test, then, otherwise].map(|n| self.nodes[n].clone());
        let is_of = |sides| above.op == Op::Above && above.of == sides;
        let same = (yes.op == no.op).then_some(yes.op);
        match (same, &yes.of[..], &no.of[..]) {
            _ if then == otherwise => then,
            // max and min, as the crate derives them
            _ if is_of([then, otherwise]) => self.number(MAXIMUM, &above.of),
            _ if is_of([otherwise, then]) => self.number(MINIMUM, &above.of),
            _ if self.known(test) == Some(true) => then,
            _ if self.known(test) == Some(false) => otherwise,
            (Some(Op::Select), &[same, a, x], &[t, b, y]) if (same, x) == (t, y) => {
                let then = self.select(test, a, b);
                self.select(same, then, x)
            }
            (Some(op), &[a, x], &[b, y]) if op != DOT && (a == b || x == y) => {
                let of = [(a, b), (x, y)].map(|(yes, no)| self.select(test, yes, no));
                self.number(op, &of)
            }
            (_, &[a, x], _) if yes.op == Op::Mul && a == otherwise => {
                let right = self.select(test, x, ONE);
                self.number(Op::Mul, &[a, right])
            }
            _ => self.choice(test, then, otherwise),
        }
    }
}

/// The result of an operation on known numbers, if a language can write it; a comparison gives 1 or 0.
fn computed(op: Op, x: f32, y: f32) -> Option<f32> {
    let result = match op {
        Op::Neg => -x,
        Op::Add => x + y,
        Op::Sub => x - y,
        Op::Mul => x * y,
        Op::Div => x / y,
        Op::Above => f32::from(x > y),
        Op::AtLeast => f32::from(x >= y),
        _ => return None,
    };
    result.is_finite().then_some(result)
}
