//! Smallest zonotope along given directions, in k + d unknowns, with normals found as they are needed: the default.
//!
//! # Statement
//! Input: points of R^D, at least one, directions and weights ≥ 0. Output: centre p and coefficients c ≥ 0 in doubles such that every point lies in
//! { p + Σ δ_i c_i v_i : |δ_i| ≤ 1 } exactly, with Σ w_i c_i and a proven lower bound of it; or the proof that a difference of two points leaves the span of the directions.
//! Zero, parallel and repeated directions are legal; of parallel ones the cheapest is used. The optimum need not be unique.
//!
//! # Source
//! Section 4.2, Theorem 4.6. Departures: the unknowns are p and c alone, with a constraint Σ c_i |u · v_i| + u · p ≥ max_j u · p_j for facet normals u; the
//! normals are not enumerated; directions that do not span are handled in their span.
//!
//! # Method
//! 1. The span exactly; points off it make the problem infeasible. One direction for each line, coordinates of ordinary size.
//! 2. Begin with the axes as normals, and of many points with some two thousand. Solve by a revised simplex method that keeps its basis when normals are added.
//! 3. For each point that mattered so far, and when these are inside for each point, the facet that its ray from the centre meets. Which directions span a facet does not depend
//!    on coefficients: facets met before are kept with their neighbours, and a ray is followed from one met near it. A point outside adds the normal of
//!    its facet, with the farthest point along it; for all such normals together the points are read once. Again from 2 until no point is outside.
//! 4. Round the centre, in a flat span to doubles of that span that it costs least to move it to, nearly (lattice reduction); prove each point inside, and enlarge the coefficients of a basis of directions by what any point still misses.
//! 5. The multipliers pull at the points with multipliers that add up to zero; scaled to the limits w_i they prove the lower bound.
//! 6. Small programs whose bounds differ by more than rounding are solved again in rationals.
//!
//! # Complexity
//! n points, k directions, r rows found (in practice a few times k + d), f ≤ min(2 C(k, d − 1), points looked at) facets met: a pass costs O(n d²) and O(k d) for each facet, both a few
//! times over, the farthest points O(n) for each normal that a pass adds, a pivot O((k + d)²), space O(n + r k + f k). The paper: O(n k^{d−1}) for all normals and a program of k n' + k + d unknowns.
//!
//! # Shapes
//! `points`: n × D, any order, duplicates allowed; `directions`: k × D of any length; `coefficients`: half-lengths in units of their directions.
//!
//! # Numerics
//! Whether there is an answer is decided exactly, and so is that every point is inside. The relative gap is about 1e-14 for 20 directions, 5e-14 for 200, where they are neither nearly
//! dependent nor points far from the origin for their spread; it is always proven by `lower_bound`. For flat point sets the centre must be a point of doubles in their affine
//! span; where none is near the optimal one the gap says so. A direction of weight zero is certified only in small programs.
//!
//! # Errors
//! [`OutOfRange`](super::FixedDirectionsError::OutOfRange) ⇔ a coefficient or the value exceeds the largest double. All else is refused when the problem is made.
//!
//! # Panics
//! Never.
//!
//! # Checked by
//! [`brute_force`](super::brute_force); [`verify`](super::verify) on every answer.
//!
//! # Example
//! ```
//! use zonotope::enclosing::fixed_directions::{FixedDirections, min_length_along};
//! let triangle = [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
//! let directions = [[1.0, 0.0], [0.0, 1.0], [1.0, -1.0]];
//! let answer = min_length_along(&FixedDirections::new(&triangle, &directions, &[1.0, 1.0, 1.0])?)?;
//! let zonogon = answer.optimal().expect("the directions span the plane");
//! // the square [0, 2]² has c = (1, 1, 0), and nothing along these directions is cheaper
//! assert!(zonogon.lower_bound <= 2.0 && 2.0 <= zonogon.value && zonogon.relative_gap() < 1e-12);
//! # Ok::<(), zonotope::enclosing::fixed_directions::FixedDirectionsError>(())
//! ```

mod generation;
mod normal_simplex;

use super::answer::Enclosure;
use super::problem::{FixedDirections, FixedDirectionsError};
use super::solve::solve_with;
use crate::tally::Tally;

pub(crate) use generation::Generation;

/// The smallest zonotope along the directions around the points.
///
/// # Errors
/// When a coefficient of the answer is no double.
pub fn min_length_along<const D: usize>(
    problem: &FixedDirections<'_, D>,
) -> Result<Enclosure<D>, FixedDirectionsError> {
    min_length_along_counted(problem, &mut ())
}

/// As [`min_length_along`], counting operations: points read and rounds.
///
/// # Errors
/// When a coefficient of the answer is no double.
pub fn min_length_along_counted<const D: usize>(
    problem: &FixedDirections<'_, D>,
    tally: &mut impl Tally,
) -> Result<Enclosure<D>, FixedDirectionsError> {
    solve_with(problem, tally, |_, _, _| Ok(0))
}
