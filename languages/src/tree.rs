//! What a function computes on each of its paths.

use crate::graph::{Node, Op, Test, ZERO, with};
use crate::number::Expr;

/// Which of two paths to take: the first, if all tests hold, or if any does.
#[derive(Clone, Debug, PartialEq)]
pub enum Condition {
    All(Vec<Test>),
    Any(Vec<Test>),
}

#[derive(Clone, Debug, PartialEq)]
pub enum Tree {
    Leaf(Vec<usize>),
    Branch(Condition, Box<Tree>, Box<Tree>),
}

/// Runs a formula once for each path through its decisions.
pub fn explore(formula: &dyn Fn() -> Vec<Expr>, given: &[bool]) -> Tree {
    with(|g| (g.given, g.path) = (given.to_vec(), vec![]));
    let results = formula();
    let Some(&(test, _)) = with(|g| g.path.get(given.len()).copied()).as_ref() else {
        return Tree::Leaf(results.iter().map(|x| x.0).collect());
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
    match (&yes, &no) {
        (_, Tree::Branch(Condition::Any(tests), same, rest)) if **same == yes => {
            let tests = [&[test], &tests[..]].concat();
            Tree::Branch(Condition::Any(tests), same.clone(), rest.clone())
        }
        (_, Tree::Branch(Condition::All(tests), same, rest))
            if **same == yes && tests.len() == 1 =>
        {
            let tests = vec![test, tests[0]];
            Tree::Branch(Condition::Any(tests), same.clone(), rest.clone())
        }
        (Tree::Branch(Condition::All(tests), rest, same), _) if **same == no => {
            let tests = [&[test], &tests[..]].concat();
            Tree::Branch(Condition::All(tests), rest.clone(), same.clone())
        }
        _ => Tree::Branch(Condition::All(vec![test]), Box::new(yes), Box::new(no)),
    }
}

/// w/|w| where |w| > 0, and 0 elsewhere: a choice, which is printed as a call.
fn normalized(test: Test, yes: &Tree, no: &Tree) -> Option<Tree> {
    let (Tree::Leaf(yes), Tree::Leaf(no)) = (yes, no) else {
        return None;
    };
    let Test::Above(length, ZERO) = test else {
        return None;
    };
    with(|g| {
        let is_quotient =
            |&n: &usize| matches!(g.nodes[n], Node::Binary(Op::Div, _, d) if d == length);
        let is_unit = yes.len() == 3 && yes.iter().all(is_quotient) && no[..] == [ZERO; 3];
        is_unit.then(|| {
            let select = |&n: &usize| g.node(Node::Select(test, n, ZERO));
            Tree::Leaf(yes.iter().map(select).collect())
        })
    })
}
