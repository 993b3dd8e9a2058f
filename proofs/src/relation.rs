//! What is known of several nodes together, which intervals forget: of a vector and its square, of products
//! and the roots that divide them, of two dot products that share a vector.
//!
//! Below, u is the unit roundoff and η the smallest number above 0. A rounded result is x(1 + θ) + δ with
//! |θ| ≤ u and |δ| ≤ η/2, unless it overflows; δ = 0 for sums, differences and roots. Bounds are computed in
//! `f64`, whose own roundings the factors cover, too: they are wider than the derivations by at least 6 u.

use std::cell::Cell;

use super::graph::{Graph, Node, ONE, Test};
use super::known::{INF, Known, at_least, at_most, get};
use super::range::Range;

/// How many operations inside one another a share follows.
const DEPTH: u32 = 6;

thread_local!(static ARE_USED: Cell<bool> = const { Cell::new(true) });

/// Runs without any of these rules, with intervals alone.
pub(super) fn without<R>(f: impl FnOnce() -> R) -> R {
    ARE_USED.set(false);
    let result = f();
    ARE_USED.set(true);
    result
}

/// A multiple of a difference: (to · shrink − from · shrink) · grow, where both factors are powers of two.
struct Rescaled {
    difference: u32,
    shrink: f64,
    grow: f64,
}

impl Known {
    /// The values of a node, given those that its operation alone leaves.
    pub(super) fn related(&mut self, g: &Graph, id: u32, range: Range) -> Range {
        if !ARE_USED.get() {
            return range;
        }
        match g.nodes[id as usize] {
            Node::Add(..) => {
                let range = self.no_longer_than_its_vectors(g, id, range);
                let range = self.no_shorter_than_unscaled(g, id, range);
                let range = self.square_of_mirrored(g, id, range);
                if self.is_behind(g, id) {
                    range.meet(at_most(0.0).or_nan())
                } else {
                    range
                }
            }
            Node::Sub(..) => {
                let range = self.no_longer_than_its_vectors(g, id, range);
                let range = self.component_of_mirrored(g, id, range);
                self.like_unscaled(g, id, range)
            }
            Node::Mul(a, b) if a != b => {
                let limit = self.component(g, a, b).min(self.component(g, b, a));
                let limit = up(g, limit);
                range.meet(Range::within(-limit, limit).or_nan())
            }
            Node::Div(a, b) => {
                let limit = self.most(g, a, b) * (1.0 + 4.0 * g.format.u()) + g.format.tiny();
                let limit = up(g, limit).min(self.slope(g, id, a, b));
                // a ≥ b > 0 makes a/b ≥ 1
                let is_above =
                    self.range(g, b).low > 0.0 && self.answer(g, Test::AtMost(b, a)) == Some(true);
                let least = if is_above { 1.0 } else { -limit };
                range.meet(Range::within(least, limit).or_nan())
            }
            _ => range,
        }
    }

    /// Whether a ≤ b, if neither is NaN.
    pub(super) fn is_related(&mut self, g: &Graph, a: u32, b: u32) -> bool {
        ARE_USED.get() && (self.is_below_root(g, a, b) || self.is_less_of_the_same(g, a, b))
    }

    fn is_finite(&mut self, g: &Graph, id: u32) -> bool {
        let range = self.range(g, id);
        range.low > -INF && range.high < INF
    }

    /// The most that |v · 1/root| can be. With m for the share of v, |v| ≤ m · root, and the reciprocal is
    /// at most (1 + u)/root + η/2, so the product is at most m (1 + 3u) + η, for a root below √MAX.
    fn component(&mut self, g: &Graph, v: u32, reciprocal: u32) -> f64 {
        let reciprocal = self.resolved(g, reciprocal);
        match g.nodes[reciprocal as usize] {
            Node::Div(ONE, root) if self.is_root(g, root) => {
                self.most(g, v, root) * (1.0 + 16.0 * g.format.u()) + 2.0 * g.format.tiny()
            }
            _ => INF,
        }
    }

