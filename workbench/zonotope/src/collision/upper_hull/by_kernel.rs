//! The height of the upper hull over a point, by the kernel: the least of a sum of absolute values.
//!
//! # Source
//! Beyond the paper, which searches the tile of p_0. The duality is its own: (x, y, 1) is the normal of a facet.
//!
//! # Method
//! 1. Minimise Σ |a_i x + b_i y + c_i| − (x, y) · p_0 over the plane ([`lad`](crate::lad)).
//! 2. The minimum is the height. If there is none, the direction in which the objective falls for ever separates.
//!
//! Where all lines nearly meet in a point, coordinates around it take their place (`near_one_plane`).
//!
//! # Complexity
//! n generators: expected O(n); space O(n).
//!
//! # Numerics
//! Exact.
//!
//! # Checked by
//! [`brute_force`](super::brute_force) and [`by_slope_selection`](super::by_slope_selection).
//!
//! # Example
//! ```
//! use zonotope::collision::upper_hull::{Height, by_kernel};
//! // the cube [−1, 1]³ with a slanted segment: its top goes up by a unit from x = −1 to x = 1
//! let generators = [[1.0, 0.0, 0.5], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
//! assert_eq!(by_kernel::height(&generators, [0.0, 0.25], &mut ()).unwrap(), Height::OverQ(1.into()));
//! assert_eq!(by_kernel::height(&generators, [1.0, -1.0], &mut ()).unwrap(), Height::OverQ("3/2".parse().unwrap()));
//! assert!(matches!(by_kernel::height(&generators, [1.5, 0.0], &mut ()).unwrap(), Height::BesideQ(_)));
//! ```

use super::{Height, HeightError, near_one_plane, validate};
use crate::lad::{LadOutcome, LadProblem, WeightedLine, minimize};
use crate::seed::DEFAULT_SEED;
use crate::tally::Tally;

/// The height of the upper hull over a point.
///
/// # Errors
/// [`HeightError`] names the first coordinate that is not finite.
pub fn height(generators: &[[f64; 3]], p0: [f64; 2], tally: &mut impl Tally) -> Result<Height, HeightError> {
    validate(generators, p0)?;
    if let Some(height) = near_one_plane::height(generators, p0, tally) {
        return Ok(height);
    }
    let lines: Vec<WeightedLine> = generators.iter().map(|&[a, b, c]| WeightedLine::unweighted([a, b], c)).collect();
    let problem = LadProblem::new(&lines, p0.map(|c| -c)).expect("the coordinates are finite, weights are 1");
    Ok(match minimize(&problem, DEFAULT_SEED, tally) {
        LadOutcome::Optimal(optimum) => {
            Height::OverQ(optimum.exact_value(&problem).expect("the optimum is of this problem"))
        }
        LadOutcome::Unbounded { direction } => Height::BesideQ(direction.map(|c| c.to_rational())),
    })
}
