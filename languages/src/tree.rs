//! What a function computes on each of its paths.

use crate::graph::{Node, Op, Test, ZERO, with};

/// Which of two paths to take: the first, if all tests hold, or if any does.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    pub tests: Vec<Test>,
    pub is_any: bool,
}

#[derive(Clone, Debug, PartialEq)]
pub enum Tree {
    Leaf(Vec<usize>),
    Branch(Condition, Box<Tree>, Box<Tree>),
}

/// Runs a formula once for each path through its decisions.
pub fn explore(formula: &dyn Fn() -> Vec<usize>, given: &[bool]) -> Tree {
    with(|g| (g.given, g.path) = (given.to_vec(), vec![]));
    let results = formula();
    let Some(&(test, _)) = with(|g| g.path.get(given.len()).copied()).as_ref() else {
        return Tree::Leaf(results);
    };
    let side = |answer| explore(formula, &[given, &[answer]].concat());
    let (yes, no) = (side(true), side(false));
    joined(test, yes, no)
}

/// One branch, or none where both sides are the same.
fn joined(test: Test, yes: Tree, no: Tree) -> Tree {
    if yes == no {
        return yes;
    }
    if let Some(unit) = normalized(test, &yes, &no) {
        return unit;
    }
    let before = |tests: &[Test], is_any| Condition {
        tests: [&[test], tests].concat(),
        is_any,
    };
    match (&yes, &no) {
        (_, Tree::Branch(Condition { tests, is_any }, same, rest))
            if **same == yes && (*is_any || tests.len() == 1) =>
        {
            Tree::Branch(before(tests, true), same.clone(), rest.clone())
        }
        (Tree::Branch(Condition { tests, is_any }, rest, same), _) if **same == no && !is_any => {
            Tree::Branch(before(tests, false), rest.clone(), same.clone())
        }
        _ => Tree::Branch(before(&[], false), Box::new(yes), Box::new(no)),
    }
}

/// w/|w| where |w| > 0, and 0 elsewhere: a choice, which is printed as a call.
fn normalized(test: Test, yes: &Tree, no: &Tree) -> Option<Tree> {
    let (Tree::Leaf(yes), Tree::Leaf(no), Test::Above(length, ZERO)) = (yes, no, test) else {
        return None;
    };
    with(|g| {
        let is_over_length =
            |&n: &usize| matches!(g.nodes[n], Node::Binary(Op::Div, _, of) if of == length);
        let is_unit = yes.iter().all(is_over_length) && no[..] == [ZERO; 3];
        let select = |&n: &usize| g.node(Node::Select(test, n, ZERO));
        is_unit.then(|| Tree::Leaf(yes.iter().map(select).collect()))
    })
}
