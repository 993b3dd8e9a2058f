//! What a path has shown about the nodes of a graph.

use std::collections::HashMap;

use super::format::Format;
use super::graph::{Function, Graph, Node, Test};
use super::range::Range;

pub(super) const INF: f64 = f64::INFINITY;

/// How many selections inside one another are tried both ways with all that follows.
const DEPTH: u32 = 3;

#[doc(hidden)]
#[derive(Clone, Default)]
pub struct Known {
    pub(super) shown: Vec<Option<Range>>,
    pub(super) facts: Vec<(Test, bool)>,
    memo: Vec<Option<Range>>,
    depth: u32,
    pub impossible: bool,
}

fn constant(x: f64) -> Range {
    Range {
        low: x,
        high: x,
        nan: x.is_nan(),
        minus_zero: x == 0.0 && x.is_sign_negative(),
        finite: x.is_finite(),
    }
}

fn above(x: f64, f: Format) -> Range {
    Range::within(f.next_up(x), INF)
}

fn below(x: f64, f: Format) -> Range {
    Range::within(-INF, f.next_down(x))
}

pub(super) fn at_most(x: f64) -> Range {
    Range::within(-INF, x)
}

pub(super) fn at_least(x: f64) -> Range {
    Range::within(x, INF)
}

pub(super) fn get(list: &[Option<Range>], id: u32) -> Option<Range> {
    list.get(id as usize).copied().flatten()
}

fn set(list: &mut Vec<Option<Range>>, id: u32, range: Range) {
    let id = id as usize;
    if list.len() <= id {
        list.resize(id + 1, None);
    }
    list[id] = Some(range);
}

impl Known {
    /// The node itself, or what a decided selection selects.
    pub fn resolved(&mut self, g: &Graph, id: u32) -> u32 {
        let Node::Select(test, then, otherwise) = g.nodes[id as usize] else {
            return id;
        };
        if let Some(answer) = self.answer(g, test) {
            return self.resolved(g, if answer { then } else { otherwise });
        }
        // max(x, 0) is x, if x is neither negative nor −0 nor NaN
        let x = self.range(g, then);
        let is_maximum = test == Test::Above(then, 0) && otherwise == 0;
        if is_maximum && x.low >= 0.0 && !x.minus_zero && !x.nan {
            self.resolved(g, then)
        } else {
            id
        }
    }

    /// The node that has the same bits once the decided selections are made, if it has been recorded.
    pub(super) fn twin(&mut self, g: &Graph, id: u32) -> u32 {
        self.twin_but(g, id, &mut HashMap::new())
    }

    fn twin_but(&mut self, g: &Graph, id: u32, found: &mut HashMap<u32, u32>) -> u32 {
        if let Some(&twin) = found.get(&id) {
            return twin;
        }
        let resolved = self.resolved(g, id);
        let mut of = |id| self.twin_but(g, id, found);
        let node = match g.nodes[resolved as usize] {
            Node::Neg(a) => Node::Neg(of(a)),
            Node::Abs(a) => Node::Abs(of(a)),
            Node::Sqrt(a) => Node::Sqrt(of(a)),
            Node::Call(function, a) => Node::Call(function, of(a)),
            Node::Add(a, b) => Node::Add(of(a), of(b)),
            Node::Sub(a, b) => Node::Sub(of(a), of(b)),
            Node::Mul(a, b) => Node::Mul(of(a), of(b)),
            Node::Div(a, b) => Node::Div(of(a), of(b)),
            node => node,
        };
        let twin = g.find(node).unwrap_or(resolved);
        found.insert(id, twin);
        twin
    }

