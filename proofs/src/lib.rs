//! Proofs of formulas that are generic over [`Real`]: for every bit pattern of their
//! input, not for samples of it.
//!
//! The formula runs with [`Term`], a number that records. Intervals, which know of rounding, overflow, NaN
//! and −0, then show what values the result can have. See [`prove`].

#![deny(missing_docs)]
#![forbid(unsafe_code)]
#![allow(clippy::float_cmp)] // special cases are exact

// the floats, and sets of them
mod format;
mod range;

// a formula, and the rules: what is known of it
mod graph;
mod known;
mod relation;

// a run of a formula, and the number that it runs with
mod run;
mod term;

// what is claimed, the search for what refutes it, and queries for a solver
mod goal;
mod sample;
#[doc(hidden)]
pub mod smt;
#[doc(hidden)]
pub mod tried;

use std::fmt;

use shading::{Real, Rgb, UnitVec3, Vec3};

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
        term::var(name, range.of_format(self.0))
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
    pub fn vector(self, name: &str, range: Range) -> Vec3<Term> {
        ["x", "y", "z"]
            .map(|axis| self.number(&format!("{name}.{axis}"), range))
            .into()
    }

    /// A direction: a vector of length 1 up to rounding, |v|² within 8 units of roundoff.
    pub fn unit(self, name: &str) -> UnitVec3<Term> {
        let (one, slack) = (1.0, 8.0 * self.0.u());
        let v = self.vector(name, Range::within(-one - slack, one + slack));
        term::normalize([v.x, v.y, v.z]);
        let square = v.dot(v);
        self.assume_at_most(Term::of(one - slack), square);
        self.assume_at_most(square, Term::of(one + slack));
        UnitVec3::assume_unit(v)
    }

    /// A color that is finite and not negative.
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

/// The variables of a claim, each with a value.
pub type Input = Vec<(String, f64)>;

/// What became of a claim, in one format.
#[derive(Clone, PartialEq, Debug)]
pub enum Verdict {
    /// It holds for every input, and there is one.
    Proved,
    /// It does not hold for this input.
    Refuted(Input),
    /// The rules do not prove it, and no input was found that refutes it.
    Open(String),
    /// It says nothing.
    Empty(String),
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
            Self::Empty(why) => write!(f, "it says nothing: {why}"),
        }
    }
}

/// Runs a formula along every path that the rules do not exclude; `each` sees the run with its result.
#[doc(hidden)]
pub fn paths<R>(format: Format, formula: impl Fn(Given) -> R, mut each: impl FnMut(&Run, R)) {
    run::explore(format, &|| formula(Given(format)), |run, result| {
        if let Some(result) = result {
            each(run, result);
        }
    });
}

/// What the rules say of a claim: the first goal that is open, why the claim is empty, and the
/// cases that have goals.
#[derive(Default)]
struct Derived {
    open: Option<String>,
    empty: Option<String>,
    cases: Vec<Vec<(Test, bool)>>,
}

fn derive(format: Format, claim: impl Fn(Given) -> Vec<Goal>) -> Derived {
    let (mut derived, mut without_goal) = (Derived::default(), Vec::new());
    run::explore(format, &|| claim(Given(format)), |run, goals| {
        let Run { graph, known, .. } = run;
        if let Some((name, _)) = graph.names.iter().find(|(_, range)| range.is_empty()) {
            derived.empty = Some(format!("no number lies in the range of {name}"));
        }
        let (case, goals) = (run.cases(), goals.unwrap_or_default());
        if goals.is_empty() {
            without_goal.push(case);
        } else if derived.open.is_none() {
            if !derived.cases.contains(&case) {
                derived.cases.push(case);
            }
            derived.open = goals
                .iter()
                .find(|goal| !goal.is_proved(graph, known))
                .map(|goal| {
                    let mut known = known.clone();
                    let nodes = goal.nodes().into_iter();
                    let ranges: Vec<_> = nodes.map(|id| known.range(graph, id)).collect();
                    format!("{goal:?} has {ranges:?}")
                });
        }
    });
    let has_goal = |case: &Vec<_>| derived.cases.iter().any(|other| other.starts_with(case));
    if derived.empty.is_none() {
        if derived.cases.is_empty() {
            derived.empty = Some("it has no goal on any path".into());
        } else if derived.open.is_none() && !without_goal.iter().all(has_goal) {
            derived.empty = Some("one of its cases has no goal".into());
        }
    }
    derived
}

/// Tries to prove a claim, and if that fails, to refute it with 20 times as many inputs as must
/// otherwise show that each of its cases says something.
pub fn judge(format: Format, claim: impl Fn(Given) -> Vec<Goal>, runs: u64) -> Verdict {
    let Derived { open, empty, cases } = derive(format, &claim);
    if let Some(why) = empty {
        return Verdict::Empty(why);
    }
    if let Some(open) = open {
        return refute(format, claim, 20 * runs).map_or(Verdict::Open(open), Verdict::Refuted);
    }
    let is_witnessed = |case: &Vec<_>| {
        let is_witness = |run: &Run, goals: &[Goal]| !goals.is_empty() && run.cases() == *case;
        sample::find(format, case, &claim, runs, is_witness).is_some()
    };
    if cases.iter().all(is_witnessed) {
        Verdict::Proved
    } else {
        Verdict::Empty("no input was found that satisfies what it assumes".into())
    }
}

/// Looks for an input that refutes a claim, among random and extreme ones.
pub fn refute(format: Format, claim: impl Fn(Given) -> Vec<Goal>, runs: u64) -> Option<Input> {
    let is_refuted = |run: &Run, goals: &[Goal]| !goals.iter().all(|goal| goal.holds(&run.graph));
    sample::find(format, &[], &claim, runs, is_refuted)
}

/// Proves a claim for every `f32` and every `f64`, as a test: panics if it does not hold, or if the rules do
/// not suffice. Where it can, the message names an input that refutes the claim. A claim that says nothing is
/// refused, such as one of which no input satisfies the assumptions.
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
/// # Panics
///
/// If the claim is not proved.
pub fn prove(claim: impl Fn(Given) -> Vec<Goal>) {
    for format in [Format::F32, Format::F64] {
        let verdict = judge(format, &claim, 100_000);
        assert!(verdict == Verdict::Proved, "{format:?}: {verdict}");
    }
}
