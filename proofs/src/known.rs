//! What a path has shown about the nodes of a graph: the values that each can have.

use super::format::Format;
use super::graph::{Graph, Node, Test};
use super::range::Range;

const INF: f64 = f64::INFINITY;

#[doc(hidden)]
#[derive(Clone, Default)]
pub struct Known {
    /// What was learned of a node from what the path has decided about later ones.
    shown: Vec<Option<Range>>,
    facts: Vec<(Test, bool)>,
    /// The ranges of the first nodes. Each depends on earlier nodes alone.
    memo: Vec<Range>,
    pub impossible: bool,
}

fn above(x: f64, f: Format) -> Range {
    Range::within(f.next_up(x), INF)
}

fn below(x: f64, f: Format) -> Range {
    Range::within(-INF, f.next_down(x))
}

impl Known {
    /// The node itself, or what a decided selection selects.
    #[doc(hidden)]
    pub fn resolved(&mut self, g: &Graph, id: u32) -> u32 {
        if let Node::Select(test, then, otherwise) = g.nodes[id as usize]
            && let Some(answer) = self.answer(g, test)
        {
            self.resolved(g, if answer { then } else { otherwise })
        } else {
            id
        }
    }

    /// The node of which this one has the bits, because it adds 0 to it or selects it.
    fn reduced(&mut self, g: &Graph, id: u32) -> u32 {
        let id = self.resolved(g, id);
        let Node::Add(x, y) = g.nodes[id as usize] else {
            return id;
        };
        for (x, y) in [(x, y), (y, x)] {
            // x + 0 = x, whatever the sign of that zero, unless x is −0
            let is_zero = Range::within(0.0, 0.0).covers(self.range(g, y));
            if is_zero && !self.range(g, x).minus_zero {
                return self.reduced(g, x);
            }
        }
        id
    }

    /// Whether two nodes have the same bits on this path; any NaN is as good as another.
    pub(super) fn same(&mut self, g: &Graph, a: u32, b: u32) -> bool {
        let (a, b) = (self.reduced(g, a), self.reduced(g, b));
        let (x, y) = (self.range(g, a), self.range(g, b));
        if a == b || x == y && (x.only().is_some() || x == Range::NAN) {
            return true;
        }
        let mut are = |pairs: &[(u32, u32)]| pairs.iter().all(|(a, b)| self.same(g, *a, *b));
        match (g.nodes[a as usize], g.nodes[b as usize]) {
            (Node::Mul(c, d), Node::Mul(e, f)) | (Node::Add(c, d), Node::Add(e, f)) => {
                are(&[(c, e), (d, f)]) || are(&[(c, f), (d, e)])
            }
            (Node::Sub(c, d), Node::Sub(e, f)) | (Node::Div(c, d), Node::Div(e, f)) => {
                are(&[(c, e), (d, f)])
            }
            (Node::Select(Test::Above(x, y), c, d), Node::Select(Test::Above(z, w), e, f)) => {
                are(&[(x, z), (y, w), (c, e), (d, f)])
            }
            _ => false,
        }
    }

    /// The values that a node can have on this path.
    pub fn range(&mut self, g: &Graph, id: u32) -> Range {
        while self.memo.len() <= id as usize {
            let at = self.memo.len();
            #[allow(clippy::cast_possible_truncation)] // it is at most `id`
            let next = at as u32;
            let derived = self.derived(g, next);
            let range = self.related(g, next, derived);
            let shown = self.shown.get(at).copied().flatten();
            self.memo
                .push(shown.map_or(range, |shown| range.meet(shown)));
        }
        self.memo[id as usize]
    }

    /// Whether no values remain for a node.
    pub(super) fn is_impossible(&mut self, g: &Graph) -> bool {
        let shown: Vec<_> = (0..).zip(self.shown.iter().map(Option::is_some)).collect();
        let mut of_shown = shown.into_iter().filter(|(_, is_shown)| *is_shown);
        self.impossible |= of_shown.any(|(id, _)| self.range(g, id).is_empty());
        self.impossible
    }

    fn derived(&mut self, g: &Graph, id: u32) -> Range {
        let f = g.format;
        match g.nodes[id as usize] {
            Node::Var(index) => g.names[index as usize].1,
            Node::Constant(bits) => Range::exactly(f64::from_bits(bits)),
            Node::Neg(a) => self.range(g, a).opposite(),
            Node::Sqrt(a) => self.range(g, a).sqrt(f),
            Node::Add(a, b) => self.range(g, a).add(self.range(g, b), f),
            // x − x is 0, or NaN if x is not finite
            Node::Sub(a, b) if a == b => {
                let a = self.range(g, a);
                let nan = a.nan || a.is_infinite();
                let zero = if a.finite {
                    Range::unsigned(0.0, 0.0)
                } else {
                    Range::NONE
                };
                Range { nan, ..zero }
            }
            Node::Sub(a, b) => self.range(g, a).sub(self.range(g, b), f),
            Node::Mul(a, b) if a == b => self.range(g, a).square(f),
            Node::Mul(a, b) => self.range(g, a).mul(self.range(g, b), f),
            Node::Div(a, b) => self.range(g, a).div(self.range(g, b), f),
            Node::Select(test, then, otherwise) => self.selected(g, test, then, otherwise),
            Node::Power(cosine, m) => raised(self.range(g, cosine), self.range(g, m)),
        }
    }

