//! The problem with most generators summed up: their sign is fixed throughout a cell.
//!
//! For any signs fixed on a part of the generators, (Σ sign v) · u + Σ_rest |v · u| ≤ h(u), with equality in the cell
//! where those signs are right. So an optimum of the reduced problem that lies in the cell is an optimum of the
//! whole, by convexity.

use crate::lad::of_generators::plane::in_doubles::{RoundedChart, RoundedLines};
use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::seam::sign_pass::{FixedSum, Places};
use crate::numeric::lanes::rows::Rows;
use crate::numeric::reused::{Reused, keep_lists_of};
use crate::numeric::tolerance::MODERATE_SIZES;

/// The generators that cross a cell, and the sum of all others with their signs.
#[derive(Debug)]
pub(crate) struct Reduced {
    pub(crate) vectors: Reused<[f64; 3]>,
    /// The index of each in the query.
    pub(crate) indices: Places,
    pub(crate) fixed: FixedSum,
    /// The cell in which the signs of the generators that were summed up last are right; `None` while no generator is
    /// summed up.
    pub(crate) cell: Option<DirectionCone>,
    /// A bound on the error of each vector, in terms of its length.
    pub(crate) relative_error: f64,
}

/// Most searches go through at most so many problems, each reduced from the one before.
pub(crate) const USUAL_LEVELS: usize = 4;

keep_lists_of!(Reduced);

impl Reduced {
    /// All generators, none summed up.
    pub(crate) fn whole(query: &dyn KernelQuery) -> Self {
        let mut vectors = Reused::with_capacity(query.len());
        for part in query.parts() {
            part.copy(part.rows.list(), &mut vectors);
        }
        Self {
            vectors,
            indices: (0..query.len() as u32).collect(),
            fixed: FixedSum::default(),
            cell: None,
            relative_error: query.relative_error(),
        }
    }

    /// One pass over the query.
    pub(crate) fn of_query(query: &dyn KernelQuery, cell: DirectionCone) -> Self {
        let expected = query.expected_crossing();
        let (mut vectors, mut indices) = (Reused::with_capacity(expected), Places::with_capacity(expected));
        let fixed = query.split(&cell, &mut vectors, &mut indices);
        Self { vectors, indices, fixed, cell: Some(cell), relative_error: query.relative_error() }
    }

    /// The problem from which the generators that miss a smaller cell are summed up, too.
    pub(crate) fn split(&self, cell: DirectionCone) -> Self {
        let mut crossing = Places::with_capacity(self.vectors.len() / 4 + 16);
        let fixed = self.plus_fixed_in(&cell, &mut crossing);
        let vectors = crossing.iter().map(|&place| self.vectors[place as usize]).collect();
        let indices = crossing.iter().map(|&place| self.indices[place as usize]).collect();
        Self { vectors, indices, fixed, cell: Some(cell), relative_error: self.relative_error }
    }

    /// The sum of all generators whose sign is fixed in a cell: those that were summed up before and those of this
    /// problem. The positions of this problem's other generators are added to a list.
    pub(crate) fn plus_fixed_in(&self, cell: &DirectionCone, crossing: &mut Places) -> FixedSum {
        let mut own = cell.widened(self.relative_error).split(Rows::new(&self.vectors), crossing);
        own.error += self.relative_error * own.magnitude;
        self.fixed.plus(&own)
    }

    /// Whether no sum overflowed or is about to.
    pub(crate) fn is_moderate(&self) -> bool {
        // false for NaN as well
        self.fixed.magnitude <= MODERATE_SIZES.end
    }

    /// The indices of two vectors in the query.
    pub(crate) fn indices_of(&self, places: [usize; 2]) -> [usize; 2] {
        places.map(|place| self.indices[place] as usize)
    }

    pub(crate) fn lines(&self, chart: &RoundedChart) -> RoundedLines {
        chart.lines(&self.vectors)
    }

    /// Writes the lines in the place of others.
    pub(crate) fn write_lines(&self, chart: &RoundedChart, lines: &mut RoundedLines) {
        chart.write_lines(&self.vectors, lines);
    }

    /// The gradient of the whole objective at a point of the cell.
    pub(crate) fn gradient(&self, chart: &RoundedChart, [x, y]: [f64; 2]) -> [f64; 2] {
        let mut sum = self.fixed.sum;
        for v in &self.vectors {
            let [a, b, c] = chart.line(v);
            let sign = f64::copysign(1.0, a * x + b * y + c);
            sum = [0, 1, 2].map(|k| sum[k] + sign * v[k]);
        }
        let [x, y, _] = chart.line(&sum);
        [x, y]
    }

    /// The gradient of the sum of the generators that were summed up.
    pub(crate) fn linear(&self, chart: &RoundedChart) -> [f64; 2] {
        let [x, y, _] = chart.line(&self.fixed.sum);
        [x, y]
    }
}