    /// The most that |x/y| can be, if it is not NaN. If x is infinite, so is a root of x² and more, and x/y is NaN.
    fn most(&mut self, g: &Graph, x: u32, y: u32) -> f64 {
        let y = self.resolved(g, y);
        if self.range(g, y).low <= 0.0 {
            return INF;
        }
        let of_root = match g.nodes[y as usize] {
            Node::Sqrt(sum) => self.share_of_root(g, x, sum),
            _ => INF,
        };
        let is_finite = self.is_finite(g, x);
        if is_finite {
            of_root.min(self.share(g, x, y, DEPTH))
        } else {
            of_root
        }
    }

    /// The most that |a/b| can be, if it is not NaN, and if the path has compared the two, or if a is a
    /// difference of which b is the sum.
    ///
    /// - |p − q| ≤ p + q for p, q ≥ 0, and rounding is monotone.
    /// - From 0 ≤ a ≤ fl(|b|k) follows a ≤ |b|k(1 + u) + η/2, and |b| ≥ η, or a = b = 0 and a/b is NaN.
    /// - From fl(|a|k) ≤ b follows |a|k ≤ (b + η/2)(1 + 2u), and b ≥ η, or |a|k is rounded to 0, and k ≥ 1 makes a = 0.
    fn slope(&mut self, g: &Graph, id: u32, a: u32, b: u32) -> f64 {
        match (&self.combination(g, a)[..], &self.combination(g, b)[..]) {
            (&[(p, _), (q, _)], &[(r, by_r), (s, by_s)])
                if (p, q) == (r, s) || (p, q) == (s, r) =>
            {
                let mut is_added = |v, by: f64| {
                    let range = self.range(g, v);
                    !range.nan
                        && if by > 0.0 {
                            range.low >= 0.0
                        } else {
                            range.high <= 0.0
                        }
                };
                if by_r != 0.0 && by_s != 0.0 && is_added(r, by_r) && is_added(s, by_s) {
                    1.0
                } else {
                    INF
                }
            }
            (&[(a, by_a)], &[(b, by_b)]) if by_a != 0.0 && by_b != 0.0 => {
                let answers = self.facts.clone();
                let no = answers.iter().filter_map(|fact| match *fact {
                    // what lies below the node alone, so that no range asks for itself
                    (Test::Above(p, q), false) if p.max(q) < id => Some((p, q)),
                    _ => None,
                });
                let limits = no.map(|(p, q)| {
                    if p == a && self.range(g, a).low >= 0.0 && self.range(g, a).high < INF {
                        self.multiple_of_size(g, q, b)
                            .map_or(INF, |k| k * (1.0 + 8.0 * g.format.u()) + 1.0)
                    } else if q == b && self.range(g, b).low >= 0.0 {
                        self.multiple_of_size(g, p, a)
                            .filter(|k| *k >= 1.0)
                            .map_or(INF, |_| 2.0)
                    } else {
                        INF
                    }
                });
                limits.fold(INF, f64::min)
            }
            _ => INF,
        }
    }

    /// k for a node |v|k, if neither is NaN.
    fn multiple_of_size(&mut self, g: &Graph, id: u32, v: u32) -> Option<f64> {
        let Node::Mul(p, q) = g.nodes[id as usize] else {
            return None;
        };
        let size = g.find(Node::Abs(v))?;
        let k = if p == size { q } else { p };
        let is_number = (p == size || q == size) && !self.range(g, v).nan;
        self.range(g, k).only().filter(|k| is_number && *k > 0.0)
    }

    /// A sum of two terms, or one, as numbers that are added or subtracted; what is multiplied by 0 is left out.
    fn combination(&mut self, g: &Graph, id: u32) -> Vec<(u32, f64)> {
        let id = self.resolved(g, id);
        let terms = match g.nodes[id as usize] {
            Node::Add(a, b) => vec![self.signed(g, a), self.signed(g, b)],
            Node::Sub(a, b) => {
                let (b, sign) = self.signed(g, b);
                vec![self.signed(g, a), (b, -sign)]
            }
            _ => vec![self.signed(g, id)],
        };
        let is_zero =
            |known: &mut Self, v, by| by == 0.0 && known.is_finite(g, v) && !known.range(g, v).nan;
        terms
            .into_iter()
            .filter(|&(v, by)| !is_zero(self, v, by))
            .collect()
    }

