//! Smallest zonotope along given directions, by one linear program in k + d unknowns to which facet normals are added
//! as points violate their constraints: the default.
//!
//! # Source
//! Section 4.2, Theorem 4.6, with three departures. The unknowns are p and c alone, with the constraint
//! Σ c_i |u · v_i| + u · p ≥ max_j u · p_j for facet normals u: a program in the paper's unknowns b_ij grows
//! with the number of points. The normals are not enumerated, since few of them matter. And directions that do not span
//! the space are handled in their span.
//!
//! # Method
//! 1. Find the span of the directions exactly; a point off it proves that the problem is infeasible. Take coordinates
//!    of ordinary size in the span, and one direction for each line.
//! 2. Begin with the axes as normals. Solve the program for the normals so far by a revised simplex method, which keeps
//!    its basis when normals are added.
//! 3. For each point of a working set, find the facet through which its ray from the centre leaves; if all of these
//!    points are inside, for every other point. The working set holds the points that have been farthest along a normal
//!    and, of many points, a sample of about two thousand. Which directions span a facet does not depend on the
//!    coefficients, so facets are kept with their neighbours, and a ray is followed from the facet of a ray near it. A
//!    point outside adds the normal of its facet, with the farthest point along it; the points are read once for all
//!    such normals together. Repeat from 2 until no point is outside.
//! 4. Round the centre to doubles. If the directions do not span the space, the centre has to lie in the affine span of
//!    the points, and lattice reduction finds a point of doubles there that costs little. Prove each point inside, or
//!    enlarge the coefficients of a basis of directions by what it misses.
//! 5. Round the multipliers of the points so that they add up to zero, and divide them so that they satisfy the dual
//!    constraints: the lower bound.
//! 6. Solve a small program in rationals if its bounds differ by more than rounding.
//!
//! # Complexity
//! n points, k directions, r rows found (in practice a few times k + d), f facets met, at most min(2 C(k, d − 1),
//! points looked at). A pass over the points costs O(n d²), and O(k d) for each facet, both a few times over. The
//! farthest points cost O(n) for each normal that a pass adds, and a pivot O((k + d)²). Space is O(n + r k + f k). The
//! paper takes O(n k^{d−1}) for all normals, and a program of k n' + k + d unknowns for n' extreme points.
//!
//! # Numerics
//! Whether there is an answer is decided exactly, and every point is inside exactly. The relative gap is always proven
//! by `lower_bound`. It is about 1e-14 for 20 directions and 5e-14 for 200, unless directions are nearly dependent or
//! the points are far from the origin for their spread. If the span is not the whole space, the centre must be a point
//! of doubles in the affine span of the points; where none is near the optimal centre, the gap shows it. A direction of
//! weight zero is certified only in small programs.
//!
//! # Example
//! ```
//! use zonotope::enclosing::fixed_directions::{FixedDirections, min_length_along};
//! let triangle = [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
//! let directions = [[1.0, 0.0], [0.0, 1.0], [1.0, -1.0]];
//! let answer = min_length_along(&FixedDirections::new(&triangle, &directions, &[1.0, 1.0, 1.0])?, &mut ())?;
//! let zonogon = answer.optimal().expect("the directions span the plane");
//! // the square [0, 2]² has c = (1, 1, 0), and nothing along these directions is cheaper
//! assert!(zonogon.lower_bound <= 2.0 && 2.0 <= zonogon.value && zonogon.relative_gap() < 1e-12);
//! # Ok::<(), zonotope::enclosing::fixed_directions::FixedDirectionsError>(())
//! ```

use super::answer::Enclosure;
use super::problem::{FixedDirections, FixedDirectionsError};
use super::solve::solve_with;
use crate::tally::Tally;

/// The smallest zonotope along the directions around the points.
///
/// Points read and rounds are counted.
///
/// # Errors
/// When a coefficient of the answer exceeds the largest double.
#[inline(never)]
pub fn min_length_along<const D: usize>(
    problem: &FixedDirections<'_, D>,
    tally: &mut dyn Tally,
) -> Result<Enclosure<D>, FixedDirectionsError> {
    solve_with(problem, tally, |_, _, _| Ok(0))
}
