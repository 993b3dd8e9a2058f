//! Values as a language has them, of numbers, vectors and structs, found in the graph of numbers.

use std::collections::HashMap;

use crate::graph::{Graph, MAX, Node, Op, Test};
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
    Above(usize, usize),
    AtLeast(usize, usize),
    /// Where all tests hold, the first, and elsewhere the second.
    Select(Vec<usize>, usize, usize),
    Vector([usize; 3]),
}

const COMPONENTS: [&str; 3] = ["x", "y", "z"];

pub struct Values<'a> {
    graph: &'a Graph,
    pub all: Vec<Value>,
    pub kinds: Vec<Kind>,
    index: HashMap<Value, usize>,
}

impl<'a> Values<'a> {
    pub fn new(graph: &'a Graph) -> Self {
        let (all, kinds, index) = Default::default();
        Self {
            graph,
            all,
            kinds,
            index,
        }
    }

    fn node(&self, n: usize) -> &'a Node {
        &self.graph.nodes[n]
    }

    fn add(&mut self, value: Value, kind: Kind) -> usize {
        if let Some(&known) = self.index.get(&value) {
            return known;
        }
        self.all.push(value.clone());
        self.kinds.push(kind);
        self.index.insert(value, self.all.len() - 1);
        self.all.len() - 1
    }

    /// One number, a vector of three, or a struct.
    pub fn value(&mut self, numbers: &[usize]) -> usize {
        match *numbers {
            [x] => self.number(x),
            [x, y, z] => self.vector([x, y, z]),
            [first, ..] => match self.node(first) {
                Node::Part(call, 0) => self.call(*call),
                Node::Var(name, _) => {
                    let name = name.split('.').next().expect("a struct's name").into();
                    let mut structs = Kind::STRUCTS.iter();
                    let kind = structs.find(|kind| kind.width() == numbers.len());
                    self.add(Value::Variable(name), *kind.expect("a struct"))
                }
                other => panic!("a struct is an argument or the result of a call: {other:?}"),
            },
            [] => panic!("a value has numbers"),
        }
    }

    fn number(&mut self, n: usize) -> usize {
        let value = match self.node(n) {
            Node::Var(name, None) => Value::Variable(name.clone()),
            Node::Var(name, Some(i)) => Value::Variable(format!("{name}.{}", COMPONENTS[*i])),
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
        self.add(value, Kind::Number)
    }

    /// Three numbers as a vector, whose operations are the same in each.
    fn vector(&mut self, numbers: [usize; 3]) -> usize {
        let value = match numbers.map(|n| self.node(n)) {
            [
                Node::Var(a, Some(0)),
                Node::Var(b, Some(1)),
                Node::Var(c, Some(2)),
            ] if a == b && b == c => Value::Variable(a.clone()),
            [Node::Part(a, i), Node::Part(b, j), Node::Part(c, k)]
                if a == b && b == c && (*j, *k) == (i + 1, i + 2) =>
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
            _ => Value::Vector(numbers.map(|n| self.number(n))),
        };
        self.add(value, Kind::Vector)
    }

    fn vector_binary(&mut self, op: Op, left: [usize; 3], right: [usize; 3]) -> Value {
        if let Some((v, w)) = self.crossed(op, left, right) {
            return Value::Call("cross", vec![self.vector(v), self.vector(w)]);
        }
        let is_uniform = |n: [usize; 3]| n == [n[0]; 3];
        let is_scaled = matches!(op, Op::Mul | Op::Div) || (op == Op::Min && right[0] == MAX);
        if is_uniform(right) && is_scaled {
            return Value::Binary(op, self.vector(left), self.number(right[0]));
        }
        if is_uniform(left) && op == Op::Mul {
            return Value::Binary(op, self.vector(right), self.number(left[0]));
        }
        Value::Binary(op, self.vector(left), self.vector(right))
    }

    /// v and w, if the differences are those of v × w.
    fn crossed(
        &self,
        op: Op,
        left: [usize; 3],
        right: [usize; 3],
    ) -> Option<([usize; 3], [usize; 3])> {
        let product = |n: &usize| match self.node(*n) {
            Node::Binary(Op::Mul, a, b) => Some((*a, *b)),
            _ => None,
        };
        let [plus, minus] = [left, right].map(|side| side.iter().filter_map(product).collect());
        let (plus, minus): (Vec<_>, Vec<_>) = (plus, minus);
        let &[(a_y, b_z), (a_z, b_x), (a_x, b_y)] = &plus[..] else {
            return None;
        };
        let is_cross = op == Op::Sub && minus == [(a_z, b_y), (a_x, b_z), (a_y, b_x)];
        is_cross.then_some(([a_x, a_y, a_z], [b_x, b_y, b_z]))
    }

    pub fn test(&mut self, test: Test) -> usize {
        let value = match test {
            Test::Above(a, b) => Value::Above(self.number(a), self.number(b)),
            Test::AtLeast(a, b) => Value::AtLeast(self.number(a), self.number(b)),
            Test::Extreme(square) => Value::Call("is_extreme", vec![self.number(square)]),
        };
        self.add(value, Kind::Number)
    }

    fn select(&mut self, test: Test, yes: usize, no: usize) -> Value {
        let test = self.test(test);
        if let Some(of) = self.normalized(test, yes, no) {
            return Value::Call("unit", vec![of]);
        }
        match &self.all[yes] {
            Value::Select(inner, then, same) if *same == no => {
                Value::Select([&[test], &inner[..]].concat(), *then, no)
            }
            _ => Value::Select(vec![test], yes, no),
        }
    }

    /// v, if the choice is v/|v| where it has a direction, and 0 elsewhere.
    fn normalized(&self, test: usize, yes: usize, no: usize) -> Option<usize> {
        let Value::Binary(Op::Div, _, length) = self.all[yes] else {
            return None;
        };
        let Value::Field(measured, "w_length") = self.all[length] else {
            return None;
        };
        let Value::Call("measured", of) = &self.all[measured] else {
            return None;
        };
        let zero = *self.index.get(&Value::Constant(0))?;
        let has_direction = self.all[test] == Value::Above(length, zero);
        // where the length has another use, it is measured once
        let measures = ["unit", "normal_corner"].contains(&self.graph.defining);
        let is_unit = has_direction && self.all[no] == Value::Vector([zero; 3]) && !measures;
        is_unit.then(|| of[0])
    }

    fn call(&mut self, n: usize) -> usize {
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
        let kind = function.map_or(Kind::Number, |function| function.result);
        self.add(Value::Call(name, values), kind)
    }

    /// Some numbers of the result of a call.
    fn part(&mut self, call: usize, first: usize, width: usize) -> usize {
        let whole = self.call(call);
        let kind = self.kinds[whole];
        if kind.width() == width {
            return whole;
        }
        let Some((_, _, fields)) = kind.fields() else {
            return self.component(whole, first);
        };
        let mut at = first;
        for (name, kind) in fields {
            if at < kind.width() {
                let field = self.add(Value::Field(whole, name), *kind);
                let is_component = kind.width() != width;
                return if is_component {
                    self.component(field, at)
                } else {
                    field
                };
            }
            at -= kind.width();
        }
        panic!("a call has this part")
    }

    fn component(&mut self, vector: usize, which: usize) -> usize {
        self.add(Value::Field(vector, COMPONENTS[which]), Kind::Number)
    }

    pub fn children(&self, value: usize) -> Vec<usize> {
        match &self.all[value] {
            Value::Variable(_) | Value::Constant(_) => vec![],
            Value::Binary(_, a, b) | Value::Above(a, b) | Value::AtLeast(a, b) => vec![*a, *b],
            Value::Neg(a) | Value::Field(a, _) => vec![*a],
            Value::Call(_, all) => all.clone(),
            Value::Vector(all) => all.to_vec(),
            Value::Select(tests, yes, no) => [&tests[..], &[*yes, *no]].concat(),
        }
    }

    /// What has no variable, however often it is used: it has what it consists of.
    pub fn is_part(&self, value: usize) -> bool {
        matches!(
            self.all[value],
            Value::Field(..) | Value::Above(..) | Value::AtLeast(..)
        )
    }

    /// What has no need of a name.
    pub fn is_trivial(&self, value: usize) -> bool {
        let is_constant = |value: &usize| matches!(self.all[*value], Value::Constant(_));
        match &self.all[value] {
            Value::Variable(_) => true,
            Value::Vector(numbers) => numbers.iter().all(is_constant),
            Value::Neg(a) => matches!(self.all[*a], Value::Variable(_)),
            _ => is_constant(&value) || self.is_part(value),
        }
    }
}
