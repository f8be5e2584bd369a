//! The signs of all generators, as the cells that fixed them.
//!
//! A search narrows cells. The sign of a generator is that of its dot product with the centre of the first cell that
//! the generator misses. So the cells and the short lists of generators that cross them hold all signs: no list of n
//! signs is written before a proof asks for one.

use crate::lad::of_generators::cells::direction_cone::DirectionCone;
use crate::lad::of_generators::cells::reduced::Reduced;
use crate::lad::of_generators::cells::sign_pass::Places;
use crate::lad::of_generators::generators::{KernelQuery, generator_of};
use crate::numeric::reused::{Reused, keep_lists_of};

/// Cells, each within the one before, and for each the generators that cross it and all cells before it.
#[derive(Debug, Clone, Default)]
pub(crate) struct NestedCells {
    steps: Reused<(DirectionCone, Places)>,
}

keep_lists_of!((DirectionCone, Places));

impl NestedCells {
    /// From cells and the generators that cross each.
    pub(crate) fn new(steps: impl IntoIterator<Item = (DirectionCone, Places)>) -> Self {
        Self { steps: steps.into_iter().collect() }
    }

    /// The cells of problems that were reduced one from the other.
    pub(crate) fn of(mut levels: Reused<Reduced>) -> Self {
        Self::new(levels.drain(..).filter_map(|level| Some((level.cell?, level.indices))))
    }

    /// The cells with the generators that cross them, widest first.
    pub(crate) fn steps(&self) -> &[(DirectionCone, Places)] {
        &self.steps
    }

    /// The first steps.
    pub(crate) fn up_to(&self, count: usize) -> Self {
        Self::new(self.steps[..count].iter().cloned())
    }

    /// The sign of one generator, 1 or −1. O(log n).
    pub(crate) fn sign(&self, query: &dyn KernelQuery, last: &DirectionCone, index: usize) -> f64 {
        let misses = |(_, crossing): &&(DirectionCone, Places)| crossing.binary_search(&(index as u32)).is_err();
        let cell = self.steps.iter().find(misses).map_or(last, |(cell, _)| cell);
        if cell.value(&query.generator(index)) < 0.0 { -1.0 } else { 1.0 }
    }

    /// The signs of all generators; 0 for those that cross all cells.
    pub(crate) fn signs(&self, query: &dyn KernelQuery) -> Vec<i8> {
        let side = |cell: &DirectionCone, v: &[f64; 3]| if cell.value(v) < 0.0 { -1 } else { 1 };
        let Some(((first, _), _)) = self.steps.split_first() else { return vec![0; query.len()] };
        let mut signs = Vec::with_capacity(query.len());
        for part in query.parts() {
            part.map_into(&mut signs, |v| side(first, v));
        }
        for (step, (_, crossing)) in self.steps.iter().enumerate() {
            let next = self.steps.get(step + 1).map(|(cell, _)| cell);
            for &index in crossing {
                signs[index as usize] = next.map_or(0, |cell| side(cell, &query.generator(index as usize)));
            }
        }
        signs
    }

    /// A list of ±`factor` with the sign of each generator; a generator that crosses all cells has its sign at a last
    /// direction.
    pub(crate) fn coefficients(&self, query: &dyn KernelQuery, last: &DirectionCone, factor: f64) -> Vec<f64> {
        let of = |cell: &DirectionCone, v: &[f64; 3]| factor.copysign(cell.value(v));
        let first = *self.steps.first().map_or(last, |(cell, _)| cell);
        let parts = query.parts();
        let mut coefficients = vec![0.0; query.len()];
        let mut places = &mut coefficients[..];
        for part in &parts {
            let (own, others) = places.split_at_mut(part.rows.len());
            part.signed_factors(&first, factor, own);
            places = others;
        }
        for (step, (_, crossing)) in self.steps.iter().enumerate() {
            let next = self.steps.get(step + 1).map_or(last, |(cell, _)| cell);
            for &index in crossing {
                coefficients[index as usize] = of(next, &generator_of(&parts, index as usize));
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
        let wide = (cell([1.0, 0.1, 0.0], 0.2), [2, 3].into_iter().collect());
        let narrow = (cell([1.0, 0.1, 0.9], 0.01), [3].into_iter().collect());
        let cells = NestedCells::new([wide, narrow]);
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
