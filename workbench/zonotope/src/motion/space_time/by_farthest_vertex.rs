//! Theorem 6.1: the body and a square around the circle that the farthest vertex stays in.
//!
//! # Statement
//! Input: a sweep, a body. Output: a zonotope that contains every placement exactly: the generators of the body as they
//! are, half the translation, and two of equal length orthogonal to the axis.
//!
//! # Source
//! Section 6, Theorem 6.1. Departures: the paper adds the translation v; in half-lengths that is v/2. The radius is
//! 2 r sin(θ/2) for an angle θ up to half a turn and 2 r from there on, so that any angle is taken.
//!
//! # Method
//! A point x of the body is moved by R(φ) x − x, orthogonal to the axis and as long as 2 sin(φ/2) times the distance
//! from the axis; that is largest at a vertex of the body's shadow, whose vertices follow from the generators sorted by
//! angle. A square around the circle of that radius holds all these vectors, for any φ up to θ; a translation by half
//! of v and the generator v/2 hold the rest.
//!
//! # Complexity
//! O(n log n) for n generators.
//!
//! # Shapes
//! Input and output: centres and generators of space, generators in half-lengths; zero and parallel ones, none, and
//! bodies that the axis goes through are allowed.
//!
//! # Numerics
//! The square is orthogonal to the axis exactly. Its half-side is rounded up: it exceeds the exact one by about n 2^-52
//! of it, and by 2^-48 of the body's distance from the axis point, which is long where a body lies far along the axis.
//!
//! # Errors
//! [`SweepError::OutOfRange`] ⇔ a coordinate of the volume is above the largest double.
//!
//! # Checked by
//! [`brute_force`](super::brute_force), which holds exact placements against all facets; the check of `sweep` answers
//! in the crate `verifier`.
//!
//! # Example
//! ```
//! use zonotope::Zonotope;
//! use zonotope::motion::space_time::{Sweep, by_farthest_vertex::volume};
//!
//! // the cube of side 2 moved by 10 sweeps a box of 12 × 2 × 2
//! let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])?;
//! let moved = volume(&Sweep::new([0.0; 3], [0.0, 0.0, 1.0], 0.0, [10.0, 0.0, 0.0])?, &cube, &mut ())?;
//! assert_eq!((moved.center(), moved.generators()[3]), ([5.0, 0.0, 0.0], [5.0, 0.0, 0.0]));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::parts::angle::{chord_above, covering, product_above};
use super::parts::plane::Plane;
use super::parts::scaled_body::ScaledBody;
use super::parts::shadow::Shadow;
use super::parts::volume::Volume;
use crate::motion::sweep::{Sweep, SweepError};
use crate::tally::Tally;
use crate::zonotope::Zonotope;

/// The volume of Theorem 6.1; counting operations.
///
/// # Errors
/// [`SweepError::OutOfRange`] if it leaves the range of doubles.
pub fn volume(sweep: &Sweep, body: &Zonotope<3>, tally: &mut dyn Tally) -> Result<Zonotope<3>, SweepError> {
    if sweep.angle == 0.0 {
        return Volume::of_translation(body, sweep);
    }
    let (plane, scaled) = (Plane::orthogonal_to(sweep.axis), ScaledBody::of(body, sweep.axis_point));
    let farthest = Shadow::of(&plane, &scaled, tally).farthest_above(tally);
    let mut volume = Volume::of_body(body, sweep, scaled.exponent);
    volume.add_square(&plane, product_above(chord_above(covering(sweep.angle)), farthest));
    volume.finished()
}
