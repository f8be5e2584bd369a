//! The kernel in homogeneous form: the minimum of h(u) = Σ |v_i · u| over the plane of directions u with u · p = 1.
//!
//! | notation | meaning in every stage |
//! |---|---|
//! | p | the displacement of the query |
//! | v, v_i | a generator: its segment is { δ v : abs(δ) ≤ 1 } |
//! | u | a direction of the plane u · p = 1, or any multiple of it |
//! | h(u) | the support value Σ abs(v_i · u) of the body: the objective |
//! | λ | h(u) / u · p at the optimal u: the body holds λ p and no larger multiple, so 1 / λ is the gauge of p |
//! | μ | a rounded number near λ, of which a proof is made |
//! | sign | that of v · u, of one generator |
//! | g | the sum of all generators with their signs but those of a vertex: g + δ_a v_a + δ_b v_b = λ p |
//! | δ, share | a coefficient in \[−1, 1\] that is solved for: of a generator whose sign at u is 0 |
//! | vertex | a pair of generators a, b, and with it the direction ±a × b |
//! | cell | a cone of directions in which signs are fixed |
//! | level | a problem of the generators that cross a cell, the others summed up; each cell is within the one before |
//! | band | the distance from a guess within which the kinks of lines are rounded off, and the lines within it |
//! | side | one of two edges of the parallelogram around a guess in which the optimum is likely to be |
//!
//! The line of a generator v is v · u = 0, and a vertex of the arrangement of these lines is the direction v × w of a
//! pair of generators. That is why vertices are pairs of generators and not points with coordinates: nothing is
//! rotated, no line is computed before it is needed, and every decision is the sign of a determinant of input
//! vectors, which exact arithmetic can take. The minimum is 1 / the gauge of p.
//!
//! The kernel rests on one fact. For any signs fixed on a part of the generators,
//!
//! (Σ sign v) · u + Σ_rest |v · u| ≤ h(u),
//!
//! with equality where the signs are those of v · u. So nearly all generators are summed up with their signs, and an
//! optimum of the few others with that sum, if it lies in the cell of directions in which the signs are right, is the
//! optimum of all generators, by convexity. That is why the kernel sums generators up with signs where a search by
//! pruning would throw lines away: the sum keeps the objective, and its signs are the proof.
//!
//! | stage | passes on | promises | has no answer by |
//! |---|---|---|---|
//! | [`guess`] | a point of the plane and a cell around it | nothing but speed | `None` |
//! | [`cells`] | a reduced problem, nested cells | the signs of the generators that were summed up are exact | too many lines |
//! | [`certify`] | a rounded optimum | the gauge is in an interval, every rounding error bounded | `Unproved` |
//! | [`search`] | guess, cells and certificate in turn | what `certify` promises | `Missed`, `NotCertified` |
//! | [`exact`] | an exact optimum | an answer | never |
//! | [`ladder`] | the optimum and the rung that answered | an answer; the only file with fallbacks | never |
//!
//! Beside the stages: [`seam`] has what the kernel asks of whoever holds the generators, under a pose or not; [`plane`]
//! has the coordinates of the plane of directions; [`span`] makes bodies that do not span space into prisms that do;
//! [`problem`] and [`goal`] are what goes in, [`optimum`] what comes out; [`nearest_gauge`] has the last digits of the
//! gauge. The kernel knows no location: a caller that wants one hands a function down ([`goal::AtVertex`]), which sees
//! the vertices of a search and may end it.

pub(crate) mod cells;
pub(crate) mod certify;
pub(crate) mod exact;
pub(crate) mod goal;
pub(crate) mod guess;
pub(crate) mod ladder;
pub(crate) mod nearest_gauge;
pub(crate) mod optimum;
pub(crate) mod plane;
pub(crate) mod problem;
pub(crate) mod seam;
pub(crate) mod search;
pub(crate) mod span;

use self::goal::{AtVertex, Goal};
use self::optimum::Optimum;
use super::of_generators::seam::kernel_query::KernelQuery;
use crate::tally::{Rung, Tally};

/// The optimum of a query, counted under the rung that answered. Expected O(n).
pub(crate) fn solve(query: &dyn KernelQuery, goal: Goal, tally: &mut dyn Tally) -> Optimum {
    counted(ladder::climb(query, goal, None, None, tally), tally)
}

/// The optimum of a query whose location is all that is asked, unless the caller ends the search at a vertex; it
/// begins at a vertex at which a search in doubles has ended, if there is one.
pub(crate) fn search_from(
    query: &dyn KernelQuery,
    at_vertex: AtVertex<'_>,
    vertex: Option<[usize; 2]>,
    tally: &mut dyn Tally,
) -> Optimum {
    counted(ladder::climb(query, Goal::Location, Some(at_vertex), vertex, tally), tally)
}

fn counted((optimum, rung): (Optimum, Rung), tally: &mut dyn Tally) -> Optimum {
    tally.answered_by(rung);
    optimum
}
