//! A formula as a graph: what each node computes, and from which others.

use std::collections::HashMap;

use super::format::Format;
use super::range::Range;

#[doc(hidden)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Node {
    Var(u32),
    Constant(u64), // the bits of an f64, which the format rounds
    Max,
    Extreme,
    Neg(u32),
    Abs(u32),
    Sqrt(u32),
    Add(u32, u32),
    Sub(u32, u32),
    Mul(u32, u32),
    Div(u32, u32),
    Select(Test, u32, u32),
    /// A function of `libm`, of which only the signs, the ends and NaN are known.
    Call(Function, u32),
    /// A cosine to a real power, of which only the contract is known: within [0, 1]; 0 for a cosine that
    /// is not above 0; otherwise 1 for an m that is not above 0, and at least c − 2⁻²⁰ for m ≤ 1. In `f32`,
    /// the package of proofs tries every input of it; in `f64` it is that of `libm`.
    Power(u32, u32),
}

#[doc(hidden)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Function {
    Sin,
    Cos,
    Exp,
    Ln,
}

#[doc(hidden)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Test {
    Above(u32, u32),
    AtMost(u32, u32),
    Equal(u32, u32),
    /// `any_outside`, for which the trait leaves the answer open on the limits.
    Outside(u32, u32, u32),
    /// One of two cases into which the author of a claim divides it.
    Case(u32),
}

/// A node in the one way in which it is written.
enum Simple {
    Node(u32),
    New(Node),
    Negated(Node),
}

/// Where the variables get their values from, for a run with numbers.
pub(super) type Sampler = Box<dyn FnMut(Range, &[f64]) -> f64>;

#[doc(hidden)]
#[derive(Default)]
pub struct Graph {
    pub format: Format,
    pub nodes: Vec<Node>,
    index: HashMap<Node, u32>,
    /// The nodes that have the opposite value, apart from the sign of a zero.
    mirrors: HashMap<u32, Vec<u32>>,
    pub names: Vec<(String, Range)>,
    /// The nodes' values, in a run with numbers.
    pub values: Vec<f64>,
    sampler: Option<Sampler>,
}

/// The nodes of [`Real::ZERO`](shading::Real::ZERO) and of [`Real::ONE`](shading::Real::ONE).
pub(super) const ZERO: u32 = 0;
pub(super) const ONE: u32 = 1;

impl Graph {
    /// Records a node in the one way in which it is written.
    pub(super) fn node(&mut self, node: Node) -> u32 {
        match self.simplified(node) {
            Simple::Node(id) => id,
            Simple::New(node) => self.insert(node),
            Simple::Negated(node) => {
                let id = self.insert(node);
                self.node(Node::Neg(id))
            }
        }
    }

    /// What has the same bits by the rules of signs.
    fn simplified(&self, node: Node) -> Simple {
        let of = |id: u32| self.nodes[id as usize];
        let sum = |a: u32, b: u32| Simple::New(Node::Add(a.min(b), a.max(b)));
        match node {
            Node::Neg(a) => match of(a) {
                Node::Neg(x) => Simple::Node(x),
                _ => Simple::New(node),
            },
            Node::Abs(a) => match of(a) {
                Node::Neg(x) => Simple::New(Node::Abs(x)),
                _ => Simple::New(node),
            },
            Node::Add(a, b) => match (of(a), of(b)) {
                (_, Node::Neg(y)) => Simple::New(Node::Sub(a, y)),
                (Node::Neg(x), _) => Simple::New(Node::Sub(b, x)),
                _ => sum(a, b),
            },
            Node::Sub(a, ZERO) => Simple::Node(a),
            Node::Sub(a, b) => match of(b) {
                Node::Neg(y) => sum(a, y),
                _ => Simple::New(node),
            },
            Node::Mul(a, b) | Node::Div(a, b) => {
                let is_mul = matches!(node, Node::Mul(..));
                let make = |a: u32, b: u32| {
                    if is_mul {
                        Node::Mul(a.min(b), a.max(b))
                    } else {
                        Node::Div(a, b)
                    }
                };
                match (of(a), of(b)) {
                    (_, _) if b == ONE => Simple::Node(a),
                    (_, _) if a == ONE && is_mul => Simple::Node(b),
                    (Node::Neg(x), Node::Neg(y)) => Simple::New(make(x, y)),
                    (Node::Neg(x), _) => Simple::Negated(make(x, b)),
                    (_, Node::Neg(y)) => Simple::Negated(make(a, y)),
                    _ => Simple::New(make(a, b)),
                }
            }
            node => Simple::New(node),
        }
    }

