//! Random formulas, whose values must lie in the ranges that the prover derives for them.

use shading::{Real, Vec3};
use shading_laws::proof::{Given, Goal, Range, Term};

/// A linear congruential generator (Knuth's constants).
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).expect("31 bits") % n
    }
    fn pick(&mut self, terms: &[Term]) -> Term {
        terms[self.below(terms.len())]
    }
    /// Vectors share their components more often than chance would have it.
    fn vector(&mut self, terms: &[Term]) -> Vec3<Term> {
        let at = self.below(4) * 3;
        if at + 3 <= terms.len().min(9) {
            return Vec3::new(terms[at], terms[at + 1], terms[at + 2]);
        }
        [0; 3].map(|_| self.pick(terms)).into()
    }
    fn range(&mut self) -> Range {
        let (tiny, big) = ((-140.0_f64).exp2(), 120.0_f64.exp2());
        match self.below(10) {
            0 | 1 => Range::ANY,
            2 => Range::within(0.0, f64::INFINITY),
            3 => Range::unsigned(0.0, 2.0),
            4 => Range::within(-1.0, 1.0),
            5 => Range::within(-tiny, tiny),
            6 => Range::within(-big, big),
            7 => Range::within(f64::NEG_INFINITY, f64::INFINITY),
            8 => Range::NOT_FINITE,
            _ => Range::within(0.0, 0.0).or_nan(),
        }
    }
}

/// A formula of nine variables and up to 24 operations, the same for the same seed.
pub fn formula(seed: u64, given: Given) -> Vec<Goal> {
    let mut random = Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15));
    let mut terms: Vec<Term> = (0..9).map(|i| given.number(&format!("x{i}"), random.range())).collect();
    for _ in 0..random.below(22) + 3 {
        let [x, y, a, b] = [0; 4].map(|_| random.pick(&terms));
        let term = match random.below(16) {
            0 | 1 => x + y,
            2 | 3 => x - y,
            4 | 5 => x * y,
            6 | 7 => x / y,
            8 => x.sqrt(),
            9 => x.if_above(y, a, b),
            10 => [x.abs(), -x, x * x, x - x][random.below(4)],
            11 => [x.at_least(Term::ZERO), x.at_most(Term::ONE), x.at_most(Term::MAX)][random.below(3)],
            12 => random.vector(&terms).dot(random.vector(&terms)),
            13 => random.vector(&terms).cross(random.vector(&terms)).x,
            14 => random.vector(&terms).length(),
            _ => {
                // a decision, from which the prover learns
                let is_decided = [x > y, x <= y, x == y, (x - y).any_positive()][random.below(4)];
                if is_decided { x * x } else { x / x.abs() }
            }
        };
        terms.push(term);
    }
    vec![]
}
