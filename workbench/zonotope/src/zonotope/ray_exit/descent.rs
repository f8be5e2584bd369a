//! The facet of a zonotope that a ray from its centre meets, in floating point: a guess that its users prove or refute.
//!
//! The ray of q leaves the zonotope at the multiple min { h(u) : u · q = 1 } of q, its reach, with h(u) = Σ |u · g_i|:
//! that is 1 over the gauge of q. A vertex of that problem has u orthogonal to d − 1 independent generators, the basis:
//! it is a facet normal. The other generators contribute with the signs of u · g_i; the coefficients of the basis that
//! put their sum on the ray tell whether the vertex is optimal (all within [−1, 1]) and if not, which generator to
//! leave. The next vertex is the weighted median of the crossings along the edge. Statuses are kept from step to step,
//! and a random choice among the generators that may leave keeps ties from cycling.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

use crate::numeric::linear::{dot, inverse};
use crate::numeric::tolerance::UNIT;

/// Where a ray leaves the zonotope.
#[derive(Clone, Debug)]
pub(crate) struct Facet<const D: usize> {
    /// The normal u, with u · q = 1.
    pub(crate) normal: [f64; D],
    /// The multiple h(u) of q at which the ray leaves the zonotope, within rounding: 1 over the gauge of q.
    pub(crate) reach: f64,
    /// The generators that span the facet.
    pub(crate) basis: [usize; D],
    /// Coefficients with Σ δ_i g_i ≈ reach · q.
    pub(crate) coefficients: Vec<f64>,
}

/// The generators of a zonotope centred at the origin, one column for each coordinate, and room for the search.
pub(crate) struct FacetDescent<const D: usize> {
    rank: usize,
    columns: Vec<Vec<f64>>,
    /// One over the length of each generator, zero for one that is none.
    per_length: Vec<f64>,
    /// The sum of their lengths.
    total: f64,
    inverse_moments: [[f64; D]; D],
    signs: Vec<f64>,
    heights: Vec<f64>,
    rates: Vec<f64>,
    crossings: Vec<(f64, usize)>,
    rng: Pcg64,
}

/// Coefficients beyond 1 by less than this, or by what rounding the sum of all generators may do, are within their
/// range.
const COEFFICIENT_TOLERANCE: f64 = 1e-13;

/// What rounding does to coefficients of a good basis is less than this.
const LARGEST_COEFFICIENT_ROUNDING: f64 = 1e-10;

/// A search that takes more steps than this has lost its way in rounding errors or ties.
const STEP_LIMIT: usize = 400;

impl<const D: usize> FacetDescent<D> {
    /// Room for the search among generators that span the first `rank` coordinates.
    pub(crate) fn new(rank: usize, generators: &[[f64; D]]) -> Self {
        let columns = (0..rank).map(|c| generators.iter().map(|g| g[c]).collect()).collect();
        let per_length: Vec<f64> = generators
            .iter()
            .map(|g| {
                let length = dot(g, g).sqrt();
                if length > 0.0 { 1.0 / length } else { 0.0 }
            })
            .collect();
        let mut moments = [[0.0; D]; D];
        for (g, per_length) in generators.iter().zip(&per_length) {
            for i in 0..rank {
                for j in 0..rank {
                    moments[i][j] += g[i] * g[j] * per_length;
                }
            }
        }
        let total = generators.iter().map(|g| dot(g, g).sqrt()).sum();
        let inverse_moments = inverse(rank, &moments).unwrap_or_else(identity);
        let count = generators.len();
        Self {
            rank,
            columns,
            per_length,
            total,
            inverse_moments,
            signs: vec![0.0; count],
            heights: vec![0.0; count],
            rates: vec![0.0; count],
            crossings: Vec::new(),
            rng: Pcg64::seed_from_u64(0x5eed),
        }
    }

    fn generator(&self, index: usize) -> [f64; D] {
        std::array::from_fn(|c| if c < self.rank { self.columns[c][index] } else { 0.0 })
    }

    /// direction · g_i for all generators.
    fn products(columns: &[Vec<f64>], direction: &[f64; D], into: &mut [f64]) {
        into.fill(0.0);
        for (column, &d) in columns.iter().zip(direction) {
            for (sum, &g) in into.iter_mut().zip(column) {
                *sum += d * g;
            }
        }
    }

