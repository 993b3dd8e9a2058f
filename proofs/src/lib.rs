//! Proofs of formulas that are generic over [`Real`](shading::Real): for every bit pattern of their
//! input, not for samples of it.
//!
//! The formula runs with [`Term`], a number that records. An analysis of ranges, which knows of
//! rounding, overflow, NaN and −0, then shows what values the result can have. See [`prove`].

#![allow(clippy::float_cmp)] // special cases are exact

// the floats, and sets of them
mod format;
mod range;

// a formula, and what is known of it
mod graph;
mod known;
mod mirror;
mod relation;

// a run of a formula, and the number that it runs with
mod run;
mod term;

// what is claimed, and the search for what refutes it
mod goal;
mod sample;

use std::fmt;

use shading::{Rgb, UnitVec3, Vec3};

pub use format::Format;
pub use goal::Goal;
#[doc(hidden)]
pub use graph::{Graph, Node, Test};
#[doc(hidden)]
pub use known::Known;
pub use range::Range;
#[doc(hidden)]
pub use run::{Run, with};
pub use term::Term;

/// What a claim is about: its variables, and what it assumes of them.
#[derive(Clone, Copy, Debug)]
pub struct Given(Format);

impl Given {
    /// Single or double precision.
    #[must_use]
    pub fn format(self) -> Format {
        self.0
    }

    /// A variable with a range.
    #[must_use]
    pub fn number(self, name: &str, range: Range) -> Term {
        term::var(name, range)
    }

    /// A number of any bits, NaN and the infinities included.
    #[must_use]
    pub fn any(self, name: &str) -> Term {
        self.number(name, Range::ANY)
    }

    /// A finite number that is not negative.
    #[must_use]
    pub fn not_negative(self, name: &str) -> Term {
        self.number(name, Range::within(0.0, self.0.max()))
    }

    /// A vector whose components have a range.
    #[must_use]
    pub fn vector(self, name: &str, range: Range) -> Vec3<Term> {
        ["x", "y", "z"]
            .map(|axis| self.number(&format!("{name}.{axis}"), range))
            .into()
    }

    /// A direction: a vector of length 1 up to rounding, |v|² within 8 units of roundoff.
    #[must_use]
    pub fn unit(self, name: &str) -> UnitVec3<Term> {
        let (one, slack) = (1.0, 8.0 * self.0.u());
        let v = self.vector(name, Range::within(-one - slack, one + slack));
        term::normalize([v.x, v.y, v.z]);
        let square = v.dot(v);
        let limit = |x| <Term as shading::Real>::of(x);
        self.assume_at_most(limit(one - slack), square);
        self.assume_at_most(square, limit(one + slack));
        UnitVec3::assume_unit(v)
    }

    /// A color that is finite and not negative.
    #[must_use]
    pub fn rgb(self, name: &str) -> Rgb<Term> {
        ["r", "g", "b"]
            .map(|channel| self.not_negative(&format!("{name}.{channel}")))
            .into()
    }

    /// One of `n` cases, each of which is proved apart.
    #[must_use]
    pub fn one_of(self, n: u32) -> u32 {
        (1..n).find(|_| run::case()).unwrap_or(0)
    }

    /// Assumes a ≤ b.
    pub fn assume_at_most(self, a: Term, b: Term) {
        run::assume(Test::AtMost(a.0, b.0));
    }

    /// Assumes a > b.
    pub fn assume_above(self, a: Term, b: Term) {
        run::assume(Test::Above(a.0, b.0));
    }
}

/// What became of a claim, in one format.
#[derive(Clone, PartialEq, Debug)]
pub enum Verdict {
    /// It holds for every input.
    Proved,
    /// It does not hold for this input.
    Refuted(Vec<(String, f64)>),
    /// Ranges do not prove it, and no input was found that refutes it.
    Open(String),
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Proved => write!(f, "proved"),
            Self::Refuted(input) => {
                write!(f, "refuted by")?;
                for (name, x) in input {
                    write!(f, " {name} = {x:e}")?;
                }
                Ok(())
            }
            Self::Open(goal) => write!(f, "open: {goal}"),
        }
    }
}

/// Runs a formula along every path; `each` sees the run with its result.
#[doc(hidden)]
pub fn paths<R>(format: Format, formula: impl Fn(Given) -> R, each: impl FnMut(&Run, R)) -> usize {
    run::explore(format, &|| formula(Given(format)), each)
}

/// Whether intervals alone prove a claim, without what is known of several nodes together.
#[doc(hidden)]
pub fn is_proved_by_intervals(format: Format, claim: impl Fn(Given) -> Vec<Goal>) -> bool {
    relation::without(|| judge(format, claim, 0)) == Verdict::Proved
}

