//! The ladder of a location: what is tried, when, and what comes next. The kernel's ladder is about the optimum alone,
//! and [`of_optimum`] has the fallbacks of a proof that rounding leaves no room for.
//!
//! | step | tried | where it has no answer |
//! |---|---|---|
//! | [`early::locate`] | always; of bodies under poses, where the entries of the matrices are of moderate size | the next one |
//! | [`location_by_pair`] | 3 to [`LIKELY_LIMIT`] generators, at their [`likely_vertex`] | the next one, from that vertex |
//! | [`from_optimum`] | the search for the optimum; at each vertex that it finds, [`location_by_pair`] may end it | always answers |
//!
//! A gauge to its last digits is tried from the [`likely_vertex`] of as many generators, and then read off the optimum
//! ([`Facet`]).
//!
//! A step is a function to a [`Proof`], which names the rung that proved it. A step that searches counts the rung of
//! the search, too.

use std::cell::OnceCell;
use std::ops::ControlFlow;

use super::early;
use super::facet::Facet;
use super::likely_vertex::{LIKELY_LIMIT, likely_vertex};
use crate::collision::proof::at_vertex::in_doubles::location_by_pair;
use crate::collision::proof::of_optimum;
use crate::collision::{Gauge, Location, Query};
use crate::lad::of_generators::ladder::WHOLE_LIMIT;
use crate::lad::of_generators::nearest_gauge::gauge_by_pair;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::search::best_pair::PAIRS_LIMIT;
use crate::lad::of_generators::search_from;
use crate::numeric::bounded::BoundedVector;
use crate::numeric::tolerance::MODERATE_SIZES;
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
    let vertex = if (3..=LIKELY_LIMIT).contains(&n) { likely_vertex(query, &p, tally) } else { None };
    if let Some(pair) = vertex {
        tally.add(Operation::GeneratorRead, n as u64);
        if let Some(proof) = location_by_pair(query, &p, pair) {
            tally.answered_by(rung_of_likely_vertex(n));
            return proof.counted(tally);
        }
    }
    // a search that begins with a sample has cells, in which the vertex may not be
    from_optimum(query, vertex.filter(|_| n <= WHOLE_LIMIT), tally).counted(tally)
}

/// The gauge of a displacement of space, within four units in the last place. Expected O(n).
pub(super) fn nearest_gauge(query: &dyn KernelQuery, tally: &mut dyn Tally) -> Gauge<3, Location<3, Coefficients>> {
    gauge_at_likely_vertex(query, tally).unwrap_or_else(|| Facet::find(query, tally).nearly_measured(tally))
}

/// The gauge from a vertex that is likely to be the optimum, and the location that it proves.
fn gauge_at_likely_vertex(
    query: &dyn KernelQuery,
    tally: &mut dyn Tally,
) -> Option<Gauge<3, Location<3, Coefficients>>> {
    let (p, n) = (query.rounded_displacement(), query.len());
    let is_moderate = MODERATE_SIZES.contains(&p.iter().fold(0.0f64, |m, c| m.max(c.value.abs())));
    if !is_moderate || !(3..=LIKELY_LIMIT).contains(&n) {
        return None;
    }
    let pair = likely_vertex(query, &p, tally)?;
    let (value, error) = gauge_by_pair(query, pair, tally)?;
    tally.add(Operation::GeneratorRead, n as u64);
    let proof = location_by_pair(query, &p, pair)?;
    tally.answered_by(rung_of_likely_vertex(n));
    Some(Gauge { value, error, location: proof.counted(tally) })
}

/// The rung of the search that a likely vertex stands for.
fn rung_of_likely_vertex(n: usize) -> Rung {
    if n <= PAIRS_LIMIT { Rung::BestPair } else { Rung::AllInDoubles }
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
