//! What a frame answers: the status, with a proof that is written out when it is asked for.

use std::cmp::Ordering;

use crate::collision::by_lad::locate_posed;
use crate::collision::proof::of_optimum;
use crate::collision::{Location, Separation, Status};
use crate::lad::of_generators::optimum::Optimum;
use crate::lad::of_generators::seam::generators::Posed;
use crate::lad::of_generators::told::Told;
use crate::zonotope::posed_query::PosedQuery;

/// How two bodies meet in a frame.
#[derive(Debug)]
pub struct Tracked<'b> {
    query: PosedQuery<'b>,
    status: Status,
    found: Found,
}

/// How the status was found.
#[derive(Debug)]
pub(super) enum Found {
    /// By a bound of the gauge in an earlier frame and the way since: inside.
    Near,
    /// By a direction that separates.
    Separated([f64; 3]),
    /// With all coefficients.
    Located(Location<3>),
    /// By an optimum of the kernel that doubles prove.
    Rounded(Optimum),
}

impl<'b> Tracked<'b> {
    pub(super) fn new(query: PosedQuery<'b>, found: Found) -> Self {
        let status = match &found {
            Found::Near => Status::Inside,
            Found::Separated(_) => Status::Outside,
            Found::Located(location) => location.status(),
            Found::Rounded(optimum) if optimum.is_member() => Status::Inside,
            Found::Rounded(_) => Status::Outside,
        };
        Self { query, status, found }
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
    pub fn query(&self) -> &PosedQuery<'b> {
        &self.query
    }

    /// The status with its proof, such as [`PosedZonotope::intersection`](crate::collision::PosedZonotope) gives it: a
    /// direction, O(1) nearly always, or a coefficient for each generator, O(n).
    pub fn location(&self) -> Location<3> {
        let location = match &self.found {
            Found::Near => locate_posed(&self.query),
            Found::Separated(direction) => Location::Outside(Separation::Rounded(*direction)),
            Found::Located(location) => location.clone(),
            Found::Rounded(optimum) => of_optimum::location(&Posed::new(&self.query), optimum, &mut ()),
        };
        location.with_nearest_basis(&self.query)
    }
}

impl Found {
    /// What an optimum says; one that doubles do not prove is written out, since its status takes the proof.
    pub(super) fn of_optimum(query: &PosedQuery<'_>, optimum: Optimum) -> Self {
        match optimum {
            Optimum::Told(Told::Separated(direction)) => Self::Separated(direction),
            Optimum::Rounded(decided) if decided.order != Ordering::Equal => Self::Rounded(Optimum::Rounded(decided)),
            other => Self::Located(of_optimum::location(&Posed::new(query), &other, &mut ())),
        }
    }
}
