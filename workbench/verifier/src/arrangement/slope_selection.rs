//! Answers to "which abscissa has the k-th leftmost vertex of an arrangement of lines".
//!
//! The line a x + b y + c = 0 of a generator with b ≠ 0 has the height −(a x + c) / b over x. Far to the left the
//! lines are sorted by slope, falling slopes upwards; two of them cross left of x just when their order over x is
//! another. So the number of vertices left of x is a number of inversions, and x is right if fewer than k vertices lie
//! left of it and at least k not right of it. A vertical line crosses every other one that is not vertical.

use std::cmp::Ordering;
use std::fmt::{self, Display};

use crate::verdict::Verdict;

use dashu_int::IBig;

use crate::exact::fraction::Fraction;
use crate::exact::grid::{Grid, check_finite};
use crate::exact::inversions::sort_counting;
use crate::exact::linear::Vector;

/// Lines a x + b y + c = 0.
#[derive(Debug)]
pub(crate) struct Lines {
    /// Lines with b > 0 from the lowest to the highest far to the left, parallel ones too.
    graphs: Vec<Vector>,
    /// The abscissas of vertical lines: numerators and positive denominators.
    verticals: Vec<(IBig, IBig)>,
}

/// Checks the abscissas of vertices, given by their ranks from 1.
pub fn check_slope_selection(generators: &[Vec<f64>], ranks: &[u64], x: &[Fraction]) -> Verdict<SlopeSelectionProof> {
    counted(generators, ranks, x).map(|()| SlopeSelectionProof { abscissas: x.len() }).into()
}

/// The number of abscissas that were proved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SlopeSelectionProof {
    /// The number of abscissas.
    pub abscissas: usize,
}

impl Display for SlopeSelectionProof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} abscissas, each with the right numbers of vertices on its sides", self.abscissas)
    }
}

fn counted(generators: &[Vec<f64>], ranks: &[u64], x: &[Fraction]) -> Result<(), String> {
    if ranks.len() != x.len() {
        return Err(format!("{} abscissas for {} ranks", x.len(), ranks.len()));
    }
    let lines = Lines::of_generators(generators)?;
    for (rank, x) in ranks.iter().zip(x) {
        let [left, not_right] = lines.vertices_left_of(x);
        if left >= *rank || not_right < *rank {
            return Err(format!("x of vertex {rank}: {left} vertices lie left of it, {not_right} not right of it"));
        }
    }
    Ok(())
}

impl Lines {
    /// The lines of generators (a, b, c); those with a = b = 0 have none.
    pub(crate) fn of_generators(generators: &[Vec<f64>]) -> Result<Self, String> {
        if generators.iter().any(|generator| generator.len() != 3) {
            return Err("answered a question whose generators are not in space".to_owned());
        }
        check_finite("the question", generators.iter().flatten())?;
        let grid = Grid::of(generators.iter().flatten().copied());
        let mut lines = Self { graphs: Vec::new(), verticals: Vec::new() };
        for generator in generators {
            let line: Vector = generator.iter().map(|&component| grid.units(component)).collect();
            let negated = || line.iter().map(|component| -component).collect();
            match (line[1].cmp(&IBig::ZERO), line[0].cmp(&IBig::ZERO)) {
                (Ordering::Less, _) => lines.graphs.push(negated()),
                (Ordering::Equal, Ordering::Greater) => lines.verticals.push((-&line[2], line[0].clone())),
                (Ordering::Equal, Ordering::Less) => lines.verticals.push((line[2].clone(), -&line[0])),
                (Ordering::Equal, Ordering::Equal) => {}
                (Ordering::Greater, _) => lines.graphs.push(line),
            }
        }
        // The slope is −a / b, the height over x = 0 is −c / b.
        let ratio = |l: &Vector, m: &Vector, axis: usize| (&l[axis] * &m[1]).cmp(&(&m[axis] * &l[1]));
        lines.graphs.sort_by(|l, m| ratio(l, m, 0).then_with(|| ratio(m, l, 2)));
        Ok(lines)
    }

    /// The number of vertices left of an abscissa, and that of those not right of it.
    fn vertices_left_of(&self, abscissa: &Fraction) -> [u64; 2] {
        let (x, w) = (abscissa.numerator(), abscissa.denominator());
        let heights: Vec<IBig> = self.graphs.iter().map(|line| -(&line[0] * x + &line[2] * w)).collect();
        let compare =
            |&i: &usize, &j: &usize| (&heights[i] * &self.graphs[j][1]).cmp(&(&heights[j] * &self.graphs[i][1]));
        let parallel =
            |i: usize, j: usize| &self.graphs[i][0] * &self.graphs[j][1] == &self.graphs[j][0] * &self.graphs[i][1];

        let mut order: Vec<usize> = (0..self.graphs.len()).collect();
        let left = sort_counting(&mut order, &compare);
        let here: u64 = order
            .chunk_by(|i, j| compare(i, j) == Ordering::Equal)
            .map(|run| {
                pairs(run.len()) - run.chunk_by(|&i, &j| parallel(i, j)).map(|same| pairs(same.len())).sum::<u64>()
            })
            .sum();
        let sides = self.verticals.iter().map(|(numerator, denominator)| (numerator * w).cmp(&(x * denominator)));
        let count = |wanted: Ordering| sides.clone().filter(|&side| side == wanted).count() as u64;
        let graphs = self.graphs.len() as u64;
        let left = left + count(Ordering::Less) * graphs;
        [left, left + here + count(Ordering::Equal) * graphs]
    }
}

fn pairs(count: usize) -> u64 {
    (count as u64 * (count as u64).saturating_sub(1)) / 2
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(generators: &[[f64; 3]], ranks: &[u64], x: &[(i64, i64)]) -> Result<(), String> {
        let generators: Vec<Vec<f64>> = generators.iter().map(|generator| generator.to_vec()).collect();
        let x: Vec<Fraction> =
            x.iter().filter_map(|&(numerator, denominator)| Fraction::new(numerator, denominator)).collect();
        check_slope_selection(&generators, ranks, &x).proof().map(|_| ())
    }

    #[test]
    fn a_triangle_and_a_vertical_line() {
        // y = 0, y = x, y = 1 − 2x cross at x = 0, 1/3, 1/2; the vertical line x = 1/4 crosses all three.
        let lines = [[0.0, 1.0, 0.0], [1.0, -1.0, 0.0], [2.0, 1.0, -1.0], [4.0, 0.0, -1.0], [0.0, 0.0, 1.0]];
        let x = [(0, 1), (1, 4), (1, 4), (1, 4), (1, 3), (1, 2)];
        assert_eq!(check(&lines, &[1, 2, 3, 4, 5, 6], &x), Ok(()));
        assert_eq!(check(&lines, &[6, 1], &[(1, 2), (0, 1)]), Ok(()));
        assert!(check(&lines, &[5], &[(1, 4)]).is_err());
        assert!(check(&lines, &[1], &[(1, 100)]).is_err());
        assert!(check(&lines, &[1, 2], &[(0, 1)]).is_err());
    }

    #[test]
    fn parallel_and_equal_lines_do_not_cross() {
        let lines = [[1.0, 1.0, 0.0], [2.0, 2.0, 0.0], [-1.0, -1.0, 3.0], [0.0, 1.0, 0.0]];
        assert_eq!(check(&lines, &[1, 2, 3], &[(0, 1), (0, 1), (3, 1)]), Ok(()));
        assert!(check(&lines, &[4], &[(3, 1)]).is_err());
    }
}
