//! A run of a formula: what it records, and the answers to its decisions.
//!
//! A decision, such as `any_positive` or a comparison, is a fork: the formula runs once for each
//! combination of answers that the rules do not exclude.

use std::cell::RefCell;

use super::format::Format;
use super::graph::{Graph, Node, Sampler, Test};
use super::known::Known;
use super::range::Range;

/// A run of a formula, along one path.
#[doc(hidden)]
#[derive(Default)]
pub struct Run {
    pub graph: Graph,
    /// What is assumed and what was decided.
    pub path: Vec<(Test, bool)>,
    /// What the rules answered, and how long the path was then.
    pub answered: Vec<(usize, Test, bool)>,
    pub known: Known,
    /// Whether an assumption does not hold, in a run with numbers.
    is_void: bool,
    script: Vec<(bool, bool)>, // the answer, and whether the other one remains to be tried
    next: usize,
    cases: u32,
    /// The cases of a run with numbers; others are drawn.
    wanted: Vec<(Test, bool)>,
}

impl Run {
    /// Begins another run: with numbers, if there is a sampler.
    fn restart(&mut self, format: Format, sampler: Option<Sampler>) {
        *self = Self {
            graph: std::mem::take(&mut self.graph),
            script: std::mem::take(&mut self.script),
            ..Self::default()
        };
        self.graph.restart(format, sampler);
    }

    /// The answer that this path has given to a test.
    fn told(&self, test: Test) -> Option<bool> {
        let told = self.path.iter().find(|(told, _)| *told == test);
        told.map(|(_, answer)| *answer)
    }

    fn learn(&mut self, test: Test, answer: bool) {
        self.path.push((test, answer));
        self.known.refine(&self.graph, test, answer);
    }

    /// The answer to a test: that of the numbers, a known one, or a fork.
    fn decide(&mut self, test: Test) -> bool {
        if self.graph.is_numeric() {
            let wanted = self.wanted.iter().find(|(wanted, _)| *wanted == test);
            let answer = match (test, wanted) {
                (Test::Case(_), Some((_, answer))) => *answer,
                (Test::Case(_), None) => self.graph.draw(Range::unsigned(0.0, 1.0)) > 0.5,
                _ => self.graph.holds(test),
            };
            self.path.push((test, answer));
            return answer;
        }
        if let Some(answer) = self.told(test) {
            return answer;
        }
        if self.known.impossible {
            return false;
        }
        if let Some(answer) = self.known.answer(&self.graph, test) {
            self.answered.push((self.path.len(), test, answer));
            return answer;
        }
        if self.next == self.script.len() {
            self.script.push((true, true));
        }
        let answer = self.script[self.next].0;
        self.next += 1;
        self.learn(test, answer);
        answer
    }

    /// Prepares the script of the next path, if one remains.
    fn turn(&mut self) -> bool {
        while let Some((answer, other_remains)) = self.script.pop() {
            if other_remains {
                self.script.push((!answer, false));
                return true;
            }
        }
        false
    }

    /// The cases of this path.
    pub(super) fn cases(&self) -> Vec<(Test, bool)> {
        let is_case = |(test, _): &&(Test, bool)| matches!(test, Test::Case(_));
        self.path.iter().filter(is_case).copied().collect()
    }
}

thread_local!(static RUN: RefCell<Run> = RefCell::default());

fn with_run<R>(f: impl FnOnce(&mut Run) -> R) -> R {
    RUN.with_borrow_mut(f)
}

#[doc(hidden)]
pub fn with<R>(f: impl FnOnce(&mut Graph) -> R) -> R {
    with_run(|run| f(&mut run.graph))
}

/// Records a node.
pub(super) fn node(node: Node) -> u32 {
    with(|g| g.node(node))
}

pub(super) fn assume(test: Test) {
    with_run(|run| {
        if run.graph.is_numeric() {
            run.is_void |= !run.graph.holds(test);
            run.path.push((test, true));
        } else {
            run.learn(test, true);
        }
    });
}

/// Either answer, whichever the numbers are.
pub(super) fn case() -> bool {
    with_run(|run| {
        run.cases += 1;
        run.decide(Test::Case(run.cases))
    })
}

/// The answer that the path has given to a test.
pub(super) fn told(test: Test) -> Option<bool> {
    with_run(|run| run.told(test))
}

/// The answer to a test.
pub(super) fn decide(test: Test) -> bool {
    with_run(|run| run.decide(test))
}

/// Runs a formula along every path; `each` sees the run with its result, unless that was called impossible.
pub(super) fn explore<R>(
    format: Format,
    formula: &impl Fn() -> R,
    mut each: impl FnMut(&Run, Option<R>),
) {
    with_run(|run| run.script.clear());
    loop {
        with_run(|run| run.restart(format, None));
        let result = formula();
        let another = with_run(|run| {
            each(run, (!run.known.impossible).then_some(result));
            run.turn()
        });
        if !another {
            return;
        }
    }
}

/// Runs a formula with the numbers of a sampler, in these cases or in any; `each` sees the run with
/// its result, unless an assumption does not hold.
pub(super) fn calculate<R, S>(
    format: Format,
    sampler: Sampler,
    cases: &[(Test, bool)],
    formula: &impl Fn() -> R,
    each: impl FnOnce(&Run, R) -> S,
) -> Option<S> {
    with_run(|run| {
        run.restart(format, Some(sampler));
        run.wanted = cases.to_vec();
    });
    let result = formula();
    with_run(|run| (!run.is_void).then(|| each(run, result)))
}
