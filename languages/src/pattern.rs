//! Formulas that a function of the files stands for: it is called where its formula is found.

use std::collections::HashMap;
use std::rc::Rc;

use crate::graph::{Graph, Node, Test};

/// A function whose formula is recorded.
pub struct Pattern {
    pub name: &'static str,
    pub graph: Graph,
    pub result: u32,
}

/// The nodes that stand in the places of a pattern's variables.
type Found = HashMap<(String, Option<u8>), u32>;

impl Pattern {
    /// What its variables stand for, if the node of another graph has its formula.
    pub fn found(&self, graph: &Graph, node: u32) -> Option<Found> {
        let mut found = Found::new();
        self.matches(self.result, graph, node, &mut found)
            .then_some(found)
    }

    fn matches(&self, mine: u32, graph: &Graph, other: u32, found: &mut Found) -> bool {
        let (left, right) = (
            &self.graph.nodes[mine as usize],
            &graph.nodes[other as usize],
        );
        let mut all = |mine: &[u32], others: &[u32]| {
            mine.len() == others.len()
                && mine
                    .iter()
                    .zip(others)
                    .all(|(a, b)| self.matches(*a, graph, *b, found))
        };
        match (left, right) {
            (Node::Var(name, part), _) => {
                *found.entry((name.clone(), *part)).or_insert(other) == other
            }
            (Node::Const(a), Node::Const(b)) => a == b,
            (Node::Binary(a, x, y), Node::Binary(b, z, w)) => a == b && all(&[*x, *y], &[*z, *w]),
            (Node::Neg(a), Node::Neg(b)) => all(&[*a], &[*b]),
            (Node::Dot(a, x), Node::Dot(b, y)) => all(a, b) && all(x, y),
            (Node::Select(s, a, x), Node::Select(t, b, y)) => {
                let (Test::Above(s1, s2), Test::Above(t1, t2)) = (s, t) else {
                    return false;
                };
                all(&[*s1, *s2, *a, *x], &[*t1, *t2, *b, *y])
            }
            (Node::Call(a, x), Node::Call(b, y)) => a == b && all(x, y),
            (Node::Part(a, i), Node::Part(b, j)) => i == j && all(&[*a], &[*b]),
            _ => false,
        }
    }
}

pub type Patterns = Rc<[Pattern]>;