    fn signed(&mut self, g: &Graph, id: u32) -> (u32, f64) {
        let id = self.resolved(g, id);
        match g.nodes[id as usize] {
            Node::Neg(a) => {
                let (v, sign) = self.signed(g, a);
                (v, -sign)
            }
            Node::Mul(a, b) => {
                for (v, k) in [(a, b), (b, a)] {
                    let k = self.range(g, k).only();
                    if let Some(k) = k.filter(|k| k.abs() == 1.0 || *k == 0.0) {
                        let (v, sign) = self.signed(g, v);
                        return (v, k * sign);
                    }
                }
                (id, 1.0)
            }
            _ => (id, 1.0),
        }
    }

    fn is_root(&mut self, g: &Graph, id: u32) -> bool {
        let id = self.resolved(g, id);
        matches!(g.nodes[id as usize], Node::Sqrt(_))
    }

    /// A number m with |x| ≤ m·y, if x is finite and y above 0.
    ///
    /// A sum that is finite has finite terms, and a product finite factors, so none of the operations that
    /// are followed overflows. Each adds a relative error of u, and a product one of η/2, which is at most
    /// η/(2y) shares of y.
    fn share(&mut self, g: &Graph, x: u32, y: u32, depth: u32) -> f64 {
        let (x, y) = (self.resolved(g, x), self.resolved(g, y));
        let (of_x, of_y, u) = (self.range(g, x), self.range(g, y), g.format.u());
        if of_y.low <= 0.0 || !of_x.has_numbers() {
            return INF;
        }
        let size = |range: Range| range.low.abs().max(range.high.abs());
        let plain = size(of_x) / of_y.low * (1.0 + 4.0 * u);
        let lost = g.format.tiny() / (2.0 * of_y.low);
        let divisor = g.nodes[y as usize];
        let (parts, of_vectors) = match divisor {
            _ if depth == 0 => return plain,
            Node::Sqrt(sum) => (None, self.share_of_root(g, x, sum)),
            Node::Mul(p, q) if self.is_root(g, p) && self.is_root(g, q) => {
                (Some((p, q)), self.share_of_roots(g, x, p, q, lost))
            }
            _ => return plain,
        };
        let mut of = |x, y| self.share(g, x, y, depth - 1);
        let of_operation = match g.nodes[x as usize] {
            Node::Neg(a) | Node::Abs(a) => of(a, y),
            Node::Select(_, a, b) => of(a, y).max(of(b, y)),
            Node::Add(a, b) | Node::Sub(a, b) => (of(a, y) + of(b, y)) * (1.0 + 4.0 * u),
            Node::Mul(a, b) => {
                // y ≥ pq (1 − u) − η/2, so pq ≤ y (1 + lost)(1 + 2u)
                let of_parts = parts.map_or(INF, |(p, q)| {
                    let straight = of(a, p) * of(b, q);
                    straight.min(of(a, q) * of(b, p)) * (1.0 + lost)
                });
                let (of_a, of_b) = (of(a, y), of(b, y));
                let by_size = (of_a * size(self.range(g, b))).min(of_b * size(self.range(g, a)));
                of_parts.min(by_size) * (1.0 + 16.0 * u) + lost
            }
            _ => INF,
        };
        // 0 · ∞ is NaN, which `min` passes over
        plain.min(of_vectors).min(of_operation)
    }

    /// The share of x in the root of a sum of x² and of numbers that are not negative.
    ///
    /// The sum S is at least the rounded x², which is at least x² (1 − u) − η/2. So x² ≤ (S + η/2)(1 + 2u), and
    /// the root is at least √S (1 − u).
    fn share_of_root(&mut self, g: &Graph, x: u32, sum: u32) -> f64 {
        let (mut found, mut terms) = (false, vec![sum]);
        while let Some(term) = terms.pop() {
            match g.nodes[term as usize] {
                Node::Mul(p, q) if p == x && q == x => found = true,
                Node::Add(p, q) => terms.extend([p, q]),
                _ if self.range(g, term).low >= 0.0 => {}
                _ => return INF,
            }
        }
        let f = g.format;
        let least = self.range(g, sum).low.max(f.tiny());
        if found {
            (1.0 + f.tiny() / (2.0 * least)).sqrt() * (1.0 + 16.0 * f.u())
        } else {
            INF
        }
    }

