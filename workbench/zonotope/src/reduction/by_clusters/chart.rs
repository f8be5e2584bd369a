//! Coordinates in which a flat or thin body is neither, and the way back.
//!
//! Some coordinates, as many as there are thin principal axes, are nearly linear functions of the others. Without them
//! the body is the projection along coordinate axes, whose generators are still vectors of doubles. A zonotope around
//! the projection is put back on the graph of the linear functions; what these miss of the body's generators, and what
//! rounding takes off, adds up to one generator along each coordinate axis that was left out.

use super::super::keeping::principal_axes::{extent, principal_axes};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::{add_multiple, dot};
use crate::numeric::outward::{at_least, axis_generators};

/// The coordinates that are kept, and the others as functions of them.
#[derive(Debug, Clone)]
pub(super) struct Chart<const D: usize> {
    kept: Vec<usize>,
    /// A coordinate and its rates of change, 0 in all coordinates that are left out.
    others: Vec<(usize, [f64; D])>,
}

/// A principal axis counts as thin if the body's width along it is below this part of the largest.
const THIN_WIDTH: f64 = 0.1;

/// An axis along which the body is narrower than this part of its largest width is left out in every chart: facets of
/// so thin a body have normals of few certain digits.
const LEAST_WIDTH: f64 = 1e-9;

/// The charts of vectors, from all coordinates to one that leaves out all thin axes. None if all vectors are zero.
pub(super) fn charts<const D: usize>(vectors: &[[f64; D]]) -> Vec<Chart<D>> {
    let weighted = vectors.iter().map(|v| (*v, 1.0 / dot(v, v).sqrt())).filter(|(_, weight)| weight.is_finite());
    let mut axes = principal_axes(weighted);
    let mut extents = axes.map(|axis| extent(vectors, &axis));
    let mut order: [usize; D] = std::array::from_fn(|k| k);
    order.sort_by(|&a, &b| extents[b].total_cmp(&extents[a]).then(a.cmp(&b)));
    (axes, extents) = (order.map(|k| axes[k]), order.map(|k| extents[k]));
    let is_candidate = |rank: &usize| *rank == D || extents[*rank] <= THIN_WIDTH * extents[0];
    let has_width = |rank: &usize| extents[*rank - 1] > LEAST_WIDTH * extents[0];
    (1..=D).rev().filter(is_candidate).filter(has_width).map(|rank| Chart::new(&axes[rank..])).collect()
}

impl<const D: usize> Chart<D> {
    /// The chart that leaves out as many coordinates as there are orthonormal normals. Each normal n says n · x = 0 but
    /// for the thickness; elimination with full pivoting solves these equations.
    fn new(normals: &[[f64; D]]) -> Self {
        let mut rows = normals.to_vec();
        let mut pivots: Vec<usize> = Vec::with_capacity(rows.len());
        for at in 0..rows.len() {
            let places = (at..rows.len()).flat_map(|row| (0..D).map(move |c| (row, c)));
            let free = places.filter(|(_, c)| !pivots.contains(c));
            let largest = free.max_by(|a, b| rows[a.0][a.1].abs().total_cmp(&rows[b.0][b.1].abs()));
            let Some((row, column)) = largest else { break };
            rows.swap(at, row);
            let head = rows[at][column];
            rows[at] = rows[at].map(|c| c / head);
            let pivot = rows[at];
            for (_, other) in rows.iter_mut().enumerate().filter(|(index, _)| *index != at) {
                let factor = other[column];
                add_multiple(other, -factor, &pivot);
                other[column] = 0.0;
            }
            pivots.push(column);
        }
        let kept = (0..D).filter(|c| !pivots.contains(c)).collect();
        let rates = |row: &[f64; D]| std::array::from_fn(|c| if pivots.contains(&c) { 0.0 } else { -row[c] });
        Self { kept, others: pivots.iter().zip(&rows).map(|(&column, row)| (column, rates(row))).collect() }
    }

    /// The number of coordinates that are kept.
    pub(super) fn rank(&self) -> usize {
        self.kept.len()
    }

    /// The number of coordinates that are left out.
    pub(super) fn left_out(&self) -> usize {
        self.others.len()
    }

    /// The coordinates that are kept, in the first places, and zeros.
    pub(super) fn projected(&self, v: &[f64; D]) -> [f64; D] {
        std::array::from_fn(|k| self.kept.get(k).map_or(0.0, |&c| v[c]))
    }

    /// Generators around a body, from generators around its projection: those on the graph of the linear functions, and
    /// one along each coordinate axis that was left out; `None` if one leaves the range of doubles.
    pub(super) fn lifted(&self, projections: &[[f64; D]], body: &[[f64; D]]) -> Option<Vec<[f64; D]>> {
        let mut lost: [Dyadic; D] = std::array::from_fn(|_| Dyadic::zero());
        let mut generators: Vec<[f64; D]> = projections
            .iter()
            .map(|b| {
                let mut v = [0.0; D];
                self.kept.iter().zip(b).for_each(|(&c, value)| v[c] = *value);
                self.others.iter().for_each(|(c, rates)| v[*c] = dot(rates, &v));
                v
            })
            .collect();
        let are_finite = |list: &[[f64; D]]| list.as_flattened().iter().all(|c| c.is_finite());
        if !are_finite(&generators) {
            return None;
        }
        for v in generators.iter().chain(body) {
            for (c, rates) in &self.others {
                let terms = rates.iter().zip(v).filter(|(rate, _)| **rate != 0.0);
                let value = terms.fold(Dyadic::from_f64(v[*c]), |left, (rate, x)| {
                    &left - &(&Dyadic::from_f64(*rate) * &Dyadic::from_f64(*x))
                });
                lost[*c] = &lost[*c] + &value.abs();
            }
        }
        generators.extend(axis_generators(lost.each_ref().map(at_least)));
        are_finite(&generators).then_some(generators)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plane_of_space() {
        let flat: Vec<[f64; 3]> = (0..9).map(f64::from).map(|a| [a, 3.0 - a, a]).collect();
        let charts = charts(&flat);
        assert_eq!(charts.iter().map(Chart::rank).collect::<Vec<_>>(), [2]);
        let projected: Vec<[f64; 3]> = flat.iter().map(|v| charts[0].projected(v)).collect();
        assert!(projected.iter().all(|v| v[2] == 0.0));
        let lifted = charts[0].lifted(&projected, &flat).unwrap();
        assert!(lifted.len() <= 10);
        for (a, b) in lifted.iter().zip(&flat) {
            assert!((0..3).all(|k| (a[k] - b[k]).abs() < 1e-14), "{a:?} for {b:?}");
        }
    }

    #[test]
    fn what_is_thick_in_all_directions_has_one_chart() {
        let all = charts(&[[1.0, 0.0], [0.0, 0.5], [1.0, 1.0]]);
        assert_eq!((all.len(), all[0].rank(), all[0].left_out()), (1, 2, 0));
        assert!(charts(&[[0.0; 2]; 3]).is_empty());
    }
}
