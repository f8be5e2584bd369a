//! The tree as an implementor of the kernel's seam: passes over the generators become walks over the nodes.
//!
//! A displacement is asked about in the order of the tree. Support values and the sums over a cell of directions come
//! from the nodes that miss the cell and from the leaves that cross it; what a search needs beside these (a first cell,
//! how thick the body is) is known beforehand. All rows are there for the rungs that read them.

use std::ops::Range;

use super::DirectionTree;
use super::guess::cell_near_optimum;
use super::nodes::Face;
use super::part::TreePart;
use super::walk::{Nodes, Visitor, walk};
use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::lad::of_generators::seam::generators::{Generators, KernelQuery, Part};
use crate::lad::of_generators::seam::sign_pass::{FixedSum, Places, USUAL_CROSSING};
use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::numeric::double_double::DoubleDoubleDirection;
use crate::numeric::exact_linear::{self, ExactVector, exact, rounded_direction};
use crate::numeric::lanes::bounded_sum;
use crate::numeric::lanes::rows::Rows;
use crate::numeric::linear::dot;
use crate::numeric::signed_sum::signed_sum;
use crate::numeric::tolerance::{EXACT_DIRECTION_ROUNDING, NODE_SUM_ROUNDING};
use crate::tally::Tally;
use crate::zonotope::query::Query;

/// Memory for so many generators is taken for those that cross a cell; few cells are crossed by more.
pub(super) const LIKELY_CROSSING: usize = 1024;

/// A displacement relative to the generators of a tree, in the order of the tree.
#[derive(Debug, Clone, Copy)]
pub(super) struct TreeQuery<'t> {
    pub(super) tree: &'t DirectionTree,
    pub(super) query: Query<'t, 3>,
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
    pub(super) fn centred_support(&self, u: &[f64; 3]) -> Bounded {
        let mut places = Places::with_capacity(USUAL_CROSSING);
        let fixed = self.split(&DirectionCone { center: *u, axes: None, ball: 0.0 }, &mut places);
        let near: Vec<[f64; 3]> = places.iter().map(|&place| self.rows[place as usize]).collect();
        dot(&fixed.bounded(), &bounded::exact(*u)) + bounded_sum(Rows::new(&near), u)
    }
}

impl<'t> TreeQuery<'t> {
    fn part(&self) -> TreePart<'t> {
        TreePart { tree: self.tree, frame: None }
    }
}

impl Generators for TreeQuery<'_> {
    fn parts(&self) -> [Part<'_>; 2] {
        self.query.parts()
    }

    fn expected_crossing(&self) -> usize {
        LIKELY_CROSSING
    }

    fn support(&self, u: &[f64; 3]) -> Bounded {
        self.part().support(u)
    }

    fn split(&self, cell: &DirectionCone, crossing: &mut Vec<[f64; 3]>, indices: &mut Places) -> FixedSum {
        self.part().split(cell, 0, crossing, indices)
    }
}

impl KernelQuery for TreeQuery<'_> {
    fn exact(&self) -> ExactVector {
        self.query.exact()
    }

    fn rounded_displacement(&self) -> BoundedVector {
        self.query.rounded_displacement()
    }

    fn as_query(&self) -> Option<Query<'_, 3>> {
        Some(self.query)
    }

    fn likely_cell(&self, tally: &mut dyn Tally) -> Option<DirectionCone> {
        let p = self.query.rounded_displacement().map(|c| c.value);
        cell_near_optimum(&[self.part()], p, tally)
    }

    fn exact_sum_along(&self, direction: &ExactVector) -> Option<ExactVector> {
        self.part().exact_sum_along(direction)
    }

    fn known_gauge_bound(&self) -> Option<f64> {
        Some(self.tree.gauge_bound)
    }
}
