//! The body turned halfway and a square around the circle that its vertices stay in from there.
//!
//! # Statement
//! Input: a sweep, a body. Output: a zonotope that contains every placement exactly.
//!
//! # Source
//! Section 6, Theorem 6.1, about another placement: the paper takes the first one.
//!
//! # Method
//! As [`by_farthest_vertex`](super::by_farthest_vertex), from the placement at half the angle θ: no other is farther
//! than θ/2 from it, and the radius is 2 r sin(θ/4), half of the other for small angles. It grows up to a whole turn.
//!
//! # Complexity
//! O(n log n) for n generators.
//!
//! # Shapes
//! Input and output: centres and generators of space, generators in half-lengths; zero and parallel ones, none, and
//! bodies that the axis goes through are allowed.
//!
//! # Numerics
//! The turned generators are rounded, and what that loses is a generator along each axis: some 2^-49 of the body's size
//! each.
//!
//! # Errors
//! [`SweepError::OutOfRange`] ⇔ a coordinate of the volume is above the largest double.
//!
//! # Checked by
//! [`brute_force`](super::brute_force), which holds exact placements against all facets.
//!
//! # Example
//! ```
//! use zonotope::Zonotope;
//! use zonotope::motion::space_time::{Sweep, by_middle_placement::volume};
//!
//! let bar = Zonotope::new([2.0, 0.0, 0.0], vec![[1.0, 0.0, 0.0]])?;
//! let volume = volume(&Sweep::new([0.0; 3], [0.0, 0.0, 1.0], 3.0, [0.0; 3])?, &bar)?;
//! assert!(volume.contains([3.0, 0.0, 0.0])? && volume.contains([-2.9, 0.4, 0.0])?);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::parts::angle::{chord_above, cosine_and_sine, covering, product_above};
use super::parts::plane::Plane;
use super::parts::scaled_body::ScaledBody;
use super::parts::shadow::Shadow;
use super::parts::volume::Volume;
use crate::motion::sweep::{Sweep, SweepError};
use crate::zonotope::Zonotope;

/// The volume around the middle placement.
///
/// # Errors
/// [`SweepError::OutOfRange`] if it leaves the range of doubles.
pub fn volume(sweep: &Sweep, body: &Zonotope<3>) -> Result<Zonotope<3>, SweepError> {
    if sweep.angle == 0.0 {
        return Volume::of_translation(body, sweep);
    }
    let half = covering(sweep.angle) / 2.0;
    let (plane, scaled) = (Plane::orthogonal_to(sweep.axis), ScaledBody::of(body, sweep.axis_point));
    let farthest = Shadow::of(&plane, &scaled, &mut ()).farthest_above(&mut ());
    let mut volume = Volume::of_turned_body(&scaled, &plane, &cosine_and_sine(half), sweep);
    volume.add_square(&plane, product_above(chord_above(half), farthest));
    volume.finished()
}
