//! Searches in doubles: each takes a guess through cells to a vertex that is certified, or says why it has none.
//!
//! | search | where it is at home |
//! |---|---|
//! | [`narrowing`] | most bodies: smaller and smaller cells around a guess, then descent from vertex to vertex until one is certified |
//! | [`best_pair`] | a few generators: h(u) at the normals of their pairs, all of them or along lines |
//! | [`class_meetings`] | generators of few directions: the optimum is where two classes of parallel generators meet |
//! | [`corrected_sample`] | lines that nearly meet, uneven lengths: passes over all correct the gradient of a sample |
//! | [`cutting_planes`] | where these leave a doubt: three pieces of the objective close in on the optimum |

pub(crate) mod best_pair;
pub(crate) mod class_meetings;
pub(crate) mod corrected_sample;
pub(crate) mod cutting_planes;
pub(crate) mod narrowing;

use super::cells::nested::NestedCells;
use super::certify::rounded_optimum::RoundedOptimum;
use crate::numeric::reused::ReusedBox;

/// The outcome of a search in doubles.
#[derive(Debug)]
pub(crate) enum Searched {
    /// Nothing: the caller ended the search at a vertex.
    Ended,
    /// A vertex that is the optimum or so near to it that the gauge is bounded, and the cells on the way to it.
    Certified(ReusedBox<RoundedOptimum>, NestedCells),
    /// Cells that probably hold the optimum, of which doubles cannot say more; no cells where the search has made no
    /// progress. And the generators of a vertex at which a descent ended, perhaps outside of the cells.
    Doubtful { cells: NestedCells, vertex: Option<[usize; 2]> },
}
