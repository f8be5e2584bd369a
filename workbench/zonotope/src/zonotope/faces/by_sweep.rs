//! The face lattice, by a topological sweep of the great circles: a half turn of a meridian meets every pair of
//! opposite faces once.
//!
//! # Statement
//! Input: the generators of a zonotope of R^3 with at least two directions. Output: its [`FaceLattice`]. Zero
//! generators are left out, parallel ones make one edge, coplanar directions one facet. Flat bodies have two facets,
//! one a side.
//!
//! # Source
//! Section 3: faces correspond to those of an arrangement of great circles. The sweep is the topological sweep of
//! Edelsbrunner and Guibas (1989), here over crossings sorted beforehand circle by circle: the paper assumes general
//! position, and sorting exactly is what decides degenerate cases. Facets with more than four sides are crossings of
//! more than two circles.
//!
//! # Method
//! 1. Sort the crossings of every circle in the half turn from the first meridian (`circles.rs`).
//! 2. Keep the circles in their order along a meridian from north to south and, between them, the cells: vertices of
//!    the body. Where neighbours have their next crossing in common, the meridian can pass it.
//! 3. Pass such a crossing: a facet. The circles through it change places. The cells that end there and those that
//!    begin there, numbered by it, are its vertices from north by west and south to east, counter-clockwise; the arcs
//!    between them are its edges.
//! 4. A new cell lies south of its northern neighbour across one circle: its vertex is the neighbour's minus twice that
//!    generator.
//! 5. The other half turn is the image under x → −x: every face gets its opposite, at a fixed distance in the
//!    numbering. Cells that the first meridian cuts become the opposites of those that the last one cuts.
//!
//! # Complexity
//! n directions, f ≤ n (n − 1) facets: time O(n² log n) for the sorting, then O(n² + f); the paper's O(n²) would need
//! the arrangement to be built without sorting. For generators in general position f = n (n − 1), so sorting costs log
//! n a facet. Space: 4 bytes for each pair of directions besides the lattice, which has 92 bytes a parallelogram.
//!
//! # Shapes
//! `generators`: n × 3, in any order, zero, parallel and coplanar ones allowed.
//!
//! # Numerics
//! All of the combinatorics is exact. Vertices are carried as sums of two doubles and rounded once: see
//! [`FaceLattice::coordinate_error`].
//!
//! # Errors
//! [`FacesError::TooManyDirections`] ⇔ more than [`MAX_DIRECTIONS`] directions: indices would not fit 32 bits.
//!
//! # Checked by
//! `brute_force.rs` on every family of the tests, Euler's relation, incidences and oppositeness on larger ones.
//!
//! # Example
//! ```
//! use zonotope::zonotope::Zonotope;
//! use zonotope::zonotope::faces::{Faces, faces};
//!
//! let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).expect("finite");
//! let found = faces(&cube, &mut ()).expect("few directions");
//! let Faces::Solid(lattice) = found else { unreachable!("three directions") };
//! assert_eq!([lattice.vertex_count(), lattice.edge_count(), lattice.facet_count()], [8, 12, 6]);
//! ```

use super::circles::{Circles, Crossings};
use super::error::FacesError;
pub use super::error::MAX_DIRECTIONS;
use super::lattice::FaceLattice;
use super::slots::Slots;
use crate::tally::{Operation, Tally};
use crate::zonotope::Zonotope;
use crate::zonotope::directions::Directions;

/// The faces of a zonotope with at least two directions.
///
/// # Errors
/// [`FacesError::TooManyDirections`].
pub(super) fn face_lattice(
    body: &Zonotope<3>,
    directions: Directions<3>,
    tally: &mut impl Tally,
) -> Result<FaceLattice, FacesError> {
    if directions.len() > MAX_DIRECTIONS {
        return Err(FacesError::TooManyDirections { directions: directions.len() });
    }
    let circles = Circles::new(directions.representatives());
    let crossings = Crossings::new(&circles, tally);
    let mut lattice = FaceLattice::with_room(body, directions, circles, &crossings);
    let mut slots = Slots::new(&crossings, &lattice);
    while let Some(crossing) = slots.next_crossing() {
        tally.add(Operation::SearchStep, 1);
        slots.pass(crossing, &mut lattice);
    }
    let (last_cells, north) = slots.finish();
    lattice.complete_by_reflection(&last_cells, &north);
    Ok(lattice)
}
