//! The tree as an implementor of the kernel's seam: passes over the generators become walks over the nodes.
//!
//! A displacement is asked about in the order of the tree. Support values and the sums over a cell of directions come
//! from the nodes that miss the cell and from the leaves that cross it; what a search needs beside these (a first cell,
//! how thick the body is) is known beforehand. All rows are there for the rungs that read them.

use std::ops::Range;

use smallvec::SmallVec;

use super::DirectionTree;
use super::guess::cell_near_optimum;
use super::nodes::Face;
use super::part::TreePart;
use super::walk::{Nodes, Visitor, walk};
use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::lad::of_generators::seam::generators::Generators;
use crate::lad::of_generators::seam::kernel_query::{InDoubles, KernelQuery};
use crate::lad::of_generators::seam::part::Part;
use crate::lad::of_generators::seam::sign_pass::{FixedSum, Places, USUAL_CROSSING};
use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::numeric::double_double::{BoundedDoubleDouble, DoubleDoubleDirection};
use crate::numeric::exact_linear::{self, ExactVector, exact, rounded_direction};
use crate::numeric::lanes::bounded_sum;
use crate::numeric::lanes::rows::Rows;
use crate::numeric::linear::dot;
use crate::numeric::signed_sum::signed_sum;
use crate::numeric::tolerance::{EXACT_DIRECTION_ROUNDING, NODE_SUM_ROUNDING};
use crate::tally::Tally;
use crate::zonotope::pose::{AtRest, Standing};
use crate::zonotope::query::Query;

/// Memory for so many generators is taken for those that cross a cell; few cells are crossed by more.
pub(super) const LIKELY_CROSSING: usize = 1024;

/// A displacement relative to the generators of one or two trees where their bodies stand, in the order of the trees.
#[derive(Debug, Clone, Copy)]
pub(super) struct TreeQuery<'t, P = AtRest> {
    pub(super) query: Query<'t, 3, P>,
    /// The tree of each run; the second run may be empty.
    pub(super) trees: [Option<&'t DirectionTree>; 2],
}

/// The rows of the leaves that a walk crosses.
struct Leaves<'t> {
    faces: &'t [Face; 3],
    ranges: Vec<Range<usize>>,
}

impl Visitor for Leaves<'_> {
    #[inline(always)]
    fn crossed(&mut self, nodes: Nodes) {
        self.faces[nodes.face].push_leaves(nodes.block, nodes.lanes, &mut self.ranges);
    }
}

impl DirectionTree {
    /// The sum of the generators whose sign is fixed in a cell; the places of the others are added to a list.
    pub(super) fn split(&self, cell: &DirectionCone, places: &mut Places) -> FixedSum {
        let mut crossed = Leaves { faces: &self.faces, ranges: Vec::with_capacity(512) };
        let walked = walk(&self.faces, cell, 0, &mut crossed);
        let rows = cell.split_ranges(Rows::new(&self.rows), &crossed.ranges, places);
        let nodes =
            FixedSum { sum: walked.sum, magnitude: 0.0, error: NODE_SUM_ROUNDING * self.weight, read: walked.read };
        FixedSum { magnitude: self.length, ..nodes.plus(&rows) }
    }

    /// Σ sign · v with the signs of the products with a direction, exactly, and the places of the generators that are
    /// orthogonal to it, which are left out; none where sums of nodes are not exact. O(√n) nodes of a random body.
    pub(super) fn exact_sum_along(&self, direction: &ExactVector) -> Option<(ExactVector, Places)> {
        let sums = self.exact_sums.as_ref()?;
        let center = rounded_direction(direction);
        let cell = DirectionCone { center, axes: None, ball: EXACT_DIRECTION_ROUNDING };
        let mut doubtful = Places::new();
        let sum = sums.signed_sum(&self.rows, &self.faces, &cell, &mut doubtful);
        let of_direction = DoubleDoubleDirection::of(direction);
        let exact_sign = |v: &[f64; 3]| exact_linear::dot(&exact(*v), direction).sign() as i8;
        let mut orthogonal = Places::new();
        let mut signs = Vec::with_capacity(doubtful.len());
        for &place in &doubtful {
            let v = &self.rows[place as usize];
            match of_direction.certain_sign(v).unwrap_or_else(|| exact_sign(v)) {
                0 => orthogonal.push(place),
                sign => signs.push((*v, sign)),
            }
        }
        Some((exact_linear::sum(&sum, &signed_sum(signs.into_iter())), orthogonal))
    }

