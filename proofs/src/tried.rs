//! A claim with every input, in a format of few numbers: the value of each node must lie in the
//! range that the rules derive for it, each answer of theirs must be that of the numbers, and each
//! goal that they prove must hold.

use std::cell::RefCell;
use std::rc::Rc;

use rustc_hash::FxHashMap;

use super::known::Known;
use super::run::{Run, calculate};
use super::{Format, Given, Goal, Range, Test};

/// What the rules say of a path: the range of each node, and whether each goal is proved.
struct Derived {
    is_impossible: bool,
    ranges: Vec<Range>,
    are_proved: Vec<bool>,
}

fn derive(run: &Run, goals: &[Goal]) -> Derived {
    let (g, mut known) = (&run.graph, Known::default());
    for &(test, answer) in &run.path {
        known.refine(g, test, answer);
    }
    let ids = 0..u32::try_from(g.nodes.len()).expect("fewer than 2³² nodes");
    Derived {
        ranges: ids.map(|id| known.range(g, id)).collect(),
        are_proved: goals.iter().map(|goal| goal.is_proved(g, &known)).collect(),
        is_impossible: known.impossible,
    }
}

/// Numbers the inputs: the remainders by how many numbers each variable has say which of these it gets, and
/// what is left when all have one ends the inputs.
struct Inputs {
    rest: usize,
    numbers: Vec<f64>,
    /// Those of each range, which are looked for once.
    inside: Vec<(Range, Vec<f64>)>,
}

impl Inputs {
    fn new(format: Format) -> Self {
        Self {
            rest: 0,
            numbers: format.numbers(),
            inside: Vec::new(),
        }
    }

    fn next(&mut self, range: Range) -> f64 {
        let known = self.inside.iter().position(|(known, _)| *known == range);
        let at = known.unwrap_or_else(|| {
            let inside = self.numbers.iter().copied();
            let inside = inside.filter(|x| range.contains(*x)).collect();
            self.inside.push((range, inside));
            self.inside.len() - 1
        });
        let inside = &self.inside[at].1;
        let choice = self.rest % inside.len();
        self.rest /= inside.len();
        inside[choice]
    }
}

/// Tries a claim with every input. Returns how many values were compared.
///
/// # Errors
///
/// The first value, answer or goal that the rules get wrong.
pub fn every(format: Format, claim: impl Fn(Given) -> Vec<Goal>) -> Result<u64, String> {
    let inputs = Rc::new(RefCell::new(Inputs::new(format)));
    let mut derived: FxHashMap<Vec<(Test, bool)>, Derived> = FxHashMap::default();
    let (mut compared, mut wrong) = (0, None);
    for input in 0_usize.. {
        inputs.borrow_mut().rest = input;
        let choices = inputs.clone();
        let sampler = move |range: Range, _: &[f64]| choices.borrow_mut().next(range);
        let formula = || claim(Given(format));
        calculate(format, Box::new(sampler), &[], &formula, |run, goals| {
            if inputs.borrow().rest > 0 {
                return;
            }
            if !derived.contains_key(&run.path) {
                derived.insert(run.path.clone(), derive(run, &goals));
            }
            let (g, of_path) = (&run.graph, &derived[&run.path]);
            compared += g.values.len() as u64;
            let outside = of_path
                .ranges
                .iter()
                .zip(&g.values)
                .position(|(range, x)| !range.contains(*x));
            let mut proved = goals.iter().zip(&of_path.are_proved);
            wrong = if of_path.is_impossible {
                Some("this path is not impossible".into())
            } else if let Some(id) = outside {
                Some(format!(
                    "{:?} is {:e}, not in {:?}",
                    g.nodes[id], g.values[id], of_path.ranges[id]
                ))
            } else {
                let false_goal = proved.find(|(goal, is_proved)| **is_proved && !goal.holds(g));
                false_goal.map(|(goal, _)| format!("{goal:?} is proved, and wrong"))
            };
            wrong = wrong
                .take()
                .map(|wrong| format!("{wrong}, with {:?}", g.input()));
        });
        if let Some(wrong) = wrong {
            return Err(wrong);
        }
        if inputs.borrow().rest > 0 {
            return Ok(compared);
        }
    }
    unreachable!("the inputs end")
}