    /// The share of Σ aᵢbᵢ in |a||b|, which are the roots p and q of the computed squares A and B (Cauchy and
    /// Schwarz).
    ///
    /// Rounding takes from a square no more than A ≥ |a|² (1 − u)³ − 2η, and so |a| ≤ √A √(1 + 2η/A) (1 + 2u).
    /// The root loses a factor of 1 − u, and the product of the roots another and η/2. The sum of
    /// the products is at most |a||b| (1 + u)³ + 2η. All factors together are below 1 + 14u.
    fn share_of_roots(&mut self, g: &Graph, x: u32, p: u32, q: u32, lost: f64) -> f64 {
        let [p, q] = [p, q].map(|id| self.resolved(g, id));
        let (Node::Sqrt(of_a), Node::Sqrt(of_b)) = (g.nodes[p as usize], g.nodes[q as usize])
        else {
            return INF;
        };
        let pairs = products(g, x).map_or(vec![], orientations);
        let of_vectors =
            |(a, b): &([u32; 3], [u32; 3])| is_square(g, of_a, *a) && is_square(g, of_b, *b);
        if !pairs.iter().any(of_vectors) {
            return INF;
        }
        let f = g.format;
        let mut flat = |square| {
            let least = self.range(g, square).low.max(f.tiny());
            (1.0 + 2.0 * f.tiny() / least).sqrt()
        };
        flat(of_a) * flat(of_b) * (1.0 + lost) * (1.0 + 24.0 * f.u()) + 4.0 * lost
    }

    /// |Σ aᵢbᵢ| ≤ |a||b|, where the squares of a and b were computed and found to be small.
    ///
    /// A computed square S is at least |a|²(1 − u)³ − 3η, and the computed sum is at most |a||b|(1 + u)³ + 3η,
    /// together |a||b|(1 + 6u). The factors below stand for both.
    fn no_longer_than_its_vectors(&mut self, g: &Graph, id: u32, range: Range) -> Range {
        let f = g.format;
        let pairs = products(g, id).map_or(vec![], orientations);
        let mut limit = INF;
        for (a, b) in pairs {
            let square = |v| {
                let shown = squares(g, v)
                    .into_iter()
                    .find_map(|node| get(&self.shown, node));
                shown
                    .filter(|shown| !shown.nan)
                    .map(|shown| shown.high + 3.0 * f.tiny())
            };
            if let (Some(a), Some(b)) = (square(a), square(b)) {
                let product = (a.sqrt() * b.sqrt()) * (1.0 + 16.0 * f.u()) + 3.0 * f.tiny();
                // √(ab) ≤ (a + b)/2; `up` covers what these sums round
                let mean = 0.5 * a + 0.5 * b;
                let mean = mean + (6.5 * f.u()) * mean + 3.0 * f.tiny();
                limit = limit.min(up(g, product.min(mean)));
            }
        }
        if limit >= f.max() {
            return range;
        }
        range.meet(Range::within(-limit, limit))
    }

    /// The difference of two numbers times 1, a factor that may be known of this path alone.
    fn like_unscaled(&mut self, g: &Graph, id: u32, range: Range) -> Range {
        match self.rescaled(g, id) {
            Some(Rescaled {
                difference,
                shrink: 1.0,
                grow: 1.0,
            }) if difference < id => range.meet(self.range(g, difference)),
            _ => range,
        }
    }

    /// |σd|² ≥ σ²|d|², where the square of the differences d was computed and is known to be large.
    ///
    /// With e for the exact differences, the computed square is at most |e|² (1 + u)⁵ + 2η, unless it overflows,
    /// and then |e|² is at least the largest number but for such a factor. A rescaled component is
    /// g((s e + δ)(1 + θ)), |δ| ≤ η, rounded once more; its square loses what `share_of_roots` says.
    fn no_shorter_than_unscaled(&mut self, g: &Graph, id: u32, range: Range) -> Range {
        let f = g.format;
        let Some((d, shrink, grow)) = self.rescaled_square(g, id) else {
            return range;
        };
        let square = self.least_square(g, id, d);
        let (u, tiny) = (f.u(), f.tiny());
        let length = ((square.min(f.max()) - 2.0 * tiny).max(0.0) * (1.0 - 16.0 * u)).sqrt();
        let rescaled = grow * (shrink * length * (1.0 - 16.0 * u) - 2.0 * tiny) - 2.0 * tiny;
        if rescaled <= 0.0 || !rescaled.is_finite() {
            return range;
        }
        let least = rescaled * rescaled * (1.0 - 16.0 * u) - 4.0 * tiny;
        range.meet(at_least(f.next_down(f.round(least.min(f.max())))).or_nan())
    }

