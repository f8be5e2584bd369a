//! Coefficients of many generators, written in one pass, part after part: each part balances the error of those
//! before it.
//!
//! The generators are dealt out in stretches. Of every group of stretches all but one belong to the first part, every
//! second of the others to the second part, and so on, until the last part has a small share, from all over the list,
//! which stands for all generators. The first part gets the coefficients that would combine to the point if all
//! generators were like those of the last part. The error of its sum shows how far the mean of the last part is from
//! that of all, and is spread over the parts that follow. In the end the last part has to combine to the rest, which
//! is known.
//!
//! The sample is stratified and not drawn independently, because its mean is then much nearer to that of all
//! generators where neighbours in the list resemble each other.

use std::ops::Range;

use crate::collision::Witness;
use crate::collision::by_lad::early::combination::{Combination, Stretches, Written};
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::bounded::BoundedVector;

/// The last part has at least this many generators, and √n more.
const LEAST_LAST_PART: usize = 32;

/// At least one generator in this number is in the last part.
const LAST_PART_SHARE: usize = 128;

/// The number of stretches in a group is the root of the last part's size over this number: a larger last part tells
/// the mean better, and lets the first part be a larger share.
const STEADY_ROOT: usize = 8;

/// Limits of the number of generators in a stretch.
const SHORTEST_STRETCH: usize = 8;
const LONGEST_STRETCH: usize = 128;

/// The order in which generators are dealt out.
#[derive(Debug, Clone, Copy)]
pub(crate) struct StratifiedPass {
    /// Generators in a stretch.
    stretch: usize,
    /// Stretches in a group, all but one of them of the first part.
    group: usize,
    /// Parts between the first and the last.
    halvings: u32,
}

impl StratifiedPass {
    pub(crate) fn of(count: usize) -> Self {
        let few = (LEAST_LAST_PART + count.isqrt()).max(count / LAST_PART_SHARE);
        let group = (few.isqrt() / STEADY_ROOT).next_power_of_two().max(2);
        let halvings = (count / few / group).max(1).ilog2();
        Self {
            stretch: (count.isqrt() / 8).clamp(SHORTEST_STRETCH, LONGEST_STRETCH).next_power_of_two(),
            group,
            halvings,
        }
    }

    /// The period of a part in generators, and the place of its stretch in it.
    fn places(self, part: u32) -> (usize, Range<usize>) {
        let first = self.group << part.saturating_sub(1);
        let end = self.stretch * if part == 0 { first - 1 } else { first };
        let start = if part == 0 { 0 } else { end - self.stretch };
        (self.stretch * (self.group << part.min(self.halvings)), start..end)
    }

    /// The generators of the last part.
    pub(crate) fn last(self, query: &impl KernelQuery) -> Vec<[f64; 3]> {
        let (period, range) = self.places(self.halvings + 1);
        let mut few = Vec::with_capacity((query.len() / period + 2) * self.stretch);
        for part in query.parts() {
            for period in part.rows.list().chunks(period) {
                part.copy(&period[within(&range, period.len())], &mut few);
            }
        }
        few
    }

    /// The proof that p is inside; `steer` gives coefficients with which the generators of the last part, `few` of
    /// them, sum up to a vector, exactly or nearly.
    pub(crate) fn witness(
        self,
        query: &impl KernelQuery,
        p: &BoundedVector,
        few: usize,
        mut steer: impl FnMut(&[f64; 3], bool) -> Option<Combination>,
    ) -> Option<Witness> {
        let n = query.len();
        let mut coefficients = vec![0.0; n];
        let mut written = Written::default();
        let mut bias = [0.0; 3];
        for part in 0..self.halvings + 2 {
            let left = (n - written.count) as f64;
            let is_last = part == self.halvings + 1;
            if is_last {
                bias = [0.0; 3];
            }
            let mean = [0, 1, 2].map(|k| (p[k].value - written.sum[k]) / left - bias[k]);
            let mut combination = steer(&mean.map(|c| c * few as f64), is_last)?;
            if !is_last {
                combination = combination.merged();
            }
            let (period, range) = self.places(part);
            let own = combination.write_all(query, &Stretches { period, range }, &mut coefficients);
            if part == 0 {
                bias = [0, 1, 2].map(|k| own.sum[k] / own.count as f64 - mean[k]);
            }
            written = written.with(&own);
        }
        written.witness(query, p, coefficients)
    }
}

/// A range, cut off at the end of a run.
#[inline(always)]
fn within(range: &Range<usize>, len: usize) -> Range<usize> {
    range.start.min(len)..range.end.min(len)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::Query;

    #[test]
    fn every_generator_has_its_turn_once() {
        for n in [321, 1000, 5000, 70_000] {
            let body: Vec<[f64; 3]> = (0..n).map(|i| [f64::from(i); 3]).collect();
            let pass = StratifiedPass::of(body.len());
            for (first, second) in [body.split_at(body.len()), body.split_at(body.len() / 3)] {
                let mut turn = vec![0; body.len()];
                for part in 0..pass.halvings + 2 {
                    let (period, range) = pass.places(part);
                    for run in [first, second] {
                        for period in run.chunks(period) {
                            for [index, ..] in &period[within(&range, period.len())] {
                                turn[*index as usize] += 1;
                            }
                        }
                    }
                }
                assert!(turn.iter().all(|count| *count == 1), "{n}");
            }
            let query = Query::new([0.0; 3], [1.0; 3], &body).expect("finite");
            let few = pass.last(&query);
            assert!(few.len() > 30 && few.len() < body.len() / 2 && few.is_sorted_by(|a, b| a[0] < b[0]), "{n}");
        }
    }
}
