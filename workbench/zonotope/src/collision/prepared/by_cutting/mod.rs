//! Membership and gauge of many points relative to one body, by a cutting of the dual plane: more space for faster
//! queries, as the caller chooses.
//!
//! # Statement
//! Input: a body of n generators in space, a space m from n to n², a seed. Output: a structure that answers, for any
//! point, the gauge min { t ≥ 0 : p ∈ t Z } of its displacement p from the centre, and whether the point is in the
//! interior, on the boundary or outside, exactly; the proof when it is asked for. Bodies are closed: touching is
//! boundary, and so is every member of a flat body; the gauge is infinite off the span of a flat body. Zero, vertical,
//! level, parallel and coplanar generators and none at all are ordinary input. The seed decides which cutting is found,
//! never an answer.
//!
//! # Source
//! Section 5.2, Lemma 5.3 and Corollary 5.4, with r = m / n. Departures:
//! - Every query is a ray: the facet in which the ray along p leaves the body tells the gauge, and with it membership.
//!   So there is one location, where the paper locates p_0 below the upper and above the lower hull, and there is no
//!   separate test for p_0 beside Q. The first cut is the horizon: whether the ray leaves by the upper hull, by the
//!   lower one, which is the upper one for −p, or by a vertical facet between them.
//! - The image of a cut in the tiling, a chain of edges, is kept as the order of the generators along the cut, with
//!   sums at every few of them; the image of a part is not drawn. A chain reaches only over the part in which it is
//!   asked for, which keeps the space at that of the lists.
//! - Each decision has three outcomes: on either side of a cut, or on it. A query whose optimum is on a cut is answered
//!   there. So no tile straddles trapezoids, boundary lines need not be kept among the crossing lines, walls need not
//!   be perturbed, and facets of coplanar generators are no special cases.
//! - Within a trapezoid the linear-time kernel takes the place of the search of Theorem 5.2.
//!
//! # Method
//! 1. Make a (1/r)-cutting of the lines of the generators ([`arrangement::cutting`](crate::arrangement::cutting)), with
//!    its search among the trapezoids: each step asks for the sides of at most four cuts of the part it is in.
//! 2. For each part and each cut asked for in it, sort the generators whose lines cross the part by where they turn
//!    along the cut, and keep the gradient of the support function at every few places (`structure`).
//! 3. A query decides on which side of a cut its optimum lies (`location`): the minimum of h(u) over the directions u
//!    along the cut with u · p = 1, by binary search for the edge of the chain that the ray meets; then the side of
//!    that edge.
//! 4. In the trapezoid that is found, the generators that cross it and the sum of all others are a small body, which
//!    the static method answers; its facet is checked exactly, and solved for exactly where the check fails
//!    (`cell_optimum`).
//!
//! # Complexity
//! n generators, space m, N trapezoids: a query takes at most 4 log N decisions, the logarithm to the base 3/2, each
//! O(log n), and expected O(n²/m) for the static method: O(n²/m + log² n), where the paper has O((n²/m) log² n). Where
//! parallel or coplanar generators turn together at the minimum along a cut, the decision reads all of them, and the
//! side is found in exact arithmetic if they are not parallel. N = O(r²) and the length of all lists, O(n r) = O(m),
//! are as measured as the [cutting](crate::arrangement::cutting::by_hierarchy) is. Measured on all families of bodies,
//! n to 512: at most 270 bytes a unit of m; 360 where generators are short whole numbers, 640 where they lie on a cone,
//! 770 where coordinates are so uneven that two doubles do not hold their sums. Building it takes O(m log n)
//! operations, but for what the cutting takes. The proof takes O(n) more.
//!
//! Operations of a query, random bodies, n = 4,096, r = 1, 16, 64, 1,024: 44, 627, 742 and 967 to find the trapezoid,
//! 12,706, 784, 164 and 8 in it. The latter fall with the exponent −0.99 in m; their sum with −0.66 up to m = n^1.5 and
//! −0.35 up to r = 1,024, as from there on log² n is what is left; for n = 16,384 with −0.87 up to r = 64. In time, on
//! these bodies, a query is behind one of the static method up to n = 4,096 at least: that one passes over all
//! generators, but eight at a time.
//!
//! # Shapes
//! `body`: n generators in any order, duplicates allowed; `space`: m, from n to n²; `point`: any point.
//!
//! # Numerics
//! Every decision is exact: doubles with bounds, then doubles with an exponent of their own, pairs of doubles and exact
//! numbers, on exact sums. The gauge is the quotient of two exact numbers, rounded: off by little more than half a unit
//! in the last place.
//!
//! # Errors
//! [`PreparationError::TooLittleSpace`] ⇔ m < n. [`PreparationError::TooMuchSpace`] ⇔ m > n².
//! [`PreparationError::TooMany`] ⇔ there are more than 2^31 generators. `NonFinite` ⇔ a coordinate of the point is NaN
//! or infinite.
//!
//! # Checked by
//! [`by_lad`](crate::collision::by_lad) and [`brute_force`](crate::collision::brute_force) on all families, points of
//! the boundary included; the crate `verifier` on every proof.
//!
//! # Example
//! ```
//! use zonotope::Zonotope;
//! use zonotope::collision::{Status, prepared::by_cutting::PreparedByCutting};
//! // the cube [−1, 1]³ with all the space that three generators can use
//! let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).unwrap();
//! let prepared = PreparedByCutting::new(cube, 9, 0, &mut ()).unwrap();
//! let facet = prepared.facet([2.0, 0.5, -1.0], &mut ()).unwrap();
//! assert_eq!((facet.value().0, facet.status()), (2.0, Status::Outside));
//! assert_eq!(prepared.contains([1.0, -1.0, 0.25]), Ok(true));
//! ```