    /// The facet through which the ray of `point` leaves; `None` if the search fails: a point at the centre, generators
    /// that do not span, ties.
    pub(crate) fn facet(&mut self, point: &[f64; D]) -> Option<Facet<D>> {
        self.facet_from(point, &apply(&self.inverse_moments, point))
    }

    /// The same facet, searched for from a direction near its normal: the nearer, the fewer steps it takes.
    pub(crate) fn facet_from(&mut self, point: &[f64; D], start: &[f64; D]) -> Option<Facet<D>> {
        let mut basis = self.first_basis(point, start)?;
        let rank = self.rank;
        let mut rows = self.rows(&basis, point)?;
        let mut normal = rows[rank - 1];
        Self::products(&self.columns, &normal, &mut self.heights);
        for (sign, &height) in self.signs.iter_mut().zip(&self.heights) {
            *sign = if height < 0.0 { -1.0 } else { 1.0 };
        }
        for step in 0..STEP_LIMIT {
            let mut sum = [0.0; D];
            for &b in &basis[..rank - 1] {
                self.signs[b] = 0.0;
            }
            for (total, column) in sum.iter_mut().zip(&self.columns) {
                *total = column.iter().zip(&self.signs).map(|(g, s)| g * s).sum();
            }
            let deltas: [f64; D] = std::array::from_fn(|i| if i + 1 < rank { -dot(&rows[i], &sum) } else { 0.0 });
            // A basis that is nearly dependent says little of its coefficients: others are tried first.
            let most = if step < STEP_LIMIT / 4 { LARGEST_COEFFICIENT_ROUNDING } else { f64::INFINITY };
            let rounding = |i: usize| 2.0 * UNIT * self.total * dot(&rows[i], &rows[i]).sqrt();
            let limits = std::array::from_fn(|i| 1.0 + rounding(i).clamp(COEFFICIENT_TOLERANCE, most));
            let leaving = self.leaving(&deltas[..rank - 1], &limits, step);
            let Some(leaving) = leaving else {
                let reach = dot(&normal, &sum);
                let mut coefficients = self.signs.clone();
                for (&b, delta) in basis[..rank - 1].iter().zip(deltas) {
                    coefficients[b] = delta.clamp(-1.0, 1.0);
                }
                return Some(Facet { normal, reach, basis, coefficients });
            };
            let turn = deltas[leaving].signum();
            let edge = rows[leaving].map(|c| c * turn);
            let entering = self.cross(&normal, &edge, deltas[leaving].abs() - 1.0, &basis[..rank - 1])?;
            self.signs[basis[leaving]] = turn;
            basis[leaving] = entering;
            rows = self.rows(&basis, point)?;
            normal = rows[rank - 1];
        }
        None
    }

    /// Which of the basis must leave: the one farthest beyond its limit, after many steps any.
    fn leaving(&mut self, deltas: &[f64], limits: &[f64; D], step: usize) -> Option<usize> {
        let beyond = |i: &usize| deltas[*i].abs() > limits[*i];
        if step < STEP_LIMIT / 8 {
            (0..deltas.len()).filter(beyond).max_by(|&a, &b| deltas[a].abs().total_cmp(&deltas[b].abs()))
        } else {
            let all: Vec<usize> = (0..deltas.len()).filter(beyond).collect();
            (!all.is_empty()).then(|| all[self.rng.random_range(0..all.len())])
        }
    }

