//! Each generator turned by itself: three generators for one.
//!
//! # Statement
//! Input: a sweep, a body. Output: a zonotope that contains every placement exactly.
//!
//! # Source
//! Section 6. Departure: the arcs of the generators are enclosed, not those of the vertices.
//!
//! # Method
//! Let v be a generator turned halfway, v∥ and v⊥ its parts along the axis and orthogonal to it, J the quarter turn.
//! Let α be an angle of at most half of θ and c the cosine of that.
//! Then R(α) v = v∥ + cos α v⊥ + sin α J v⊥, and cos α lies in [c, 1].
//! The segment of v, turned, therefore lies in a sum of three segments:
//! of v∥ + ½ (1 + c) v⊥, of ½ (1 − c) v⊥ and of sin(θ/2) J v⊥; the
//! centre moves likewise, and its first part does not vary. From θ = π on the largest sine is 1.
//!
//! # Complexity
//! O(n) for n generators.
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
//! use zonotope::motion::space_time::{Sweep, by_turned_generators::volume};
//!
//! let bar = Zonotope::new([2.0, 0.0, 0.0], vec![[1.0, 0.0, 0.0]])?;
//! let volume = volume(&Sweep::new([0.0; 3], [0.0, 0.0, 1.0], 3.0, [0.0; 3])?, &bar)?;
//! assert!(volume.contains([3.0, 0.0, 0.0])? && volume.contains([-2.9, 0.4, 0.0])?);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::parts::angle::{cosine_and_sine, covering, largest_sine, least_cosine};
use super::parts::plane::Plane;
use super::parts::scaled_body::ScaledBody;
use super::parts::volume::{Volume, turned};
use crate::motion::sweep::{Sweep, SweepError};
use crate::numeric::bounded::{Bounded, BoundedVector};
use crate::zonotope::Zonotope;

/// The volume by turned generators.
///
/// # Errors
/// [`SweepError::OutOfRange`] if it leaves the range of doubles.
pub fn volume(sweep: &Sweep, body: &Zonotope<3>) -> Result<Zonotope<3>, SweepError> {
    if sweep.angle == 0.0 {
        return Volume::of_translation(body, sweep);
    }
    let half = covering(sweep.angle) / 2.0;
    let (plane, scaled) = (Plane::orthogonal_to(sweep.axis), ScaledBody::of(body, sweep.axis_point));
    let turn = cosine_and_sine(half);
    let mut volume = Volume::translated(sweep.axis_point, sweep, scaled.exponent);
    let (one, cosine) = (Bounded::exact(1.0), Bounded::exact(least_cosine(half)));
    let [sum, rest] = [one + cosine, one - cosine].map(|twice| twice * Bounded::exact(0.5));
    let sine = Bounded::exact(largest_sine(half));
    // the part that does not vary, and those that do
    let parts = |v: &BoundedVector| {
        let [along, x, y] = turned(&plane.coordinates(v), &turn);
        let zero = Bounded::exact(0.0);
        [[along, sum * x, sum * y], [zero, rest * x, rest * y], [zero, (sine * y).negated(), sine * x]]
            .map(|part| plane.vector(&part))
    };
    let [fixed, away, across] = parts(&scaled.arm);
    volume.move_center(&fixed);
    [away, across].iter().for_each(|part| volume.add(part));
    scaled.generators().for_each(|g| parts(&g).iter().for_each(|part| volume.add(part)));
    volume.finished()
}
