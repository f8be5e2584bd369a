//! A vertex that doubles found, as an exact optimum.
//!
//! For a point of an edge of the body the optimum is not unique, and doubles cannot prove any
//! vertex; they find one all the same. Whether it is optimal is seen from the signs of the generators at it, which
//! takes a hundredth of the time of a search in exact arithmetic. Where the vertex is only near the optimum, pivots
//! lead on; each costs a pass in pairs of doubles.

use crate::lad::of_generators::cells::nested::NestedCells;
use crate::lad::of_generators::certify::rounded_optimum::RoundedOptimum;
use crate::lad::of_generators::exact::best_on_line::best_on_line;
use crate::lad::of_generators::exact::bundle::Bundle;
use crate::lad::of_generators::exact::pivot::Balance;
use crate::lad::of_generators::exact::solve::{ExactOptimum, signs_in};
use crate::lad::of_generators::exact::vertex_signs::ExactVertex;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::exact_linear::ExactVector;
use crate::numeric::linear::max_norm;
use crate::tally::{Operation, Tally};

/// At most so many pivots lead from a vertex that doubles found to the optimum.
const PIVOT_LIMIT: usize = 12;

impl ExactOptimum {
    /// The exact form of an optimum that was proved in doubles.
    pub(crate) fn at_vertex(
        query: &dyn KernelQuery,
        p: &ExactVector,
        vertex: &RoundedOptimum,
        cells: &NestedCells,
    ) -> Self {
        let direction = vertex.exact_vertex(query);
        let (last, basis) = (vertex.cell(), vertex.basis.to_vec());
        match query.exact_sum_along(&direction) {
            Some(sum) => Self::with_cells(p, direction, (cells.clone(), last), basis, sum),
            None => Self::new(query, p, direction, signs_in(query, cells, &last, &basis), basis),
        }
    }

    /// The optimum, if a few pivots lead there from the best vertex on the line of the longest generator: where lengths
    /// are uneven, so that no sample is like the whole, the longest have most to say.
    pub(crate) fn from_line_of_longest(
        query: &dyn KernelQuery,
        p: &ExactVector,
        tally: &mut dyn Tally,
    ) -> Option<Self> {
        let sizes = query.generators().map(|v| max_norm(&v));
        let (longest, _) = (0..).zip(sizes).max_by(|(_, a), (_, b)| a.total_cmp(b))?;
        tally.add(Operation::GeneratorRead, 2 * query.len() as u64);
        let basis = best_on_line(query, p, longest)?;
        Self::from_likely_vertex(query, p, basis, &NestedCells::default(), tally)
    }

    /// The optimum from a vertex that is probably the optimum or near it, if a few pivots lead there.
    pub(crate) fn from_likely_vertex(
        query: &dyn KernelQuery,
        p: &ExactVector,
        basis: [usize; 2],
        cells: &NestedCells,
        tally: &mut dyn Tally,
    ) -> Option<Self> {
        tally.add(Operation::ExactFallback, 1);
        let (mut basis, mut known) = (basis, cells);
        let whole = NestedCells::default();
        for _ in 0..=PIVOT_LIMIT {
            tally.add(Operation::GeneratorRead, query.len() as u64);
            let mut vertex = ExactVertex::at(query, p, basis, known);
            if vertex.is_none() && !known.steps().is_empty() {
                vertex = ExactVertex::at(query, p, basis, &whole);
            }
            let Some(vertex) = vertex else {
                (basis, known) = (best_on_line(query, p, basis[0])?, &whole);
                continue;
            };
            let Some(bundles) = Bundle::of_facet(query, &vertex.direction, basis, &vertex.facet) else {
                return vertex.optimum_of_facet(query, p, tally);
            };
            let balance = Balance::of(bundles, query.signed_sum(&vertex.signs), p);
            if balance.is_optimal() {
                return Some(balance.optimum(vertex, query, p));
            }
            basis = balance.pivot(&vertex, query)?;
            known = &whole;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::exact_linear::exact;
    use crate::zonotope::query::Query;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// The optimum that pivots reach from a vertex, compared with that of all generators at once.
    fn reached(query: &Query<'_, 3>, p: &ExactVector, basis: [usize; 2]) -> bool {
        let truth = ExactOptimum::of_whole(query, p, None, &mut ());
        let Some(found) = ExactOptimum::from_likely_vertex(query, p, basis, &NestedCells::default(), &mut ()) else {
            return false;
        };
        assert_eq!(&found.along * &truth.reach, &truth.along * &found.reach, "another gauge");
        true
    }

    #[test]
    fn pivots_lead_from_any_vertex_to_the_optimum() {
        let random = &mut Pcg64Mcg::seed_from_u64(3);
        let mut found = 0;
        for kind in 0..4 {
            for round in 0..20 {
                let n = 5 + 7 * (round % 5);
                let body: Vec<[f64; 3]> = (0..n)
                    .map(|i| {
                        let v = [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64));
                        match kind {
                            0 => v,
                            // four directions but for noise, nearly in a plane, whole numbers
                            1 => [0, 1, 2]
                                .map(|k| [[3, 1, 2], [1, -2, 1], [2, 2, -3], [1, 1, 1]][i % 4][k])
                                .map(f64::from),
                            2 => [v[0], v[1], v[0] + 1e-9 * v[2]],
                            _ => v.map(|c| (3.0 * c).round()),
                        }
                    })
                    .zip(0..)
                    .map(|(v, i)| if kind == 1 { [v[0] + 1e-9 * f64::from(i), v[1], v[2] - 1e-9] } else { v })
                    .collect();
                // the sum of some of the generators is often on an edge of the body
                let p = body.iter().skip(2).fold([0.0; 3], |sum, v| {
                    let sign = f64::copysign(1.0, v[round % 3]);
                    [0, 1, 2].map(|k| sum[k] + sign * v[k])
                });
                let query = Query::new([0.0; 3], p, &body).expect("finite");
                found += usize::from(reached(&query, &exact(p), [0, 1]));
            }
        }
        assert!(found >= 60, "{found} of 80");
    }

    #[test]
    fn parallel_generators_lead_to_another_vertex() {
        let body = [[1.0, 2.0, 3.0], [2.0, 4.0, 6.0], [0.0, 1.0, 0.0]];
        let query = Query::new([0.0; 3], [1.0, 0.0, 0.0], &body).expect("finite");
        assert!(reached(&query, &exact([1.0, 0.0, 0.0]), [0, 1]));
    }
}