mod cell_optimum;
mod facet;
mod filtered;
mod location;
mod structure;
mod target;
mod vertex;

#[cfg(test)]
mod tests;

use std::num::NonZeroU32;

use thiserror::Error;

pub use facet::Facet;

use self::location::circle::Circle;
use self::location::decision::{Decision, decide};
use self::structure::tree::{Condition, GENERATOR_LIMIT, Step, Tree};
use self::target::Target;
use self::vertex::Vertex;
use crate::arrangement::DualArrangement;
use crate::collision::{Gauge, Location, Query};
use crate::numeric::exact_linear::Span;
use crate::numeric::non_finite::NonFinite;
use crate::tally::Tally;
use crate::zonotope::Zonotope;

/// Why a body is not prepared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum PreparationError {
    /// The space is less than the number of generators.
    #[error("a space of {space} is less than the number of generators, {generators}")]
    TooLittleSpace {
        /// The space that was asked for.
        space: u64,
        /// How many generators there are.
        generators: u64,
    },
    /// The space is more than the square of the number of generators.
    #[error("a space of {space} is more than the square of the number of generators, {generators}")]
    TooMuchSpace {
        /// The space that was asked for.
        space: u64,
        /// How many generators there are.
        generators: u64,
    },
    /// There are more generators than the structure can name.
    #[error("{generators} generators are more than the {} that can be named", GENERATOR_LIMIT)]
    TooMany {
        /// How many generators there are.
        generators: u64,
    },
}

/// A body prepared for queries about points, with as much space as the caller allowed.
#[derive(Debug)]
pub struct PreparedByCutting {
    body: Zonotope<3>,
    r: NonZeroU32,
    spans_space: bool,
    tree: Tree,
}

impl PreparedByCutting {
    /// Prepares a body with a space of m, n ≤ m ≤ n² for n generators; `seed` decides which cutting is found.
    ///
    /// # Errors
    /// [`PreparationError`] if m is not between n and n², or there are more than 2^31 generators.
    pub fn new(body: Zonotope<3>, space: u64, seed: u64, tally: &mut impl Tally) -> Result<Self, PreparationError> {
        let generators = body.generators().len() as u64;
        if generators > GENERATOR_LIMIT as u64 {
            return Err(PreparationError::TooMany { generators });
        }
        if space < generators {
            return Err(PreparationError::TooLittleSpace { space, generators });
        }
        if space > generators * generators {
            return Err(PreparationError::TooMuchSpace { space, generators });
        }
        let r = u32::try_from(space.checked_div(generators).unwrap_or(1)).ok().and_then(NonZeroU32::new);
        let r = r.expect("the quotient is between 1 and n, because the space is between n and n²");
        let dual = DualArrangement::of_runs([body.generators(), &[]], [0, 1, 2], tally);
        let tree = Tree::new(&dual, body.generators(), r, seed, tally);
        let spans_space = Span::of_doubles(body.generators()).rank() == 3;
        drop(dual);
        Ok(Self { body, r, spans_space, tree })
    }

