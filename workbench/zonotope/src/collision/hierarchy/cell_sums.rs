//! Bodies within a body: the sums of the generators of each cell of directions.
//!
//! A sum takes one coefficient for all generators of a cell, so the body of the sums is within that of the generators
//! if the sums are exact. Rounded sums are made shorter by a part η: let S be the rounded ones, e their errors and s
//! such that s |x|_1 bounds the gauge of any x. What the generators (1 − η) S, rounded once more, combine to is in (1 −
//! η) Z but for rounding errors of gauge at most η.

use super::grid::Cell;
use crate::numeric::exact_sum::exact_sum;
use crate::numeric::linear::sum_norm;
use crate::numeric::outward::above;
use crate::numeric::scaling::power_of_two_below;
use crate::numeric::tolerance::{LONG_SUM, PRODUCT_UNDERFLOW, UNIT};

/// Where sums had to be made shorter by more than this part, there is no inner body.
const SHORTENING_LIMIT: f64 = 1.0 / 256.0;

/// The cells of one depth with the sums of their generators.
#[derive(Debug, Clone)]
pub(super) struct CellSums {
    sums: Vec<(Cell, [f64; 3])>,
    /// At least what all sums together lost to rounding, |·|_1.
    lost: f64,
}

impl CellSums {
    /// The sums of vectors in the order of their cells; each is turned to the face of its cell. O(n).
    pub(super) fn new(vectors: impl Iterator<Item = (Cell, [f64; 3])>) -> Self {
        let (mut sums, mut lost): (Vec<(Cell, [f64; 3])>, f64) = (Vec::new(), 0.0);
        for (cell, v) in vectors {
            let Some((_, sum)) = sums.last_mut().filter(|(last, _)| *last == cell) else {
                sums.push((cell, v));
                continue;
            };
            let parts = [0, 1, 2].map(|k| exact_sum(sum[k], v[k]));
            *sum = parts.map(|(value, _)| value);
            lost = above(lost + sum_norm(&parts.map(|(_, rest)| rest)) * LONG_SUM);
        }
        Self { sums, lost }
    }

    /// The sums of the depth above. O(k).
    pub(super) fn coarser(&self) -> Self {
        let Self { sums, lost } = Self::new(self.sums.iter().map(|(cell, sum)| (cell.parent(), *sum)));
        Self { sums, lost: above(lost + self.lost) }
    }

    /// The generators of a body within the one whose generators were added up, of which s |x|_1 bounds the gauge of any
    /// x; none where rounding may take it out of that body. O(k).
    pub(super) fn generators(&self, gauge_bound: f64) -> Option<Vec<[f64; 3]>> {
        if self.lost == 0.0 {
            return Some(self.sums.iter().map(|(_, sum)| *sum).collect());
        }
        let total: f64 = self.sums.iter().map(|(_, sum)| sum_norm(sum)).sum();
        let underflow = self.sums.len() as f64 * PRODUCT_UNDERFLOW;
        let doubt = gauge_bound * ((self.lost + UNIT * total + underflow) * LONG_SUM);
        // a power of two more than twice the doubt, and such that 1 − η is a double
        let part = 4.0 * power_of_two_below(doubt.max(UNIT));
        (part <= SHORTENING_LIMIT).then(|| self.sums.iter().map(|(_, sum)| sum.map(|c| c * (1.0 - part))).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::super::grid::finest_cell;
    use super::*;
    use crate::Zonotope;
    use crate::reduction::contains;

    fn sums(vectors: &[[f64; 3]], depth: u32) -> CellSums {
        let placed = vectors.iter().map(|v| (finest_cell(v).expect("not zero").at_depth(depth), *v));
        CellSums::new(placed)
    }

    #[test]
    fn exact_sums_are_left_as_they_are() {
        let list = [[2.0, 1.0, 0.0], [4.0, 1.0, 0.0], [1.0, 0.5, 1.0], [0.0, 0.5, 3.0]];
        let sums = sums(&list, 0);
        assert_eq!(sums.generators(f64::INFINITY), Some(vec![[7.0, 2.5, 1.0], [0.0, 0.5, 3.0]]));
    }

    #[test]
    fn rounded_sums_are_shortened_or_given_up() {
        // all through the cell about the x-axis, so that thirds are rounded away
        let list: Vec<[f64; 3]> = (1..12).map(|i| [4.0, 1.0 / f64::from(i), f64::from(i * i % 7) / 3.0]).collect();
        let rounded = sums(&list, 0);
        assert_eq!(rounded.generators(f64::INFINITY), None);
        assert_eq!(rounded.generators(1e14), None);
        let inner = rounded.generators(1.0).expect("the doubt is little");
        let body = |list: &[[f64; 3]]| Zonotope::new([0.0; 3], list.to_vec()).expect("finite");
        assert_eq!((inner.len(), contains(&body(&list), &body(&inner))), (1, Some(true)));
        let coarser = sums(&list, 3).coarser().coarser().coarser();
        assert_eq!(coarser.generators(1.0).map(|g| g.len()), Some(1));
    }
}
