//! Repeated queries, by a tree over the directions of the generators: sums of neighbours take the place of generators
//! wherever their signs are the same.
//!
//! # Statement
//! Input: a zonotope Z of space. Output: a [`DirectionTree`] that answers for any point where it lies relative to Z
//! ([`locate`](DirectionTree::locate)), how many times Z must be taken to hold it ([`gauge`](DirectionTree::gauge)),
//! and how far Z reaches in a direction ([`support`](DirectionTree::support)); and the same of Z where a pose puts it,
//! with how two such bodies meet ([`at`](DirectionTree::at)). Z is closed: touching is
//! [`Status::Boundary`](crate::collision::Status::Boundary), and so is every member of a flat Z. Zero, parallel and
//! coplanar generators and none at all are ordinary input.
//!
//! # Source
//! Corollary 5.4 for m = n. The paper's structure of Lemma 5.3 needs O(n log² n) for a query with so little space, more
//! than a scan; a tree over directions is not in the paper.
//!
//! # Method
//! 1. The generators are turned to one side and ordered by a k-d tree over their places on three faces of a cube
//!    (`order`). Runs of 64 are leaves, eight runs make the next one; each node has its sum and a slab around its
//!    directions (`nodes`, `slab`).
//! 2. For a cell of directions, a node whose slab is on one side of it counts with its sum; the others are opened, and
//!    the generators of crossed leaves are read (`walk`). For a single direction these are the leaves on a great
//!    circle. That makes the tree an implementor of the kernel's seam (`query`), and every stage of the kernel runs on
//!    it.
//! 3. A point far inside or far outside is located by a hundred nodes, the sums of which are a body within Z, and whose
//!    slabs bound Z from outside (`early`).
//! 4. For other points the nodes give a cell that probably holds the optimum, level by level (`guess`); the kernel sums
//!    up what misses it, searches the few generators that cross it, and certifies what it finds. Where the point is too
//!    near to the boundary for doubles, sums of nodes without rounding decide (`exact_sums`).
//! 5. A body under a pose, or two, are asked without touching a tree: cells and directions are pulled back into the
//!    frame of the tree, sums are pushed forward (`placed`).
//! 6. The answer keeps the form in which it was proved; the coefficients of all generators are written when they are
//!    asked for (`answer`).
//!
//! # Complexity
//! n generators: built in O(n log n), about 32 bytes for each, the generators themselves included. Points far from the
//! boundary O(1). Of random bodies a support value and an exact query take O(√n), as a great circle meets that many
//! leaves: n from 2^10 to 2^14, an exact query reads 15 to 30 √n nodes and generators. Where the body is flat, many
//! generators are parallel to the optimum's facet, or lengths are far apart, the kernel's other rungs read all
//! generators, some of them several times: of bodies near a plane, up to 5 times what the kernel reads without a tree.
//!
//! # Shapes
//! `body`: any order, duplicates allowed. Bases and coefficients are those of the body's order.
//!
//! # Numerics
//! The status is exact for every point of doubles. The gauge is within `error`, at most 2^-36 of it. Sums of nodes are
//! rounded once, and their error is part of every bound; where lengths add up to less than 2^-200 or more than 2^200,
//! the nodes are not used.
//!
//! # Errors
//! [`NonFinite`] if a coordinate of a point or direction is NaN or infinite.
//!
//! # Checked by
//! The kernel without a tree and the rational twin, on all families; the verifier, on every proof that is written out.
//!
//! # Example
//! ```
//! use zonotope::Zonotope;
//! use zonotope::collision::Status;
//! use zonotope::collision::prepared::DirectionTree;
//! // the cube [−1, 1]³
//! let axes = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
//! let tree = DirectionTree::new(&Zonotope::new([0.0; 3], axes).unwrap());
//! assert_eq!(tree.locate([0.5, 1.0, 0.0], &mut ()).unwrap().status(), Status::Boundary);
//! assert_eq!(tree.gauge([2.0, 0.0, 1.0], &mut ()).unwrap().value, 2.0);
//! ```

mod answer;
mod early;
mod exact_sums;
mod guess;
mod nodes;
mod order;
mod part;
mod placed;
mod query;
mod slab;
mod support;
mod walk;

#[cfg(test)]
mod tests;

pub use answer::{Certificate, Located, Measured};
pub use placed::PlacedTree;

use self::exact_sums::ExactSums;
use self::nodes::{Face, Front, leaves};
use self::order::Ordered;
use crate::collision::proof::balance::basis::Basis;
use crate::lad::of_generators::certify::unit_gauge_bound::unit_gauge_bound;
use crate::numeric::non_finite::NonFinite;
use crate::numeric::tolerance::{LONG_SUM, MODERATE_SIZES};
use crate::tally::Tally;
use crate::zonotope::query::Query;
use crate::zonotope::{PreparedBody, Zonotope};