    /// Whether two nodes have the same bits on this path; any NaN is as good as another.
    pub fn same(&mut self, g: &Graph, a: u32, b: u32) -> bool {
        let (a, b) = (self.resolved(g, a), self.resolved(g, b));
        let (x, y) = (self.range(g, a), self.range(g, b));
        if a == b || x == y && (x.only().is_some() || x == Range::NAN) {
            return true;
        }
        let is_zero = |x: Range| x.only() == Some(0.0) && !x.minus_zero;
        match (g.nodes[a as usize], g.nodes[b as usize]) {
            // x + 0 = x, unless x is −0
            (Node::Add(c, d), _) if is_zero(self.range(g, d)) && !self.range(g, c).minus_zero => {
                self.same(g, c, b)
            }
            (Node::Add(c, d), _) if is_zero(self.range(g, c)) && !self.range(g, d).minus_zero => {
                self.same(g, d, b)
            }
            (_, Node::Add(..)) if !matches!(g.nodes[a as usize], Node::Add(..)) => {
                self.same_sum(g, b, a)
            }
            (Node::Mul(c, d), _) if self.range(g, d).only() == Some(1.0) => self.same(g, c, b),
            (Node::Mul(c, d), _) if self.range(g, c).only() == Some(1.0) => self.same(g, d, b),
            (Node::Mul(c, d), Node::Mul(e, f)) | (Node::Add(c, d), Node::Add(e, f)) => {
                self.same(g, c, e) && self.same(g, d, f) || self.same(g, c, f) && self.same(g, d, e)
            }
            (Node::Div(c, d), Node::Div(e, f)) | (Node::Sub(c, d), Node::Sub(e, f)) => {
                self.same(g, c, e) && self.same(g, d, f)
            }
            (Node::Sqrt(c), Node::Sqrt(d)) | (Node::Neg(c), Node::Neg(d)) => self.same(g, c, d),
            (Node::Power(c, m), Node::Power(d, n)) => self.same(g, c, d) && self.same(g, m, n),
            _ => false,
        }
    }

    fn same_sum(&mut self, g: &Graph, sum: u32, other: u32) -> bool {
        let Node::Add(c, d) = g.nodes[sum as usize] else {
            return false;
        };
        [(c, d), (d, c)].into_iter().any(|(x, zero)| {
            let zero = self.range(g, zero);
            zero.only() == Some(0.0)
                && !zero.minus_zero
                && !self.range(g, x).minus_zero
                && self.same(g, x, other)
        })
    }

    /// The values that a node can have on this path.
    pub fn range(&mut self, g: &Graph, id: u32) -> Range {
        if let Some(range) = get(&self.memo, id) {
            return range;
        }
        let derived = self.derived(g, id);
        let mut range = self.related(g, id, derived);
        if let Some(shown) = get(&self.shown, id) {
            range = range.meet(shown);
        }
        for mirror in g.mirrors(id) {
            if let Some(shown) = get(&self.shown, mirror) {
                range = range.meet(shown.opposite().with_zeros());
            }
        }
        let range = self.in_steps(g, id, range);
        set(&mut self.memo, id, range);
        range
    }

    /// Whether no values remain for a node.
    pub(super) fn is_impossible(&mut self, g: &Graph) -> bool {
        let shown = (0..)
            .zip(&self.shown)
            .filter_map(|(id, shown)| shown.map(|_| id));
        let shown: Vec<u32> = shown.collect();
        self.impossible |= shown.into_iter().any(|id| self.range(g, id).is_empty());
        self.impossible
    }

    fn derived(&mut self, g: &Graph, id: u32) -> Range {
        let f = g.format;
        match g.nodes[id as usize] {
            Node::Var(index) => g.names[index as usize].1,
            Node::Constant(bits) => constant(f64::from_bits(bits)),
            Node::Max => constant(f.max()),
            Node::Extreme => constant(f.extreme()),
            Node::Neg(a) => self.range(g, a).opposite(),
            Node::Abs(a) => self.range(g, a).abs(),
            Node::Sqrt(a) => self.range(g, a).sqrt(f),
            Node::Add(a, b) => self.range(g, a).add(self.range(g, b), f),
            Node::Sub(a, b) if a == b => {
                let a = self.range(g, a);
                let is_lost = a.nan || a.low == -INF || a.high == INF;
                let zero = if a.finite { constant(0.0) } else { Range::NONE };
                Range {
                    nan: is_lost,
                    ..zero
                }
            }
            Node::Sub(a, b) => self.range(g, a).sub(self.range(g, b), f),
            Node::Mul(a, b) if a == b => self.range(g, a).square(f),
            Node::Mul(a, b) => self.range(g, a).mul(self.range(g, b), f),
            Node::Div(a, b) => self.range(g, a).div(self.range(g, b), f),
            Node::Select(test, then, otherwise) => self.selected(g, test, then, otherwise),
            Node::Call(function, a) => called(function, self.range(g, a)),
            Node::Power(cosine, m) => {
                let (cosine, m) = (self.range(g, cosine), self.range(g, m));
                let is_lit = cosine.low > 0.0 && !cosine.nan;
                let is_dark = cosine.high <= 0.0 || !cosine.has_numbers();
                let is_flat = m.high <= 0.0 || !m.has_numbers();
                match (is_dark, is_lit && is_flat) {
                    (true, _) => constant(0.0),
                    (_, true) => constant(1.0),
                    // cᵐ ≥ c
                    _ if is_lit && m.high <= 1.0 => {
                        Range::unsigned(cosine.low.min(1.0) - 2.0_f64.powi(-20), 1.0)
                    }
                    _ => Range::unsigned(0.0, 1.0),
                }
            }
        }
    }

