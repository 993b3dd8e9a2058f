//! What a claim says about its results.

use super::graph::{Graph, Test};
use super::known::Known;
use super::range::Range;
use super::term::Term;

/// How many open selections a goal may try both ways, one inside the other.
const SPLITS: u32 = 8;

/// What a claim says about its results.
#[derive(Clone, Copy, Debug)]
pub enum Goal {
    /// A value lies in a range.
    Within(Term, Range),
    /// Two values have the same bits; any NaN is as good as another.
    Same(Term, Term),
    /// Two values are ordered: the first is at most the second, and neither is NaN.
    AtMost(Term, Term),
    /// This is never reached.
    Never,
}

impl Goal {
    pub(super) fn nodes(&self) -> Vec<u32> {
        match *self {
            Self::Within(a, _) => vec![a.0],
            Self::Same(a, b) | Self::AtMost(a, b) => vec![a.0, b.0],
            Self::Never => vec![],
        }
    }

    /// Whether the rules prove it.
    #[doc(hidden)]
    #[must_use]
    pub fn is_proved(&self, g: &Graph, known: &Known) -> bool {
        self.is_proved_within(g, known, SPLITS)
    }

    fn is_proved_within(&self, g: &Graph, known: &Known, splits: u32) -> bool {
        let mut known = known.clone();
        let is_proved = match *self {
            Self::Within(term, goal) => goal.covers(known.range(g, term.0)),
            Self::Same(a, b) => known.same(g, a.0, b.0),
            Self::AtMost(a, b) => known.answer(g, Test::AtMost(a.0, b.0)) == Some(true),
            Self::Never => false,
        };
        if is_proved || splits == 0 {
            return is_proved;
        }
        let Some(test) = known.open_test(g, self.nodes()) else {
            return false;
        };
        [true, false].into_iter().all(|answer| {
            let mut known = known.clone();
            known.refine(g, test, answer);
            known.is_impossible(g) || self.is_proved_within(g, &known, splits - 1)
        })
    }

    /// Whether it holds, in a run with numbers.
    #[doc(hidden)]
    #[must_use]
    pub fn holds(&self, g: &Graph) -> bool {
        let v = |term: Term| g.values[term.0 as usize];
        match *self {
            Self::Within(term, range) => range.contains(v(term)),
            Self::Same(a, b) => v(a).to_bits() == v(b).to_bits() || v(a).is_nan() && v(b).is_nan(),
            Self::AtMost(a, b) => v(a) <= v(b),
            Self::Never => false,
        }
    }
}
