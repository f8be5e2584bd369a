//! A tree under a matrix: what the nodes tell of a cell or a direction of space.

use super::DirectionTree;
use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::lad::of_generators::seam::frame::Frame;
use crate::lad::of_generators::seam::part::Part;
use crate::lad::of_generators::seam::sign_pass::{FixedSum, Places};
use crate::numeric::bounded::Bounded;
use crate::numeric::exact_linear::ExactVector;
use crate::numeric::lanes::rows::Rows;
use crate::numeric::tolerance::{FIVE_ROUNDINGS, UNIT};

/// A tree with the matrix that its generators are to be taken under.
#[derive(Debug, Clone, Copy)]
pub(super) struct TreePart<'t> {
    pub(super) tree: &'t DirectionTree,
    pub(super) frame: Option<Frame<'t>>,
}

impl TreePart<'_> {
    /// The image of a vector of the tree's frame.
    pub(super) fn image(&self, v: &[f64; 3]) -> [f64; 3] {
        self.frame.map_or(*v, |frame| frame.image(v))
    }

    /// The sum of the generators whose sign is fixed in a cell; the others and their places are added to lists.
    pub(super) fn split(
        &self,
        cell: &DirectionCone,
        offset: usize,
        crossing: &mut Vec<[f64; 3]>,
        indices: &mut Places,
    ) -> FixedSum {
        let Self { tree, frame } = *self;
        let part = Part { rows: Rows::new(&tree.rows), frame };
        if !tree.is_moderate {
            return part.split(cell, offset, crossing, indices);
        }
        let first = indices.len();
        let fixed = match frame {
            None => tree.split(cell, indices),
            Some(frame) => frame.pushed_sum(&tree.split(&frame.pulled_cell(cell), indices)),
        };
        part.gather(first, offset, crossing, indices);
        fixed
    }

    /// Σ |v · u| with a bound of its error.
    pub(super) fn support(&self, u: &[f64; 3]) -> Bounded {
        let Self { tree, frame } = *self;
        if !tree.is_moderate {
            return Part { rows: Rows::new(&tree.rows), frame }.support(u);
        }
        self.in_frame(u, |u| tree.centered_support(u))
    }

    /// The value of a function of Mᵀ u in the place of Σ |v · u|, with what the rounding of Mᵀ u may take off that sum.
    pub(super) fn in_frame(&self, u: &[f64; 3], of: impl FnOnce(&[f64; 3]) -> Bounded) -> Bounded {
        let Some(frame) = self.frame else { return of(u) };
        let Bounded { value, error } = of(&frame.pulled(u));
        // |v|_1 is at most three times the largest coordinate
        let off = 3.0 * self.tree.weight * 4.0 * UNIT * frame.pulled_size(u);
        Bounded { value, error: (error + off) * FIVE_ROUNDINGS }
    }

    /// [`DirectionTree::exact_sum_along`] of the images of the generators.
    pub(super) fn exact_sum_along(&self, direction: &ExactVector) -> Option<ExactVector> {
        let Some(frame) = self.frame else { return Some(self.tree.exact_sum_along(direction)?.0) };
        let (sum, _) = self.tree.exact_sum_along(&frame.exact_pulled(direction))?;
        Some(frame.exact_image(&sum))
    }
}
