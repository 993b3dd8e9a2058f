//! What is known of R = 2(N·L)N − L, if N and L are known to be directions.
//!
//! As in `relation.rs`, u is the unit roundoff and η the smallest number above 0. The squares of N and L must be
//! within 2⁻¹⁰ of 1, so that η is nothing beside them.

use super::graph::{Graph, Node};
use super::known::{Known, get};
use super::range::Range;
use super::relation::{Pair, all_orientations, is_sum, products, squares, up};

impl Known {
    /// A component is no longer than R.
    pub(super) fn component_of_mirrored(&mut self, g: &Graph, id: u32, range: Range) -> Range {
        let length = mirrored(g, id).and_then(|pair| self.length_of_mirrored(g, pair));
        length.map_or(range, |(_, most)| {
            let limit = up(g, most);
            range.meet(Range::within(-limit, limit))
        })
    }

    /// The square of R, which rounds to |R|²(1 ± 3u).
    pub(super) fn square_of_mirrored(&mut self, g: &Graph, id: u32, range: Range) -> Range {
        let factors = products(g, id).filter(|_| is_sum(g, id));
        let Some([[x, a], [y, b], [z, c]]) = factors else {
            return range;
        };
        let pairs = [x, y, z].map(|component| mirrored(g, component));
        let is_one = x != y && y != z && z != x && pairs[0] == pairs[1] && pairs[1] == pairs[2];
        let pair = pairs[0].filter(|_| is_one && [x, y, z] == [a, b, c]);
        let length = pair.and_then(|pair| self.length_of_mirrored(g, pair));
        length.map_or(range, |(least, most)| {
            let u = g.format.u();
            let low = -up(g, -(least * least * (1.0 - 8.0 * u)));
            range.meet(Range::within(low, up(g, most * most * (1.0 + 8.0 * u))))
        })
    }

    /// The least and the most that the length of the computed R can be.
    ///
    /// Exactly, |R|² = |L|² + 4(N·L)²(|N|² − 1), and (N·L)² ≤ |N|²|L|². The computed N·L is off by 3u|N||L|, so that
    /// twice it, times N, is off by 6u; the products add 2u, and the differences u. That is less than 10u together,
    /// and this computation rounds by less than 6u.
    fn length_of_mirrored(&mut self, g: &Graph, (n, l): Pair) -> Option<(f64, f64)> {
        let (n, l) = (self.exact_square(g, n)?, self.exact_square(g, l)?);
        let longer = 4.0 * n.high * (n.high - 1.0).max(0.0);
        let shorter = 4.0 * n.high * l.high * (1.0 - n.low).max(0.0);
        let slack = 16.0 * g.format.u();
        let most = (l.high * (1.0 + longer)).sqrt() + slack;
        Some(((l.low - shorter).sqrt() - slack, most))
    }

    /// |v|², which rounding to a known sum has changed by 3u of itself, if it is near 1.
    fn exact_square(&self, g: &Graph, v: [u32; 3]) -> Option<Range> {
        let near = 2.0_f64.powi(-10);
        let mut shown = squares(g, v).into_iter();
        let square = shown.find_map(|node| get(&self.shown, node))?;
        let (low, high) = (
            square.low * (1.0 - 4.0 * g.format.u()),
            square.high * (1.0 + 4.0 * g.format.u()),
        );
        let is_near = !square.nan && low >= 1.0 - near && high <= 1.0 + near;
        is_near.then_some(Range::within(low, high))
    }
}

/// N and L, if a node is nᵢ · 2(N·L) − lᵢ.
fn mirrored(g: &Graph, id: u32) -> Option<Pair> {
    let node = |id: u32| g.nodes[id as usize];
    let Node::Sub(product, of_l) = node(id) else {
        return None;
    };
    let Node::Mul(a, b) = node(product) else {
        return None;
    };
    [(a, b), (b, a)].into_iter().find_map(|(of_n, twice)| {
        let dot = match node(twice) {
            Node::Add(dot, same) if dot == same && is_sum(g, dot) => dot,
            _ => return None,
        };
        let pairs = products(g, dot).map_or(vec![], all_orientations);
        let has_both = |(n, l): &Pair| (0..3).any(|i| n[i] == of_n && l[i] == of_l);
        pairs.into_iter().find(has_both)
    })
}
