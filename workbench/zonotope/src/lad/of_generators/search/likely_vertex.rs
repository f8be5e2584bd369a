//! A vertex that is likely to be the optimum of a few hundred generators, found in doubles and certified by nobody.
//!
//! That is enough for whoever can prove an answer from the vertex alone.

use super::best_pair::{Found, PAIRS_LIMIT, steepest};
use crate::lad::of_generators::guess::vertex_descent::descend;
use crate::lad::of_generators::plane::in_doubles::RoundedChart;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::bounded::BoundedVector;
use crate::numeric::reused::Reused;
use crate::tally::{Operation, Tally};

/// The generators of the vertex, by their indices; `None` where doubles find no vertex. O(n) for each line that the
/// descent takes, of which there are few.
pub(crate) fn likely_vertex(query: &dyn KernelQuery, p: &BoundedVector, tally: &mut dyn Tally) -> Option<[usize; 2]> {
    let [first, second] = query.parts();
    let n = query.len();
    let p = [p[0].value, p[1].value, p[2].value];
    if n <= PAIRS_LIMIT {
        let mut vectors = [[0.0; 3]; PAIRS_LIMIT];
        let (own, others) = vectors[..n].split_at_mut(first.rows.len());
        first.write(own);
        second.write(others);
        let Found { pair, octets } = steepest(&vectors[..n], &p);
        // each eight of pairs is tried with all generators
        tally.add(Operation::GeneratorRead, n as u64 * octets as u64);
        return Some(pair);
    }
    tally.add(Operation::GeneratorRead, n as u64);
    let mut vectors = Reused::with_capacity(n);
    first.copy(first.rows.list(), &mut vectors);
    second.copy(second.rows.list(), &mut vectors);
    let lines = RoundedChart::new(p).lines(&vectors);
    descend(&lines, [0.0; 2], lines.approach([0.0; 2], None))
}
