//! The body and the zonogon of least area around the arcs of its vertices.
//!
//! # Statement
//! Input: a sweep, a body. Output: a zonotope that contains every placement exactly.
//!
//! # Source
//! Section 6, Figure 3, with the zonogon of Section 4.1 for the parallelogram.
//!
//! # Method
//! The points around the arcs are those of [`by_least_rectangle`](super::by_least_rectangle); Theorem 4.5 finds the
//! zonogon of least area around them.
//!
//! # Complexity
//! O(n log n) for n generators; the zonogon has at most as many generators as the hull of the points has edges.
//!
//! # Shapes
//! Input and output: centres and generators of space, generators in half-lengths; zero and parallel ones, none, and
//! bodies that the axis goes through are allowed.
//!
//! # Numerics
//! The zonogon contains the points exactly; a box of some 2^-46 of the body's size holds what rounding the points
//! lost.
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
//! use zonotope::motion::space_time::{Sweep, by_least_zonogon::volume};
//!
//! let point = Zonotope::new([1.0, 0.0, 0.0], vec![])?;
//! let around = volume(&Sweep::new([0.0; 3], [0.0, 0.0, 1.0], 1.5707963267948966, [0.0; 3])?, &point)?;
//! assert!(around.contains([0.7071067811865476, 0.7071067811865476, 0.0])? && around.contains([0.0, 1.0, 0.0])?);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::parts::arcs::ArcPoints;
use super::parts::plane::Plane;
use super::parts::scaled_body::ScaledBody;
use super::parts::shadow::Shadow;
use super::parts::volume::Volume;
use crate::enclosing::min_area;
use crate::motion::sweep::{Sweep, SweepError};
use crate::numeric::bounded::Bounded;
use crate::zonotope::Zonotope;

/// The volume with the zonogon of least area around the arcs.
///
/// # Errors
/// [`SweepError::OutOfRange`] if it leaves the range of doubles.
pub fn volume(sweep: &Sweep, body: &Zonotope<3>) -> Result<Zonotope<3>, SweepError> {
    if sweep.angle == 0.0 {
        return Volume::of_translation(body, sweep);
    }
    let (plane, scaled) = (Plane::orthogonal_to(sweep.axis), ScaledBody::of(body, sweep.axis_point));
    let arcs = ArcPoints::of(&Shadow::of(&plane, &scaled, &mut ()), sweep.angle);
    let mut volume = Volume::of_body(body, sweep, scaled.exponent);
    let around = min_area(&arcs.points).map_err(|_| SweepError::OutOfRange)?.body;
    let in_space = |v: [f64; 2]| plane.vector(&[0.0, v[0], v[1]].map(Bounded::exact));
    volume.move_center(&in_space(around.center()));
    around.generators().iter().for_each(|g| volume.add(&in_space(*g)));
    volume.add_ball(arcs.off);
    volume.finished()
}
