//! Values as a language has them, of numbers, vectors and structs, found in the graph of numbers.

use std::collections::HashMap;

use crate::graph::{Graph, MAX, Node, Op, Test, ZERO};
use crate::kind::Kind;
use crate::table::functions;

#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Value {
    Variable(String),
    Constant(u32),
    Binary(Op, usize, usize),
    Neg(usize),
    Call(&'static str, Vec<usize>),
    Field(usize, &'static str),
    /// Where all tests hold, the first, and elsewhere the second.
    Select(Vec<Comparison>, usize, usize),
    Vector(Vec<usize>),
}

/// left > right, or left ≥ right.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Comparison {
    pub left: usize,
    pub right: usize,
    pub or_equal: bool,
}

/// The type of a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Type {
    Number,
    Vector,
    Struct(Kind),
}

impl Type {
    fn of(kind: Kind) -> Self {
        match kind.width() {
            _ if kind.fields().is_some() => Self::Struct(kind),
            1 => Self::Number,
            _ => Self::Vector,
        }
    }
}

pub struct Values<'a> {
    graph: &'a Graph,
    pub all: Vec<Value>,
    pub types: Vec<Type>,
    index: HashMap<Value, usize>,
}

impl<'a> Values<'a> {
    pub fn new(graph: &'a Graph) -> Self {
        Self {
            graph,
            all: vec![],
            types: vec![],
            index: HashMap::new(),
        }
    }

