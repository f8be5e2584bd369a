//! The ladder of a location: what is tried, when, and what comes next. The only file with fallbacks on the way to a
//! proof; the kernel's own ladder is about the optimum alone.
//!
//! | step | tried | where it has no answer |
//! |---|---|---|
//! | [`early::locate`] | always; of bodies under poses, where the entries of the matrices are of moderate size | the next one |
//! | [`at_likely_vertex`] | 3 to [`WHOLE_LIMIT`] generators | the next one, from the vertex that was found |
//! | [`from_optimum`] | the search for the optimum; at each vertex that it finds, [`location_by_pair`] may end it | always answers |
//!
//! A step is a function to a [`Proof`], which names the rung that proved it. A step that searches counts the rung of
//! the search, too.

use std::cell::OnceCell;
use std::ops::ControlFlow;

use super::early;
use crate::collision::answer::Proof;
use crate::collision::proof::at_vertex::in_doubles::location_by_pair;
use crate::collision::proof::of_optimum;
use crate::collision::{Location, Query};
use crate::lad::of_generators::ladder::WHOLE_LIMIT;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::search::best_pair::PAIRS_LIMIT;
use crate::lad::of_generators::search::likely_vertex::likely_vertex;
use crate::lad::of_generators::search_from;
use crate::numeric::bounded::BoundedVector;
use crate::tally::{Operation, Rung, Tally};
use crate::zonotope::placed::Standing;

/// The location of a displacement of space.
#[inline(never)]
pub(super) fn locate<P: Standing>(query: &Query<'_, 3, P>, tally: &mut dyn Tally) -> Location<3> {
    let proof = early(query, tally).unwrap_or_else(|| {
        let p = query.rounded_displacement();
        let vertex = likely(query, &p, tally);
        let proof = vertex.and_then(|pair| at_likely_vertex(query, &p, pair, tally));
        proof.unwrap_or_else(|| from_optimum(query, vertex, tally))
    });
    proof.counted(tally)
}

/// The proof of a location by passes over a sample, without a search.
#[inline]
pub(in crate::collision) fn early<P: Standing>(query: &Query<'_, 3, P>, tally: &mut dyn Tally) -> Option<Proof> {
    query.is_moderate().then(|| early::locate(query, tally))?
}

/// The vertex that a search in doubles finds among a few hundred generators, not certified. O(n) for each line of the
/// descent.
fn likely(query: &dyn KernelQuery, p: &BoundedVector, tally: &mut dyn Tally) -> Option<[usize; 2]> {
    if (3..=WHOLE_LIMIT).contains(&query.len()) { likely_vertex(query, p, tally) } else { None }
}

/// The proof that a vertex gives. O(n).
fn at_likely_vertex(
    query: &dyn KernelQuery,
    p: &BoundedVector,
    pair: [usize; 2],
    tally: &mut dyn Tally,
) -> Option<Proof> {
    let n = query.len();
    tally.add(Operation::GeneratorRead, n as u64);
    let proof = location_by_pair(query, p, pair)?;
    tally.answered_by(if n <= PAIRS_LIMIT { Rung::BestPair } else { Rung::AllInDoubles });
    Some(proof)
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
