//! What a frame of a walk answers: the status and, of disjoint bodies, the closest face of their sum.

use super::facet_polygon::Reach;
use crate::arrangement::facet_walk::FacetName;
use crate::collision::distance::FeatureKind;
use crate::collision::{Location, Query, Separation, Status, by_lad};
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;

/// How two bodies that only translate meet in a frame.
#[derive(Debug)]
pub struct Walked<'t> {
    pub(super) query: Query<'t, 3>,
    pub(super) status: Status,
    pub(super) facet: FacetName,
    pub(super) steps: u64,
    pub(super) closest: Option<Reach>,
}

impl<'t> Walked<'t> {
    /// Inside if the interiors of the bodies have a point in common, boundary if they only touch, outside if they are
    /// disjoint; decided exactly.
    pub fn status(&self) -> Status {
        self.status
    }

    /// Whether the closed bodies have a point in common.
    pub fn is_member(&self) -> bool {
        self.status.is_member()
    }

    /// The facet of the sum of the bodies at which the walk has ended: of disjoint bodies one with the point that is
    /// nearest to the displacement of the centres, else one through which the ray to it leaves.
    pub fn facet(&self) -> FacetName {
        self.facet
    }

    /// How many edges were crossed in this frame.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Of disjoint bodies, the dimension of the least face of their sum that holds the nearest point.
    pub fn closest(&self) -> Option<FeatureKind> {
        self.closest.as_ref().map(|reach| reach.kind)
    }

    /// The square of the distance, exactly: 0 for bodies that meet.
    pub fn exact_squared_distance(&self) -> Rational {
        self.closest
            .as_ref()
            .map_or(Rational::ZERO, |reach| reach.numerator.to_rational() / reach.denominator.to_rational())
    }

    /// The square of the distance, within a unit in the last place; 0 or infinite where it leaves the range of doubles.
    pub fn squared_distance(&self) -> f64 {
        self.closest.as_ref().map_or(0.0, |reach| reach.numerator.rounded_ratio(&reach.denominator))
    }

    /// Of disjoint bodies, the direction from the first one's nearest point to that of the second, exactly, of any
    /// length. It separates the bodies: the nearest point is extreme in it.
    pub fn exact_direction(&self) -> Option<&[Dyadic; 3]> {
        self.closest.as_ref().map(|reach| &reach.direction)
    }

    /// The query that the frame answered.
    pub fn query(&self) -> Query<'t, 3> {
        self.query
    }

    /// The status with its proof: the direction of the distance, or coefficients, for which the query is located
    /// afresh. O(n).
    pub fn location(&self) -> Location<3> {
        match &self.closest {
            Some(reach) => Location::Outside(Separation::near(&self.query, &reach.direction)),
            None => by_lad::locate(&self.query, &mut ()).with_nearest_basis(&self.query),
        }
    }
}
