//! The body turned halfway and two images of its own shadow.
//!
//! # Statement
//! Input: a sweep, a body. Output: a zonotope that contains every placement exactly.
//!
//! # Source
//! Section 6. Departure: the shadow of the body takes the place of a circle around it.
//!
//! # Method
//! Let x be a point of the body turned halfway, x⊥ its part orthogonal to the axis, J the quarter turn. For an angle α
//! of at most half of θ, R(α) x = x − (1 − cos α) x⊥ + sin α J x⊥. So all placements lie in the sum of the turned
//! body, 1 − cos(θ/2) times the shadow and sin(θ/2) times the shadow turned by a quarter; the centre counts as a
//! generator of the shadow. From θ = π on the largest sine is 1.
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
//! use zonotope::motion::space_time::{Sweep, by_shadow::volume};
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

/// The volume by the body's shadow.
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
    let mut volume = Volume::of_turned_body(&scaled, &plane, &turn, sweep);
    let sine = Bounded::exact(largest_sine(half));
    let rest = Bounded::exact((1.0 - least_cosine(half)).next_up());
    let mut add_images = |v: BoundedVector| {
        let [_, x, y] = turned(&plane.coordinates(&v), &turn);
        let zero = Bounded::exact(0.0);
        volume.add(&plane.vector(&[zero, (sine * y).negated(), sine * x]));
        volume.add(&plane.vector(&[zero, rest * x, rest * y]));
    };
    add_images(scaled.arm);
    scaled.generators().for_each(add_images);
    volume.finished()
}
