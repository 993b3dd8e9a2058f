//! A number that records a formula instead of computing it.
//!
//! Every operation adds a node to a graph. A decision, such as `any_positive` or a comparison, is a
//! fork: the formula runs once for each combination of answers that its ranges allow.

use std::cell::RefCell;
use std::cmp::Ordering;
use std::collections::HashMap;
use std::ops::{Add, Div, Mul, Neg, Sub};

use shading::{Elementary, Exponent, Real};

use super::known::Known;
use super::range::Range;

/// The floats that a proof is about.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Format {
    /// Single precision.
    #[default]
    F32,
    /// Double precision.
    F64,
}

impl Format {
    /// The nearest number. For + − × ÷ √ of two `f32`, rounding the result of `f64` once more is
    /// correct, because 53 ≥ 2·24 + 2.
    #[allow(clippy::cast_possible_truncation)] // it is what rounds
    #[must_use]
    pub fn round(self, x: f64) -> f64 {
        match self {
            Self::F32 => f64::from(x as f32),
            Self::F64 => x,
        }
    }

    /// The largest finite number.
    #[must_use]
    pub fn max(self) -> f64 {
        match self {
            Self::F32 => f32::MAX.into(),
            Self::F64 => f64::MAX,
        }
    }

    /// `Real::EXTREME`.
    #[must_use]
    pub fn extreme(self) -> f64 {
        match self {
            Self::F32 => f32::EXTREME.into(),
            Self::F64 => f64::EXTREME,
        }
    }

    /// The smallest number above 0.
    #[must_use]
    pub fn tiny(self) -> f64 {
        match self {
            Self::F32 => f32::from_bits(1).into(),
            Self::F64 => f64::from_bits(1),
        }
    }

    /// The unit roundoff.
    #[must_use]
    pub fn u(self) -> f64 {
        match self {
            Self::F32 => f64::from(f32::EPSILON) / 2.0,
            Self::F64 => f64::EPSILON / 2.0,
        }
    }

    /// The next number.
    #[allow(clippy::cast_possible_truncation)] // it is one of these numbers
    #[must_use]
    pub fn next_up(self, x: f64) -> f64 {
        if x.is_nan() || x == f64::INFINITY {
            return x;
        }
        if x == 0.0 {
            return self.tiny();
        }
        match self {
            Self::F32 => {
                let bits = (x as f32).to_bits();
                f32::from_bits(if x > 0.0 { bits + 1 } else { bits - 1 }).into()
            }
            Self::F64 => {
                let bits = x.to_bits();
                f64::from_bits(if x > 0.0 { bits + 1 } else { bits - 1 })
            }
        }
    }

    /// The number before it.
    #[must_use]
    pub fn next_down(self, x: f64) -> f64 {
        -self.next_up(-x)
    }
}

