//! Which few of many boxes a ray may meet.
//!
//! Source: Kay and Kajiya, *Ray tracing complex scenes*, SIGGRAPH 1986.

use std::ops::Range;

use crate::vector::{Number, Vector};

/// The low and the high corner of a box.
pub type Bounds<N> = [[N; 3]; 2];

struct Node<N> {
    bounds: Bounds<N>,
    items: Range<usize>,
    /// The second child; the first is the next node. 0 for a leaf.
    second: usize,
}

pub struct Bvh<N> {
    nodes: Vec<Node<N>>,
    /// The items; those of a leaf are adjacent.
    order: Vec<usize>,
}

/// The most items in a leaf.
const LEAF: usize = 4;

impl<N: Number> Bvh<N> {
    pub fn new(bounds: &[Bounds<N>]) -> Self {
        let order = (0..bounds.len()).collect();
        let mut bvh = Self {
            nodes: Vec::new(),
            order,
        };
        if !bounds.is_empty() {
            bvh.build(bounds, 0..bounds.len());
        }
        bvh
    }

    /// Appends the nodes of these items, halved along the longest side of their box.
    fn build(&mut self, bounds: &[Bounds<N>], items: Range<usize>) {
        let here = &mut self.order[items.clone()];
        let around = here
            .iter()
            .map(|&item| bounds[item])
            .reduce(joined)
            .unwrap_or([[N::ZERO; 3]; 2]);
        let node = self.nodes.len();
        self.nodes.push(Node {
            bounds: around,
            items: items.clone(),
            second: 0,
        });
        if items.len() > LEAF {
            let side = |axis: &usize| (around[1][*axis] - around[0][*axis]).to_f32();
            let axis = (0..3)
                .max_by(|a, b| side(a).total_cmp(&side(b)))
                .unwrap_or(0);
            let center = |item: usize| (bounds[item][0][axis] + bounds[item][1][axis]).to_f32();
            let half = items.len() / 2;
            here.select_nth_unstable_by(half, |&a, &b| center(a).total_cmp(&center(b)));
            self.build(bounds, items.start..items.start + half);
            self.nodes[node].second = self.nodes.len();
            self.build(bounds, items.start + half..items.end);
        }
    }

    /// Calls `meet` for each item whose box a ray enters before the limit. `meet` returns the new limit.
    pub fn walk<V: Vector<Number = N>>(
        &self,
        from: V,
        along: V,
        mut limit: N,
        mut meet: impl FnMut(usize, N) -> N,
    ) {
        let (from, slope) = (from.into(), along.into().map(|d: N| N::ONE / d));
        let mut waiting = if self.nodes.is_empty() {
            vec![]
        } else {
            vec![0]
        };
        while let Some(index) = waiting.pop() {
            let node = &self.nodes[index];
            if !enters(&node.bounds, from, slope, limit) {
                continue;
            }
            if node.second > 0 {
                waiting.extend([node.second, index + 1]);
            } else {
                for &item in &self.order[node.items.clone()] {
                    limit = meet(item, limit);
                }
            }
        }
    }
}

pub fn joined<N: Number>(a: Bounds<N>, b: Bounds<N>) -> Bounds<N> {
    [
        std::array::from_fn(|i| a[0][i].at_most(b[0][i])),
        std::array::from_fn(|i| a[1][i].at_least(b[1][i])),
    ]
}

fn enters<N: Number>([low, high]: &Bounds<N>, from: [N; 3], slope: [N; 3], limit: N) -> bool {
    let (mut enter, mut leave) = (N::ZERO, limit);
    for i in 0..3 {
        let [a, b] = [low[i], high[i]].map(|end| (end - from[i]) * slope[i]);
        let (near, far) = if a > b { (b, a) } else { (a, b) };
        // a NaN, of a ray within a side, changes neither
        enter = if near > enter { near } else { enter };
        leave = if far < leave { far } else { leave };
    }
    enter <= leave
}
