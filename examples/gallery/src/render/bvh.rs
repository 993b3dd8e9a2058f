//! A bounding volume hierarchy, which finds the few triangles that a ray may hit.
//!
//! Source: Kay and Kajiya, *Ray tracing complex scenes*, SIGGRAPH 1986.

use std::ops::Range;

use shading::Vec3;

use super::ray::Ray;

/// The maximum number of items in a leaf.
const LEAF: usize = 4;

/// An axis-aligned box.
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

    /// The longest axis of the box.
    fn longest(&self) -> usize {
        let length = |&axis: &usize| self.high[axis] - self.low[axis];
        (0..3)
            .max_by(|a, b| length(a).total_cmp(&length(b)))
            .unwrap_or(0)
    }

    /// Where a ray enters the box, if it enters before `limit`.
    fn entry(&self, origin: [f32; 3], reciprocal: [f32; 3], limit: f32) -> Option<f32> {
        let (mut enter, mut leave) = (0.0_f32, limit);
        for axis in 0..3 {
            let a = (self.low[axis] - origin[axis]) * reciprocal[axis];
            let b = (self.high[axis] - origin[axis]) * reciprocal[axis];
            // min and max ignore the NaN of a ray that lies in a side of the box
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
    /// The indices of the items; those of a leaf are adjacent.
    order: Vec<usize>,
}

impl Bvh {
    /// Builds the hierarchy for items with these bounds; there must be at least one.
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

    /// Calls `visit` for each item that the ray may hit before the distance `limit`. `visit` takes
    /// an item and the current limit, and returns the new limit, which is smaller if the ray hit
    /// the item.
    pub fn walk(&self, ray: &Ray, mut limit: f32, mut visit: impl FnMut(usize, f32) -> f32) {
        let origin = ray.origin.into();
        let reciprocal = ray.direction.map(|d| 1.0 / d).into();
        let entry = |node: usize, limit| self.nodes[node].bounds.entry(origin, reciprocal, limit);

        // the median halves the items at each level, so there are fewer levels than bits in an
        // index
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
                    // the nearer child last, so that it is visited first
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
