//! What the tree answers: a status with a proof of constant size, which is written out when it is asked for.

use std::cmp::Ordering;

use super::DirectionTree;
use super::clear::Told;
use super::query::TreeQuery;
use crate::collision::by_lad::early::combination::Written;
use crate::collision::proof::of_optimum;
use crate::collision::{Location, Separation, Status, Witness};
use crate::lad::of_generators::goal::Goal;
use crate::lad::of_generators::nearest_gauge::nearest_gauge;
use crate::lad::of_generators::optimum::Optimum;
use crate::lad::of_generators::seam::generators::KernelQuery;
use crate::lad::of_generators::solve;
use crate::numeric::exact_linear::rounded_direction;
use crate::numeric::tolerance::NODE_BODY_STRETCH;

/// Where a displacement lies relative to the body of a tree, with a proof that was not written out.
#[derive(Debug)]
pub struct Located<'t> {
    pub(super) query: TreeQuery<'t>,
    pub(super) found: Found,
}

/// How a location was told.
#[derive(Debug)]
pub(super) enum Found {
    /// Because it is clear.
    Told(Told),
    /// By the facet in which the ray leaves.
    Facet(Optimum),
}

/// How many times the body must be taken to hold a displacement.
#[derive(Debug)]
pub struct Measured<'t> {
    /// The gauge, within [`error`](Self::error).
    pub value: f64,
    /// A bound for |`value` − gauge|.
    pub error: f64,
    /// Where the displacement lies.
    pub location: Located<'t>,
}

/// A proof that was not written out.
#[derive(Debug, Clone, PartialEq)]
pub enum Certificate {
    /// A direction that separates.
    Separation(Separation<3>),
    /// Coefficients of a hundred sums of generators of neighbouring directions: each stands for all generators of its
    /// sum.
    Sums(Vec<f64>),
    /// The facet in which the ray leaves the body.
    Facet {
        /// A direction u orthogonal to the facet, but for rounding: the coefficients of all other generators are the
        /// signs of their products with u, over λ.
        direction: [f64; 3],
        /// Generators of the facet, the coefficients of which make up for the rest.
        basis: Vec<usize>,
    },
    /// A coefficient for each generator: of flat bodies, and of those whose sums doubles do not hold.
    Written(Witness),
}

impl Measured<'_> {
    /// The gauge within four units in the last place, and a bound of its error. O(√n) nodes of a random body, or one
    /// pass where sums of nodes are not exact.
    pub fn nearest_value(&self) -> (f64, f64) {
        match &self.location.found {
            Found::Facet(optimum) => nearest_gauge(&self.location.query, optimum, &mut ()),
            Found::Told(_) => (self.value, self.error),
        }
    }
}