    /// Goes from `normal` along `edge` while h falls, at first with slope −`descent`; the generator whose crossing
    /// stops it.
    fn cross(&mut self, normal: &[f64; D], edge: &[f64; D], descent: f64, basis: &[usize]) -> Option<usize> {
        Self::products(&self.columns, normal, &mut self.heights);
        Self::products(&self.columns, edge, &mut self.rates);
        self.crossings.clear();
        for i in 0..self.signs.len() {
            let against = self.signs[i] * self.rates[i];
            if against < 0.0 {
                self.crossings.push(((self.signs[i] * self.heights[i]).max(0.0) / -against, i));
            }
        }
        self.crossings.retain(|(_, i)| !basis.contains(i));
        let mut left = descent;
        let mut rest = &mut self.crossings[..];
        // Rounding may keep the slope below zero past the last crossing: then the last one is where it is zero.
        let mut last = None;
        loop {
            if rest.is_empty() {
                return last;
            }
            let middle = rest.len() / 2;
            rest.select_nth_unstable_by(middle, |a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            let gain = |part: &[(f64, usize)]| part.iter().map(|&(_, i)| 2.0 * self.rates[i].abs()).sum::<f64>();
            let before = gain(&rest[..middle]);
            if before >= left {
                rest = &mut rest[..middle];
                continue;
            }
            let (_, entering) = rest[middle];
            let at = 2.0 * self.rates[entering].abs();
            for &(_, i) in &rest[..middle] {
                self.signs[i] = -self.signs[i];
            }
            if before + at >= left {
                return Some(entering);
            }
            self.signs[entering] = -self.signs[entering];
            left -= before + at;
            last = Some(entering);
            rest = &mut rest[middle + 1..];
        }
    }

    /// d − 1 independent generators that are most nearly orthogonal to a direction: without a better one it is W⁻¹ q,
    /// W = Σ g gᵀ / |g|.
    fn first_basis(&mut self, point: &[f64; D], start: &[f64; D]) -> Option<[usize; D]> {
        Self::products(&self.columns, start, &mut self.heights);
        let mut basis = [usize::MAX; D];
        let mut reduced: Vec<[f64; D]> = Vec::with_capacity(self.rank);
        let length = dot(point, point).sqrt();
        if length.is_nan() || length <= 0.0 {
            return None;
        }
        reduced.push(point.map(|c| c / length));
        for slot in basis.iter_mut().take(self.rank - 1) {
            let mut best: Option<(f64, usize, [f64; D])> = None;
            for (i, (height, per_length)) in self.heights.iter().zip(&self.per_length).enumerate() {
                let key = height.abs() * per_length;
                if best.as_ref().is_some_and(|b| b.0 <= key) {
                    continue;
                }
                let mut rest = self.generator(i).map(|c| c * per_length);
                for unit in &reduced {
                    let along = dot(unit, &rest);
                    rest = std::array::from_fn(|c| rest[c] - along * unit[c]);
                }
                let left = dot(&rest, &rest).sqrt();
                if left > 1e-7 {
                    best = Some((key, i, rest.map(|c| c / left)));
                }
            }
            let (_, index, unit) = best?;
            *slot = index;
            reduced.push(unit);
        }
        Some(basis)
    }

    /// The inverse of the matrix with the basis and the point for columns, row by row.
    fn rows(&self, basis: &[usize; D], point: &[f64; D]) -> Option<[[f64; D]; D]> {
        let mut matrix = [[0.0; D]; D];
        for i in 0..self.rank {
            let column = if i + 1 < self.rank { self.generator(basis[i]) } else { *point };
            for c in 0..self.rank {
                matrix[c][i] = column[c];
            }
        }
        inverse(self.rank, &matrix)
    }
}

fn apply<const D: usize>(matrix: &[[f64; D]; D], vector: &[f64; D]) -> [f64; D] {
    std::array::from_fn(|i| dot(&matrix[i], vector))
}

fn identity<const D: usize>() -> [[f64; D]; D] {
    std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cube_and_a_point() {
        let mut descent = FacetDescent::new(3, &[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
        let facet = descent.facet(&[0.5, 0.25, -2.0]).expect("found");
        assert_eq!((facet.reach, facet.normal), (0.5, [0.0, 0.0, -0.5]));
        assert_eq!(facet.coefficients, [0.25, 0.125, -1.0]);
        assert!(descent.facet(&[0.0; 3]).is_none());
    }

    #[test]
    fn random_generators_reach_the_least_height_over_all_normals() {
        let mut rng = Pcg64::seed_from_u64(7);
        for _ in 0..200 {
            let mut vector = || -> [f64; 3] { std::array::from_fn(|_| rng.random_range(-1.0..1.0)) };
            let generators: Vec<[f64; 3]> = (0..9).map(|_| vector()).collect();
            let point = vector();
            let facet = FacetDescent::new(3, &generators).facet(&point).expect("in general position");
            let mut least = f64::INFINITY;
            for (i, a) in generators.iter().enumerate() {
                for b in &generators[..i] {
                    let u = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
                    let h: f64 = generators.iter().map(|g| dot(&u, g).abs()).sum();
                    least = least.min(h / dot(&u, &point).abs());
                }
            }
            assert!((facet.reach - least).abs() <= 1e-10 * least, "{} {least}", facet.reach);
            for c in 0..3 {
                let sum: f64 = generators.iter().zip(&facet.coefficients).map(|(g, d)| g[c] * d).sum();
                assert!((sum - facet.reach * point[c]).abs() < 1e-10);
            }
        }
    }
}
