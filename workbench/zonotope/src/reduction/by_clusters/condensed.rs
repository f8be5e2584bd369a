//! Few generators that stand for many where nothing has to be exact: sums over cells of directions.

use super::super::cells::cells;
use crate::numeric::linear::{add_multiple, dot};

/// More generators than this are condensed, to about half as many at most.
const GENERATOR_LIMIT: usize = 1 << 15;

/// The generators, 0 beyond the first `rank` coordinates, or those of cells of a grid of directions: a cell's sum, as
/// long as its members together. O(n log n).
pub(super) fn condensed<const D: usize>(vectors: Vec<[f64; D]>, rank: usize) -> Vec<[f64; D]> {
    if vectors.len() <= GENERATOR_LIMIT {
        return vectors;
    }
    let mut side = 1u32;
    let cells_with = |side: u32| (1..rank).fold(rank as u64, |count, _| count * u64::from(side));
    while rank > 1 && cells_with(side + 1) <= GENERATOR_LIMIT as u64 / 2 {
        side += 1;
    }
    let sum = |members: &[usize]| {
        let (mut sum, mut total) = ([0.0; D], 0.0);
        for v in members.iter().map(|&index| &vectors[index]) {
            let sign = if dot(&sum, v) < 0.0 { -1.0 } else { 1.0 };
            add_multiple(&mut sum, sign, v);
            total += dot(v, v).sqrt();
        }
        let length = dot(&sum, &sum).sqrt();
        sum.map(|c| if length > 0.0 { c * (total / length) } else { c })
    };
    cells(&vectors, side, &mut ()).iter().map(|cell| sum(&cell.members)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::lanes::absolute_sum;

    #[test]
    fn many_generators_are_as_wide_as_their_sums() {
        let many: Vec<[f64; 3]> = (0..40_000)
            .map(|k| {
                let (sin, cos) = libm::sincos(2.4 * f64::from(k));
                [sin, cos, f64::from(k % 101) / 101.0]
            })
            .collect();
        let few = condensed(many.clone(), 3);
        assert!(few.len() < 20_000);
        for u in [[1.0, 0.0, 0.0], [0.0, 0.6, 0.8], [0.48, -0.6, 0.64]] {
            let [exact, near] = [&many, &few].map(|list| absolute_sum(list, &u));
            assert!((near / exact - 1.0).abs() < 1e-3, "{near} for {exact}");
        }
        assert_eq!(condensed(many[..100].to_vec(), 3), many[..100]);
    }
}
