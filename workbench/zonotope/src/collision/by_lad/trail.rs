//! The signs of all generators, as the cells that fixed them.
//!
//! A search narrows cells: the sign of a generator is that of its dot product with the centre of the first cell that it misses.

use super::cell::Cell;
use crate::collision::Displacement;

/// Cells one after the other, and which generators cross each and all before it.
#[derive(Debug, Clone, Default)]
pub(super) struct Trail {
    steps: Vec<(Cell, Vec<u32>)>,
}

impl Trail {
    /// From cells and the generators that cross each.
    pub(super) fn new(steps: Vec<(Cell, Vec<u32>)>) -> Self {
        Self { steps }
    }

    /// The cells with the generators that cross them, widest first.
    pub(super) fn steps(&self) -> &[(Cell, Vec<u32>)] {
        &self.steps
    }

    /// The first steps.
    pub(super) fn up_to(&self, count: usize) -> Self {
        Self { steps: self.steps[..count].to_vec() }
    }

    /// The sign of one generator, 1 or −1. O(log n).
    pub(super) fn sign(&self, question: &Displacement<'_, 3>, last: &Cell, index: usize) -> f64 {
        let misses = |(_, crossing): &&(Cell, Vec<u32>)| crossing.binary_search(&(index as u32)).is_err();
        let cell = self.steps.iter().find(misses).map_or(last, |(cell, _)| cell);
        if cell.value(&question.generator(index)) < 0.0 { -1.0 } else { 1.0 }
    }

    /// What `value` makes of the signs: those of the generators that cross all cells are those of a last direction, if there is one.
    pub(super) fn signed<T: Copy>(
        &self,
        question: &Displacement<'_, 3>,
        last: Option<&Cell>,
        [negative, zero, positive]: [T; 3],
    ) -> Vec<T> {
        let sign = |cell: Option<&Cell>, v: &[f64; 3]| match cell {
            Some(cell) if cell.value(v) < 0.0 => negative,
            Some(_) => positive,
            None => zero,
        };
        let mut cells = self.steps.iter().map(|(cell, _)| Some(cell)).chain([last]);
        let first = cells.next().expect("the last direction ends the cells");
        let mut signs = Vec::with_capacity(question.len());
        for run in question.runs() {
            signs.extend(run.iter().map(|v| sign(first, v)));
        }
        for (cell, (_, crossing)) in cells.zip(&self.steps) {
            for &index in crossing {
                signs[index as usize] = sign(cell, &question.generator(index as usize));
            }
        }
        signs
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_cell_that_a_generator_misses_decides_its_sign() {
        let generators = [[1.0, 0.0, 0.0], [-1.0, 0.5, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.1]];
        let question = Displacement::new([0.0; 3], [1.0; 3], &generators).expect("finite");
        let cell = |center, ball| Cell { center, axes: None, ball };
        // 2 and 3 cross the first cell, 3 the second as well
        let wide = (cell([1.0, 0.1, 0.0], 0.2), vec![2, 3]);
        let narrow = (cell([1.0, 0.1, 0.9], 0.01), vec![3]);
        let trail = Trail::new(vec![wide, narrow]);
        let last = cell([1.0, 0.1, 2.0], 0.0);
        let expected = [1, -1, 1, 1];
        assert_eq!(trail.signed(&question, Some(&last), [-1, 0, 1]), expected);
        assert_eq!([0, 1, 2, 3].map(|i| trail.sign(&question, &last, i)), expected.map(f64::from));
        assert_eq!(trail.signed(&question, None, [-1, 0, 1]), [1, -1, 1, 0]);
        // without the second cell the last direction decides for both
        assert_eq!(trail.up_to(1).signed(&question, None, [-1, 0, 1]), [1, -1, 0, 0]);
        assert_eq!(Trail::default().signed(&question, None, [-1, 0, 1]), [0; 4]);
    }
}
