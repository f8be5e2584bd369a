//! The answer of the tree: a status with a proof of constant size, which is written out when it is asked for.

use std::cmp::Ordering;

use smallvec::SmallVec;

use super::DirectionTree;
use super::query::TreeQuery;
use crate::collision::by_lad::early::combination::Written;
use crate::collision::proof::of_optimum;
use crate::collision::{Location, Separation, Status, Witness};
use crate::lad::of_generators::goal::Goal;
use crate::lad::of_generators::nearest_gauge::nearest_gauge;
use crate::lad::of_generators::optimum::Optimum;
use crate::lad::of_generators::seam::part::Carried;
use crate::lad::of_generators::solve;
use crate::numeric::exact_linear::rounded_direction;
use crate::numeric::tolerance::NODE_BODY_STRETCH;
use crate::zonotope::pose::{AtRest, Standing};

/// The location of a displacement relative to the bodies of one or two trees, with a proof that was not written out.
#[derive(Debug)]
pub struct Located<'t, P = AtRest> {
    pub(super) query: TreeQuery<'t, P>,
    pub(super) certified: Certified,
}

/// The proof as it was found.
#[derive(Debug)]
pub(super) enum Certified {
    /// The coefficients of the nodes of the first fronts, whose sum is nearly the displacement times
    /// [`NODE_BODY_STRETCH`].
    Sums(Vec<f64>),
    /// A direction that separates, or coefficients of all generators in the order of the trees.
    Written(Location<3>),
    /// The facet in which the ray leaves.
    Facet(Optimum),
}

/// The gauge: the number of times that the bodies must be taken to hold a displacement.
#[derive(Debug)]
pub struct Measured<'t, P = AtRest> {
    /// The gauge, within [`error`](Self::error).
    pub value: f64,
    /// A bound for |`value` − gauge|.
    pub error: f64,
    /// The location of the displacement.
    pub location: Located<'t, P>,
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

impl<P: Standing> Measured<'_, P> {
    /// The gauge within four units in the last place, and a bound of its error. O(√n) nodes of a random body, or one
    /// pass where sums of nodes are not exact.
    pub fn nearest_value(&self) -> (f64, f64) {
        match &self.location.certified {
            Certified::Facet(optimum) => nearest_gauge(&self.location.query, optimum, &mut ()),
            Certified::Sums(_) | Certified::Written(_) => (self.value, self.error),
        }
    }
}

