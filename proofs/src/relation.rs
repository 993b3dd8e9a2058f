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
    /// The sum is at least the rounded v², because rounding is monotone. So S ≥ v²(1 − u) − η/2, and with s for
    /// the least S, v² ≤ S(1 + η/2s)/(1 − u). The root is at least √S(1 − u). The quotient adds a
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
        if a == b || self.is_told(a, b) || self.range(g, a).high <= self.range(g, b).low {
            return true;
        }
        if depth == 0 {
            return false;
        }
        let is = |known: &mut Self, x, y| known.is_ordered(g, x, y, depth - 1);
        // a share of a number that is not negative
        if let Node::Mul(p, q) = g.nodes[a as usize]
            && self.range(g, p).low.min(self.range(g, q).low) >= 0.0
            && (is(self, p, b) && is(self, q, ONE) || is(self, q, b) && is(self, p, ONE))
        {
            return true;
        }
        // a sum of a number that is not positive, and another
        if let Node::Add(p, q) = g.nodes[a as usize]
            && (self.range(g, p).high <= 0.0 && is(self, q, b)
                || self.range(g, q).high <= 0.0 && is(self, p, b))
        {
            return true;
        }
        // another, and a sum of it and a number that is not negative
        if let Node::Add(r, s) = g.nodes[b as usize]
            && (self.range(g, r).low >= 0.0 && is(self, a, s)
                || self.range(g, s).low >= 0.0 && is(self, a, r))
        {
            return true;
        }
        // what is selected below an edge, and what is selected of a number that is not less
        if let Node::Select(Test::Above(edge, x), below, other) = g.nodes[a as usize]
            && let Node::Select(Test::Above(same, y), less, more) = g.nodes[b as usize]
            && edge == same
            && is(self, below, less)
            && (x == y || !self.range(g, x).nan && is(self, x, y) && is(self, below, more))
            && is(self, other, more)
        {
            return true;
        }
        match (g.nodes[a as usize], g.nodes[b as usize]) {
            (Node::Add(p, q), Node::Add(r, s)) => {
                is(self, p, r) && is(self, q, s) || is(self, p, s) && is(self, q, r)
            }
            (Node::Sub(p, q), Node::Sub(r, s)) => is(self, p, r) && is(self, s, q),
            (Node::Mul(p, q), Node::Mul(r, s)) => {
                self.range(g, p).low.min(self.range(g, q).low) >= 0.0
                    && (is(self, p, r) && is(self, q, s) || is(self, p, s) && is(self, q, r))
            }
            // 1/−0 is −∞
            (Node::Div(p, q), Node::Div(r, s)) => {
                (q == s || self.range(g, p).low >= 0.0)
                    && self.is_plus(g, s)
                    && is(self, p, r)
                    && is(self, s, q)
            }
            // a minimum passes over a limit that is NaN, and a maximum over a number that is NaN
            (x, y) => {
                let of_first = match limit(x) {
                    Some(Limit::Most(x, l)) => {
                        is(self, x, b) || !self.range(g, l).nan && is(self, l, b)
                    }
                    Some(Limit::Least(x, l)) => is(self, x, b) && is(self, l, b),
                    None => false,
                };
                match limit(y) {
                    _ if of_first => true,
                    Some(Limit::Most(y, m)) => is(self, a, y) && is(self, a, m),
                    Some(Limit::Least(y, m)) => {
                        is(self, a, m) || !self.range(g, y).nan && is(self, a, y)
                    }
                    None => false,
                }
            }
        }
    }
}

/// A number, and the most or the least that is selected instead of it.
enum Limit {
    Most(u32, u32),
    Least(u32, u32),
}

fn limit(node: Node) -> Option<Limit> {
    match node {
        Node::Select(Test::Above(x, y), a, b) if (a, b) == (x, y) => Some(Limit::Least(x, y)),
        Node::Select(Test::Above(x, y), a, b) if (a, b) == (y, x) => Some(Limit::Most(x, y)),
        _ => None,
    }
}