    fn insert(&mut self, node: Node) -> u32 {
        if let Some(&id) = self.index.get(&node) {
            return id;
        }
        let id = u32::try_from(self.nodes.len()).expect("fewer than 2³² nodes");
        self.index.insert(node, id);
        self.nodes.push(node);
        let value = self.value(node);
        self.values.push(value);
        if let Node::Sub(a, b) = node {
            // −p − q has the opposite value of p + q, and q − p that of p − q
            let negated: Vec<u32> = self.mirrors(a).collect();
            for p in negated {
                let mirror = self.insert(Node::Add(p.min(b), p.max(b)));
                self.mirror(id, mirror);
            }
            if let Some(&mirror) = self.index.get(&Node::Sub(b, a)) {
                self.mirror(id, mirror);
            }
        }
        id
    }

    fn mirror(&mut self, a: u32, b: u32) {
        self.mirrors.entry(a).or_default().push(b);
        self.mirrors.entry(b).or_default().push(a);
    }

    /// The nodes that have the opposite value, apart from the sign of a zero.
    pub(super) fn mirrors(&self, id: u32) -> impl Iterator<Item = u32> {
        let inner = match self.nodes[id as usize] {
            Node::Neg(x) => Some(x),
            _ => None,
        };
        let recorded = self.mirrors.get(&id);
        inner
            .into_iter()
            .chain(recorded.into_iter().flatten().copied())
    }

    /// The node, if it has been recorded.
    pub(super) fn find(&self, node: Node) -> Option<u32> {
        match self.simplified(node) {
            Simple::Node(id) => Some(id),
            Simple::New(node) => self.index.get(&node).copied(),
            Simple::Negated(node) => {
                let inner = self.index.get(&node)?;
                self.index.get(&Node::Neg(*inner)).copied()
            }
        }
    }

    /// A number of a range that is no variable, in a run with numbers.
    pub(super) fn draw(&mut self, range: Range) -> f64 {
        let sampler = self.sampler.as_mut();
        sampler.map_or(f64::NAN, |sampler| sampler(range, &[0.0]))
    }

    fn value(&mut self, node: Node) -> f64 {
        if let (Node::Var(index), Some(sampler)) = (node, &mut self.sampler) {
            return sampler(self.names[index as usize].1, &self.values);
        }
        let v = |id: u32| self.values[id as usize];
        let exact = match node {
            Node::Var(_) => f64::NAN,
            Node::Constant(bits) => f64::from_bits(bits),
            Node::Max => self.format.max(),
            Node::Extreme => self.format.extreme(),
            Node::Neg(a) => -v(a),
            Node::Abs(a) => v(a).abs(),
            Node::Sqrt(a) => v(a).sqrt(),
            Node::Add(a, b) => v(a) + v(b),
            Node::Sub(a, b) => v(a) - v(b),
            Node::Mul(a, b) => v(a) * v(b),
            Node::Div(a, b) => v(a) / v(b),
            Node::Select(test, a, b) => v(if self.holds(test) { a } else { b }),
            Node::Call(Function::Sin, a) => v(a).sin(),
            Node::Call(Function::Cos, a) => v(a).cos(),
            Node::Call(Function::Exp, a) => v(a).exp(),
            Node::Call(Function::Ln, a) => v(a).ln(),
            Node::Power(c, m) => raised(v(c), v(m)),
        };
        self.format.round(exact)
    }

    /// Whether a test holds, in a run with numbers.
    #[must_use]
    pub fn holds(&self, test: Test) -> bool {
        let v = |id: u32| self.values[id as usize];
        match test {
            Test::Above(a, b) => v(a) > v(b),
            Test::AtMost(a, b) => v(a) <= v(b),
            Test::Equal(a, b) => v(a) == v(b),
            Test::Outside(x, low, high) => {
                // as floats decide it, a number on the upper limit is outside if the lower one is above 0
                let is_below = v(x) < v(high) || v(x) == v(high) && v(low) <= 0.0;
                !(v(low) <= v(x) && is_below)
            }
            Test::Case(_) => unreachable!("a case is no property of the numbers"),
        }
    }

    /// An empty graph but for the constants of [`Real`](shading::Real); with a sampler, for a run with numbers.
    pub(super) fn new(format: Format, sampler: Option<Sampler>) -> Self {
        let mut graph = Self {
            format,
            ..Self::default()
        };
        for constant in [0.0_f64, 1.0, -1.0] {
            graph.insert(Node::Constant(constant.to_bits()));
        }
        graph.insert(Node::Max);
        graph.insert(Node::Extreme);
        graph.sampler = sampler;
        graph
    }

    /// Whether the nodes have values.
    pub(super) fn is_numeric(&self) -> bool {
        self.sampler.is_some()
    }
}

fn raised(cosine: f64, m: f64) -> f64 {
    if cosine > 0.0 {
        let m = if m > 0.0 { m } else { 0.0 };
        cosine.min(1.0).powf(m)
    } else {
        0.0
    }
}
