//! What a frame answers: the status, with a proof that is written out when it is asked for.

use std::cmp::Ordering;

use crate::collision::by_lad::locate;
use crate::collision::proof::of_optimum;
use crate::collision::{Location, Separation, Status};
use crate::lad::of_generators::optimum::Optimum;
use crate::zonotope::pose::Pose;
use crate::zonotope::query::Query;

/// How two bodies meet in a frame.
#[derive(Debug)]
pub struct Tracked<'b> {
    query: Query<'b, 3, Pose>,
    status: Status,
    certificate: Certificate,
}

/// The proof of a frame's status, as far as it was written out.
#[derive(Debug)]
pub(super) enum Certificate {
    /// A bound of the gauge in an earlier frame and the way since: inside.
    Near,
    /// A direction that separates, or all coefficients.
    Written(Location<3>),
    /// An optimum of the kernel that doubles prove.
    Rounded(Optimum),
}

impl<'b> Tracked<'b> {
    pub(super) fn new(query: Query<'b, 3, Pose>, certificate: Certificate) -> Self {
        let status = match &certificate {
            Certificate::Near => Status::Inside,
            Certificate::Written(location) => location.status(),
            Certificate::Rounded(optimum) if optimum.is_member() => Status::Inside,
            Certificate::Rounded(_) => Status::Outside,
        };
        Self { query, status, certificate }
    }

    /// Inside if the interiors of the bodies have a point in common, boundary if they only touch or their sum is flat,
    /// outside if they are disjoint; decided exactly. O(1).
    pub fn status(&self) -> Status {
        self.status
    }

    /// Whether the closed bodies have a point in common. O(1).
    pub fn is_member(&self) -> bool {
        self.status.is_member()
    }

    /// The query that the frame answered.
    pub fn query(&self) -> &Query<'b, 3, Pose> {
        &self.query
    }

    /// The status with its proof, such as [`Placed::intersection`](crate::Placed::intersection) gives it: a
    /// direction, O(1) nearly always, or a coefficient for each generator, O(n).
    pub fn location(&self) -> Location<3> {
        let location = match &self.certificate {
            Certificate::Near => locate(&self.query, &mut ()),
            Certificate::Written(location) => location.clone(),
            Certificate::Rounded(optimum) => of_optimum::location(&self.query, optimum, &mut ()),
        };
        location.with_nearest_basis(&self.query)
    }
}

impl Certificate {
    /// The proof by a direction that separates.
    pub(super) fn outside(direction: [f64; 3]) -> Self {
        Self::Written(Location::Outside(Separation::Rounded(direction)))
    }

    /// What an optimum says; one that doubles do not prove is written out, since its status takes the proof.
    pub(super) fn of_optimum(query: &Query<'_, 3, Pose>, optimum: Optimum) -> Self {
        match optimum {
            Optimum::Rounded(decided) if decided.order != Ordering::Equal => Self::Rounded(Optimum::Rounded(decided)),
            other => Self::Written(of_optimum::location(query, &other, &mut ())),
        }
    }
}
