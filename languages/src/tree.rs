//! What a function computes on each of its paths.

use std::mem::take;

use crate::dialect::Dialect;
use crate::graph::{Graph, Op, with};
use crate::kind::Kind;

/// What is recorded and printed as a function.
pub struct Formula<'a> {
    /// The name of a function of the files; a user's has none.
    pub defining: &'static str,
    pub parameters: &'a [(&'static str, Kind)],
    pub result: Kind,
    /// Records it, given the numbers of its parameters.
    pub record: &'a dyn Fn(&[usize]) -> Vec<usize>,
}

/// What a formula computes, on each of its paths.
pub fn recorded(dialect: &Dialect, formula: &Formula) -> (Graph, Tree) {
    let divides_vectors = dialect.vector_functions.is_empty();
    with(|g| g.begin(formula.defining, divides_vectors));
    let numbers = |(name, kind): &(&'static str, Kind)| with(|g| g.parameter(name, *kind));
    let numbers: Vec<_> = formula.parameters.iter().flat_map(numbers).collect();
    let whole = [("", formula.result)];
    let fields = formula.result.fields();
    let fields = fields.map_or(&whole[..], |(_, _, fields)| fields);
    let results = || {
        let results = (formula.record)(&numbers);
        with(|g| g.values(fields, &results))
    };
    let tree = explore(&results, &[]);
    (with(take), tree)
}

#[derive(Clone, Debug, PartialEq)]
pub enum Tree {
    /// The fields of a result.
    Leaf(Vec<usize>),
    /// The paths where a test holds, and where it does not.
    Branch(usize, Box<Tree>, Box<Tree>),
}

/// Runs a formula once for each path through its decisions.
fn explore(formula: &dyn Fn() -> Vec<usize>, given: &[bool]) -> Tree {
    with(|g| (g.given, g.path) = (given.to_vec(), vec![]));
    let results = formula();
    let Some((test, _)) = with(|g| g.path.get(given.len()).copied()) else {
        return Tree::Leaf(results);
    };
    let side = |answer| explore(formula, &[given, &[answer]].concat());
    let (yes, no) = (side(true), side(false));
    joined(test, yes, no)
}

/// One branch, or none where both sides are the same.
fn joined(test: usize, yes: Tree, no: Tree) -> Tree {
    if yes == no {
        return yes;
    }
    let op = |test: usize| with(|g| g.nodes[test].op);
    let tests = |op, others| with(|g| g.joined(op, test, others));
    match (&yes, &no) {
        // a direction is printed as a call
        (Tree::Leaf(then), Tree::Leaf(otherwise))
            if with(|g| g.normalized(test, then[0], otherwise[0])).is_some() =>
        {
            Tree::Leaf(vec![with(|g| g.choice(test, then[0], otherwise[0]))])
        }
        // `>=` and `==` as `partial_cmp` derives them
        (_, Tree::Branch(other, then, otherwise))
            if with(|g| g.implied(test, *other))
                .is_some_and(|holds| yes == **if holds { then } else { otherwise }) =>
        {
            no
        }
        (_, Tree::Branch(others, same, rest)) if **same == yes && op(*others) != Op::All => {
            Tree::Branch(tests(Op::Any, *others), same.clone(), rest.clone())
        }
        (Tree::Branch(others, rest, same), _) if **same == no && op(*others) != Op::Any => {
            Tree::Branch(tests(Op::All, *others), rest.clone(), same.clone())
        }
        _ => Tree::Branch(test, Box::new(yes), Box::new(no)),
    }
}