/// The most nodes that locate points far from the boundary: the body of their sums reaches as far as the body itself
/// but for some percent.
const FIRST_FRONT: usize = 96;

/// At most so many nodes are searched without a cell.
const MIDDLE_FRONT: usize = 1024;

/// √3, rounded up: |v| in terms of the largest coordinate of v.
const LONGEST_OF_WEIGHT: f64 = 1.732_050_807_568_878;

/// A body of space with a tree over the directions of its generators, for many queries.
#[derive(Debug)]
pub struct DirectionTree {
    center: [f64; 3],
    /// The generators in the order of the tree.
    rows: Vec<[f64; 3]>,
    /// The index of each in the body, and whether it was turned.
    places: Vec<u32>,
    is_turned: Vec<bool>,
    faces: [Face; 3],
    first_front: Front,
    /// The body of the first front's sums; none where a sum overflows.
    first_body: Option<PreparedBody>,
    middle_front: Front,
    /// A level of which no node is smaller than those of the middle front, but for the last one of a face.
    middle_level: usize,
    exact_sums: Option<ExactSums>,
    /// At least Σ w, w being the largest coordinate of a generator, and at least Σ |v|.
    weight: f64,
    length: f64,
    /// Whether sums neither overflow nor are lost to underflow.
    is_moderate: bool,
    /// s such that the gauge of any x is at most s |x|_1; infinite where doubles do not tell.
    gauge_bound: f64,
    /// Whether rounded sums of nodes locate points far from the boundary.
    is_located_by_nodes: bool,
    /// Whether the generators span space.
    is_solid: bool,
}

impl DirectionTree {
    /// The tree of a body, which is copied. O(n log n).
    pub fn new(body: &Zonotope<3>) -> Self {
        let ordered = Ordered::new(body.generators());
        let leaves = leaves(&ordered);
        let faces = [0, 1, 2].map(|face| Face::new(ordered.faces[face].clone(), &leaves[face]));
        let first_front = Front::new(&ordered, &leaves, FIRST_FRONT);
        let middle_front = Front::new(&ordered, &leaves, MIDDLE_FRONT);
        let weight = first_front.blocks.iter().flat_map(|block| block.weight).sum::<f64>() * LONG_SUM;
        let first_body = Zonotope::new([0.0; 3], first_front.sums.clone()).ok().map(PreparedBody::new);
        let Ordered { rows, places, is_turned, .. } = ordered;
        let query = Query::of_finite([0.0; 3], [0.0; 3], &rows);
        let gauge_bound = unit_gauge_bound(&query, 1);
        let is_solid = gauge_bound.is_finite() || Basis::spanning(&query, Basis::new(Vec::new())).0.rank() == 3;
        let is_moderate = MODERATE_SIZES.contains(&weight);
        Self {
            center: body.center(),
            middle_level: middle_front.level,
            exact_sums: ExactSums::new(&rows, &faces),
            rows,
            places,
            is_turned,
            faces,
            first_front,
            first_body,
            middle_front,
            weight,
            length: weight * LONGEST_OF_WEIGHT * LONG_SUM,
            is_moderate,
            gauge_bound,
            is_located_by_nodes: is_moderate && Self::rounding_is_little(gauge_bound, weight),
            is_solid,
        }
    }

    /// The number of generators of the body.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether the body is a point.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// The generators of each leaf, turned to one side, by their indices in the body: for pictures of the tree.
    pub fn leaves(&self) -> impl Iterator<Item = &[u32]> {
        self.faces.iter().flat_map(|face| (0..face.leaves()).map(|leaf| &self.places[face.leaf(leaf)]))
    }

    /// The bytes that are held, the generators included.
    pub fn bytes(&self) -> usize {
        let own = size_of_val(&self.rows[..]) + size_of_val(&self.places[..]) + size_of_val(&self.is_turned[..]);
        let fronts = [&self.first_front, &self.middle_front].map(Front::bytes);
        own + self.faces.iter().map(Face::bytes).sum::<usize>()
            + fronts.iter().sum::<usize>()
            + self.exact_sums.as_ref().map_or(0, ExactSums::bytes)
    }

    /// Whether a point lies in the closed body, exactly.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn contains(&self, point: [f64; 3]) -> Result<bool, NonFinite> {
        Ok(self.locate(point, &mut ())?.is_member())
    }

    /// The location of a point relative to the body, exactly, with a proof that is written out on request.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn locate(&self, point: [f64; 3], tally: &mut dyn Tally) -> Result<Located<'_>, NonFinite> {
        self.placed().locate(point, tally)
    }

    /// The gauge: the number of times that the body must be taken, from its centre, to hold a point.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn gauge(&self, point: [f64; 3], tally: &mut dyn Tally) -> Result<Measured<'_>, NonFinite> {
        self.placed().gauge(point, tally)
    }
}
