//! The signs of all generators, as the cells that fixed them.
//!
//! A search narrows cells. The sign of a generator is that of its dot product with the centre of the first cell that
//! the generator misses. So the cells and the short lists of generators that cross them hold all signs: no list of n
//! signs is written before a proof asks for one.

use crate::lad::of_generators::cells::reduced::Reduced;
use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::seam::sign_pass::Places;
use crate::numeric::lanes::octet::LANES;
use crate::numeric::reused::{Reused, keep_lists_of};

/// A cell, and the generators that cross it and all cells before it.
#[derive(Debug, Clone)]
pub(crate) struct NestedCell {
    pub(crate) cell: DirectionCone,
    /// The generators by their index in the query, in increasing order, and in doubles.
    pub(crate) crossing: Places,
    vectors: Reused<[f64; 3]>,
}

/// Cells, each within the one before.
#[derive(Debug, Clone, Default)]
pub(crate) struct NestedCells {
    steps: Reused<NestedCell>,
}

keep_lists_of!(NestedCell);

impl NestedCells {
    /// The cells of problems that were reduced one from the other.
    pub(crate) fn of(mut levels: Reused<Reduced>) -> Self {
        let steps = levels.drain(..).filter_map(|Reduced { cell, indices, vectors, .. }| {
            Some(NestedCell { cell: cell?, crossing: indices, vectors })
        });
        Self { steps: steps.collect() }
    }

    /// The cells with the generators that cross them, widest first.
    pub(crate) fn steps(&self) -> &[NestedCell] {
        &self.steps
    }

    /// The first steps.
    pub(crate) fn up_to(&self, count: usize) -> Self {
        Self { steps: self.steps[..count].iter().cloned().collect() }
    }

    /// The sign of one generator, 1 or −1. O(log n).
    pub(crate) fn sign(&self, query: &dyn KernelQuery, last: &DirectionCone, index: usize) -> f64 {
        let misses = |step: &&NestedCell| step.crossing.binary_search(&(index as u32)).is_err();
        let cell = self.steps.iter().find(misses).map_or(last, |step| &step.cell);
        if cell.value(&query.generator(index)) < 0.0 { -1.0 } else { 1.0 }
    }

    /// The signs of all generators; 0 for those that cross all cells.
    pub(crate) fn signs(&self, query: &dyn KernelQuery) -> Vec<i8> {
        let side = |cell: &DirectionCone, v: &[f64; 3]| if cell.value(v) < 0.0 { -1 } else { 1 };
        let Some(NestedCell { cell: first, .. }) = self.steps.first() else { return vec![0; query.len()] };
        let mut signs = Vec::with_capacity(query.len());
        for part in query.parts() {
            part.map_into(&mut signs, |v| side(first, v));
        }
        for (place, step) in self.steps.iter().enumerate() {
            let next = self.steps.get(place + 1).map(|step| &step.cell);
            for (&index, v) in step.crossing.iter().zip(&step.vectors) {
                signs[index as usize] = next.map_or(0, |cell| side(cell, v));
            }
        }
        signs
    }

    /// A list of ±`factor` with the sign of each generator; a generator that crosses all cells has its sign at a last
    /// direction.
    pub(crate) fn coefficients(&self, query: &dyn KernelQuery, last: &DirectionCone, factor: f64) -> Vec<f64> {
        let of = |cell: &DirectionCone, v: &[f64; 3]| factor.copysign(cell.value(v));
        let first = self.steps.first().map_or(last, |step| &step.cell);
        let mut coefficients = Vec::with_capacity(query.len() + LANES);
        for part in &query.parts() {
            part.signed_factors(first, factor, &mut coefficients);
        }
        for (place, step) in self.steps.iter().enumerate() {
            let next = self.steps.get(place + 1).map_or(last, |step| &step.cell);
            for (&index, v) in step.crossing.iter().zip(&step.vectors) {
                coefficients[index as usize] = of(next, v);
            }
        }
        coefficients
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::zonotope::query::Query;

    #[test]
    fn the_first_cell_that_a_generator_misses_decides_its_sign() {
        let generators = [[1.0, 0.0, 0.0], [-1.0, 0.5, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.1]];
        let query = Query::new([0.0; 3], [1.0; 3], &generators).expect("finite");
        let cell = |center, ball| DirectionCone { center, axes: None, ball };
        // 2 and 3 cross the first cell, 3 the second as well
        let step = |cell: DirectionCone, crossing: &[u32]| NestedCell {
            cell,
            crossing: crossing.iter().copied().collect(),
            vectors: crossing.iter().map(|&index| generators[index as usize]).collect(),
        };
        let (wide, narrow) = (step(cell([1.0, 0.1, 0.0], 0.2), &[2, 3]), step(cell([1.0, 0.1, 0.9], 0.01), &[3]));
        let cells = NestedCells { steps: [wide, narrow].into_iter().collect() };
        let last = cell([1.0, 0.1, 2.0], 0.0);
        let expected = [1, -1, 1, 1];
        assert_eq!(cells.coefficients(&query, &last, 0.5), expected.map(|sign| 0.5 * f64::from(sign)));
        assert_eq!([0, 1, 2, 3].map(|i| cells.sign(&query, &last, i)), expected.map(f64::from));
        assert_eq!(cells.signs(&query), [1, -1, 1, 0]);
        // without the second cell neither is decided
        assert_eq!(cells.up_to(1).signs(&query), [1, -1, 0, 0]);
        assert_eq!(NestedCells::default().signs(&query), [0; 4]);
    }
}