    /// The least that |v|² can be, if it was recorded before this node.
    fn least_square(&mut self, g: &Graph, id: u32, v: [u32; 3]) -> f64 {
        let recorded = squares(g, v).into_iter().filter(|square| *square < id);
        let known: Vec<Range> = recorded.map(|square| self.range(g, square)).collect();
        known
            .iter()
            .filter(|square| !square.nan)
            .fold(0.0, |least, square| square.low.max(least))
    }

    /// The differences of which a sum of three squares is the rescaled square, and their two factors.
    fn rescaled_square(&mut self, g: &Graph, id: u32) -> Option<([u32; 3], f64, f64)> {
        let factors = products(g, id)?;
        if factors.iter().any(|[p, q]| p != q) {
            return None;
        }
        self.rescaled_vector(g, factors.map(|[p, _]| p))
    }

    fn rescaled_vector(&mut self, g: &Graph, v: [u32; 3]) -> Option<([u32; 3], f64, f64)> {
        let [x, y, z] = v.map(|id| self.rescaled(g, id));
        let (x, y, z) = (x?, y?, z?);
        let same = |of: fn(&Rescaled) -> f64| of(&x) == of(&y) && of(&y) == of(&z);
        let is_one_factor = same(|v| v.shrink) && same(|v| v.grow);
        is_one_factor.then_some(([x.difference, y.difference, z.difference], x.shrink, x.grow))
    }

    fn rescaled(&mut self, g: &Graph, id: u32) -> Option<Rescaled> {
        let (inner, grow) = self.without_factor(g, id);
        let (difference, shrink) = match g.nodes[inner as usize] {
            Node::Sub(to, from) => {
                let ((to, shrink), (from, same)) =
                    (self.without_factor(g, to), self.without_factor(g, from));
                let difference = g.find(Node::Sub(to, from)).filter(|_| shrink == same);
                difference.map_or((inner, 1.0), |difference| (difference, shrink))
            }
            _ => (inner, 1.0),
        };
        (shrink <= 1.0 && grow >= 1.0).then_some(Rescaled {
            difference,
            shrink,
            grow,
        })
    }

    /// A product with a power of two, which may be known of this path alone, as its factors.
    fn without_factor(&mut self, g: &Graph, id: u32) -> (u32, f64) {
        let id = self.resolved(g, id);
        if let Node::Mul(a, b) = g.nodes[id as usize] {
            for (x, k) in [(a, b), (b, a)] {
                if let Some(k) = self.range(g, k).only().filter(|k| is_power_of_two(*k)) {
                    let (x, more) = self.without_factor(g, x);
                    if (k <= 1.0) == (more <= 1.0) || k == 1.0 || more == 1.0 {
                        return (x, k * more);
                    }
                    return (id, 1.0);
                }
            }
        }
        (id, 1.0)
    }

