//! The signs of all generators, as the cells that fixed them.
//!
//! A search narrows cells: the sign of a generator is that of its dot product with the centre of the first cell that it misses.

use crate::lad::of_generators::cells::direction_cone::Cell;
use crate::zonotope::query::Query;

/// Cells one after the other, and which generators cross each and all before it.
#[derive(Debug, Clone, Default)]
pub(crate) struct Trail {
    steps: Vec<(Cell, Vec<u32>)>,
}

impl Trail {
    /// From cells and the generators that cross each.
    pub(crate) fn new(steps: Vec<(Cell, Vec<u32>)>) -> Self {
        Self { steps }
    }

    /// The cells with the generators that cross them, widest first.
    pub(crate) fn steps(&self) -> &[(Cell, Vec<u32>)] {
        &self.steps
    }

    /// The first steps.
    pub(crate) fn up_to(&self, count: usize) -> Self {
        Self { steps: self.steps[..count].to_vec() }
    }

    /// The sign of one generator, 1 or −1. O(log n).
    pub(crate) fn sign(&self, query: &Query<'_, 3>, last: &Cell, index: usize) -> f64 {
        let misses = |(_, crossing): &&(Cell, Vec<u32>)| crossing.binary_search(&(index as u32)).is_err();
        let cell = self.steps.iter().find(misses).map_or(last, |(cell, _)| cell);
        if cell.value(&query.generator(index)) < 0.0 { -1.0 } else { 1.0 }
    }

    /// The signs of all generators; 0 for those that cross all cells.
    pub(crate) fn signs(&self, query: &Query<'_, 3>) -> Vec<i8> {
        let side = |cell: &Cell, v: &[f64; 3]| if cell.value(v) < 0.0 { -1 } else { 1 };
        let Some(((first, _), _)) = self.steps.split_first() else { return vec![0; query.len()] };
        let mut signs: Vec<i8> = query.generators().map(|v| side(first, v)).collect();
        for (step, (_, crossing)) in self.steps.iter().enumerate() {
            let next = self.steps.get(step + 1).map(|(cell, _)| cell);
            for &index in crossing {
                signs[index as usize] = next.map_or(0, |cell| side(cell, &query.generator(index as usize)));
            }
        }
        signs
    }

    /// A factor with the sign of each generator: that of a last direction for those that cross all cells.
    pub(crate) fn coefficients(&self, query: &Query<'_, 3>, last: &Cell, factor: f64) -> Vec<f64> {
        let of = |cell: &Cell, v: &[f64; 3]| factor.copysign(cell.value(v));
        let first = self.steps.first().map_or(last, |(cell, _)| cell);
        let mut coefficients = Vec::with_capacity(query.len());
        for run in query.runs() {
            coefficients.extend(run.iter().map(|v| of(first, v)));
        }
        for (step, (_, crossing)) in self.steps.iter().enumerate() {
            let next = self.steps.get(step + 1).map_or(last, |(cell, _)| cell);
            for &index in crossing {
                coefficients[index as usize] = of(next, &query.generator(index as usize));
            }
        }
        coefficients
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_cell_that_a_generator_misses_decides_its_sign() {
        let generators = [[1.0, 0.0, 0.0], [-1.0, 0.5, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.1]];
        let query = Query::new([0.0; 3], [1.0; 3], &generators).expect("finite");
        let cell = |center, ball| Cell { center, axes: None, ball };
        // 2 and 3 cross the first cell, 3 the second as well
        let wide = (cell([1.0, 0.1, 0.0], 0.2), vec![2, 3]);
        let narrow = (cell([1.0, 0.1, 0.9], 0.01), vec![3]);
        let trail = Trail::new(vec![wide, narrow]);
        let last = cell([1.0, 0.1, 2.0], 0.0);
        let expected = [1, -1, 1, 1];
        assert_eq!(trail.coefficients(&query, &last, 0.5), expected.map(|sign| 0.5 * f64::from(sign)));
        assert_eq!([0, 1, 2, 3].map(|i| trail.sign(&query, &last, i)), expected.map(f64::from));
        assert_eq!(trail.signs(&query), [1, -1, 1, 0]);
        // without the second cell neither is decided
        assert_eq!(trail.up_to(1).signs(&query), [1, -1, 0, 0]);
        assert_eq!(Trail::default().signs(&query), [0; 4]);
    }
}
