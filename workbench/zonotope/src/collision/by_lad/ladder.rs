//! The ladder of a location: what is tried, when, and what comes next. The kernel's ladder is about the optimum alone,
//! and [`of_optimum`] has the fallbacks of a proof that rounding leaves no room for.
//!
//! | step | tried | where it has no answer |
//! |---|---|---|
//! | [`early::locate`] | always; of bodies under poses, where the entries of the matrices are of moderate size | the next one |
//! | [`location_by_pair`] | 3 to [`WHOLE_LIMIT`] generators, at their [`likely_vertex`] | the next one, from that vertex |
//! | [`from_optimum`] | the search for the optimum; at each vertex that it finds, [`location_by_pair`] may end it | always answers |
//!
//! A step is a function to a [`Proof`], which names the rung that proved it. A step that searches counts the rung of
//! the search, too.

use std::cell::OnceCell;
use std::ops::ControlFlow;

use super::early;
use crate::collision::proof::at_vertex::in_doubles::location_by_pair;
use crate::collision::proof::of_optimum;
use crate::collision::{Location, Query};
use crate::lad::of_generators::guess::vertex_descent::descend;
use crate::lad::of_generators::ladder::WHOLE_LIMIT;
use crate::lad::of_generators::plane::in_doubles::RoundedChart;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::search::best_pair::{Found, PAIRS_LIMIT, steepest};
use crate::lad::of_generators::search_from;
use crate::numeric::bounded::BoundedVector;
use crate::numeric::reused::Reused;
use crate::tally::{Operation, Rung, Tally};
use crate::zonotope::location::{Coefficients, Proof};
use crate::zonotope::pose::Standing;

/// The location of a displacement of space. Expected O(n).
#[inline(never)]
pub(super) fn locate<P: Standing>(query: &Query<'_, 3, P>, tally: &mut dyn Tally) -> Location<3, Coefficients> {
    if let Some(proof) = early::locate(query, tally) {
        return proof.counted(tally);
    }
    let (p, n) = (query.rounded_displacement(), query.len());
    let vertex = if (3..=WHOLE_LIMIT).contains(&n) { likely_vertex(query, &p, tally) } else { None };
    if let Some(pair) = vertex {
        tally.add(Operation::GeneratorRead, n as u64);
        if let Some(proof) = location_by_pair(query, &p, pair) {
            tally.answered_by(if n <= PAIRS_LIMIT { Rung::BestPair } else { Rung::AllInDoubles });
            return proof.counted(tally);
        }
    }
    from_optimum(query, vertex, tally).counted(tally)
}

/// The generators of a vertex that is likely to be the optimum, found in doubles and certified by nobody: that is
/// enough where a proof is made from the vertex alone. `None` where doubles find no vertex. O(n) for each line that the
/// descent takes, of which there are few.
fn likely_vertex(query: &dyn KernelQuery, p: &BoundedVector, tally: &mut dyn Tally) -> Option<[usize; 2]> {
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

/// The proof at a vertex of the search for the optimum, which begins at a vertex, if there is one, or else from the
/// optimum. Expected O(n).
pub(super) fn from_optimum(query: &dyn KernelQuery, vertex: Option<[usize; 2]>, tally: &mut dyn Tally) -> Proof {
    let found = OnceCell::new();
    let at_vertex = |query: &dyn KernelQuery, p: &BoundedVector, pair| match location_by_pair(query, p, pair) {
        Some(proof) => {
            found.get_or_init(|| proof);
            ControlFlow::Break(())
        }
        None => ControlFlow::Continue(()),
    };
    let optimum = search_from(query, &at_vertex, vertex, tally);
    of_optimum::proof(query, &optimum, found.into_inner(), tally)
}