    /// Σ |v · u| with a bound of its error. O(√n) nodes of a random body.
    pub(super) fn centered_support(&self, u: &[f64; 3]) -> Bounded {
        let mut places = Places::with_capacity(USUAL_CROSSING);
        let fixed = self.split(&DirectionCone { center: *u, axes: None, ball: 0.0 }, &mut places);
        let near: Vec<[f64; 3]> = places.iter().map(|&place| self.rows[place as usize]).collect();
        dot(&fixed.bounded(), &bounded::exact(*u)) + bounded_sum(Rows::new(&near), u)
    }
}

impl<'t, P: Standing> TreeQuery<'t, P> {
    /// The trees with their matrices.
    pub(super) fn tree_parts(&self) -> SmallVec<[TreePart<'_>; 2]> {
        let parts = self.trees.iter().zip(Generators::parts(&self.query));
        parts.filter_map(|(tree, part)| Some(TreePart { tree: (*tree)?, frame: part.frame })).collect()
    }

    /// Whether the generators certainly span space: those of one body do, and its matrix does not flatten it.
    pub(super) fn is_solid(&self) -> bool {
        let is_solid = |part: &TreePart<'_>| part.frame.is_none_or(|frame| frame.relative_error().is_finite());
        self.tree_parts().iter().any(|part| part.tree.is_solid && is_solid(part))
    }
}

impl<P: Standing> Generators for TreeQuery<'_, P> {
    fn parts(&self) -> [Part<'_>; 2] {
        Generators::parts(&self.query)
    }

    fn expected_crossing(&self) -> usize {
        LIKELY_CROSSING
    }

    fn support(&self, u: &[f64; 3]) -> Bounded {
        self.tree_parts().iter().map(|part| part.support(u)).reduce(|a, b| a + b).unwrap_or(Bounded::exact(0.0))
    }

    fn split(&self, cell: &DirectionCone, crossing: &mut Vec<[f64; 3]>, indices: &mut Places) -> FixedSum {
        let mut offset = 0;
        let sums = self.tree_parts().into_iter().map(|part| {
            let fixed = part.split(cell, offset, crossing, indices);
            offset += part.tree.rows.len();
            fixed
        });
        sums.reduce(|sum, fixed| sum.plus(&fixed)).unwrap_or_default()
    }
}

impl<P: Standing> KernelQuery for TreeQuery<'_, P> {
    fn exact(&self) -> ExactVector {
        self.query.exact()
    }

    fn rounded_displacement(&self) -> BoundedVector {
        self.query.rounded_displacement()
    }

    fn displacement_pairs(&self) -> [BoundedDoubleDouble; 3] {
        self.query.displacement_pairs()
    }

    fn in_doubles(&self) -> Option<InDoubles<'_>> {
        self.query.in_doubles()
    }

    fn likely_cell(&self, tally: &mut dyn Tally) -> Option<DirectionCone> {
        let p = self.query.rounded_displacement().map(|c| c.value);
        cell_near_optimum(&self.tree_parts(), p, tally)
    }

    fn has_exact_sums(&self) -> bool {
        true
    }

    fn exact_sum_along(&self, direction: &ExactVector) -> Option<ExactVector> {
        let mut sums = self.tree_parts().into_iter().map(|part| part.exact_sum_along(direction));
        let first = sums.next()??;
        sums.try_fold(first, |sum, next| Some(exact_linear::sum(&sum, &next?)))
    }

    /// A body holds each of the two that it is the sum of, and M x is in s M Z if x is in s Z.
    fn known_gauge_bound(&self) -> Option<f64> {
        let bound = |part: TreePart<'_>| part.tree.gauge_bound * part.frame.map_or(1.0, |frame| frame.shortening());
        self.tree_parts().into_iter().map(bound).filter(|bound| !bound.is_nan()).reduce(f64::min)
    }
}