    fn selected(&mut self, g: &Graph, test: Test, then: u32, otherwise: u32) -> Range {
        if let Some(answer) = self.answer(g, test) {
            return self.range(g, if answer { then } else { otherwise });
        }
        if self.depth < DEPTH {
            let branch = |answer, result| {
                let mut known = self.clone();
                known.depth += 1;
                known.refine(g, test, answer);
                if known.impossible {
                    Range::NONE
                } else {
                    known.range(g, result)
                }
            };
            return branch(true, then).join(branch(false, otherwise));
        }
        let (mut x, mut y) = (self.range(g, then), self.range(g, otherwise));
        if let Test::Above(a, b) = test {
            let (of_a, of_b) = (self.range(g, a), self.range(g, b));
            let meet = |node, is_above: bool, range: Range| match (node == a, node == b) {
                (true, _) if is_above => range.meet(above(of_b.low, g.format)),
                (_, true) if is_above => range.meet(below(of_a.high, g.format)),
                (true, _) if !of_b.nan => range.meet(at_most(of_b.high).or_nan()),
                (_, true) if !of_a.nan => range.meet(at_least(of_a.low).or_nan()),
                _ => range,
            };
            (x, y) = (meet(then, true, x), meet(otherwise, false, y));
        }
        x.join(y)
    }

    /// What a path says about a test.
    pub fn answer(&mut self, g: &Graph, test: Test) -> Option<bool> {
        if let Some((_, answer)) = self.facts.iter().find(|(known, _)| *known == test) {
            return Some(*answer);
        }
        if let Test::AtMost(a, b) = test {
            if self.facts.contains(&(Test::Above(a, b), true)) {
                return Some(false);
            }
            if self.facts.contains(&(Test::Above(b, a), true)) {
                return Some(true);
            }
        }
        match test {
            Test::Above(a, b) => {
                let (x, y) = (self.range(g, a), self.range(g, b));
                if x.low > y.high && !x.nan && !y.nan && x.has_numbers() && y.has_numbers() {
                    return Some(true);
                }
                let is_never = x.high <= y.low || !x.has_numbers() || !y.has_numbers() || a == b;
                is_never.then_some(false)
            }
            Test::AtMost(a, b) => {
                let (x, y) = (self.range(g, a), self.range(g, b));
                let is_always = x.high <= y.low
                    || a == b
                    || self.facts.contains(&(Test::Above(a, b), false))
                    || self.is_related(g, a, b);
                if is_always && !x.nan && !y.nan {
                    return Some(true);
                }
                let is_never = x.low > y.high || !x.has_numbers() || !y.has_numbers();
                is_never.then_some(false)
            }
            Test::Equal(a, b) => {
                let (x, y) = (self.range(g, a), self.range(g, b));
                let is_one = x.low == x.high && y.low == y.high && x.low == y.low;
                if (is_one || a == b) && !x.nan && !y.nan {
                    return Some(true);
                }
                let is_never = x.low > y.high || x.high < y.low;
                is_never.then_some(false)
            }
            Test::Outside(x, low, high) => {
                let [x, low, high] = [x, low, high].map(|id| self.range(g, id));
                if x.low > low.high && x.high < high.low && !x.nan && !low.nan && !high.nan {
                    return Some(false);
                }
                let is_always = x.high < low.low || x.low > high.high || !x.has_numbers();
                is_always.then_some(true)
            }
            Test::Case(_) => None,
        }
    }