    /// Whether Σ nᵢwᵢ ≤ 0, or NaN, because w = σd/|σd| and the path found Σ nᵢdᵢ < c Σ|dᵢ| − t, for a c below 0 and
    /// a t above 0 that exceed all rounding errors.
    ///
    /// Let E = Σ|dᵢ|, exactly, P = Σ nᵢdᵢ, exactly, and M ≥ |nᵢ|, at most 1 + 2⁻¹⁰.
    ///
    /// - The computed sum of |dᵢ| is at least E(1 − u)², so the threshold is at most −|c|E(1 − 4u) − (t − η)(1 − u).
    /// - The computed dot product differs from P by at most 4uME + 2η. So P < −(|c| − 8u)E. Only if it overflows to
    ///   −∞ is there no such bound; then the negative terms alone sum to MAX (1 − 4u), all terms to no more than
    ///   ME ≤ (1 + 2⁻¹⁰)(1 + 4u) MAX in size, because the sum of |dᵢ| is finite, and P ≤ −0.9 E.
    /// - A component of σd is σdᵢ(1 + 4u) + 2ηg, where g is the factor that scales up, or 0 if none scales down
    ///   before, and w that times r, the rounded reciprocal of the length, once more rounded. So nᵢwᵢ is σr nᵢdᵢ up to 5u σrM|dᵢ| + 3ηM(gr + 1), and the
    ///   computed sum of the three is at most σr P + 12u σrME + 16η(gr + 1).
    /// - E is at least |d|, which is at least the length over σ, but for 8u and for what underflow adds to the
    ///   length: no more than 3ηg + √(3η). If that is below a hundredth of σE, σrE ≥ 0.9.
    ///
    /// Together the sum is below −0.9 (|c| − 32u) + 16η(gr + 1). If the length is ∞, r and w are 0.
    fn is_behind(&mut self, g: &Graph, id: u32) -> bool {
        let thresholds = self.facts.iter().filter_map(|fact| match *fact {
            (Test::Above(threshold, dot), true) => Some((threshold, dot)),
            _ => None,
        });
        let thresholds: Vec<_> = thresholds
            .filter(|(threshold, dot)| {
                // what lies below the node alone, so that no range asks for itself
                *threshold < id
                    && matches!(g.nodes[*threshold as usize], Node::Sub(..))
                    && products(g, *dot).is_some()
            })
            .collect();
        if thresholds.is_empty() || !is_sum(g, id) {
            return false;
        }
        let pairs = products(g, id).map_or(vec![], all_orientations);
        thresholds.into_iter().any(|(threshold, dot)| {
            pairs
                .iter()
                .any(|&pair| self.is_turned_away(g, id, (threshold, dot), pair))
        })
    }

    fn is_turned_away(
        &mut self,
        g: &Graph,
        id: u32,
        (threshold, dot): (u32, u32),
        (n, w): Pair,
    ) -> bool {
        let (u, tiny) = (g.format.u(), g.format.tiny());
        let Some((v, r, root_of)) = self.divided(g, w) else {
            return false;
        };
        let Some((d, shrink, grow)) = self.rescaled_vector(g, v) else {
            return false;
        };
        let is_dot = |(a, b): &([u32; 3], [u32; 3])| *a == n && *b == d;
        let of_dot = products(g, dot).map_or(vec![], all_orientations);
        let Some((c, t)) = self.threshold(g, threshold, d) else {
            return false;
        };
        if !is_square(g, root_of, v) || !is_sum(g, dot) || !of_dot.iter().any(is_dot) {
            return false;
        }
        let are_finite = d.iter().all(|d| self.is_finite(g, *d))
            && w.iter()
                .all(|w| self.range(g, *w).meet(Range::ANY).abs().high <= 4.0);
        let are_short = n
            .iter()
            .all(|n| self.range(g, *n).abs().high <= 1.0 + 2.0_f64.powi(-10));
        let r = self.range(g, r);
        let square = self.least_square(g, id, d);
        let size = (square.min(g.format.max()).sqrt() * (1.0 - 16.0 * u)).max(tiny);
        let lost = if shrink < 1.0 { grow } else { 0.0 };
        let added = 3.0 * tiny * lost + (3.0 * tiny).sqrt();
        are_finite
            && are_short
            && r.low >= 0.0
            && t > 4.0 * tiny
            && size * shrink * grow > 100.0 * added
            && 0.9 * (-c - 32.0 * u) > 16.0 * tiny * (lost * r.high + 1.0)
    }

    /// c and t of a threshold c Σ|dᵢ| − t.
    fn threshold(&mut self, g: &Graph, id: u32, d: [u32; 3]) -> Option<(f64, f64)> {
        let Node::Sub(product, t) = g.nodes[id as usize] else {
            return None;
        };
        let Node::Mul(a, b) = g.nodes[product as usize] else {
            return None;
        };
        let sizes = d.map(|d| g.find(Node::Abs(d)));
        let [Some(x), Some(y), Some(z)] = sizes else {
            return None;
        };
        let (sum, c) = if is_sum(g, a) { (a, b) } else { (b, a) };
        let is_size = is_sum(g, sum) && sorted(terms(g, sum)?) == sorted([x, y, z]);
        let c = self.range(g, c).only().filter(|_| is_size)?;
        Some((c, self.range(g, t).low))
    }

