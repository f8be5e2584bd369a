//! The shadow of a body: its projection along the axis, a zonogon, by the coordinates in the plane of the rotation.
//!
//! The coordinates are rounded, and the zonogon of the rounded ones is taken as it is: its generators are sorted by
//! exact decisions. So the farthest vertex of the true shadow is at most the sum of all roundings farther away.

use super::plane::Plane;
use super::scaled_body::ScaledBody;
use crate::numeric::exact_sum::exact_sum;
use crate::numeric::scaling::power_of_two;
use crate::tally::{Operation, Tally};
use crate::zonotope::zonogon::sorted_by_angle;

/// The zonogon of a centre and generators sorted by angle.
#[derive(Debug)]
pub(in super::super) struct Shadow {
    center: [f64; 2],
    generators: Vec<[f64; 2]>,
    /// A bound of the distance of any of its points from that of the true shadow with the same coefficients.
    off: f64,
}

impl Shadow {
    /// The shadow of a body, seen from the axis. Generators that are read and comparisons that sort them are counted.
    pub(in super::super) fn of(plane: &Plane, body: &ScaledBody<'_>, tally: &mut dyn Tally) -> Self {
        let [_, x, y] = plane.coordinates(&body.arm);
        let (projected, off) = body.projected(&plane.projection());
        let mut comparisons = 0;
        let generators = sorted_by_angle(&projected, &mut comparisons);
        tally.add(Operation::Comparison, comparisons);
        tally.add(Operation::GeneratorRead, body.generators().len() as u64);
        Self { center: [x.value, y.value], generators, off: (off + x.error + y.error) * (1.0 + 4.0 * f64::EPSILON) }
    }

    /// Twice the number of generators that are not zero: how many vertices are visited.
    pub(in super::super) fn vertex_count(&self) -> usize {
        2 * self.generators.len().max(1)
    }

    /// Hands over every vertex, some twice, and some points of edges; each within [`off`](Self::off) of the true one.
    pub(in super::super) fn each_vertex(&self, mut visit: impl FnMut([f64; 2])) {
        let mut place = self.center.map(Compensated::of);
        for g in &self.generators {
            (0..2).for_each(|k| place[k].add(-g[k]));
        }
        let mut visit_both = |place: &[Compensated; 2]| {
            visit(place.each_ref().map(Compensated::value));
            visit([0, 1].map(|k| place[k].reflected_in(self.center[k])));
        };
        visit_both(&place);
        for g in &self.generators {
            (0..2).for_each(|k| place[k].add(2.0 * g[k]));
            visit_both(&place);
        }
    }

    /// A bound of the distance of a vertex that is handed over from the true one.
    pub(in super::super) fn off(&self) -> f64 {
        let terms = (2 * self.generators.len() + 4) as f64;
        let size = self
            .generators
            .iter()
            .fold(self.center[0].abs() + self.center[1].abs(), |sum, g| sum + 2.0 * (g[0].abs() + g[1].abs()));
        let carried = terms * f64::EPSILON;
        (self.off + (4.0 * f64::EPSILON + 4.0 * carried * carried) * size) * (1.0 + 2.0 * carried)
    }

    /// A number not below the largest distance of a point of the true shadow from the axis. A step of the walk around
    /// the shadow reads a generator.
    pub(in super::super) fn farthest_above(&self, tally: &mut dyn Tally) -> f64 {
        let mut square: f64 = 0.0;
        tally.add(Operation::GeneratorRead, self.generators.len() as u64);
        self.each_vertex(|[x, y]| square = square.max(x * x + y * y));
        let is_point = self.generators.is_empty() && self.center == [0.0; 2];
        let underflow = if is_point || square > power_of_two(-900) { 0.0 } else { power_of_two(-450) };
        (square.sqrt() * (1.0 + 8.0 * f64::EPSILON) + self.off() + underflow) * (1.0 + 4.0 * f64::EPSILON)
    }
}

/// A sum with what rounding took from it.
#[derive(Debug, Clone, Copy)]
struct Compensated {
    sum: f64,
    lost: f64,
}

impl Compensated {
    fn of(value: f64) -> Self {
        Self { sum: value, lost: 0.0 }
    }

    fn add(&mut self, value: f64) {
        let (sum, lost) = exact_sum(self.sum, value);
        (self.sum, self.lost) = (sum, self.lost + lost);
    }

    fn value(&self) -> f64 {
        self.sum + self.lost
    }

    fn reflected_in(&self, center: f64) -> f64 {
        2.0 * center - self.sum - self.lost
    }
}
