//! Locations in bodies of a few hundred generators, proved from a vertex that no certificate says to be the optimum.

use super::early::passes::EarlyQuery;
use crate::collision::Query;
use crate::collision::proof::at_vertex::in_doubles::location_by_pair;
use crate::lad::of_generators::ladder::WHOLE_LIMIT;
use crate::lad::of_generators::search::best_pair::PAIRS_LIMIT;
use crate::lad::of_generators::search::likely_vertex::likely_vertex;
use crate::lad::of_generators::told::Told;
use crate::tally::{Operation, Rung, Tally};

/// The proof that a vertex found in doubles gives, or else the vertex, if there is one. O(n) for each line of the
/// descent.
pub(super) fn told(query: &Query<'_, 3>, tally: &mut dyn Tally) -> Result<Told, Option<[usize; 2]>> {
    let n = query.len();
    if !(3..=WHOLE_LIMIT).contains(&n) {
        return Err(None);
    }
    let p = query.displacement_in_doubles();
    let pair = likely_vertex(query.rows(), &p, tally).ok_or(None)?;
    tally.add(Operation::GeneratorRead, n as u64);
    let told = location_by_pair(query, &p, pair).ok_or(Some(pair))?;
    tally.answered_by(if n <= PAIRS_LIMIT { Rung::BestPair } else { Rung::AllInDoubles });
    Ok(told)
}