    /// A vector of which each component is multiplied by 1/√S: the vector, 1/√S, and S.
    fn divided(&mut self, g: &Graph, w: [u32; 3]) -> Option<([u32; 3], u32, u32)> {
        let mut reciprocal = None;
        let mut v = w;
        for component in &mut v {
            let product = self.resolved(g, *component);
            let Node::Mul(a, b) = g.nodes[product as usize] else {
                return None;
            };
            let is_reciprocal = |id: u32| matches!(g.nodes[id as usize], Node::Div(ONE, _));
            let (c, r) = if is_reciprocal(b) { (a, b) } else { (b, a) };
            if *reciprocal.get_or_insert(r) != r {
                return None;
            }
            *component = c;
        }
        let Node::Div(ONE, root) = g.nodes[reciprocal? as usize] else {
            return None;
        };
        let root = self.resolved(g, root);
        match g.nodes[root as usize] {
            Node::Sqrt(square) => Some((v, reciprocal?, square)),
            _ => None,
        }
    }

    /// The ends that lie between 0 and the least multiple which the node can be.
    pub(super) fn in_steps(&mut self, g: &Graph, id: u32, range: Range) -> Range {
        if !ARE_USED.get() {
            return range;
        }
        let small = 8.0 / g.format.extreme().sqrt();
        let is_small = |x: f64| x != 0.0 && x.abs() < small;
        if !is_small(range.low) && !is_small(range.high) {
            return range;
        }
        let step = self.step(g, id, DEPTH);
        let low = match range.low {
            low if 0.0 < low && low < step => step,
            low if -step < low && low < 0.0 => 0.0,
            low => low,
        };
        let high = match range.high {
            high if 0.0 < high && high < step => 0.0,
            high if -step < high && high < 0.0 => -step,
            high => high,
        };
        range.meet(Range::within(low, high).or_nan())
    }

    /// A power of two of which every value is a multiple. Rounding keeps that: the floats of a size that rounding
    /// takes digits from are multiples of a larger power.
    fn step(&mut self, g: &Graph, id: u32, depth: u32) -> f64 {
        let id = self.resolved(g, id);
        let mut of = |id| self.step(g, id, depth - 1);
        let step = match g.nodes[id as usize] {
            _ if depth == 0 => 0.0,
            Node::Neg(a) | Node::Abs(a) => of(a),
            Node::Add(a, b) | Node::Sub(a, b) | Node::Select(_, a, b) => of(a).min(of(b)),
            Node::Mul(a, b) => {
                let mut factor = |id, other: u32| {
                    let k = self
                        .range(g, id)
                        .only()
                        .filter(|k| is_power_of_two(*k) && *k >= 1.0);
                    k.map(|k| k * self.step(g, other, depth - 1))
                };
                let by_factor = factor(a, b).or_else(|| factor(b, a));
                by_factor.unwrap_or_else(|| self.step(g, a, depth - 1) * self.step(g, b, depth - 1))
            }
            _ => 0.0,
        };
        if step < INF {
            step.max(g.format.tiny())
        } else {
            g.format.tiny()
        }
    }

    /// Whether x·k ≤ y·k, because x ≤ y and k is not negative.
    fn is_less_of_the_same(&mut self, g: &Graph, a: u32, b: u32) -> bool {
        let (Node::Mul(a, c), Node::Mul(b, d)) = (g.nodes[a as usize], g.nodes[b as usize]) else {
            return false;
        };
        [(a, c, b, d), (c, a, b, d), (a, c, d, b), (c, a, d, b)]
            .into_iter()
            .any(|(x, k, y, l)| {
                k == l
                    && self.range(g, k).low >= 0.0
                    && self.answer(g, Test::AtMost(x, y)) == Some(true)
            })
    }

    /// Whether r ≤ √s, because s is known to exceed the rounded r².
    ///
    /// If s > fl(r²), then s > r²: otherwise the float s ≤ r² would be at most fl(r²). So √s > r, and
    /// the rounded root of s is at least r.
    fn is_below_root(&mut self, g: &Graph, r: u32, root: u32) -> bool {
        let Node::Sqrt(s) = g.nodes[root as usize] else {
            return false;
        };
        let Some(square) = g.find(Node::Mul(r, r)) else {
            return false;
        };
        let facts = self.facts.clone();
        facts.into_iter().any(|fact| match fact {
            (Test::Above(a, b), true) if a == s => match g.nodes[b as usize] {
                _ if b == square => true,
                Node::Add(x, y) => {
                    x == square && self.range(g, y).low >= 0.0
                        || y == square && self.range(g, x).low >= 0.0
                }
                _ => false,
            },
            _ => false,
        })
    }
}

