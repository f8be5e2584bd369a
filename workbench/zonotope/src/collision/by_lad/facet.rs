//! The answer in constant size: the facet in which the ray along the displacement leaves the body.

use super::proof;
use crate::collision::{Gauge, Location};
use crate::lad::of_generators::generators::KernelQuery;
use crate::lad::of_generators::goal::Goal;
use crate::lad::of_generators::optimum::Optimum;
use crate::lad::of_generators::solve;
use crate::tally::Tally;

/// Where the ray along a displacement leaves the zonotope: the gauge and the status at once, the full proof on demand.
#[derive(Debug)]
pub struct Facet<'q> {
    query: &'q dyn KernelQuery,
    optimum: Optimum,
}

impl<'q> Facet<'q> {
    /// Finds the facet, or a separating direction if the goal allows that and one is found first.
    pub(super) fn find(query: &'q dyn KernelQuery, goal: Goal, tally: &mut impl Tally) -> Self {
        Self { query, optimum: solve(query, goal, tally) }
    }

    /// The gauge within a bound of its error; infinite where no multiple of the body holds the displacement. O(1).
    pub fn value(&self) -> (f64, f64) {
        self.optimum.gauge()
    }

    /// The generators, at most two, that span the facet where the ray leaves; near an edge of it, perhaps the neighbour. O(1).
    pub fn basis(&self) -> &[usize] {
        self.optimum.basis()
    }

    /// Whether [`basis`](Self::basis) is that of the facet for sure, not only nearly. O(1).
    pub fn is_sharp(&self) -> bool {
        self.optimum.is_sharp()
    }

    /// Whether the displacement is in the closed body. O(1).
    pub fn is_member(&self) -> bool {
        self.optimum.is_member()
    }

    /// The gauge with where the displacement lies. O(n).
    pub fn gauge(&self) -> Gauge<3> {
        self.gauge_counted(&mut ())
    }

    /// [`gauge`](Self::gauge), counting its operations.
    pub fn gauge_counted(&self, tally: &mut impl Tally) -> Gauge<3> {
        let (value, error) = self.value();
        Gauge { value, error, location: self.location_counted(tally) }
    }

    /// Where the displacement lies, with its proof. O(n) for a member, else O(1) nearly always.
    pub fn location(&self) -> Location<3> {
        self.location_counted(&mut ())
    }

    /// [`location`](Self::location), counting its operations.
    pub fn location_counted(&self, tally: &mut impl Tally) -> Location<3> {
        proof::location(self.query, &self.optimum, tally)
    }
}
