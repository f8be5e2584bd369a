//! The lines ℓ_t by pairs of doubles: their common points, and on which side a point lies, with bounds on every error.
//!
//! The coordinates of a few points are of about one size, so pairs of doubles tell nearly everything about them, at
//! less cost than exact numbers.

use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::tolerance::{UNDERFLOW, UNIT};

type Pair = BoundedDoubleDouble;

/// A line ℓ_t in the frame: the points x with edge × (x − through) = 0.
#[derive(Debug)]
pub(super) struct PairLine {
    edge: [Pair; 2],
    through: [Pair; 2],
}

impl PairLine {
    /// The line of an edge, given its ends and its farthest vertex in the frame.
    #[inline]
    pub(super) fn new([from, to, far]: [[f64; 2]; 3], reference: [f64; 2]) -> Self {
        let edge = [0, 1].map(|i| Pair::of_parts(to[i], -from[i], 0.0));
        let through = [0, 1].map(|i| Pair::of_parts(far[i], from[i], 0.0) - Pair::exact(reference[i]));
        Self { edge, through }
    }

    /// The cross product of the edge with a vector.
    pub(super) fn edge_times(&self, [x, y]: &[Pair; 2]) -> Pair {
        self.edge[0] * *y - self.edge[1] * *x
    }

    /// The value of the line at a point.
    pub(super) fn value(&self, point: &[Pair; 2]) -> Pair {
        self.edge_times(&[0, 1].map(|i| point[i] - self.through[i]))
    }

    /// The rate at which the value grows along a direction.
    pub(super) fn rate(&self, direction: &[Pair; 2]) -> Pair {
        self.edge_times(direction)
    }

    /// The common point of two lines; `None` where a coordinate is not certain to the last bits of a double.
    pub(super) fn meet(&self, other: &Self) -> Option<[Pair; 2]> {
        let between = [0, 1].map(|i| other.through[i] - self.through[i]);
        let along = other.edge_times(&between) / other.edge_times(&self.edge);
        let point = [0, 1].map(|i| self.through[i] + self.edge[i] * along);
        let is_certain = |coordinate: &Pair| {
            let rounded = coordinate.rounded();
            rounded.error <= 4.0 * UNIT * rounded.value.abs() + UNDERFLOW
        };
        point.iter().all(is_certain).then_some(point)
    }
}