/// A float of the format that is not below a number.
pub(super) fn up(g: &Graph, x: f64) -> f64 {
    g.format.next_up(g.format.round(x))
}

fn is_power_of_two(x: f64) -> bool {
    const FRACTION: u64 = (1 << 52) - 1;
    x.is_normal() && x > 0.0 && x.to_bits() & FRACTION == 0
}

fn sorted([a, b, c]: [u32; 3]) -> [u32; 3] {
    let mut list = [a, b, c];
    list.sort_unstable();
    list
}

/// Whether three terms are added, and none is subtracted.
pub(super) fn is_sum(g: &Graph, id: u32) -> bool {
    let is_add = |id: u32| matches!(g.nodes[id as usize], Node::Add(..));
    match g.nodes[id as usize] {
        Node::Add(a, b) => is_add(a) != is_add(b),
        _ => false,
    }
}

/// The terms of a sum of three, or of their opposites.
fn terms(g: &Graph, id: u32) -> Option<[u32; 3]> {
    let of = |id: u32| {
        let inner = match g.nodes[id as usize] {
            Node::Neg(a) => a,
            _ => id,
        };
        match g.nodes[inner as usize] {
            Node::Add(a, b) | Node::Sub(a, b) => Some([a, b]),
            _ => None,
        }
    };
    let [a, b] = of(id)?;
    match (of(a), of(b)) {
        (Some([x, y]), None) => Some([x, y, b]),
        (None, Some([x, y])) => Some([x, y, a]),
        _ => None,
    }
}

/// The factors of a sum of three products, or of their opposites.
pub(super) fn products(g: &Graph, id: u32) -> Option<[[u32; 2]; 3]> {
    let factors = |id: u32| match g.nodes[id as usize] {
        Node::Mul(a, b) => Some([a, b]),
        Node::Neg(a) => match g.nodes[a as usize] {
            Node::Mul(a, b) => Some([a, b]),
            _ => None,
        },
        _ => None,
    };
    let [x, y, z] = terms(g, id)?.map(factors);
    Some([x?, y?, z?])
}

pub(super) type Pair = ([u32; 3], [u32; 3]);

/// The pairs of vectors of which three products can be the dot product, each pair once.
fn orientations(products: [[u32; 2]; 3]) -> Vec<Pair> {
    let mut pairs: Vec<Pair> = (0..4_usize)
        .map(|turned| {
            let of = |i: usize, side: usize| products[i][(turned >> i & 1) ^ side];
            let vector = |side| [of(0, side), of(1, side), of(2, side)];
            (vector(0), vector(1))
        })
        .collect();
    pairs.dedup();
    pairs
}

/// The same with either vector first.
pub(super) fn all_orientations(products: [[u32; 2]; 3]) -> Vec<Pair> {
    let pairs = orientations(products);
    pairs.iter().flat_map(|&(a, b)| [(a, b), (b, a)]).collect()
}

/// Whether a sum is that of the squares of three numbers.
fn is_square(g: &Graph, sum: u32, v: [u32; 3]) -> bool {
    products(g, sum).is_some_and(|factors| {
        is_sum(g, sum)
            && factors.iter().all(|[p, q]| p == q)
            && sorted(factors.map(|[p, _]| p)) == sorted(v)
    })
}

/// The nodes of x² + y² + z², in whichever order it was recorded.
pub(super) fn squares(g: &Graph, v: [u32; 3]) -> Vec<u32> {
    let [Some(x), Some(y), Some(z)] = v.map(|c| g.find(Node::Mul(c, c))) else {
        return vec![];
    };
    let sum = |a: u32, b: u32| g.find(Node::Add(a, b));
    let orders = [(x, y, z), (x, z, y), (y, z, x)];
    orders
        .into_iter()
        .filter_map(|(a, b, c)| sum(a, b).and_then(|ab| sum(ab, c)))
        .collect()
}
