//! The Schur complement H = Σ_T a_T a_Tᵀ ⊗ W_T⁻² of a step, from running sums.
//!
//! The row of a point in H is the sum of W_T⁻² a_T over all T that contain it. For each run of consecutive sets that
//! contain the point this is the difference of two running sums. Neighbours in the order of the sets differ by few
//! points, so runs are long and few, and this takes far fewer additions than a sum over the sets for each pair of
//! points.

use super::cholesky::Cholesky;
use super::scaling::Scaling;
use crate::enclosing::min_total_length::by_vertex_sets::point_set::PointSet;
use crate::enclosing::min_total_length::by_vertex_sets::scalar::Scalar;
use crate::enclosing::min_total_length::by_vertex_sets::vertex_sets::VertexSets;

impl<R: Scalar, const D: usize> VertexSets<'_, R, D> {
    /// The Schur complement for the scalings of the sets.
    pub(super) fn schur_complement(&self, scalings: &[Scaling<R, D>]) -> Cholesky<R> {
        let (rank, count) = (self.rank, self.points.len() - 1);
        let entries: Vec<(usize, usize)> = (0..rank).flat_map(|a| (0..=a).map(move |b| (a, b))).collect();
        let width = entries.len() * count;
        let mut sums = vec![R::from(0.0); width];
        let mut rows = vec![R::from(0.0); width * count];
        let mut is_member = vec![R::from(0.0); count];
        let none = PointSet::with_room_for(self.points.len());
        let mut before = &none;
        let change = |rows: &mut [R], sums: &[R], j: usize, factor: f64| {
            let factor = R::from(factor);
            let row = &mut rows[width * j..][..width];
            for (row, sums) in row.chunks_exact_mut(count).zip(sums.chunks_exact(count)) {
                for (entry, sum) in row[..=j].iter_mut().zip(sums) {
                    *entry = *entry + factor * *sum;
                }
            }
        };
        for (set, scaling) in self.sets.iter().zip(scalings) {
            for (point, is_in) in set.points.changes_since(before) {
                let j = point - 1;
                is_member[j] = R::from(if is_in { 1.0 } else { 0.0 });
                change(&mut rows, &sums, j, if is_in { -1.0 } else { 1.0 });
            }
            before = &set.points;
            for (sums, &(a, b)) in sums.chunks_exact_mut(count).zip(&entries) {
                let entry = R::from(4.0) * scaling.entry(a, b);
                for (sum, is_member) in sums.iter_mut().zip(&is_member) {
                    *sum = *sum + entry * *is_member;
                }
            }
        }
        for j in before.members() {
            change(&mut rows, &sums, j - 1, 1.0);
        }
        let mut matrix = Cholesky::zero(rank * count);
        for (j, row) in rows.chunks_exact(width).enumerate() {
            for (row, &(a, b)) in row.chunks_exact(count).zip(&entries) {
                for (k, &entry) in row[..=j].iter().enumerate() {
                    matrix.set(rank * j + a, rank * k + b, entry);
                    if a != b && k < j {
                        matrix.set(rank * j + b, rank * k + a, entry);
                    }
                }
            }
        }
        matrix
    }
}