    fn selected(&mut self, g: &Graph, test: Test, then: u32, otherwise: u32) -> Range {
        if let Some(answer) = self.answer(g, test) {
            return self.range(g, if answer { then } else { otherwise });
        }
        let (mut x, mut y) = (self.range(g, then), self.range(g, otherwise));
        if let Test::Above(a, b) = test {
            let (of_a, of_b) = (self.range(g, a), self.range(g, b));
            // then a > b, and otherwise a ≤ b or one of them is NaN
            if then == a {
                x = x.meet(above(of_b.low, g.format));
            } else if then == b {
                x = x.meet(below(of_a.high, g.format));
            }
            if otherwise == a && !of_b.nan {
                y = y.meet(Range::within(-INF, of_b.high).or_nan());
            }
        }
        x.join(y)
    }

    /// What a path says about a test.
    pub fn answer(&mut self, g: &Graph, test: Test) -> Option<bool> {
        if let Some((_, answer)) = self.facts.iter().find(|(known, _)| *known == test) {
            return Some(*answer);
        }
        let (Test::Above(a, b) | Test::AtMost(a, b)) = test else {
            return None;
        };
        let (x, y) = (self.range(g, a), self.range(g, b));
        let is_above = x.low > y.high || self.facts.contains(&(Test::Above(a, b), true));
        let is_at_most = x.high <= y.low || self.is_at_most(g, a, b);
        let (is_true, is_false) = match test {
            Test::Above(..) => (is_above, is_at_most),
            _ => (is_at_most, is_above),
        };
        if is_false {
            Some(false)
        } else {
            (is_true && !x.nan && !y.nan).then_some(true)
        }
    }

    /// Whether the path has compared two nodes so that a ≤ b, if neither is NaN.
    pub(super) fn is_told(&self, a: u32, b: u32) -> bool {
        self.facts.contains(&(Test::AtMost(a, b), true))
            || self.facts.contains(&(Test::Above(a, b), false))
    }

    /// Whether the path has found that a > b.
    pub(super) fn is_told_above(&self, a: u32, b: u32) -> bool {
        self.facts.contains(&(Test::Above(a, b), true))
    }

    /// Learns the answer to a test.
    pub fn refine(&mut self, g: &Graph, test: Test, answer: bool) {
        if self.answer(g, test) == Some(!answer) {
            self.impossible = true;
            return;
        }
        self.facts.push((test, answer));
        let (Test::Above(a, b) | Test::AtMost(a, b)) = test else {
            return;
        };
        let (of_a, of_b) = (self.range(g, a), self.range(g, b));
        // a range that is remembered too long is too wide, and never wrong
        self.memo.truncate(a.min(b) as usize);
        let (to_a, to_b) = if matches!(test, Test::Above(..)) == answer {
            (above(of_b.low, g.format), below(of_a.high, g.format))
        } else {
            (Range::within(-INF, of_b.high), Range::within(of_a.low, INF))
        };
        for (id, range, other) in [(a, to_a, of_b), (b, to_b, of_a)] {
            if answer {
                self.learn(g, id, range);
            } else if !other.nan {
                // a test that does not hold may be one of NaN
                self.learn(g, id, range.or_nan());
            }
        }
    }

    /// Learns that a node lies in a range, and what follows for the nodes that it is made of.
    fn learn(&mut self, g: &Graph, id: u32, range: Range) {
        let before = self.range(g, id);
        let now = before.meet(range);
        self.impossible |= now.is_empty();
        if now == before || self.impossible {
            return;
        }
        let at = id as usize;
        if self.shown.len() <= at {
            self.shown.resize(at + 1, None);
        }
        self.shown[at] = Some(now);
        self.memo.truncate(at);
        self.learn_parts(g, id, now);
    }

    fn learn_parts(&mut self, g: &Graph, id: u32, now: Range) {
        let f = g.format;
        let node = g.nodes[id as usize];
        if let Node::Select(test, then, otherwise) = node {
            // only one of the two can be what was selected
            let [a, b] = [then, otherwise].map(|id| self.range(g, id).meet(now).is_empty());
            if a != b {
                self.refine(g, test, b);
                self.learn(g, if b { then } else { otherwise }, now);
            }
        }
        match node {
            // a sum is a number only if its terms are
            Node::Add(a, b) if !now.nan => {
                for id in [a, b] {
                    self.learn(g, id, Range::within(-INF, INF));
                }
            }
            Node::Mul(a, b) if a == b && !now.nan => {
                // the next number also covers half of the smallest one, which rounding may take away
                let root = f.next_up(f.round(f.next_up(now.high).sqrt()));
                self.learn(g, a, Range::within(-root, root));
            }
            _ => {}
        }
    }

    /// A selection below these nodes that is still open.
    pub(super) fn open_test(&mut self, g: &Graph, mut roots: Vec<u32>) -> Option<Test> {
        let mut is_seen = vec![false; g.nodes.len()];
        while let Some(id) = roots.pop() {
            if std::mem::replace(&mut is_seen[id as usize], true) {
                continue;
            }
            let node = g.nodes[self.resolved(g, id) as usize];
            if let Node::Select(test, ..) = node {
                return Some(test);
            }
            roots.extend(node.parts());
        }
        None
    }
}

/// What is known of a power. The contract speaks of cosines within [0, 1] alone, and of 0 it says only that.
fn raised(cosine: Range, m: Range) -> Range {
    if !Range::within(0.0, 1.0).covers(cosine) {
        Range::ANY
    } else if cosine.low > 0.0 && m.high <= 1.0 {
        Range::unsigned(cosine.low - 2.0_f64.powi(-20), 1.0)
    } else {
        Range::unsigned(0.0, 1.0)
    }
}
