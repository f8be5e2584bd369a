//! What posed trees answer: a status with a proof of constant size, which is written out when it is asked for.

use super::PosedTrees;
use crate::collision::prepared::by_direction_tree::answer::{Found, in_order_of_bodies, is_strict};
use crate::collision::prepared::by_direction_tree::clear::Told;
use crate::collision::proof::of_optimum;
use crate::collision::{Location, Separation, Status};
use crate::lad::of_generators::goal::Goal;
use crate::lad::of_generators::solve;

/// Where a displacement lies relative to posed bodies, with a proof that was not written out.
#[derive(Debug)]
pub struct PosedLocated<'t> {
    pub(super) query: PosedTrees<'t>,
    pub(super) found: Found,
}

/// How many times posed bodies must be taken to hold a displacement.
#[derive(Debug)]
pub struct PosedMeasured<'t> {
    /// The gauge, within [`error`](Self::error).
    pub value: f64,
    /// A bound for |`value` − gauge|.
    pub error: f64,
    /// Where the displacement lies.
    pub location: PosedLocated<'t>,
}

impl PosedLocated<'_> {
    /// Whether the displacement lies inside, on the boundary or outside. O(1), but for members of bodies that are flat
    /// or nearly so.
    pub fn status(&self) -> Status {
        let is_inner = match &self.found {
            Found::Told(Told::Inside(_)) => Some(true),
            Found::Told(Told::Outside(_)) => None,
            Found::Told(Told::Written(location)) => return location.status(),
            Found::Facet(optimum) => is_strict(optimum),
        };
        match is_inner {
            None => Status::Outside,
            Some(false) => Status::Boundary,
            Some(true) if self.query.is_solid() => Status::Inside,
            Some(true) => self.expand().status(),
        }
    }

    /// Whether the displacement is in the closed body, or the closed bodies meet. O(1).
    pub fn is_member(&self) -> bool {
        match &self.found {
            Found::Told(Told::Outside(_)) => false,
            Found::Told(Told::Inside(_)) => true,
            Found::Told(Told::Written(location)) => location.is_member(),
            Found::Facet(optimum) => optimum.is_member(),
        }
    }

    /// The location with the proof that a verifier takes as it stands: a coefficient for each generator, those of the
    /// first body first and each in the order of its body, or a separating direction. O(n) for a member.
    pub fn expand(&self) -> Location<3> {
        let in_order_of_trees = match &self.found {
            Found::Told(Told::Outside(u)) => return Location::Outside(Separation::Rounded(*u)),
            Found::Told(Told::Written(location)) => location.clone(),
            Found::Told(Told::Inside(_)) => {
                of_optimum::location(&self.query, &solve(&self.query, Goal::Location, &mut ()), &mut ())
            }
            Found::Facet(optimum) => of_optimum::location(&self.query, optimum, &mut ()),
        };
        let trees: Vec<_> = self.query.tree_parts().map(|part| part.tree).collect();
        in_order_of_bodies(in_order_of_trees.with_nearest_basis(&self.query.query), &trees)
    }
}
