//! Membership and gauge, by the facet in which the ray along the displacement leaves the body: the answer in constant
//! size.
//!
//! # Statement
//! Input: a query p and the generators of a zonotope Z in space. Output: a [`Facet`] with the gauge min { t ≥ 0 : p ∈
//! t Z } within a bound of its error, the status of p, and at most two generators that span the facet; on demand the
//! [`Location`] with a proof of O(n) numbers. Touching counts as membership. A flat Z has a facet as well, that of
//! the prism over it; p = 0 has none, and the basis is empty.
//!
//! # Source
//! Beyond the paper, as all of [`by_lad`](super): a proof lists a coefficient for every generator, and a caller who
//! asks many questions about one body often wants the gauge alone.
//!
//! # Method
//! 1. The kernel finds the optimum of h(u) over the directions u with u · p = 1 (`lad::of_generators`).
//! 2. The optimum is kept in the form in which it was proved; gauge, status and basis are read off it.
//! 3. A location is made from the optimum when it is asked for (`proof`).
//!
//! # Complexity
//! n generators: expected O(n) time to find the facet, O(1) for gauge, status and basis, O(n) for the proof of a
//! member, nearly always O(1) for a separating direction. Space O(n) for the signs of the optimum.
//!
//! # Shapes
//! `query`: n × 3 generators in two runs, any order, duplicates allowed.
//!
//! # Numerics
//! The status is exact. The gauge is within the bound that comes with it. The basis is exact where
//! [`Facet::is_sharp`] says so; else the ray leaves so near to an edge that doubles know the gauge and not the facet.
//!
//! # Checked by
//! The rational twin, by way of the gauge and the locations that are made from facets; an independent check of every
//! proof.
//!
//! # Example
//! ```
//! use zonotope::collision::{Query, by_lad};
//! // the ray along (2, 0, 0) leaves the cube [−1, 1]³ through the side x = 1, half way
//! let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
//! let query = Query::new([0.0; 3], [2.0, 0.0, 0.0], &cube).unwrap();
//! let facet = by_lad::facet(&query, &mut ());
//! assert_eq!(facet.value().0, 2.0);
//! assert!(!facet.is_member());
//! assert_eq!(facet.location(&mut ()).status().name(), "outside");
//! ```

use crate::collision::proof::of_optimum;
use crate::collision::{Gauge, Location};
#[cfg(test)]
use crate::lad::of_generators::exact::solve::ExactOptimum;
use crate::lad::of_generators::goal::Goal;
use crate::lad::of_generators::nearest_gauge::nearest_gauge;
use crate::lad::of_generators::optimum::Optimum;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::solve;
use crate::tally::Tally;
use crate::zonotope::location::Coefficients;

/// The facet in which the ray along a displacement leaves the zonotope: the gauge and the status at once, the full
/// proof on demand.
#[derive(Debug)]
pub struct Facet<'q> {
    query: &'q dyn KernelQuery,
    optimum: Optimum,
}

impl<'q> Facet<'q> {
    /// Finds the facet.
    pub(super) fn find(query: &'q dyn KernelQuery, tally: &mut dyn Tally) -> Self {
        Self { query, optimum: solve(query, Goal::Gauge, tally) }
    }

    /// The gauge within a bound of its error; infinite where no multiple of the body holds the displacement. O(1).
    pub fn value(&self) -> (f64, f64) {
        self.optimum.gauge()
    }

    /// The generators, at most two, that span the facet in which the ray leaves the body; where the ray leaves near
    /// an edge, perhaps those of the facet beside it. O(1).
    pub fn basis(&self) -> &[usize] {
        self.optimum.basis()
    }

    /// Whether [`basis`](Self::basis) certainly spans the facet in which the ray leaves, and not only one near it.
    /// O(1).
    pub fn is_sharp(&self) -> bool {
        self.optimum.is_sharp()
    }

    /// Whether the displacement is in the closed body. O(1).
    pub fn is_member(&self) -> bool {
        self.optimum.is_member()
    }

    /// The gauge with where the displacement lies. O(n).
    pub fn gauge(&self, tally: &mut dyn Tally) -> Gauge<3> {
        self.measured(tally).map(|location| location.written(self.query))
    }

    /// [`gauge`](Self::gauge) with the proof as it was found.
    pub(super) fn measured(&self, tally: &mut dyn Tally) -> Gauge<3, Location<3, Coefficients>> {
        let (value, error) = self.value();
        Gauge { value, error, location: self.located(tally) }
    }

    /// [`measured`](Self::measured) within four units in the last place.
    pub(super) fn nearly_measured(&self, tally: &mut dyn Tally) -> Gauge<3, Location<3, Coefficients>> {
        let (value, error) = nearest_gauge(self.query, &self.optimum, tally);
        Gauge { value, error, location: self.located(tally) }
    }

    /// The location of the displacement, with its proof. O(n) for a member, else O(1) nearly always.
    pub fn location(&self, tally: &mut dyn Tally) -> Location<3> {
        self.located(tally).written(self.query)
    }

    fn located(&self, tally: &mut dyn Tally) -> Location<3, Coefficients> {
        of_optimum::proof(self.query, &self.optimum, None, tally).counted(tally)
    }

    /// The gauge by exact arithmetic on all generators: the truth that the others are held to.
    #[cfg(test)]
    pub(super) fn exact_value(&self) -> f64 {
        ExactOptimum::of_whole(self.query, &self.query.exact(), None, &mut ()).gauge().0
    }
}