/// Tries to prove a claim, then to refute it with `runs` inputs.
pub fn judge(format: Format, claim: impl Fn(Given) -> Vec<Goal>, runs: u64) -> Verdict {
    let formula = || claim(Given(format));
    let mut open = None;
    run::explore(format, &formula, |Run { graph, known, .. }, goals| {
        let unproved = goals.into_iter().find(|goal| !goal.is_proved(graph, known));
        if let (None, Some(goal)) = (&open, unproved) {
            let ranges = goal
                .nodes()
                .into_iter()
                .map(|id| known.clone().range(graph, id));
            open = Some(format!("{goal:?} has {:?}", ranges.collect::<Vec<_>>()));
        }
    });
    let Some(open) = open else {
        return Verdict::Proved;
    };
    refute(format, claim, runs).map_or(Verdict::Open(open), Verdict::Refuted)
}

/// Looks for an input that refutes a claim, among random and extreme ones.
pub fn refute(
    format: Format,
    claim: impl Fn(Given) -> Vec<Goal>,
    runs: u64,
) -> Option<Vec<(String, f64)>> {
    let mut input = None;
    let formula = || claim(Given(format));
    sample::try_out(format, &formula, runs, |Run { graph, .. }, goals| {
        let holds = goals.iter().all(|goal| goal.holds(graph));
        if !holds {
            let variables = graph.nodes.iter().zip(&graph.values);
            let named = variables.filter_map(|(node, x)| match node {
                Node::Var(index) => Some((graph.names[*index as usize].0.clone(), *x)),
                _ => None,
            });
            input = Some(named.collect());
        }
        holds
    });
    input
}

/// Runs a claim with random numbers; `each` sees the run with its values, and says whether to go on.
#[doc(hidden)]
pub fn try_out(
    format: Format,
    claim: impl Fn(Given) -> Vec<Goal>,
    runs: u64,
    each: impl FnMut(&Run, Vec<Goal>) -> bool,
) {
    sample::try_out(format, &|| claim(Given(format)), runs, each);
}

/// Tests the prover itself: with numbers, the value of each node must lie in the range derived for it.
/// Returns how many values were compared.
///
/// # Errors
///
/// The first value that lies outside of its range.
#[doc(hidden)]
pub fn check_ranges(
    format: Format,
    claim: impl Fn(Given) -> Vec<Goal>,
    runs: u64,
) -> Result<u64, String> {
    let (mut compared, mut wrong) = (0, None);
    let formula = || claim(Given(format));
    sample::try_out(format, &formula, runs, |Run { graph, path, .. }, _| {
        let mut known = Known::default();
        for &(test, answer) in path {
            known.refine(graph, test, answer);
        }
        if known.impossible {
            wrong = Some(format!("the path {path:?} is not impossible"));
            return false;
        }
        for (id, (node, x)) in (0..).zip(graph.nodes.iter().zip(&graph.values)) {
            compared += 1;
            let range = known.range(graph, id);
            if !range.contains(*x) {
                wrong = Some(format!("{node:?} is {x:e}, not in {range:?}"));
            }
        }
        wrong.is_none()
    });
    wrong.map_or(Ok(compared), Err)
}

/// Proves a claim for every `f32` and every `f64`, as a test: panics if it does not hold, or if the
/// analysis of ranges does not suffice. Where it can, the message names an input that refutes the claim.
///
/// The claim gets its variables from [`Given`] and says what must hold of its results.
///
/// ```
/// use shading::Real;
/// use shading_proofs::{Goal, Range};
///
/// /// A falloff of our own: 1/(1 + q²), limited to 1.
/// fn falloff<T: Real>(q: T) -> T {
///     (T::ONE / (T::ONE + q * q)).at_most(T::ONE)
/// }
///
/// // for every q, NaN excepted: between 0 and 1, and never NaN
/// shading_proofs::prove(|given| {
///     let q = given.number("q", Range::within(f64::NEG_INFINITY, f64::INFINITY));
///     vec![Goal::Within(falloff(q), Range::within(0.0, 1.0))]
/// });
/// ```
///
/// A naive formula is refuted. At a distance of 0, 1/q² is infinite, and the light that it falls on is
/// black, so their product is NaN:
///
/// ```should_panic
/// use shading::Real;
/// use shading_proofs::{Goal, Range};
///
/// fn arriving<T: Real>(light: T, q: T) -> T {
///     light * (T::ONE / (q * q))
/// }
///
/// shading_proofs::prove(|given| {
///     let (light, q) = (given.not_negative("light"), given.not_negative("q"));
///     vec![Goal::Within(arriving(light, q), Range::within(0.0, f64::INFINITY))]
/// });
/// ```
///
/// # Panics
///
/// If the claim is not proved.
pub fn prove(claim: impl Fn(Given) -> Vec<Goal>) {
    for format in [Format::F32, Format::F64] {
        let verdict = judge(format, &claim, 100_000);
        assert!(verdict == Verdict::Proved, "{format:?}: {verdict}");
    }
}