    fn node(&self, n: u32) -> &'a Node {
        &self.graph.nodes[n as usize]
    }

    fn add(&mut self, value: Value, of: Type) -> usize {
        if let Some(&known) = self.index.get(&value) {
            return known;
        }
        self.all.push(value.clone());
        self.types.push(of);
        self.index.insert(value, self.all.len() - 1);
        self.all.len() - 1
    }

    /// One number, a vector of three, or a struct.
    pub fn value(&mut self, numbers: &[u32]) -> usize {
        match *numbers {
            [x] => self.number(x),
            [x, y, z] => self.vector([x, y, z]),
            [first, ..] => match self.node(first) {
                Node::Part(call, 0) => self.call(*call),
                Node::Var(name, _) => {
                    let name = name.split('.').next().expect("a struct's name").into();
                    let is_kind = |kind: &Kind| kind.width() == numbers.len();
                    let kind = Kind::STRUCTS
                        .iter()
                        .copied()
                        .find(is_kind)
                        .expect("a struct");
                    self.add(Value::Variable(name), Type::Struct(kind))
                }
                other => panic!("a struct is the result of a call: {other:?}"),
            },
            [] => panic!("a value has numbers"),
        }
    }

    pub fn number(&mut self, n: u32) -> usize {
        let value = match self.node(n) {
            Node::Var(name, None) => Value::Variable(name.clone()),
            Node::Var(name, Some(i)) => {
                Value::Variable(format!("{name}.{}", ["x", "y", "z"][*i as usize]))
            }
            Node::Const(bits) => Value::Constant(*bits),
            Node::Binary(Op::Min, x, limit)
                if let Node::Binary(Op::Max, x, floor) = self.node(*x) =>
            {
                Value::Call("clamp", [x, floor, limit].map(|n| self.number(*n)).to_vec())
            }
            Node::Binary(Op::Max, x, y) if *self.node(*y) == Node::Neg(*x) => {
                Value::Call("abs", vec![self.number(*x)])
            }
            Node::Binary(op, a, b) => Value::Binary(*op, self.number(*a), self.number(*b)),
            Node::Neg(a) => Value::Neg(self.number(*a)),
            Node::Dot(a, b) => Value::Call("dot", vec![self.vector(*a), self.vector(*b)]),
            Node::Select(test, yes, no) => {
                let (yes, no) = (self.number(*yes), self.number(*no));
                self.select(*test, yes, no)
            }
            Node::Part(call, i) => return self.part(*call, *i, 1),
            Node::Call(..) => return self.call(n),
        };
        self.add(value, Type::Number)
    }

    /// Three numbers as a vector, whose operations are the same in each.
    fn vector(&mut self, numbers: [u32; 3]) -> usize {
        let value = match numbers.map(|n| self.node(n)) {
            [
                Node::Var(a, Some(0)),
                Node::Var(b, Some(1)),
                Node::Var(c, Some(2)),
            ] if a == b && b == c => Value::Variable(a.clone()),
            [Node::Part(a, i), Node::Part(b, j), Node::Part(c, k)]
                if a == b && b == c && (j - i, k - i) == (1, 2) =>
            {
                return self.part(*a, *i, 3);
            }
            [Node::Neg(a), Node::Neg(b), Node::Neg(c)] => Value::Neg(self.vector([*a, *b, *c])),
            [
                Node::Select(s, a, x),
                Node::Select(t, b, y),
                Node::Select(u, c, z),
            ] if s == t && t == u => {
                let (yes, no) = (self.vector([*a, *b, *c]), self.vector([*x, *y, *z]));
                self.select(*s, yes, no)
            }
            [
                Node::Binary(op, a, x),
                Node::Binary(second, b, y),
                Node::Binary(third, c, z),
            ] if op == second && second == third => {
                self.vector_binary(*op, [*a, *b, *c], [*x, *y, *z])
            }
            _ => Value::Vector(numbers.map(|n| self.number(n)).to_vec()),
        };
        self.add(value, Type::Vector)
    }

    fn vector_binary(&mut self, op: Op, left: [u32; 3], right: [u32; 3]) -> Value {
        if let Some((v, w)) = self.crossed(op, left, right) {
            return Value::Call("cross", vec![self.vector(v), self.vector(w)]);
        }
        let uniform = |n: [u32; 3]| n[0] == n[1] && n[1] == n[2];
        let is_scaled = matches!(op, Op::Mul | Op::Div) || (op == Op::Min && right[0] == MAX);
        if uniform(right) && is_scaled {
            return Value::Binary(op, self.vector(left), self.number(right[0]));
        }
        if uniform(left) && op == Op::Mul {
            return Value::Binary(op, self.vector(right), self.number(left[0]));
        }
        Value::Binary(op, self.vector(left), self.vector(right))
    }

    /// v and w, if the differences are those of v × w.
    fn crossed(&self, op: Op, left: [u32; 3], right: [u32; 3]) -> Option<([u32; 3], [u32; 3])> {
        let product = |n| match self.node(n) {
            Node::Binary(Op::Mul, a, b) => Some((*a, *b)),
            _ => None,
        };
        let [(a_y, b_z), (a_z, b_x), (a_x, b_y)] =
            [product(left[0])?, product(left[1])?, product(left[2])?];
        let minus = [(a_z, b_y), (a_x, b_z), (a_y, b_x)];
        let is_cross =
            op == Op::Sub && right.iter().zip(minus).all(|(n, m)| product(*n) == Some(m));
        is_cross.then_some(([a_x, a_y, a_z], [b_x, b_y, b_z]))
    }

    fn comparison(&mut self, left: u32, right: u32, or_equal: bool) -> Comparison {
        Comparison {
            left: self.number(left),
            right: self.number(right),
            or_equal,
        }
    }

    fn select(&mut self, test: Test, yes: usize, no: usize) -> Value {
        let test = match test {
            Test::Above(a, b) => self.comparison(a, b, false),
            Test::AtLeast(a, b) => self.comparison(a, b, true),
            Test::Extreme(_) => panic!("what is out of range is decided"),
        };
        if let Some(of) = self.normalized(test, yes, no) {
            return Value::Call("unit", vec![of]);
        }
        let mut tests = vec![test];
        let mut then = yes;
        if let Value::Select(inner, yes, same) = &self.all[yes]
            && *same == no
        {
            tests.extend(inner);
            then = *yes;
        }
        Value::Select(tests, then, no)
    }

    /// v, if the choice is v/|v| where it has a direction, and 0 elsewhere.
    fn normalized(&self, test: Comparison, yes: usize, no: usize) -> Option<usize> {
        let zero = Value::Constant(0);
        let Value::Vector(numbers) = &self.all[no] else {
            return None;
        };
        let is_zero = |n: &usize| self.all[*n] == zero;
        let (Value::Binary(Op::Div, _, by), true) = (&self.all[yes], numbers.iter().all(is_zero))
        else {
            return None;
        };
        let Value::Field(call, "w_length") = self.all[*by] else {
            return None;
        };
        let Value::Call("measured", of) = &self.all[call] else {
            return None;
        };
        let is_length = test.left == *by && is_zero(&test.right);
        // where the length has another use, it is measured once
        let measures = ["unit", "normal_corner"].contains(&self.graph.defining);
        (is_length && !measures).then(|| of[0])
    }

    fn call(&mut self, n: u32) -> usize {
        let Node::Call(name, arguments) = self.node(n) else {
            panic!("only a call has parts");
        };
        let function = functions().iter().find(|function| function.name == *name);
        let mut rest = &arguments[..];
        let mut values = vec![];
        while !rest.is_empty() {
            let width = function.map_or(1, |function| function.parameters[values.len()].1.width());
            let (first, others) = rest.split_at(width);
            values.push(self.value(first));
            rest = others;
        }
        let of = function.map_or(Type::Number, |function| Type::of(function.result));
        self.add(Value::Call(name, values), of)
    }

    /// Some numbers of the result of a call.
    fn part(&mut self, call: u32, first: u8, width: usize) -> usize {
        let call = self.call(call);
        match self.types[call] {
            Type::Number => call,
            Type::Vector if width == 3 => call,
            Type::Vector => self.add(
                Value::Field(call, ["x", "y", "z"][first as usize]),
                Type::Number,
            ),
            Type::Struct(kind) => {
                let (_, _, fields) = kind.fields().expect("a struct has fields");
                let mut at = 0;
                for (name, field) in fields {
                    if at == first as usize && field.width() == width {
                        return self.add(Value::Field(call, name), Type::of(*field));
                    }
                    if (at..at + field.width()).contains(&(first as usize)) {
                        let whole = self.add(Value::Field(call, name), Type::of(*field));
                        let component = ["x", "y", "z"][first as usize - at];
                        return self.add(Value::Field(whole, component), Type::Number);
                    }
                    at += field.width();
                }
                panic!("a call has this part")
            }
        }
    }

    pub fn children(&self, value: usize) -> Vec<usize> {
        match &self.all[value] {
            Value::Variable(_) | Value::Constant(_) => vec![],
            Value::Binary(_, a, b) => vec![*a, *b],
            Value::Neg(a) | Value::Field(a, _) => vec![*a],
            Value::Call(_, all) | Value::Vector(all) => all.clone(),
            Value::Select(tests, yes, no) => {
                let compared = tests.iter().flat_map(|test| [test.left, test.right]);
                compared.chain([*yes, *no]).collect()
            }
        }
    }

    /// What has no need of a name.
    pub fn is_trivial(&self, value: usize) -> bool {
        match &self.all[value] {
            Value::Variable(_) | Value::Constant(_) => true,
            Value::Vector(numbers) => numbers
                .iter()
                .all(|n| matches!(self.all[*n], Value::Constant(_))),
            Value::Neg(a) => matches!(self.all[*a], Value::Variable(_)),
            Value::Field(of, _) => matches!(self.all[*of], Value::Call(..) | Value::Field(..)),
            _ => false,
        }
    }
}

const _: () = assert!(ZERO == 0);