impl<P: Standing> Located<'_, P> {
    /// Whether the displacement lies inside, on the boundary or outside. O(1), but for members of posed bodies that are
    /// flat or nearly so.
    pub fn status(&self) -> Status {
        let is_strict = match &self.certified {
            Certified::Sums(_) => Some(true),
            Certified::Written(location) => return location.status(),
            Certified::Facet(optimum) => is_strict(optimum),
        };
        match is_strict {
            None => Status::Outside,
            Some(false) => Status::Boundary,
            Some(true) if self.query.is_solid() => Status::Inside,
            // one tree at rest knows whether its body is flat
            Some(true) if P::IS_FIXED => Status::Boundary,
            Some(true) => self.expand().status(),
        }
    }

    /// Whether the displacement is in the closed body, or the closed bodies meet. O(1).
    pub fn is_member(&self) -> bool {
        match &self.certified {
            Certified::Sums(_) => true,
            Certified::Written(location) => location.is_member(),
            Certified::Facet(optimum) => optimum.is_member(),
        }
    }

    /// The proof as it was found. O(1), but for flat bodies and those of lengths that are far apart.
    pub fn certificate(&self) -> Certificate {
        match &self.certified {
            Certified::Sums(parts) => return Certificate::Sums(parts.clone()),
            Certified::Facet(optimum) if self.is_member() => {
                let direction = match optimum {
                    Optimum::Rounded(decided) => Some(decided.optimum.direction.map(|c| c.value)),
                    Optimum::Exact(exact) => Some(rounded_direction(&exact.direction)),
                    _ => None,
                };
                if let Some(direction) = direction {
                    let basis = in_order_of_bodies(optimum.basis(), &self.trees());
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

    /// The location with the proof that a verifier takes as it stands: a coefficient for each generator, those of the
    /// first body first and each in the order of its body, or a separating direction. O(n) for a member.
    pub fn expand(&self) -> Location<3> {
        let of_optimum = |optimum: &Optimum| of_optimum::location(&self.query, optimum, &mut ());
        let in_order_of_trees = match &self.certified {
            Certified::Written(location) => location.clone(),
            Certified::Facet(optimum) => of_optimum(optimum),
            Certified::Sums(parts) => match self.written(parts) {
                Some(witness) => Location::Inside(witness),
                None => of_optimum(&solve(&self.query, Goal::Location, &mut ())),
            },
        };
        let trees = self.trees();
        match in_order_of_trees.with_nearest_basis(&self.query.query) {
            Location::Inside(witness) => Location::Inside(witness_of_bodies(&witness, &trees)),
            Location::Boundary(witness) => Location::Boundary(witness_of_bodies(&witness, &trees)),
            Location::Outside(separation) => Location::Outside(separation),
        }
    }

    fn trees(&self) -> SmallVec<[&DirectionTree; 2]> {
        self.query.trees.iter().flatten().copied().collect()
    }

    /// The coefficients of nodes for each generator, with three generators that make up for the rounding of sums.
    fn written(&self, parts: &[f64]) -> Option<Witness> {
        let mut coefficients = vec![0.0; self.query.query.len()];
        let (mut nodes, mut start) = (parts.iter(), 0);
        let mut own = Vec::new();
        for part in self.query.tree_parts() {
            let front = &part.tree.first_front;
            let mut sum = [0.0; 3];
            for ((rows, node), &share) in front.rows.iter().zip(&front.sums).zip(&mut nodes) {
                let share = share / NODE_BODY_STRETCH;
                coefficients[start..][rows.clone()].fill(share);
                sum = [0, 1, 2].map(|k| sum[k] + share * node[k]);
            }
            let written = Written { sum, magnitude: part.tree.length * 2.0, count: part.tree.rows.len() };
            own.push(part.frame.map_or(written, |frame| written.carried(&frame)));
            start += part.tree.rows.len();
        }
        let written = own.into_iter().reduce(Written::joined)?;
        written.witness(&self.query.query, &self.query.query.rounded_displacement(), coefficients)
    }
}

/// Whether the gauge is below 1; none where it is above.
fn is_strict(optimum: &Optimum) -> Option<bool> {
    match optimum {
        Optimum::Center => Some(true),
        Optimum::Separated(_) | Optimum::Ended => None,
        Optimum::Rounded(decided) => (decided.order == Ordering::Less).then_some(true),
        Optimum::Exact(exact) => match exact.along.cmp(&exact.reach) {
            Ordering::Less => Some(true),
            Ordering::Equal => Some(false),
            Ordering::Greater => None,
        },
        Optimum::Flat(flat) => flat.optimum.is_member().then_some(false),
    }
}

/// Indices of rows of some trees, tree by tree, as those of generators of their bodies, in increasing order.
fn in_order_of_bodies(rows: &[usize], trees: &[&DirectionTree]) -> Vec<usize> {
    let mut own: Vec<usize> = Vec::with_capacity(rows.len());
    let mut offset = 0;
    for tree in trees {
        let range = offset..offset + tree.len();
        own.extend(rows.iter().filter(|b| range.contains(b)).map(|&b| offset + tree.places[b - offset] as usize));
        offset = range.end;
    }
    own.sort_unstable();
    own
}

/// A witness with a coefficient for each row of some trees, tree by tree, for each generator of their bodies.
fn witness_of_bodies(witness: &Witness, trees: &[&DirectionTree]) -> Witness {
    let mut coefficients = vec![0.0; witness.coefficients.len()];
    let mut offset = 0;
    for tree in trees {
        let rows = witness.coefficients[offset..].iter().zip(&tree.places).zip(&tree.is_turned);
        for ((&c, &place), &is_turned) in rows {
            coefficients[offset + place as usize] = if is_turned { -c } else { c };
        }
        offset += tree.len();
    }
    Witness { coefficients, basis: in_order_of_bodies(&witness.basis, trees) }
}
