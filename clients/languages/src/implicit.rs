//! The normals of implicit surfaces, on which a field of values is constant.

use std::array::from_fn;

use shading::Vec3;

use crate::light::is_finite;
use crate::normals::{check_steps, slope, unit_or_zero};
use crate::number::Number;
use crate::problem::{Problem, Status, triple};
use crate::threads;

/// Values at the nodes of a grid, of which the first is the origin: x grows from column to column, y
/// from row to row, z from layer to layer.
#[derive(Clone, Copy)]
pub struct Grid<'a, T> {
    pub values: &'a [T],
    /// How many columns, rows and layers.
    pub counts: [usize; 3],
    pub steps: [T; 3],
}

impl<T: Number> Grid<'_, T> {
    /// Refuses what is no field, and points that are not in it.
    pub fn check(&self, points: &[[T; 3]]) -> Result<(), Problem> {
        check_steps(["dx", "dy", "dz"], self.steps)?;
        let values = self.values;
        if let Some(i) = values.iter().position(|&value| !is_finite(value)) {
            let expected = "finite numbers (fill in what is missing first)";
            let problem = Problem::new(Status::Values, "values", expected, values[i]);
            return Err(problem.at(i, values.len()));
        }
        if values.is_empty() && !points.is_empty() {
            let expected = "at least one layer, row and column";
            return Err(Problem::new(Status::Count, "values", expected, "none"));
        }
        match points.iter().position(|&point| !self.contains(point)) {
            None => Ok(()),
            Some(i) => {
                let end = from_fn(|axis| self.last(axis) * self.steps[axis]);
                let expected = format!("positions in the grid, from (0, 0, 0) to {}", triple(end));
                let got = triple(points[i]);
                let problem = Problem::new(Status::Points, "points", &expected, got);
                Err(problem.at(i, points.len()))
            }
        }
    }

    /// The index of the last node along an axis. Without nodes, it is −1.
    #[allow(clippy::cast_precision_loss)] // no grid has so many nodes
    fn last(&self, axis: usize) -> T {
        T::of(self.counts[axis] as f64 - 1.0)
    }

    /// Whether a point is in the grid. A thousandth of a cell is left for the roundoff of whoever
    /// computed it.
    fn contains(&self, point: [T; 3]) -> bool {
        let slack = T::of(1e-3);
        (0..3).all(|axis| {
            let x = point[axis] / self.steps[axis];
            x >= -slack && x <= self.last(axis) + slack
        })
    }

    /// The gradient at a node, by its neighbors. It is exact for parabolas.
    fn gradient(&self, node: [usize; 3]) -> Vec3<T> {
        let [columns, rows, _] = self.counts;
        let along = |axis: usize| {
            let value = |k| {
                let mut neighbor = node;
                neighbor[axis] = k;
                let [column, row, layer] = neighbor;
                self.values[(layer * rows + row) * columns + column]
            };
            slope(value, node[axis], self.counts[axis], self.steps[axis])
        };
        Vec3::new(along(0), along(1), along(2))
    }

    /// The gradient at a point, interpolated between the eight nodes around it, and normalized.
    fn normal(&self, point: [T; 3]) -> [T; 3] {
        let position: [T; 3] = from_fn(|axis| point[axis] / self.steps[axis]);
        let first: [usize; 3] = from_fn(|axis| {
            position[axis]
                .floor()
                .min(self.counts[axis].saturating_sub(2))
        });
        let mut sum = Vec3::new(T::ZERO, T::ZERO, T::ZERO);
        for corner in 0..8 {
            let (mut node, mut weight) = (first, T::ONE);
            for axis in 0..3 {
                #[allow(clippy::cast_precision_loss)] // as above
                let along = position[axis] - T::of(first[axis] as f64);
                if corner >> axis & 1 == 0 {
                    weight = weight * (T::ONE - along);
                } else {
                    // the same node again where there is only one
                    node[axis] = (first[axis] + 1).min(self.counts[axis] - 1);
                    weight = weight * along;
                }
            }
            sum += self.gradient(node) * weight;
        }
        unit_or_zero(sum)
    }

    /// The normals at points of the grid, which point to where the values grow. They are 0 where the
    /// gradient is 0 or overflows.
    pub fn normals(&self, points: &[[T; 3]], out: &mut [[T; 3]]) {
        threads::map(points, out, |point| self.normal(point));
    }
}
