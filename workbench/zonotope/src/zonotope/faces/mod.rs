//! Faces: of a zonotope of R^3 vertices, edges, facets, zones and how they meet; in other dimensions vertices and
//! facets.
//!
//! | file | what it holds |
//! |---|---|
//! | [`FaceLattice`] | faces as indices; incidences, opposite faces, zones |
//! | [`by_sweep`] | O(n² log n) and the size of the output: the default |
//! | `export` | the lattice as OBJ, PLY and STL |
//! | [`by_recursion`] | vertices and facets in any dimension, O(n^r) for rank r |
//! | [`brute_force`] | all faces in any dimension, as sign vectors: the truth |

pub mod brute_force;
pub mod by_recursion;
pub mod by_sweep;
mod circles;
mod counts;
mod determinants;
mod error;
mod export;
mod lattice;
mod measures;
mod position;
mod signs;
mod slots;
#[cfg(test)]
mod tests;

use std::cmp::Ordering;

pub(super) use counts::space_counts;
pub use error::FacesError;
pub use lattice::{Edge, FaceLattice, Facet, Vertex, Zone};
pub use measures::Estimate;

use super::Zonotope;
use super::directions::Directions;
use crate::tally::Tally;

/// The coefficients of a face, one a generator: 1 (`Greater`), −1 (`Less`), or none along the face (`Equal`).
pub type SignVector = Vec<Ordering>;

/// The faces of a zonotope, by the dimension of the body.
#[derive(Debug, Clone)]
pub enum Faces {
    /// Every generator is zero.
    Point([f64; 3]),
    /// All generators are parallel: the two ends.
    Segment([[f64; 3]; 2]),
    /// All generators lie in one plane: a zonogon, whose two sides count as facets.
    Flat(FaceLattice),
    /// A body with interior.
    Solid(FaceLattice),
}

/// The faces of a zonotope, by [`by_sweep`].
///
/// Counted are an [`Operation::Comparison`](crate::tally::Operation::Comparison) for each order of two crossings of a
/// great circle, the exact fallbacks among them, and an
/// [`Operation::SearchStep`](crate::tally::Operation::SearchStep) for each crossing that the sweep passes.
///
/// # Errors
/// [`FacesError::TooManyDirections`].
pub fn faces(body: &Zonotope<3>, tally: &mut impl Tally) -> Result<Faces, FacesError> {
    let directions = Directions::of_finite(body.generators());
    match directions.len() {
        0 => Ok(Faces::Point(body.center())),
        1 => {
            let sum = directions.representatives()[0];
            Ok(Faces::Segment([body.support(sum.map(|c| -c)).point(), body.support(sum).point()]))
        }
        _ => {
            let lattice = by_sweep::face_lattice(body, directions, tally)?;
            Ok(if lattice.is_flat() { Faces::Flat(lattice) } else { Faces::Solid(lattice) })
        }
    }
}
