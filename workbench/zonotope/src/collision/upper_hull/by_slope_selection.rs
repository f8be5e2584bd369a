//! The height of the upper hull over a point, by the paper's search for the tile that holds it.
//!
//! # Source
//! Section 5.1. Departures: those of [membership](crate::collision::by_slope_selection), of which this is the first
//! half.
//!
//! # Method
//! 1. Compare p_0 with the sides of Q.
//! 2. Binary search over the separators, each found by slope selection, for the facet over p_0; its plane gives the
//!    height.
//!
//! # Complexity
//! n generators: expected O(n log² n), the paper's bound; space O(n).
//!
//! # Numerics
//! Exact.
//!
//! # Checked by
//! [`brute_force`](super::brute_force) and [`by_kernel`](super::by_kernel).
//!
//! # Example
//! ```
//! use zonotope::collision::upper_hull::{Height, by_slope_selection};
//! // a roof: the ridge over y = 0 at height 1, the eaves over y = ±2 at height 0
//! let generators = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.5], [0.0, -1.0, 0.5]];
//! let height = |p0| by_slope_selection::height(&generators, p0, 0, &mut ()).unwrap();
//! assert_eq!(height([0.5, 0.0]), Height::OverQ(1.into()));
//! assert_eq!(height([-1.0, 2.0]), Height::OverQ(0.into()));
//! ```

use super::{Height, HeightError, validate};
use crate::collision::Query;
use crate::collision::by_slope_selection::height_of_upper_hull;
use crate::numeric::dyadic::Dyadic;
use crate::tally::Tally;

/// The height of the upper hull over a point; `seed` decides the time, never the height.
///
/// # Errors
/// [`HeightError`] names the first coordinate that is not finite.
pub fn height(generators: &[[f64; 3]], p0: [f64; 2], seed: u64, tally: &mut impl Tally) -> Result<Height, HeightError> {
    validate(generators, p0)?;
    let [x, y] = p0;
    let question = Query::new([0.0; 3], [x, y, 0.0], generators).expect("the coordinates are finite");
    Ok(match height_of_upper_hull(&question, seed, tally) {
        Ok(height) => Height::OverQ(height),
        Err([x, y, _]) => Height::BesideQ([x, y].map(|c| Dyadic::from_f64(c).to_rational())),
    })
}