    /// Learns the answer to a test.
    pub fn refine(&mut self, g: &Graph, test: Test, answer: bool) {
        if self.answer(g, test) == Some(!answer) {
            self.impossible = true;
            return;
        }
        self.facts.push((test, answer));
        match test {
            Test::Above(a, b) | Test::AtMost(a, b) | Test::Equal(a, b) => self.forget(a.min(b)),
            Test::Outside(a, b, c) => self.forget(a.min(b).min(c)),
            Test::Case(_) => {}
        }
        let f = g.format;
        match (test, answer) {
            (Test::Above(a, b), true) => {
                let (of_a, of_b) = (self.range(g, a), self.range(g, b));
                self.learn(g, a, above(of_b.low, f));
                self.learn(g, b, below(of_a.high, f));
            }
            (Test::AtMost(a, b), true) => {
                let (of_a, of_b) = (self.range(g, a), self.range(g, b));
                self.learn(g, a, at_most(of_b.high));
                self.learn(g, b, at_least(of_a.low));
            }
            (Test::Equal(a, b), true) => {
                let (of_a, of_b) = (self.range(g, a), self.range(g, b));
                let both = Range::within(of_a.low.max(of_b.low), of_a.high.min(of_b.high));
                self.learn(g, a, both);
                self.learn(g, b, both);
            }
            (Test::Above(a, b), false) => {
                let (of_a, of_b) = (self.range(g, a), self.range(g, b));
                if !of_b.nan {
                    self.learn(g, a, at_most(of_b.high).or_nan());
                }
                if !of_a.nan {
                    self.learn(g, b, at_least(of_a.low).or_nan());
                }
            }
            (Test::AtMost(a, b), false) => {
                let (of_a, of_b) = (self.range(g, a), self.range(g, b));
                if !of_b.nan {
                    self.learn(g, a, above(of_b.low, f).or_nan());
                }
                if !of_a.nan {
                    self.learn(g, b, below(of_a.high, f).or_nan());
                }
            }
            (Test::Outside(x, low, high), false) => {
                let (low, high) = (self.range(g, low), self.range(g, high));
                self.learn(g, x, Range::within(low.low, high.high));
            }
            _ => {}
        }
    }

    /// Forgets the ranges that may depend on a node: those of all nodes recorded later. A range that is remembered too
    /// long is too wide, and never wrong.
    fn forget(&mut self, id: u32) {
        self.memo.truncate(id as usize);
    }

    /// Learns that a node lies in a range, and what follows for the nodes that it is made of.
    fn learn(&mut self, g: &Graph, id: u32, range: Range) {
        let before = self.range(g, id);
        let now = before.meet(range);
        self.impossible |= now.is_empty();
        if now == before && get(&self.shown, id).is_some() || self.impossible {
            return;
        }
        set(&mut self.shown, id, now);
        self.forget(g.mirrors(id).fold(id, u32::min));
        self.learn_parts(g, id, now);
        if !matches!(g.nodes[id as usize], Node::Neg(_)) {
            for mirror in g.mirrors(id) {
                self.learn(g, mirror, now.opposite().with_zeros());
            }
        }
    }

    fn learn_parts(&mut self, g: &Graph, id: u32, now: Range) {
        let f = g.format;
        let nan = now.nan;
        let nonnegative = |known: &mut Self, id| known.range(g, id).low >= 0.0;
        let positive = at_least(f.tiny());
        self.learn_of_operands(g, id, now);
        match g.nodes[id as usize] {
            Node::Neg(a) => self.learn(g, a, now.opposite()),
            Node::Abs(a) => {
                let within = Range::within(-now.high, now.high);
                self.learn(g, a, Range { nan, ..within });
            }
            // the root of a negative number is NaN, too
            Node::Sqrt(a) if !nan => {
                let low = if now.low > 0.0 { f.tiny() } else { 0.0 };
                let high = if now.high < INF { f.max() } else { INF };
                self.learn(g, a, Range::within(low, high));
            }
            Node::Select(test, then, otherwise) => {
                let [a, b] = [then, otherwise].map(|id| self.range(g, id).meet(now).is_empty());
                if a != b {
                    self.refine(g, test, b);
                    self.learn(g, if b { then } else { otherwise }, now);
                }
            }
            // a rounded sum is at least each of its terms, if they are not negative
            Node::Add(a, b) if !nan => {
                let both = nonnegative(self, a) && nonnegative(self, b);
                let high = if both { now.high } else { INF };
                for id in [a, b] {
                    self.learn(g, id, at_most(high));
                }
            }
            Node::Sub(a, b) if !nan => {
                let (of_a, of_b) = (self.range(g, a), self.range(g, b));
                // x − y is positive only if x > y
                if now.low > 0.0 {
                    self.learn(g, a, above(of_b.low, f));
                    self.learn(g, b, below(of_a.high, f));
                }
                // x is the difference and y, each rounded away from x
                let low = f.next_down(f.round(f.next_down(now.low) + of_b.low));
                let high = f.next_up(f.round(f.next_up(now.high) + of_b.high));
                if low > -INF || high < INF {
                    self.learn(g, a, Range::within(low, high));
                }
            }
            Node::Mul(a, b) if a == b && now.high < INF => {
                // the next number also covers half of the smallest one, which rounding may take away
                let root = f.next_up(f.round(f.next_up(now.high).sqrt()));
                let within = Range::within(-root, root);
                self.learn(g, a, Range { nan, ..within });
            }
            // a product is positive only if both factors are, or neither
            Node::Mul(a, b)
                if now.low > 0.0 && !nan && (nonnegative(self, a) || nonnegative(self, b)) =>
            {
                self.learn(g, a, positive);
                self.learn(g, b, positive);
            }
            // a quotient is positive only if neither is 0 and the divisor is not infinite
            Node::Div(a, b)
                if now.low > 0.0 && !nan && nonnegative(self, a) && nonnegative(self, b) =>
            {
                self.learn(g, a, positive);
                let low = if now.high < INF { f.tiny() } else { 0.0 };
                self.learn(g, b, Range::within(low, f.max()));
            }
            _ => {}
        }
    }