/// A number that records the formula which it is put into. It implements [`Real`], and so every
/// formula that is generic over it can be proved.
#[derive(Clone, Copy, Debug)]
pub struct Term(#[doc(hidden)] pub u32);

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
    /// is not above 0; otherwise 1 for an m that is not above 0, and at least c − 2⁻²⁰ for m ≤ 1.
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
type Sampler = Box<dyn FnMut(Range, &[f64]) -> f64>;

#[doc(hidden)]
#[derive(Default)]
pub struct Graph {
    pub format: Format,
    pub nodes: Vec<Node>,
    index: HashMap<Node, u32>,
    /// The nodes that have the opposite value, apart from the sign of a zero.
    mirrors: HashMap<u32, Vec<u32>>,
    pub names: Vec<(String, Range)>,
    /// What is assumed and what was answered, in this run.
    pub path: Vec<(Test, bool)>,
    pub known: Known,
    /// The nodes' values, in a run with numbers.
    pub values: Vec<f64>,
    sampler: Option<Sampler>,
    /// Whether an assumption does not hold, in a run with numbers.
    pub is_void: bool,
    script: Vec<(bool, bool)>, // the answer, and whether the other one remains to be tried
    next: usize,
    cases: u32,
}

thread_local!(static GRAPH: RefCell<Graph> = RefCell::default());

#[doc(hidden)]
pub fn with<R>(f: impl FnOnce(&mut Graph) -> R) -> R {
    GRAPH.with_borrow_mut(f)
}

impl Graph {
    fn node(&mut self, node: Node) -> Term {
        match self.simplified(node) {
            Simple::Node(id) => Term(id),
            Simple::New(node) => self.insert(node),
            Simple::Negated(node) => {
                let Term(id) = self.insert(node);
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

    fn insert(&mut self, node: Node) -> Term {
        if let Some(&id) = self.index.get(&node) {
            return Term(id);
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
                let Term(mirror) = self.insert(Node::Add(p.min(b), p.max(b)));
                self.mirror(id, mirror);
            }
            if let Some(&mirror) = self.index.get(&Node::Sub(b, a)) {
                self.mirror(id, mirror);
            }
        }
        Term(id)
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
            Test::Outside(x, low, high) => !(v(low) <= v(x) && v(x) <= v(high)),
            Test::Case(_) => unreachable!("a case is no property of the numbers"),
        }
    }

    /// Begins a run: with numbers, if there is a sampler.
    pub(super) fn restart(&mut self, format: Format, sampler: Option<Sampler>) {
        *self = Self {
            format,
            script: std::mem::take(&mut self.script),
            ..Self::default()
        };
        for constant in [0.0_f64, 1.0, -1.0] {
            self.insert(Node::Constant(constant.to_bits()));
        }
        self.insert(Node::Max);
        self.insert(Node::Extreme);
        self.sampler = sampler;
    }

    fn learn(&mut self, test: Test, answer: bool) {
        self.path.push((test, answer));
        let mut known = std::mem::take(&mut self.known);
        known.refine(self, test, answer);
        self.known = known;
    }

    fn is_numeric(&self) -> bool {
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

const ZERO: u32 = 0;
const ONE: u32 = 1;

/// A variable with a range.
pub(super) fn var(name: &str, range: Range) -> Term {
    with(|g| {
        g.names.push((name.into(), range));
        let index = u32::try_from(g.names.len() - 1).expect("fewer than 2³² variables");
        g.node(Node::Var(index))
    })
}

pub(super) fn assume(test: Test) {
    with(|g| {
        if g.is_numeric() {
            g.is_void |= !g.holds(test);
            g.path.push((test, true));
        } else {
            g.learn(test, true);
        }
    });
}

/// Makes a vector one of length 1, in a run with numbers.
pub(super) fn normalize(v: [Term; 3]) {
    with(|g| {
        let [x, y, z] = v.map(|c| g.values[c.0 as usize]);
        let length = (x * x + y * y + z * z).sqrt();
        if g.is_numeric() {
            let divisible = length > 0.1 && length.is_finite();
            let unit = if divisible {
                [x, y, z].map(|c| c / length)
            } else {
                [0.0, 0.0, 1.0]
            };
            for (c, x) in v.into_iter().zip(unit) {
                g.values[c.0 as usize] = g.format.round(x);
            }
        }
    });
}

/// Either answer, whichever the numbers are.
pub(super) fn case() -> bool {
    let case = with(|g| {
        g.cases += 1;
        g.cases
    });
    decide(Test::Case(case))
}

/// The answer to a test: a known one, or a fork.
pub(super) fn decide(test: Test) -> bool {
    with(|g| {
        if g.is_numeric() {
            let answer = match (test, &mut g.sampler) {
                (Test::Case(_), Some(sampler)) => sampler(Range::unsigned(0.0, 1.0), &[0.0]) > 0.5,
                _ => g.holds(test),
            };
            g.path.push((test, answer));
            return answer;
        }
        if let Some(&(_, answer)) = g.path.iter().find(|(known, _)| *known == test) {
            return answer;
        }
        let mut known = std::mem::take(&mut g.known);
        let answer = known.answer(g, test);
        g.known = known;
        if let Some(answer) = answer {
            return answer;
        }
        if g.next == g.script.len() {
            g.script.push((true, true));
        }
        let answer = g.script[g.next].0;
        g.next += 1;
        g.learn(test, answer);
        answer
    })
}

/// Runs a formula along every path; `each` sees the graph with its result.
#[doc(hidden)]
pub fn explore<R>(
    format: Format,
    formula: &impl Fn() -> R,
    mut each: impl FnMut(&mut Graph, R),
) -> usize {
    with(|g| g.script.clear());
    let mut paths = 0;
    loop {
        with(|g| g.restart(format, None));
        let result = formula();
        paths += 1;
        with(|g| {
            if !g.known.impossible {
                each(g, result);
            }
        });
        let other = with(|g| {
            loop {
                match g.script.pop() {
                    Some((answer, true)) => break Some(!answer),
                    Some(_) => {}
                    None => break None,
                }
            }
        });
        match other {
            Some(answer) => with(|g| g.script.push((answer, false))),
            None => return paths,
        }
    }
}

macro_rules! operator {
    ($trait:ident::$method:ident) => {
        impl $trait for Term {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                with(|g| g.node(Node::$trait(self.0, other.0)))
            }
        }
    };
}
operator!(Add::add);
operator!(Sub::sub);
operator!(Mul::mul);
operator!(Div::div);

impl Neg for Term {
    type Output = Self;
    fn neg(self) -> Self {
        with(|g| g.node(Node::Neg(self.0)))
    }
}

impl PartialEq for Term {
    fn eq(&self, other: &Self) -> bool {
        decide(Test::Equal(self.0, other.0))
    }
}

impl PartialOrd for Term {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        if self > other {
            Some(Ordering::Greater)
        } else if self < other {
            Some(Ordering::Less)
        } else {
            (self == other).then_some(Ordering::Equal)
        }
    }
    fn gt(&self, other: &Self) -> bool {
        decide(Test::Above(self.0, other.0))
    }
    fn lt(&self, other: &Self) -> bool {
        decide(Test::Above(other.0, self.0))
    }
    fn le(&self, other: &Self) -> bool {
        decide(Test::AtMost(self.0, other.0))
    }
    fn ge(&self, other: &Self) -> bool {
        decide(Test::AtMost(other.0, self.0))
    }
}

impl Real for Term {
    const ZERO: Self = Self(ZERO);
    const ONE: Self = Self(ONE);
    const NEG_ONE: Self = Self(2);
    const MAX: Self = Self(3);
    const EXTREME: Self = Self(4);

    fn of(literal: f64) -> Self {
        with(|g| g.node(Node::Constant(g.format.round(literal).to_bits())))
    }
    fn sqrt(self) -> Self {
        with(|g| g.node(Node::Sqrt(self.0)))
    }
    fn if_positive(self, then: Self, otherwise: Self) -> Self {
        self.if_above(Self::ZERO, then, otherwise)
    }
    fn any_positive(self) -> bool {
        decide(Test::Above(self.0, ZERO))
    }
    // Floats override these three, too, and give the same results.
    fn if_above(self, threshold: Self, then: Self, otherwise: Self) -> Self {
        if then.0 == otherwise.0 {
            return then;
        }
        with(|g| {
            let test = Test::Above(self.0, threshold.0);
            g.node(Node::Select(test, then.0, otherwise.0))
        })
    }
    fn abs(self) -> Self {
        with(|g| g.node(Node::Abs(self.0)))
    }
    fn any_outside(self, low: Self, high: Self) -> bool {
        decide(Test::Outside(self.0, low.0, high.0))
    }
}

impl Elementary for Term {
    fn sin(self) -> Self {
        with(|g| g.node(Node::Call(Function::Sin, self.0)))
    }
    fn cos(self) -> Self {
        with(|g| g.node(Node::Call(Function::Cos, self.0)))
    }
    fn exp(self) -> Self {
        with(|g| g.node(Node::Call(Function::Exp, self.0)))
    }
    fn ln(self) -> Self {
        with(|g| g.node(Node::Call(Function::Ln, self.0)))
    }
}

impl Exponent<Self> for Term {
    fn raise(self, cosine: Self) -> Self {
        with(|g| g.node(Node::Power(cosine.0, self.0)))
    }
}
