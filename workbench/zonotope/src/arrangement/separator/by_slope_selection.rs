//! The k-th separator of the tiling, by slope selection in the dual arrangement.
//!
//! # Source
//! Section 5.1, separators. Departures: half-lengths, so a step is 2 v'; every v' is turned to point up; L_k is
//! followed from top to bottom; L_k leans to the left by less than any angle that matters, which orders vertices with
//! equal x and lets L_k meet vertical lines.
//!
//! # Method
//! 1. Select the k-th leftmost vertex ([`randomized`](crate::arrangement::slope_selection::randomized)); let x be its
//!    abscissa.
//! 2. Sort the lines along the vertical line at x and count the vertices left of it.
//! 3. Go up along it, over the points where lines meet, until k vertices are left of x or passed. If k falls between
//!    the pairs of one point, refuse.
//! 4. The lines passed stand in their order right of x, vertical lines at x next, the others in their order left of x.
//!    Vertical lines left of x come first, those right of it last.
//! 5. Step down from the sum of all upward generators.
//!
//! # Complexity
//! n generators: expected O(n log n), the paper's bound; space O(n) numbers.
//!
//! # Shapes
//! `dual`: of n generators in any order, duplicates allowed; `k`: from 0.
//!
//! # Numerics
//! Everything is exact; the points are dyadic.
//!
//! # Checked by
//! [`brute_force`](super::brute_force) for every k, and the areas of the tiles on the left.
//!
//! # Example
//! ```
//! use zonotope::arrangement::DualArrangement;
//! use zonotope::arrangement::separator::by_slope_selection::separator;
//! // Q is the square [−1, 1]² turned by an eighth, its only tile; both sides lead from (0, 2) to (0, −2).
//! let generators = [[1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];
//! let dual = DualArrangement::new(&generators).unwrap();
//! let side = |k| separator(&dual, k, 0, &mut ()).unwrap().points();
//! assert_eq!(side(0), [[0.0, 2.0], [-2.0, 0.0], [0.0, -2.0]]);
//! assert_eq!(side(1), [[0.0, 2.0], [2.0, 0.0], [0.0, -2.0]]);
//! assert!(separator(&dual, 2, 0, &mut ()).is_err());
//! ```

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use super::{Separator, SeparatorError};
use crate::arrangement::dual::{DualArrangement, Upward};
use crate::arrangement::slope_selection::randomized::select;
use crate::arrangement::slope_selection::slab::{Cut, Slab};
use crate::tally::Tally;

/// The k-th separator; `seed` decides the time, never the chain.
///
/// # Errors
/// [`SeparatorError`] when k is above the number of tiles or falls within a facet of coplanar generators.
pub fn separator(
    dual: &DualArrangement,
    k: u64,
    seed: u64,
    tally: &mut impl Tally,
) -> Result<Separator, SeparatorError> {
    let lines = dual.lines();
    let tiles = lines.vertex_count();
    let Some(rank) = k.checked_sub(1) else {
        let sides = lines.order_before_all().into_iter().rev();
        return Ok(Separator::of_steps(slanted(dual, sides).chain(&dual.level)));
    };
    if rank >= tiles {
        return Err(SeparatorError::Rank { k, tiles });
    }
    let whole = Slab::whole(lines);
    let vertex = select(lines, &whole, rank, &mut Pcg64Mcg::seed_from_u64(seed), tally);
    let cut = whole.cut(lines, &lines.abscissa(vertex), tally);
    let (passed, above) = meeting_order(dual, &cut, k)?;
    let [left, right] = cut.verticals;
    let (before, others) = dual.level.split_at(left);
    let (at, after) = others.split_at(right - left);
    let (above, passed) = (above.into_iter().rev(), passed.into_iter().rev());
    let steps = before.iter().chain(slanted(dual, above)).chain(at).chain(slanted(dual, passed)).chain(after);
    Ok(Separator::of_steps(steps))
}

fn slanted<'a>(dual: &'a DualArrangement, places: impl Iterator<Item = u32>) -> impl Iterator<Item = &'a Upward> {
    places.map(|place| &dual.slanted[place as usize])
}

/// The places that L_k meets below the vertical lines at the cut and above them, each from bottom to top.
fn meeting_order(dual: &DualArrangement, cut: &Cut, k: u64) -> Result<(Vec<u32>, Vec<u32>), SeparatorError> {
    let at = cut.verticals[0]..cut.verticals[1];
    let (mut passed, mut above) = (Vec::new(), Vec::new());
    let mut left = cut.left;
    for group in cut.order.groups() {
        if left == k {
            let start = above.len();
            above.extend_from_slice(group);
            dual.lines().turn(&mut above[start..]);
            continue;
        }
        left += dual.lines().crossings_among(group.iter().copied()) + at.len() as u64 * group.len() as u64;
        if left > k {
            let facet = slanted(dual, group.iter().copied()).chain(&dual.level[at]);
            let mut generators: Vec<usize> = facet.map(|upward| upward.generator as usize).collect();
            generators.sort_unstable();
            return Err(SeparatorError::Coplanar { k, generators });
        }
        passed.extend_from_slice(group);
    }
    Ok((passed, above))
}