    /// What is not NaN was made of numbers, and what is finite of finite ones, but for ∞ · 0 and what is
    /// divided by ∞.
    fn learn_of_operands(&mut self, g: &Graph, id: u32, now: Range) {
        let (Node::Add(a, b) | Node::Sub(a, b) | Node::Mul(a, b) | Node::Div(a, b)) =
            g.nodes[id as usize]
        else {
            return;
        };
        if now.nan {
            return;
        }
        let (numbers, max) = (Range::within(-INF, INF), g.format.max());
        let is_finite = now.low > -INF && now.high < INF;
        for (x, other) in [(a, b), (b, a)] {
            let of_other = self.range(g, other);
            let is_kept = match g.nodes[id as usize] {
                Node::Add(..) | Node::Sub(..) => is_finite,
                Node::Mul(..) => is_finite && (of_other.low > 0.0 || of_other.high < 0.0),
                _ => is_finite && x == a,
            };
            let finite = Range::within(-max, max);
            self.learn(g, x, if is_kept { finite } else { numbers });
        }
    }

    /// The first selection below these nodes that is still open.
    pub(super) fn open_test(&mut self, g: &Graph, roots: &[u32]) -> Option<Test> {
        let mut seen = vec![false; g.nodes.len()];
        let mut stack = roots.to_vec();
        let mut first = None;
        while let Some(id) = stack.pop() {
            if std::mem::replace(&mut seen[id as usize], true) {
                continue;
            }
            match g.nodes[id as usize] {
                Node::Select(test, then, otherwise) => {
                    if let Some(answer) = self.answer(g, test) {
                        stack.push(if answer { then } else { otherwise });
                    } else {
                        if first.is_none_or(|(earlier, _)| id < earlier) {
                            first = Some((id, test));
                        }
                        stack.extend([then, otherwise]);
                        if let Test::Above(a, b) = test {
                            stack.extend([a, b]);
                        }
                    }
                }
                Node::Neg(a) | Node::Abs(a) | Node::Sqrt(a) | Node::Call(_, a) => stack.push(a),
                Node::Add(a, b)
                | Node::Sub(a, b)
                | Node::Mul(a, b)
                | Node::Div(a, b)
                | Node::Power(a, b) => stack.extend([a, b]),
                Node::Var(_) | Node::Constant(_) | Node::Max | Node::Extreme => {}
            }
        }
        first.map(|(_, test)| test)
    }
}

/// The sine and the cosine of a finite number lie within [−1, 1]. The exponential is not negative. The
/// logarithm is −∞ at 0 and NaN below.
fn called(function: Function, of: Range) -> Range {
    let nan = of.nan;
    let range = match function {
        Function::Sin | Function::Cos => {
            let nan = nan || of.low == -INF || of.high == INF;
            let wave = Range::within(-1.0, 1.0);
            return Range {
                nan,
                ..if of.finite { wave } else { Range::NONE }
            };
        }
        Function::Exp if of.has_numbers() => Range::unsigned(0.0, INF),
        Function::Ln if of.has_numbers() && of.high >= 0.0 => {
            let nan = nan || of.low < 0.0;
            let least = if of.low > 0.0 { -1000.0 } else { -INF };
            let most = if of.high == 0.0 {
                -INF
            } else if of.high < INF {
                1000.0
            } else {
                INF
            };
            return Range {
                nan,
                ..Range::within(least, most)
            };
        }
        Function::Exp => Range::NONE,
        Function::Ln => return Range::NAN,
    };
    Range { nan, ..range }
}
