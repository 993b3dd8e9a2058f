//! What is known of two nodes together, which intervals forget: that one is at most the other, and that a
//! component is at most as long as its vector.
//!
//! Below, u is the unit roundoff and η the smallest number above 0. A rounded result is x(1 + θ) + δ with
//! |θ| ≤ u and |δ| ≤ η/2, unless it overflows; δ = 0 for sums, differences and roots.

use super::graph::{Graph, Node, ONE, Test};
use super::known::Known;
use super::range::Range;

/// How many operations inside one another are compared.
const DEPTH: u32 = 12;

impl Known {
    /// The values of a node, given those that its operation alone leaves.
    pub(super) fn related(&mut self, g: &Graph, id: u32, range: Range) -> Range {
        let within = |most: f64| Range::within(-most, most).or_nan();
        match g.nodes[id as usize] {
            Node::Div(a, b) => {
                let share = self.share_of_root(g, a, b);
                let range = share.map_or(range, |most| range.meet(within(most)));
                // a ≥ b > 0 makes a/b ≥ 1
                if self.range(g, b).low > 0.0 && self.is_at_most(g, b, a) {
                    range.meet(Range::within(1.0, f64::INFINITY).or_nan())
                } else {
                    range
                }
            }
            // the difference of two floats is 0 only if they are equal
            Node::Sub(a, b) if self.is_told_above(a, b) => {
                range.meet(Range::within(g.format.tiny(), f64::INFINITY))
            }
            _ => range,
        }
    }

    /// The most that |v/√S| can be, if S is above 0 and a sum of v² and of numbers that are not negative.
    ///
    /// The sum is at least the rounded v², because rounding is monotone. So S ≥ v²(1 − u) − η/2, and with s
    /// for the least S, v² ≤ S(1 + η/2s)/(1 − u). The root is at least √S(1 − u). The quotient adds a
    /// factor of 1 + u and η/2. That is less than 16u for u ≤ ¼. If S is ∞, the result is 0 or NaN.
    fn share_of_root(&mut self, g: &Graph, v: u32, root: u32) -> Option<f64> {
        let root = self.resolved(g, root);
        let Node::Sqrt(sum) = g.nodes[root as usize] else {
            return None;
        };
        let f = g.format;
        let least = self.range(g, sum).low;
        let (mut found, mut terms) = (false, vec![sum]);
        while let Some(term) = terms.pop() {
            match g.nodes[term as usize] {
                Node::Mul(p, q) if p == v && q == v => found = true,
                Node::Add(p, q) => terms.extend([p, q]),
                _ if self.range(g, term).low >= 0.0 => {}
                _ => return None,
            }
        }
        let flat = (1.0 + f.tiny() / (2.0 * least)).sqrt();
        let most = flat * (1.0 + 16.0 * f.u()) + f.tiny();
        (found && least > 0.0).then(|| f.next_up(most))
    }

    /// Whether a ≤ b, if neither is NaN.
    pub(super) fn is_at_most(&mut self, g: &Graph, a: u32, b: u32) -> bool {
        self.is_ordered(g, a, b, DEPTH)
    }

    /// An operation rises or falls with its operands, and so does the rounded one. If the result is not NaN,
    /// neither are the operands, so that what is known of numbers suffices for them.
    fn is_ordered(&mut self, g: &Graph, a: u32, b: u32, depth: u32) -> bool {
        if self.is_told(a, b) {
            return true;
        }
        let (a, b) = (self.resolved(g, a), self.resolved(g, b));
        if a == b || self.range(g, a).high <= self.range(g, b).low {
            return true;
        }
        if depth == 0 {
            return false;
        }
        let (of_a, of_b) = (g.nodes[a as usize], g.nodes[b as usize]);
        let is = |known: &mut Self, x, y| known.is_ordered(g, x, y, depth - 1);
        let is_light = |known: &mut Self, x| known.range(g, x).low >= 0.0;
        // the operands of a sum and of a product, in either order
        let either = |p, q| [(p, q), (q, p)].into_iter();

        let is_at_most = match of_a {
            // a share of a number that is not negative
            Node::Mul(p, q) => {
                is_light(self, p)
                    && is_light(self, q)
                    && either(p, q).any(|(p, q)| is(self, p, b) && is(self, q, ONE))
            }
            // a sum of a number that is not positive, and another
            Node::Add(p, q) => {
                either(p, q).any(|(p, q)| self.range(g, p).high <= 0.0 && is(self, q, b))
            }
            // a minimum, which passes over a limit that is NaN, and a maximum
            Node::Select(Test::Above(x, y), p, q) if (p, q) == (y, x) => {
                is(self, x, b) || !self.range(g, y).nan && is(self, y, b)
            }
            Node::Select(Test::Above(x, y), p, q) if (p, q) == (x, y) => {
                is(self, x, b) && is(self, y, b)
            }
            _ => false,
        };
        if is_at_most {
            return true;
        }
        let is_at_least = match of_b {
            // a sum of a number that is not negative, and another
            Node::Add(r, s) => either(r, s).any(|(r, s)| is_light(self, r) && is(self, a, s)),
            // a minimum, and a maximum, which passes over a number that is NaN
            Node::Select(Test::Above(x, y), p, q) if (p, q) == (y, x) => {
                is(self, a, x) && is(self, a, y)
            }
            Node::Select(Test::Above(x, y), p, q) if (p, q) == (x, y) => {
                is(self, a, y) || !self.range(g, x).nan && is(self, a, x)
            }
            _ => false,
        };
        if is_at_least {
            return true;
        }
        match (of_a, of_b) {
            (Node::Add(p, q), Node::Add(r, s)) => {
                either(r, s).any(|(r, s)| is(self, p, r) && is(self, q, s))
            }
            (Node::Sub(p, q), Node::Sub(r, s)) => is(self, p, r) && is(self, s, q),
            (Node::Mul(p, q), Node::Mul(r, s)) => {
                is_light(self, p)
                    && is_light(self, q)
                    && either(r, s).any(|(r, s)| is(self, p, r) && is(self, q, s))
            }
            // 1/−0 is −∞
            (Node::Div(p, q), Node::Div(r, s)) => {
                (q == s || is_light(self, p))
                    && is_light(self, s)
                    && !self.range(g, s).minus_zero
                    && is(self, p, r)
                    && is(self, s, q)
            }
            // what is selected below an edge, and what is selected of a number that is not less
            (
                Node::Select(Test::Above(edge, x), below, other),
                Node::Select(Test::Above(same, y), less, more),
            ) => {
                edge == same
                    && is(self, below, less)
                    && !self.range(g, x).nan
                    && is(self, x, y)
                    && is(self, below, more)
                    && is(self, other, more)
            }
            _ => false,
        }
    }
}