impl Located<'_> {
    /// Whether the displacement lies inside, on the boundary or outside. O(1).
    pub fn status(&self) -> Status {
        let is_inner = match &self.found {
            Found::Told(Told::Inside(_)) => true,
            Found::Told(Told::Outside(_)) => return Status::Outside,
            Found::Told(Told::Written(location)) => return location.status(),
            Found::Facet(optimum) => match is_strict(optimum) {
                Some(is_strict) => is_strict,
                None => return Status::Outside,
            },
        };
        if is_inner && self.query.tree.is_solid { Status::Inside } else { Status::Boundary }
    }

    /// Whether the displacement is in the closed body. O(1).
    pub fn is_member(&self) -> bool {
        self.status().is_member()
    }

    /// The proof as it was found. O(1), but for flat bodies and those of lengths that are far apart.
    pub fn certificate(&self) -> Certificate {
        let tree = self.query.tree;
        match &self.found {
            Found::Told(Told::Inside(parts)) => return Certificate::Sums(parts.clone()),
            Found::Facet(optimum) if self.is_member() => {
                let direction = match optimum {
                    Optimum::Rounded(decided) => Some(decided.optimum.direction.map(|c| c.value)),
                    Optimum::Exact(exact) => Some(rounded_direction(&exact.direction)),
                    _ => None,
                };
                if let Some(direction) = direction {
                    let basis = optimum.basis().iter().map(|&place| tree.places[place] as usize).collect();
                    return Certificate::Facet { direction, basis };
                }
            }
            _ => {}
        }
        match self.expand() {
            Location::Outside(separation) => Certificate::Separation(separation),
            Location::Inside(witness) | Location::Boundary(witness) => Certificate::Written(witness),
        }
    }

    /// The location with the proof that the library's verifier takes: a coefficient for each generator of the body, in
    /// its order, or a separating direction. O(n) for a member.
    pub fn expand(&self) -> Location<3> {
        let tree = self.query.tree;
        match &self.found {
            Found::Told(Told::Outside(u)) => Location::Outside(Separation::Rounded(*u)),
            Found::Told(Told::Inside(parts)) => match self.written(parts) {
                Some(witness) => in_order_of_bodies(Location::Inside(witness), &[tree]),
                None => self.expanded_facet(&solve(&self.query, Goal::Location, &mut ())),
            },
            Found::Told(Told::Written(location)) => in_order_of_bodies(location.clone(), &[tree]),
            Found::Facet(optimum) => self.expanded_facet(optimum),
        }
    }

    fn expanded_facet(&self, optimum: &Optimum) -> Location<3> {
        in_order_of_bodies(of_optimum::location(&self.query, optimum, &mut ()), &[self.query.tree])
    }

    /// The coefficients of nodes for each generator, with three generators that make up for the rounding of sums.
    fn written(&self, parts: &[f64]) -> Option<Witness> {
        let tree = self.query.tree;
        let mut coefficients = vec![0.0; tree.rows.len()];
        let mut sum = [0.0; 3];
        let front = &tree.first_front;
        for ((part, rows), own) in parts.iter().zip(&front.rows).zip(&front.sums) {
            let part = part / NODE_BODY_STRETCH;
            coefficients[rows.clone()].fill(part);
            sum = [0, 1, 2].map(|k| sum[k] + part * own[k]);
        }
        let written = Written { sum, magnitude: tree.length * 2.0, count: tree.rows.len() };
        written.witness(&self.query.query, &KernelQuery::rounded_displacement(&self.query.query), coefficients)
    }
}

/// Whether the gauge is below 1; none where it is above.
pub(super) fn is_strict(optimum: &Optimum) -> Option<bool> {
    match optimum {
        Optimum::Centre => Some(true),
        Optimum::Told(_) => None,
        Optimum::Rounded(decided) => (decided.order == Ordering::Less).then_some(true),
        Optimum::Exact(exact) => match exact.along.cmp(&exact.reach) {
            Ordering::Less => Some(true),
            Ordering::Equal => Some(false),
            Ordering::Greater => None,
        },
        Optimum::Flat(flat) => flat.optimum.is_member().then_some(false),
    }
}

/// A location with a coefficient for each row of some trees, tree by tree, for each generator of their bodies.
pub(super) fn in_order_of_bodies(location: Location<3>, trees: &[&DirectionTree]) -> Location<3> {
    match location {
        Location::Inside(witness) => Location::Inside(witness_of_bodies(&witness, trees)),
        Location::Boundary(witness) => Location::Boundary(witness_of_bodies(&witness, trees)),
        Location::Outside(separation) => Location::Outside(separation),
    }
}

fn witness_of_bodies(witness: &Witness, trees: &[&DirectionTree]) -> Witness {
    let mut coefficients = vec![0.0; witness.coefficients.len()];
    let mut basis = Vec::with_capacity(witness.basis.len());
    let mut offset = 0;
    for tree in trees {
        let own = offset..offset + tree.len();
        for ((&c, &place), &is_turned) in
            witness.coefficients[own.clone()].iter().zip(&tree.places).zip(&tree.is_turned)
        {
            coefficients[offset + place as usize] = if is_turned { -c } else { c };
        }
        let in_tree = witness.basis.iter().filter(|b| own.contains(b));
        basis.extend(in_tree.map(|&b| offset + tree.places[b - offset] as usize));
        offset = own.end;
    }
    basis.sort_unstable();
    Witness { coefficients, basis }
}
