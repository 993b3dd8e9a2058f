//! A strategy that shrinks to one of some simple values, whatever it began with.
//!
//! proptest's own unions take one step back and stop if that passes; so a direction by two angles
//! would stay one.

use core::fmt::Debug;

use proptest::prelude::*;
use proptest::strategy::{NewTree, ValueTree};
use proptest::test_runner::TestRunner;

/// Some simple values, the simplest first, and a strategy for all others.
#[derive(Clone, Debug)]
pub struct Simplest<S: Strategy> {
    simple: Vec<S::Value>,
    any: S,
}

/// Mostly of `any`, and in one case of four one of the simple values.
pub fn simplest<S: Strategy<Value: Clone>>(
    simple: impl Into<Vec<S::Value>>,
    any: S,
) -> Simplest<S> {
    Simplest {
        simple: simple.into(),
        any,
    }
}

impl<S: Strategy<Value: Clone>> Strategy for Simplest<S> {
    type Tree = Tree<S::Tree>;
    type Value = S::Value;

    fn new_tree(&self, runner: &mut TestRunner) -> NewTree<Self> {
        let any = self.any.new_tree(runner)?;
        let begun = (0..4 * self.simple.len()).new_tree(runner)?.current();
        let count = self.simple.len();
        Ok(Tree {
            simple: self.simple.clone(),
            at: begun.min(count),
            next: 0,
            before: begun.min(count),
            any,
        })
    }
}

/// The value is the simple one `at` its place, or that of `any` after the last.
pub struct Tree<T: ValueTree> {
    simple: Vec<T::Value>,
    at: usize,
    /// The first that was not tried.
    next: usize,
    /// Where it was before it was simplified.
    before: usize,
    any: T,
}

impl<T: ValueTree<Value: Clone>> ValueTree for Tree<T> {
    type Value = T::Value;

    fn current(&self) -> T::Value {
        self.simple
            .get(self.at)
            .cloned()
            .unwrap_or_else(|| self.any.current())
    }

    fn simplify(&mut self) -> bool {
        if self.next < self.at {
            (self.before, self.at) = (self.at, self.next);
            self.next += 1;
            return true;
        }
        self.before = self.at;
        self.at == self.simple.len() && self.any.simplify()
    }

    fn complicate(&mut self) -> bool {
        if self.at == self.before {
            return self.at == self.simple.len() && self.any.complicate();
        }
        self.at = if self.next < self.before {
            self.next
        } else {
            self.before
        };
        self.next += 1;
        true
    }
}
