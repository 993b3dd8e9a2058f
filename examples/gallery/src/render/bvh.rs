//! A bounding volume hierarchy: which few of many triangles a ray may meet.
//!
//! Source: Kay and Kajiya, *Ray tracing complex scenes*, SIGGRAPH 1986.

use std::ops::Range;

use shading::Vec3;

use super::ray::Ray;

/// Leaves hold at most so many items.
const LEAF: usize = 4;

/// A box along the axes.
#[derive(Clone, Copy)]
pub struct Bounds {
    low: [f32; 3],
    high: [f32; 3],
}

impl Bounds {
    const EMPTY: Self = Self {
        low: [f32::INFINITY; 3],
        high: [f32::NEG_INFINITY; 3],
    };

    pub fn around(points: impl IntoIterator<Item = Vec3<f32>>) -> Self {
        points
            .into_iter()
            .map(<[f32; 3]>::from)
            .fold(Self::EMPTY, |bounds, p| {
                bounds.joined(Self { low: p, high: p })
            })
    }

    fn joined(self, other: Self) -> Self {
        Self {
            low: std::array::from_fn(|axis| self.low[axis].min(other.low[axis])),
            high: std::array::from_fn(|axis| self.high[axis].max(other.high[axis])),
        }
    }

    fn center(&self, axis: usize) -> f32 {
        0.5 * self.low[axis] + 0.5 * self.high[axis]
    }

    /// The axis along which the box is longest.
    fn longest(&self) -> usize {
        let length = |&axis: &usize| self.high[axis] - self.low[axis];
        (0..3)
            .max_by(|a, b| length(a).total_cmp(&length(b)))
            .unwrap_or(0)
    }

    /// Where a ray enters the box, if it does so before `limit`.
    fn entry(&self, origin: [f32; 3], reciprocal: [f32; 3], limit: f32) -> Option<f32> {
        let (mut enter, mut leave) = (0.0_f32, limit);
        for axis in 0..3 {
            let a = (self.low[axis] - origin[axis]) * reciprocal[axis];
            let b = (self.high[axis] - origin[axis]) * reciprocal[axis];
            // a NaN, of a ray within the side of a box, is ignored by min and max
            enter = enter.max(a.min(b));
            leave = leave.min(a.max(b));
        }
        (enter <= leave).then_some(enter)
    }
}

struct Node {
    bounds: Bounds,
    content: Content,
}

enum Content {
    /// A range of `Bvh::order`.
    Leaf(Range<usize>),
    /// The index of the second child; the first is the next node.
    Inner(usize),
}

pub struct Bvh {
    nodes: Vec<Node>,
    /// The items' numbers, those of a leaf side by side.
    order: Vec<usize>,
}

impl Bvh {
    /// Of items with these bounds, at least one.
    pub fn new(bounds: &[Bounds]) -> Self {
        let mut bvh = Self {
            nodes: Vec::new(),
            order: (0..bounds.len()).collect(),
        };
        bvh.build(bounds, 0..bounds.len());
        bvh
    }

    /// Appends the nodes for a range of `order`, split at the median of the longest axis.
    fn build(&mut self, bounds: &[Bounds], range: Range<usize>) {
        let items = &mut self.order[range.clone()];
        let around = items
            .iter()
            .fold(Bounds::EMPTY, |all, &item| all.joined(bounds[item]));
        let node = self.nodes.len();
        self.nodes.push(Node {
            bounds: around,
            content: Content::Leaf(range.clone()),
        });
        if items.len() > LEAF {
            let (axis, half) = (around.longest(), items.len() / 2);
            items.select_nth_unstable_by(half, |&a, &b| {
                bounds[a].center(axis).total_cmp(&bounds[b].center(axis))
            });
            self.build(bounds, range.start..range.start + half);
            self.nodes[node].content = Content::Inner(self.nodes.len());
            self.build(bounds, range.start + half..range.end);
        }
    }

    /// Shows `visit` the items that the ray may meet before the distance `limit`. It is given an
    /// item and the limit, and returns the limit from there on: smaller, where it met the item.
    pub fn walk(&self, ray: &Ray, mut limit: f32, mut visit: impl FnMut(usize, f32) -> f32) {
        let origin = ray.origin.into();
        let reciprocal = ray.direction.map(|d| 1.0 / d).into();
        let entry = |node: usize, limit| self.nodes[node].bounds.entry(origin, reciprocal, limit);

        // the median halves the items at each level, so the levels are fewer than an index has bits
        let mut waiting = [(0, 0.0); usize::BITS as usize];
        let mut count = usize::from(entry(0, limit).is_some());
        while count > 0 {
            count -= 1;
            let (node, t) = waiting[count];
            if t > limit {
                continue;
            }
            match &self.nodes[node].content {
                Content::Leaf(range) => {
                    for &item in &self.order[range.clone()] {
                        limit = visit(item, limit);
                    }
                }
                &Content::Inner(second) => {
                    let a = (node + 1, entry(node + 1, limit));
                    let b = (second, entry(second, limit));
                    // the nearer child last, to be taken up first
                    let children = if a.1 > b.1 { [a, b] } else { [b, a] };
                    for (child, t) in children {
                        if let Some(t) = t {
                            waiting[count] = (child, t);
                            count += 1;
                        }
                    }
                }
            }
        }
    }
}
