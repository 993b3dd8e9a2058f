//! Vectors and structs, found in recorded numbers.

use crate::graph::{Graph, MAX, MAXIMUM, MINIMUM, Node, Op, VECTOR, ZERO};
use crate::kind::Kind;

impl Graph {
    /// The numbers that a value consists of.
    pub fn numbers(&mut self, value: usize) -> Vec<usize> {
        let parts = self.nodes[value].kind.parts();
        if parts.is_empty() {
            return vec![value];
        }
        let mut part = |(name, kind): &(&'static str, Kind)| {
            let part = self.add(Op::Field(name), *kind, &[value]);
            self.numbers(part)
        };
        parts.iter().flat_map(&mut part).collect()
    }

    /// One value of each field or parameter, of their numbers.
    pub fn values(&mut self, of: &[(&str, Kind)], numbers: &[usize]) -> Vec<usize> {
        let mut rest = numbers;
        let value = |(_, kind): &(_, Kind)| {
            let (first, others) = rest.split_at(kind.width());
            rest = others;
            self.value(first)
        };
        of.iter().map(value).collect()
    }

    /// One number, a vector of three, or what has the numbers for its fields.
    pub fn value(&mut self, numbers: &[usize]) -> usize {
        if let Ok(vector) = numbers.try_into() {
            return self.vector(vector);
        }
        let mut whole = numbers[0];
        while self.nodes[whole].kind.width() < numbers.len() {
            whole = self.nodes[whole].of[0];
        }
        whole
    }

    /// Three numbers as a vector, whose operations are the same in each.
    fn vector(&mut self, numbers: [usize; 3]) -> usize {
        let [x, y, z] = numbers.map(|n| &self.nodes[n]);
        if [x.op, y.op, z.op] == ["x", "y", "z"].map(Op::Field) && x.of == y.of && y.of == z.of {
            return x.of[0];
        }
        let (op, lanes) = self.by_lane(numbers);
        let is_uniform = |lanes: [usize; 3]| lanes == [lanes[0]; 3];
        let (op, vectors, number) = match (op, &lanes[..]) {
            (Op::Neg, _) => (op, lanes, None),
            (Op::Mul, &[v, s] | &[s, v]) if is_uniform(s) => (Op::Scale, vec![v], Some(s[0])),
            (Op::Div, &[v, s]) if is_uniform(s) => (op, vec![v], Some(s[0])),
            (Op::Select, &[test, v, w]) if is_uniform(test) => {
                let [v, w] = [v, w].map(|lanes| self.vector(lanes));
                return self.choice(test[0], v, w);
            }
            (Op::Div | MINIMUM | MAXIMUM, _) if self.divides_vectors => (op, lanes, None),
            (MINIMUM, &[v, [MAX, MAX, MAX]]) => (op, vec![v], Some(MAX)),
            (Op::Add | Op::Sub | Op::Mul, &[v, w]) => match self.crossed(op, v, w) {
                Some(of) => (Op::Own("cross"), of.to_vec(), None),
                None => (op, lanes, None),
            },
            _ => return self.add(VECTOR, Kind::Vector, &numbers),
        };
        let vectors = vectors.into_iter().map(|lanes| self.vector(lanes));
        let of: Vec<_> = vectors.chain(number).collect();
        self.add(op, Kind::Vector, &of)
    }

    /// The operation that gives each of three numbers, and what it takes for the three.
    fn by_lane(&self, numbers: [usize; 3]) -> (Op, Vec<[usize; 3]>) {
        let [x, y, z] = numbers.map(|n| &self.nodes[n]);
        if [y.op, z.op] != [x.op; 2] {
            return (VECTOR, vec![]);
        }
        let lanes = (0..x.of.len()).map(|i| [x.of[i], y.of[i], z.of[i]]);
        (x.op, lanes.collect())
    }

    /// v and w, if the differences of two times three products are v × w.
    fn crossed(&self, op: Op, left: [usize; 3], right: [usize; 3]) -> Option<[[usize; 3]; 2]> {
        let sides = [left, right].map(|side| self.by_lane(side));
        let (Op::Sub, [(Op::Mul, plus), (Op::Mul, minus)]) = (op, sides) else {
            return None;
        };
        let ([v_y, v_z, v_x], [w_z, w_x, w_y]) = (plus[0], plus[1]);
        let is_cross = minus == [[v_z, v_x, v_y], [w_y, w_z, w_x]];
        is_cross.then_some([[v_x, v_y, v_z], [w_x, w_y, w_z]])
    }

    /// A choice between two values; v/|v| or 0 is a call.
    pub fn choice(&mut self, test: usize, then: usize, otherwise: usize) -> usize {
        // where the length has another use, it is measured once
        let measures = ["unit", "normal_corner"].contains(&self.defining);
        match self.normalized(test, then, otherwise) {
            Some(v) if !measures => return self.add(Op::Call("unit"), Kind::Unit, &[v]),
            _ => {}
        }
        let Node { op, kind, of } = self.nodes[then].clone();
        if op == Op::Select && of[2] == otherwise {
            let both = self.joined(Op::All, test, of[0]);
            return self.add(op, kind, &[both, of[1], otherwise]);
        }
        self.add(Op::Select, kind, &[test, then, otherwise])
    }

    /// v, if the choice is v/|v| where that length is above 0, and 0 elsewhere.
    pub fn normalized(&self, test: usize, then: usize, otherwise: usize) -> Option<usize> {
        let [test, then, zero] = [test, then, otherwise].map(|n| &self.nodes[n]);
        let (&[length, ZERO], Op::Div, &[_, by]) = (&test.of[..], then.op, &then.of[..]) else {
            return None;
        };
        let Node { op, of, .. } = &self.nodes[length];
        let is_of_length = test.op == Op::Above && *op == Op::Field("w_length");
        (is_of_length && by == length && zero.of == [ZERO; 3]).then(|| self.nodes[of[0]].of[0])
    }

    /// A test and others: all of them, or any.
    pub fn joined(&mut self, op: Op, test: usize, others: usize) -> usize {
        let node = self.nodes[others].clone();
        let others = if node.op == op { node.of } else { vec![others] };
        self.add(op, Kind::Flag, &[&[test], &others[..]].concat())
    }
}
