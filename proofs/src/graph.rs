//! A formula as a graph: what each node computes, and from which earlier ones.

use rustc_hash::FxHashMap;

use super::format::Format;
use super::range::Range;

#[doc(hidden)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Node {
    Var(u32),
    Constant(u64), // the bits of an f64 that is a number of the format
    Neg(u32),
    Sqrt(u32),
    Add(u32, u32),
    Sub(u32, u32),
    Mul(u32, u32),
    Div(u32, u32),
    Select(Test, u32, u32),
    /// A power of a cosine by any m, integer or real, of which only the contract is known: within [0, 1];
    /// 0 for a cosine that is not above 0; otherwise 1 for an m that is not above 0, and at least c − 2⁻²⁰
    /// for m ≤ 1.
    Power(u32, u32),
}

impl Node {
    /// The nodes that it is made of, and those that it tests.
    pub fn parts(self) -> impl Iterator<Item = u32> {
        let (test, parts) = match self {
            Self::Var(_) | Self::Constant(_) => (None, [None; 2]),
            Self::Neg(a) | Self::Sqrt(a) => (None, [Some(a), None]),
            Self::Add(a, b)
            | Self::Sub(a, b)
            | Self::Mul(a, b)
            | Self::Div(a, b)
            | Self::Power(a, b) => (None, [Some(a), Some(b)]),
            Self::Select(test, a, b) => (Some(test), [Some(a), Some(b)]),
        };
        let tested = test.into_iter().flat_map(Test::parts);
        tested.chain(parts.into_iter().flatten())
    }
}

impl Test {
    /// The nodes that it compares.
    pub fn parts(self) -> impl Iterator<Item = u32> {
        let parts = match self {
            Self::Above(a, b) | Self::AtMost(a, b) | Self::Equal(a, b) => Some([a, b]),
            Self::Case(_) => None,
        };
        parts.into_iter().flatten()
    }
}

#[doc(hidden)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Test {
    Above(u32, u32),
    AtMost(u32, u32),
    Equal(u32, u32),
    /// One of two cases into which the author of a claim divides it.
    Case(u32),
}

/// Where the variables get their values from, for a run with numbers.
pub(super) type Sampler = Box<dyn FnMut(Range, &[f64]) -> f64>;

#[doc(hidden)]
#[derive(Default)]
pub struct Graph {
    pub format: Format,
    pub nodes: Vec<Node>,
    index: FxHashMap<Node, u32>,
    /// The variables, each with the values that it may have.
    pub names: Vec<(String, Range)>,
    /// The nodes' values, in a run with numbers.
    pub values: Vec<f64>,
    sampler: Option<Sampler>,
}

/// The nodes of [`Real::ZERO`](shading::Real::ZERO), `ONE` and `NEG_ONE`.
pub(super) const ZERO: u32 = 0;
pub(super) const ONE: u32 = 1;
pub(super) const MINUS_ONE: u32 = 2;

impl Graph {
    /// Records a node in the one way in which it is written: what has the same bits by the rules of
    /// signs, and without a factor of 1 or −1.
    pub(super) fn node(&mut self, node: Node) -> u32 {
        let mut parts = node.parts();
        let mut next = || parts.next().map(|id| self.nodes[id as usize]);
        match (node, next(), next()) {
            (
                Node::Sub(a, ZERO) | Node::Mul(a, ONE) | Node::Mul(ONE, a) | Node::Div(a, ONE),
                ..,
            ) => a,
            (Node::Mul(a, MINUS_ONE) | Node::Mul(MINUS_ONE, a) | Node::Div(a, MINUS_ONE), ..) => {
                self.node(Node::Neg(a))
            }
            (Node::Neg(_), Some(Node::Neg(x)), _) => x,
            (Node::Add(a, _), _, Some(Node::Neg(y))) => self.insert(Node::Sub(a, y)),
            (Node::Add(_, b), Some(Node::Neg(x)), _) => self.insert(Node::Sub(b, x)),
            (Node::Mul(_, b), Some(Node::Neg(x)), _) => self.negated(Node::Mul(x, b)),
            (Node::Mul(a, _), _, Some(Node::Neg(y))) => self.negated(Node::Mul(a, y)),
            (Node::Add(a, b), ..) => self.insert(Node::Add(a.min(b), a.max(b))),
            (Node::Mul(a, b), ..) => self.insert(Node::Mul(a.min(b), a.max(b))),
            _ => self.insert(node),
        }
    }

    fn negated(&mut self, node: Node) -> u32 {
        let id = self.node(node);
        self.node(Node::Neg(id))
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
        id
    }

    /// A number of a range that is no variable, in a run with numbers.
    pub(super) fn draw(&mut self, range: Range) -> f64 {
        let sampler = self.sampler.as_mut();
        sampler.map_or(f64::NAN, |sampler| sampler(range, &[0.0]))
    }

    #[allow(clippy::match_same_arms)] // one has no value yet, and of the other nothing is known
    fn value(&mut self, node: Node) -> f64 {
        if let (Node::Var(index), Some(sampler)) = (node, &mut self.sampler) {
            return sampler(self.names[index as usize].1, &self.values);
        }
        let v = |id: u32| self.values[id as usize];
        let exact = match node {
            Node::Var(_) => f64::NAN,
            Node::Constant(bits) => f64::from_bits(bits),
            Node::Neg(a) => -v(a),
            Node::Sqrt(a) => v(a).sqrt(),
            Node::Add(a, b) => v(a) + v(b),
            Node::Sub(a, b) => v(a) - v(b),
            Node::Mul(a, b) => v(a) * v(b),
            Node::Div(a, b) => v(a) / v(b),
            Node::Select(test, a, b) => v(if self.holds(test) { a } else { b }),
            Node::Power(c, m) if v(c) > 0.0 && v(c) <= 1.0 => v(c).powf(v(m).max(0.0)),
            Node::Power(c, _) if v(c) == 0.0 => 0.9,
            Node::Power(..) => f64::NAN,
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
            Test::Case(_) => unreachable!("a case is no property of the numbers"),
        }
    }

    /// The variables' values, in a run with numbers.
    pub(super) fn input(&self) -> Vec<(String, f64)> {
        let nodes = self.nodes.iter().zip(&self.values);
        let variables = nodes.filter_map(|(node, x)| match node {
            Node::Var(index) => Some((self.names[*index as usize].0.clone(), *x)),
            _ => None,
        });
        variables.collect()
    }

    /// Empties the graph but for the constants of [`Real`](shading::Real); with a sampler, for a run with numbers.
    /// It keeps its memory, because a claim runs with millions of numbers.
    pub(super) fn restart(&mut self, format: Format, sampler: Option<Sampler>) {
        self.format = format;
        self.nodes.clear();
        self.index.clear();
        self.names.clear();
        self.values.clear();
        self.sampler = None;
        for constant in [0.0, 1.0, -1.0, format.max(), format.extreme()] {
            self.insert(Node::Constant(constant.to_bits()));
        }
        self.sampler = sampler;
    }

    /// Whether the nodes have values.
    pub(super) fn is_numeric(&self) -> bool {
        self.sampler.is_some()
    }
}