    /// The body.
    pub fn body(&self) -> &Zonotope<3> {
        &self.body
    }

    /// The parameter of the cutting: m / n, rounded down.
    pub fn r(&self) -> u32 {
        self.r.get()
    }

    /// How many bytes the structure holds beside the body.
    pub fn bytes(&self) -> u64 {
        self.tree.bytes()
    }

    /// How many trapezoids the cutting has.
    pub fn trapezoid_count(&self) -> usize {
        self.tree.trapezoid_count()
    }

    /// The facet in which the ray from the centre through a point leaves the body: gauge and status.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn facet(&self, point: [f64; 3], tally: &mut dyn Tally) -> Result<Facet<'_>, NonFinite> {
        let query = Query::of_point(point, &self.body)?;
        let Some(target) = Target::new(query) else { return Ok(Facet::of_center(query, self.spans_space)) };
        let (vertex, is_opposite) = self.optimum(target, tally);
        Ok(Facet::of_vertex(query, self.spans_space, vertex, is_opposite))
    }

    /// Whether a point lies in the closed body, exactly.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn contains(&self, point: [f64; 3]) -> Result<bool, NonFinite> {
        Ok(self.facet(point, &mut ())?.is_member())
    }

    /// Where a point lies, with a proof, which takes O(n) more.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn locate(&self, point: [f64; 3]) -> Result<Location<3>, NonFinite> {
        let query = Query::of_point(point, &self.body)?;
        Ok(self.facet(point, &mut ())?.location().with_nearest_basis(&query))
    }

    /// How many times the body must be taken, from its centre, to hold a point; with the proof of where the point lies,
    /// which takes O(n) more.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn gauge(&self, point: [f64; 3]) -> Result<Gauge<3>, NonFinite> {
        let query = Query::of_point(point, &self.body)?;
        Ok(self.facet(point, &mut ())?.gauge().with_nearest_basis(&query))
    }

    /// The optimum for a displacement, or for its opposite, which the second value says.
    fn optimum<'b>(&'b self, target: Target<'b>, tally: &mut dyn Tally) -> (Vertex, bool) {
        let (tree, generators) = (&self.tree, self.body.generators());
        let decide_at = |cut: u32, target: &Target<'_>, tally: &mut dyn Tally| {
            decide(&Circle::of(tree, &tree.cuts[cut as usize], generators), target, tally)
        };
        let (target, is_opposite) = match decide_at(0, &target, tally) {
            Decision::On(vertex) => return (*vertex, false),
            Decision::Beyond => (target, false),
            Decision::Before => (target.opposite(generators), true),
        };
        // several tests of a part may ask for the same cut
        let mut known: Vec<Condition> = Vec::new();
        let mut step = 0;
        loop {
            match &tree.steps[step as usize] {
                Step::Trapezoid(trapezoid) => {
                    return (cell_optimum::optimum_in(tree, trapezoid, &target, tally), is_opposite);
                }
                Step::Test { conditions, within, outside } => {
                    step = *within;
                    for condition in conditions.iter().flatten() {
                        let known_side = known.iter().find(|side| side.cut == condition.cut);
                        let is_beyond = match known_side.map(|side| side.is_beyond) {
                            Some(is_beyond) => is_beyond,
                            None => {
                                let is_beyond = match decide_at(condition.cut, &target, tally) {
                                    Decision::On(vertex) => return (*vertex, is_opposite),
                                    Decision::Before => false,
                                    Decision::Beyond => true,
                                };
                                known.push(Condition { is_beyond, ..*condition });
                                is_beyond
                            }
                        };
                        if is_beyond != condition.is_beyond {
                            step = *outside;
                            break;
                        }
                    }
                }
            }
        }
    }
}
